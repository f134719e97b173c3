/*
 * The model that a crowd consists of: its size, its middle, and what it does on
 * its routes. Any model is shown about as large as a person.
 */
#ifndef APP_DEMO_CROWD_CROWD_FIGURE_H
#define APP_DEMO_CROWD_CROWD_FIGURE_H

#include "app/character/motions/motions.h"
#include "app/demo/actor.h"
#include "app/demo/crowd/crowd_route.h"

struct crowd_figure {
	const struct model *model;
	struct motions motions;
	bool one_clip;   /* --clip: all play it */
	float scale;     /* the crowd's metres a scene unit */
	float center[3]; /* scene units; this point stands on the route */
	float front_rad; /* where the figure looks; 0 is +Z */
	float beyond_m;  /* how much farther it reaches than a person */
};

/* Measures the actor's model. Returns 0, or -errno after logging an error. */
int crowd_figure_make(struct crowd_figure *figure, const struct demo_env *env,
	struct actor *actor);

/*
 * Returns the route of walker number 0 to CROWD_MAX - 1 with the speed of the
 * motion in which the figure follows it. A figure that cannot walk stands.
 */
struct crowd_route crowd_figure_route(
	const struct crowd_figure *figure, int number, struct motion *motion);

/*
 * Returns the matrix from scene units to the walker's place. drift is what the
 * clip has moved the figure, x and z.
 */
void crowd_figure_matrix(const struct crowd_figure *figure,
	const struct crowd_route *route, const struct crowd_position *position,
	const float drift[2], mat4 out);

#endif
