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
	/*
	 * The boxes of the rest pose, of the clips, and of all places where
	 * each target's ball may be (or empty). In the instance's arena.
	 */
	struct bounds rest, *clip, *ball;
	bool *is_played; /* [clip_count]: whether a state or a layer plays it */
	float *height;   /* [clip_count]: room for character_bounds_ground() */
	struct character_follow *follow; /* [clip_count] */
	int followed; /* the clip that the camera follows now; -1: none */
	float way[3]; /* how far the followed node is from its start */
	/*
	 * The box of what morphs reach beyond the rest pose, of the parts'
	 * shifts, and of what turned parts have reached until now.
	 */
	struct bounds extra;
	/* What springs and capes have reached since one was switched on. */
	struct bounds swung;
	float extent; /* of the model */
	/* [drawable_count]: the outermost vertices; NULL without parts. */
	int (*outermost)[CHARACTER_DIRECTIONS];
};

/*
 * Measures the character. Shifts and balls so far away that the model would be
 * less than half as large in the picture are left out. Leaves the instance in
 * the rest pose. Returns 0 or -ENOMEM.
 */
int character_bounds_init(
	struct character_bounds *bounds, const struct character *character);

/*
 * Returns the box of what the state and layers play, of used balls and of the
 * extras, to which it adds where the parts, springs and capes are now. If the
 * state's clip goes far, it returns the box of the model where it is now, and
 * moved says how far the model went since the last call.
 */
struct bounds character_bounds_now(struct character_bounds *bounds,
	const struct character *character, float moved[3]);

/*
 * Returns the height of the ground: that on which most played clips stand. A
 * clip that sinks a little lower, such as a figure that falls, does not let the
 * others hover; but the ground is never so high that it hides a clip that goes
 * deeper.
 */
float character_bounds_ground(
	const struct character_bounds *bounds, int clip_count);

/*
 * Adds where a drawable's outermost vertices are now to a box. Each vertex is
 * first moved along x and z by slope times its height above y; slope may be 0
 * 0. Only for a character with parts.
 */
void character_bounds_add(const struct character_bounds *bounds,
	const struct instance *instance, int drawable, float y,
	const float slope[2], struct bounds *out);

/*
 * Finds the least and the greatest value of a number of the file: a parameter's
 * range, or the number itself.
 */
void character_range(const struct character *character, const float *value,
	float *low, float *high);

#endif
