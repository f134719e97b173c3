/*
 * Models far from their origin, as exports of maps and of CAD programs are.
 *
 * Floats at 1,000 km are 6 cm apart, so vertices that are computed there shake.
 * A loader therefore moves such a model to near the origin before anything is
 * computed, and model.origin says where it was: a position in the file is one in
 * the model plus model.origin. A model at a moderate distance stays as it is.
 */
#ifndef APP_MODEL_ORIGIN_MODEL_ORIGIN_H
#define APP_MODEL_ORIGIN_MODEL_ORIGIN_H

#include "app/model/model.h"

/*
 * Moves the rest pose of a model that is farther from the origin than 128 times
 * its size, and sets model->origin. Moves also the vertices of meshes that are
 * as far from the origin of their nodes, if each node that shows the mesh has no
 * skin and no camera, is no joint and is not turned. turned, [node_count], says
 * which nodes a clip rotates or scales; start, [node_count], where a clip begins to
 * move each node at the top, or its rest: a model that a clip begins elsewhere
 * stays. The clips have yet to be moved: *shift is
 * [node_count], by how much less each node's translation is than in the file, or
 * NULL if the model stays. The arena owns it. Subtractions are exact wherever
 * the file's numbers are near to each other. Returns 0 or -ENOMEM.
 */
int model_origin_find(struct model *model, const bool *turned,
	const float (*start)[3], struct arena *arena, double (**shift)[3]);

/* Moves the values of a channel, count keys with three floats each, or nine. */
void model_origin_shift_keys(const double shift[3],
	const struct model_channel *channel, float *value);

/*
 * The same for a model whose clips have been read, with float keys, which are
 * moved as well. The arena is for scratch memory. Returns 0 or -ENOMEM.
 */
int model_origin_move(struct model *model, struct arena *arena);

/* The position in the file of a point in the model. */
void model_origin_to_file(
	const struct model *model, const float point[3], double out[3]);

#endif
