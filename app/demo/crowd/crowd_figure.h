/*
 * The model that all walkers of a crowd show: its size, its middle, and its
 * motions on the routes. Any model is scaled to about the size of a person.
 */
#ifndef APP_DEMO_CROWD_CROWD_FIGURE_H
#define APP_DEMO_CROWD_CROWD_FIGURE_H

#include "app/character/motions/motions.h"
#include "app/demo/actor.h"
#include "app/demo/crowd/crowd_route.h"

enum {
	CROWD_NAMED_MAX = 4
};

struct crowd_figure {
	struct motions motions;
	bool one_clip; /* --clip was given: all walkers play it */
	/* clips that standing walkers play because of their names */
	struct motion named[CROWD_NAMED_MAX];
	int named_clip[CROWD_MAX]; /* index in named of each walker, or -1 */
	float scale;               /* metres of the crowd for a scene unit */
	float center[3]; /* scene units; this point stands on the route */
	float front_rad; /* the direction it faces; 0 is +Z */
	float beyond_m;  /* added to the crowd's radius for a wide figure */
};

/*
 * Measures the actor's model, which changes its instance's pose. Returns 0, or
 * -errno after logging an error.
 */
int crowd_figure_make(struct crowd_figure *figure, const struct demo_env *env,
	struct actor *actor);

/*
 * Returns the route of a walker, number 0 to CROWD_MAX - 1, with the speed of
 * the motion that the figure plays on it, and writes this motion to *motion. A
 * figure that cannot walk stands.
 */
struct crowd_route crowd_figure_route(
	const struct crowd_figure *figure, int number, struct motion *motion);

/*
 * Writes the matrix from the figure's scene units to the walker's place. drift
 * is how far the clip itself has moved the figure, in scene units; the
 * matrix undoes this.
 */
void crowd_figure_matrix(const struct crowd_figure *figure,
	const struct crowd_route *route, const struct crowd_position *position,
	const float drift[3], mat4 out);

#endif
