/*
 * Fewer triangles for small figures: the same vertices, a shorter index list.
 *
 * Vertices of one joint that share a cell of a grid at rest become one; what
 * is left without a surface is left out. Drawables of more than one batch keep
 * all they have. One set serves all instances of a model and kernel.
 */
#ifndef APP_SCENE_COARSE_H
#define APP_SCENE_COARSE_H

#include "app/scene/instance.h"

struct coarse_part {
	const uint16_t *index; /* NULL: the drawable's own */
	int index_count;
};

struct coarse {
	int count;
	struct coarse_part *part; /* [count], a drawable each */
	long triangles;
};

/*
 * Cells of that size, in the model's own units. Memory is the arena's. 0 or
 * -ENOMEM.
 */
int coarse_init(struct coarse *coarse, const struct instance *instance,
	float cell, struct arena *arena);

/*
 * Lets an instance be drawn by these lists, which must outlive its being drawn.
 */
void coarse_use(const struct coarse *coarse, struct instance *instance);

/* The lists that an instance has, to go back to. 0 or -ENOMEM. */
int coarse_keep(struct coarse *full, const struct instance *instance,
	struct arena *arena);

#endif
