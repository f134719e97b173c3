/*
 * Sizes of a model: vertices, triangles, influences, keys, bytes.
 */
#ifndef APP_MODEL_MODEL_STATS_H
#define APP_MODEL_MODEL_STATS_H

#include "app/model/model.h"

enum {
	MODEL_INFLUENCES_MAX = 8, /* the largest model_primitive.influences */
};

/*
 * Sums over meshes and clips. A mesh counts once, even if several nodes draw
 * it. Primitives and vertices are counted as in the file, before large
 * primitives are divided. Bytes are those of struct model, without the copies
 * that kernels make.
 */
struct model_stats {
	int primitive_count;
	int vertex_count;
	int triangle_count;

	/* [k]: vertices with k weights above 0 */
	int influence_histogram[MODEL_INFLUENCES_MAX + 1];
	int max_influences; /* the largest k with influence_histogram[k] > 0 */

	int target_count;       /* morph targets of all meshes */
	int morph_vertex_count; /* vertices of meshes that have targets */

	int channel_count;
	int key_count;
	float longest_s; /* the duration of the longest clip */

	size_t geometry_bytes;  /* indices and vertices, without the bytes
				 below */
	size_t influence_bytes; /* joints, weights, inverse bind matrices */
	size_t target_bytes;
	size_t clip_bytes; /* shared key times count for each channel */
	size_t image_bytes;
};

/* A level of detail of a whole mesh. */
struct model_level {
	float error_m;      /* the largest error of any primitive */
	bool shadow_only;   /* see struct model_lod */
	int triangle_count; /* primitives without this level count with all
			       triangles */
};

/* Returns the number of levels of the primitive that has the most. */
int model_level_count(const struct model_mesh *mesh);

/* Returns the figures of a level, 0..model_level_count() - 1. */
struct model_level model_level(const struct model_mesh *mesh, int level);

/* Fills *out for a whole model. */
void model_measure(const struct model *model, struct model_stats *out);

/* Adds one mesh or one clip to stats, which the caller has zeroed. */
void model_stats_add_mesh(
	struct model_stats *stats, const struct model_mesh *mesh);
void model_stats_add_clip(
	struct model_stats *stats, const struct model_clip *clip);

#endif
