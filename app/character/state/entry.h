/*
 * A clip as a state or a layer plays it: its time, its events and its pose.
 */
#ifndef APP_CHARACTER_STATE_ENTRY_H
#define APP_CHARACTER_STATE_ENTRY_H

#include "app/character/character_data.h"

/* Returns the clip's duration, or 0 for the rest pose. */
float character_entry_duration_s(const struct character_entry *entry);

/*
 * Returns the height of the clip's lower sole at the time that is shown. Only
 * for a character with feet (run/feet.h).
 */
float character_entry_sole_m(const struct character_entry *entry, int pair);

/*
 * Returns how many marks a second the clip passes at a phase. A phase counts
 * marks: 2.5 is in the middle between the marks 2 and 3.
 */
float character_entry_marks_per_s(
	const struct character_entry *entry, double phase);

/* Begins the clip at time_s. */
void character_entry_begin(struct character_entry *entry, double time_s);

/*
 * Moves the clip on by step_s, back if that is below 0, or to the phase if the
 * clip has marks. Without marks or with phase NULL the clip has its own time.
 */
void character_entry_move(
	struct character_entry *entry, double step_s, const double *phase);

/*
 * Advances the time that is shown to where the last move has led, and adds the
 * actions of the events on the way. The entry has a clip.
 */
void character_entry_show(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat);

/*
 * Shows the clip and writes its pose, without the travel of the motion's root.
 */
void character_entry_sample(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat,
	struct pose *pose);

/* The same, but mixes the clip into the pose by clip_mix(). */
void character_entry_mix(struct character *character,
	struct character_entry *entry, enum clip_repeat repeat, float amount,
	struct pose *pose);

#endif
