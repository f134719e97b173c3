/*
 * A frame of the parameters and switches of a character.
 */
#ifndef APP_CHARACTER_RUN_PARAMETERS_H
#define APP_CHARACTER_RUN_PARAMETERS_H

#include "app/character/character_data.h"

/* Sets the parameter's goal, clamped to its range. */
void character_parameter_set(struct character_parameter *parameter, float goal);

/* Moves all parameters on by the frame's step, in the order of the file. */
void character_parameters_update(struct character *character);

/* Moves all switches on by the frame's step and sets their .now. */
void character_switches_update(struct character *character);

/*
 * Sets the goal to the stop that is this many stops further (back if negative),
 * at most to the last or first one.
 */
void character_parameter_step(struct character_parameter *parameter, int steps);

#endif
