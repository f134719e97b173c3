/*
 * The space that a character takes, for the camera.
 */
#ifndef APP_CHARACTER_SHOW_CHARACTER_BOUNDS_H
#define APP_CHARACTER_SHOW_CHARACTER_BOUNDS_H

#include "app/character/character_data.h"
#include "app/character/show/character_follow.h"

enum {
	CHARACTER_DIRECTIONS = 14
};

/* All in scene units. */
struct character_bounds {
	struct bounds all;
	/* In the instance's arena; where a ball may be, or empty: */
	struct bounds rest, *clip, *ball;
	struct character_follow *follow; /* [clip_count] */
	int followed; /* the clip that the camera follows now; -1: none */
	float way[3]; /* how far it is from its start */
	/*
	 * What morphs reach beyond the rest pose, the parts' shifts, and what
	 * turned parts have reached until now.
	 */
	struct bounds extra;
	/* What springs and capes have reached since one of them is on. */
	struct bounds swung;
	float extent; /* of the model */
	/* [drawable_count]: its outermost vertices; NULL if no part turns. */
	int (*outermost)[CHARACTER_DIRECTIONS];
};

/*
 * Leaves out what goes so far that the model would be less than half as large
 * in the picture. Leaves the instance in the rest pose. Returns 0 or -ENOMEM.
 */
int character_bounds_init(
	struct character_bounds *bounds, const struct character *character);

/*
 * The box of what the state and layers play, of used balls and the extras, to
 * which it adds where the parts, springs and capes are now. If the state's clip
 * goes far it is the box of the model where it is now, and moved tells how far
 * it went since the last call.
 */
struct bounds character_bounds_now(struct character_bounds *bounds,
	const struct character *character, float moved[3]);

/*
 * The height of the ground: that on which most clips stand. Those that sink a
 * little, such as a figure that falls, do not let the others hover; but the
 * ground hides no clip that goes deeper.
 */
float character_bounds_ground(
	const struct character_bounds *bounds, int clip_count);

/*
 * Adds where a drawable's outermost vertices are now, after y has moved them by
 * so much along x and z for each unit of height above it. slope may be 0 0.
 * Only for a character with parts.
 */
void character_bounds_add(const struct character_bounds *bounds,
	const struct instance *instance, int drawable, float y,
	const float slope[2], struct bounds *out);

/* What a number of the file can be: a parameter's range, or what it is. */
void character_range(const struct character *character, const float *value,
	float *low, float *high);

#endif
