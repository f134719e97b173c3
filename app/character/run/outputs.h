/*
 * The GPIO lines that a character drives: when they go off, and their devices.
 */
#ifndef APP_CHARACTER_RUN_OUTPUTS_H
#define APP_CHARACTER_RUN_OUTPUTS_H

#include "app/character/character_data.h"

struct gpio_output;

/* The lines of a character's outputs; NULL: it has none. */
struct character_outputs {
	struct gpio_output *line[CHARACTER_OUTPUTS_MAX];
	double next_s; /* when lost lines are looked for again */
};

/*
 * Opens the character's lines that are not open yet, on or off as its outputs
 * are, and lets it drive them. A line that cannot be opened is a warning.
 * outputs must outlive the character's updates.
 */
void character_outputs_open(struct character_outputs *outputs,
	struct character *character, const struct log *log);

/*
 * Once a second, looks for lines that are missing or lost. now_s is the time of
 * any clock that does not go back.
 */
void character_outputs_check(struct character_outputs *outputs, double now_s);

/* Closes the lines, for instance before the same file is loaded again. */
void character_outputs_close(struct character_outputs *outputs);

/* Switches an output: 0 off, below 0 on, or on for so many milliseconds. */
void character_output_drive(
	struct character *character, int index, float amount);

/* Ends the pulses whose time is over. */
void character_outputs_update(struct character *character);

#endif
