/*
 * The data of rigid parts and of the sequences that move them, see
 * character_data.h.
 */
#ifndef APP_CHARACTER_CHARACTER_PART_H
#define APP_CHARACTER_CHARACTER_PART_H

#include "app/anim/pose.h"

#include <stdbool.h>

struct character_action;

/* Degrees of freedom of a part. */
enum {
	CHARACTER_HEADING,
	CHARACTER_PITCH,
	CHARACTER_BANK,
	CHARACTER_X,
	CHARACTER_Y,
	CHARACTER_Z,
	CHARACTER_FREEDOMS,
};

struct character_freedom {
	float start, low, high;
	float speed; /* degrees or metres a second, for the action move */
	bool given;

	/* Changes: */
	/* moved: the change that actions ask for in this frame */
	float value, moved;
};

enum {
	CHARACTER_GROUND = -2 /* the holder of a part that was dropped */
};

enum {
	CHARACTER_GUARDS_MAX = 4,
	CHARACTER_TOPS_MAX = 4
};

/* A capsule in a part's frame, and its units, that keeps away from others and the ground. */
struct character_guard {
	float radius_m;
	float from[3], to[3];
};

/* A rigid part on a pivot. Its freedoms are in degrees and metres. */
struct character_part {
	const char *name;
	int node;
	int order[3]; /* of CHARACTER_HEADING, .._PITCH, .._BANK; outermost first */
	bool rotates_first; /* the position turns with the angles */
	/* what one metre along x, y and z is in the frame of the node's parent */
	float metre[3];
	struct character_freedom freedom[CHARACTER_FREEDOMS];
	const float *follows[CHARACTER_FREEDOMS]; /* or NULL */
	bool has_radius; /* guard[0] is the capsule of `radius` and `tip` */
	int guard_count;
	struct character_guard guard[CHARACTER_GUARDS_MAX];
	/*
	 * Level surfaces that other parts' shadows fall on, in the part's
	 * frame and its units: y, then x and z of two corners.
	 */
	int top_count;
	float top[CHARACTER_TOPS_MAX][5];

	/* Changes: */
	/* a node, CHARACTER_GROUND, or -1 for its place in the model */
	int holder;
	bool placed; /* in this frame, at its holder */
	/* the pivot's height in the model, and that of the lowest vertex */
	float rest_m, low_m;
	float upright[4];      /* the rotation in the model, of the world */
	struct transform held; /* its place in the holder's frame */
	/* offset from held at first, and the seconds until it is 0 */
	float pull[3], pull_s;
	/* height above held, and the speed of its fall */
	float fall_m, fall_m_per_s;
};

/* A value that a part's freedom reaches at the end of a step of a sequence. */
struct character_goal {
	int part, freedom;
	float value;

	/* Changes: */
	/* the value at the step's start */
	float from;
	struct character_goal *next;
};

struct character_step {
	const char *name;
	float duration_s;
	struct character_goal *goal;
	const struct character_action *then;
	struct character_step *next;
};

struct character_sequence {
	const char *name;
	struct character_step *step;
	bool repeat;
	bool start; /* runs from the start */

	/* Changes: */
	struct character_step *now; /* or NULL */
	bool repeats;
	float elapsed_s;
};

#endif
