/*
 * Feet that keep to the ground: planted feet neither slide nor sink.
 *
 * A clip plants feet well, a mixture of two clips does not: soles sink, hover
 * and slide while the gait changes. So the hips are lifted until the lower sole
 * has the height that it has in the clips themselves, and a planted foot is
 * held on the ground by the leg's inverse kinematics. The offset that holds a
 * foot shrinks to 0 while that foot swings; a foot that does not swing takes a
 * step for this.
 */
#ifndef APP_CHARACTER_RUN_FEET_H
#define APP_CHARACTER_RUN_FEET_H

#include "app/anim/procedural/ik.h"
#include "app/character/character_data.h"
#include "app/character/run/sole.h"

enum {
	CHARACTER_SOLE_MAX = 32 /* flat parts of four bones, and the edge */
};

struct character_foot {
	struct ik_limb leg;
	float length_m; /* of the stretched leg */
	int sole_count; /* at least 1: points of the sole */
	struct character_sole sole[CHARACTER_SOLE_MAX];
	int heel, toe; /* the points farthest back and ahead */
	/* a point of the sole below this height is on the ground */
	float planted_m;

	/* Changes: */
	/* of the sole's points in the world, as animated */
	float place[CHARACTER_SOLE_MAX][3];
	/* the same along x and z, with the foot held */
	float shown[CHARACTER_SOLE_MAX][2];
	unsigned low; /* bits: the points on the ground, as animated */
	/* bits: the points on the ground both in this frame and in the last */
	unsigned stays;
	/* mean motion of these points in this frame, as animated, x and z */
	float moved[2];
	float turned;    /* radians about y in this frame, as animated */
	float direction; /* of the animated foot, radians about y */
	struct character_hold {
		float offset[2]; /* along x and z */
		float turn_rad;  /* about y */
	} hold, from;            /* displacement: now, and at take-off */
	float step_s; /* since the foot left the ground; below 0: it is held */
	float arc_m;  /* greatest height of a step; 0: the foot swings */
	float raised_m; /* how far a step raises the foot now */
};

struct character_feet {
	struct character_switch is;
	int hips;
	struct character_foot foot[2];
	float height_m;              /* of the figure */
	int pair;                    /* 0, 1 ... in the order of the file */
	struct character_feet *next; /* or NULL */
	/* an earlier pair whose hips carry the hips of this one, or NULL */
	const struct character_feet *carrier;

	/* Changes: */
	bool begun;
	float lift_m;  /* how far the hips are lifted now, on level ground */
	float moved_m; /* how far up the hips are from their animated place */
	float shown_m; /* height of the lower sole in the last frame */
	float from_m;  /* the same less that of the clips, when a fade began */
};

/* How far feet are switched on, 0 to 1; 0 without any. */
float character_feet_level(const struct character *character);

/*
 * Places the points of both soles and returns the height of the lowest point.
 */
float character_feet_place(
	struct character_feet *feet, const struct instance *instance);

/*
 * Notes which feet stand, and sets the motion's velocity so that animated feet
 * on the ground do not slide. World matrices must be those of the animated
 * pose.
 */
void character_feet_follow(struct character *character);

/*
 * Moves on what holds each foot of a pair at its place on the ground: planted
 * feet stay, and others go back to their animated places. Feet that are
 * switched off are not held.
 */
void character_feet_hold(
	const struct character *character, struct character_feet *feet);

/* The operation of a struct character_feet. */
void character_feet_run(struct character *character, void *feet);

#endif
