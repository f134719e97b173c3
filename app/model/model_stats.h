/*
 * How much a model holds, in figures for people.
 */
#ifndef APP_MODEL_MODEL_STATS_H
#define APP_MODEL_MODEL_STATS_H

#include "app/model/model.h"

enum {
	MODEL_INFLUENCES_MAX = 8, /* of a vertex, in struct model_primitive */
};

/*
 * Sums over meshes and clips. A mesh counts once, however many nodes draw it.
 * Bytes are those of struct model, before any kernel makes its own of them.
 */
struct model_stats {
	int primitive_count;
	int vertex_count;
	int triangle_count;

	/* [k]: vertices that k joints really move (weight above 0). */
	int influence_histogram[MODEL_INFLUENCES_MAX + 1];
	int max_influences; /* the largest k of these */

	int target_count;       /* morph targets, once a mesh */
	int morph_vertex_count; /* vertices of meshes that have targets */

	int channel_count;
	int key_count;
	float longest_s; /* of the clips */

	size_t geometry_bytes;  /* vertices and indices, without the next two */
	size_t influence_bytes; /* joints, weights, inverse bind matrices */
	size_t target_bytes;
	size_t clip_bytes; /* as if no two channels shared their times */
	size_t image_bytes;
};

/* A coarser level of a mesh: of all its primitives that have one so far. */
struct model_level {
	float error_m;
	bool shape;
	int triangle_count; /* a primitive without such a level keeps its own */
};

/* How many levels a mesh has: those of the primitive with most. */
int model_level_count(const struct model_mesh *mesh);

/* The level of that number, below model_level_count(). */
struct model_level model_level(const struct model_mesh *mesh, int level);

/* All of a model. */
void model_measure(const struct model *model, struct model_stats *out);

/* Adds one mesh or one clip to the figures, which begin as zeros. */
void model_stats_add_mesh(
	struct model_stats *stats, const struct model_mesh *mesh);
void model_stats_add_clip(
	struct model_stats *stats, const struct model_clip *clip);

#endif
