/*
 * A transition to another motion by inertialisation.
 *
 * When the motion changes, the difference between the pose that is shown and
 * the new motion's pose is kept for each node and shrinks to nothing. The old
 * motion is not played any more. So a transition may begin at any moment, also
 * during another one, and costs no second clip. With INERTIA_SMOOTH the
 * velocity continues too: each difference follows a polynomial of the fifth
 * degree (D. Bollo, "Inertialization", Game Developers Conference 2018).
 */
#ifndef APP_CHARACTER_STATE_INERTIA_H
#define APP_CHARACTER_STATE_INERTIA_H

#include "app/anim/pose.h"

enum inertia_curve {
	INERTIA_SMOOTH, /* keeps position and velocity */
	INERTIA_LINEAR, /* the second paper of app/departures.md, 3.1 */
	INERTIA_CUBIC,  /* 3 u^2 - 2 u^3 */
};

/* One difference along a direction that does not change. */
struct inertia_offset {
	float direction[3];   /* unit */
	float size;           /* at the start: metres or radians; 0: none */
	float coefficient[6]; /* of t^0 to t^5, for INERTIA_SMOOTH */
	float end_s;
};

struct inertia {
	struct pose last, older; /* as shown in the last two frames */
	float step_s;            /* between them */
	int shown;               /* how many of the two are valid */

	enum inertia_curve curve;
	float duration_s, elapsed_s;
	bool running;
	struct inertia_offset *turn, *shift; /* [node_count] */
	float (*scale)[3];                   /* [node_count], differences */
	bool scales;   /* some difference of scale is not 0 */
	float *weight; /* [weight_count] */
};

/* Allocates memory for poses of the model. Returns 0 or -ENOMEM. */
int inertia_init(struct inertia *inertia, const struct model *model,
	struct arena *arena);

/* Forgets all poses and ends a transition. */
void inertia_reset(struct inertia *inertia);

/*
 * Begins a transition from the poses last kept to a motion whose pose is fresh
 * at this moment. Without a pose kept, or with a duration of 0 or less, none
 * begins.
 */
void inertia_begin(struct inertia *inertia, const struct pose *fresh,
	float duration_s, enum inertia_curve curve);

/*
 * Advances by step_s and adds what is left of the differences to the motion's
 * pose. Does nothing when no transition runs.
 */
void inertia_apply(struct inertia *inertia, float step_s, struct pose *pose);

/* Keeps the pose that is shown in this frame, step_s after the last one. */
void inertia_keep(
	struct inertia *inertia, const struct pose *shown, float step_s);

#endif
