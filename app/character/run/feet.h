/*
 * Feet that keep to the ground: planted feet neither slide nor sink.
 *
 * A clip plants feet well, a mixture of two clips does not: soles sink, hover
 * and slide while the gait changes. So the hips are lifted until the lower sole
 * has the height that the clips themselves give it, and a planted foot is held
 * on the ground by the leg's inverse kinematics. The offset that holds it is
 * taken back while the foot swings; a foot that does not swing takes a step.
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
	int heel, toe;   /* the points farthest back and ahead */
	float planted_m; /* a lower point of the sole is on the ground */

	/* Changes: */
	float place[CHARACTER_SOLE_MAX][3]; /* in the world, as animated */
	float shown[CHARACTER_SOLE_MAX][2]; /* the same along x and z, held */
	unsigned low;    /* bits: the points on the ground, as animated */
	unsigned stays;  /* the same in this frame and the last one */
	float moved[2];  /* on the average of these, as animated */
	float turned;    /* radians about y in this frame, as animated */
	float direction; /* of the animated foot, radians about y */
	struct character_hold {
		float offset[2]; /* along x and z */
		float turn_rad;  /* about y */
	} hold, from;            /* what holds the foot, now and when it left */
	float step_s;   /* since it left the ground; below 0: it is held */
	float arc_m;    /* greatest height of a step; 0: the foot swings */
	float raised_m; /* by a step, now */
};

struct character_feet {
	struct character_switch is;
	int hips;
	struct character_foot foot[2];
	float height_m; /* of the figure */

	/* Changes: */
	bool begun;
	float lift_m;  /* of the hips, now */
	float shown_m; /* height of the lower sole in the last frame */
	float from_m;  /* the same, above the clips', when a fade began */
};

/* Places the points of both soles; returns the height of the lowest one. */
float character_feet_place(
	struct character_feet *feet, const struct instance *instance);

/*
 * Notes which feet stand, and makes the ground's velocity that of the animated
 * feet on it. World matrices are those of the animated pose.
 */
void character_feet_follow(struct character *character);

/* The operation. */
void character_feet_run(struct character *character, void *feet);

#endif
