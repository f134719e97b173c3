/*
 * Matrix palette skinning, laid out as AN4044 section 3.1 describes it.
 *
 * Each influence of each vertex has a JointWeight and a base vector, which is
 * multiplied by the weight in advance. So a posed vertex is the sum matrix0 *
 * base0 + matrix1 * base1 + ... (Example 5 of AN4044). A vertex's influences
 * are sorted by descending weight, and the next_vertex_offset of each leads to
 * the next vertex's first influence, so that a loop can skip light influences
 * at no cost.
 */
#ifndef APP_ANIM_SKIN_H
#define APP_ANIM_SKIN_H

#include "app/model/model.h"

/* JointWeight of AN4044's Example 3. Offsets are in bytes. */
struct joint_weight {
	float weight;
	int32_t joint_offset;       /* of the joint's matrix in the palette */
	int32_t next_vertex_offset; /* from this influence to the next vertex's
				       first one */
};

enum {
	SKIN_INFLUENCES_MAX = 8
};

/* A skinned primitive laid out for the float loops. */
struct skin_stream {
	int vertex_count;
	int influence_count;                 /* of all vertices together */
	int max_influences;                  /* the most that one vertex has */
	int capped[SKIN_INFLUENCES_MAX + 1]; /* influence_count with a cap of
						[i] per vertex; [0] is 0 */
	struct joint_weight *influence;      /* [influence_count] */
	float (*position)[4];                /* weight * (x, y, z, 1) */
	float (*normal)[4];  /* weight * (x, y, z, 0), or NULL */
	float (*tangent)[4]; /* weight * (x, y, z, 0), or NULL */
};

struct skin_influence {
	float weight;
	uint16_t joint;
};

/*
 * Writes a vertex's influences by descending weight; equal ones stay in the
 * file's order. Weights of 0 or less are left out; if none is left, the
 * vertex's first joint gets all the weight. out has room for
 * SKIN_INFLUENCES_MAX. Returns how many were written, 1..SKIN_INFLUENCES_MAX.
 */
int skin_gather_influences(const struct model_primitive *primitive,
	uint32_t vertex, struct skin_influence *out);

/* Fills in the counts of a primitive's stream, without arrays. */
void skin_stream_count(
	struct skin_stream *stream, const struct model_primitive *primitive);

/*
 * Lays out a primitive that has influences, by skin_gather_influences().
 * Positions are multiplied by position_scale. The arena owns the arrays.
 * Returns 0 or -ENOMEM.
 */
int skin_stream_init(struct skin_stream *stream,
	const struct model_primitive *primitive, float position_scale,
	struct arena *arena);

/*
 * Adds the primitive's tangents, for bump mapping. Returns 0, -EINVAL if the
 * primitive has none, or -ENOMEM.
 */
int skin_stream_add_tangents(struct skin_stream *stream,
	const struct model_primitive *primitive, struct arena *arena);

/*
 * Rewrites the base vectors from other positions and normals, for morphing
 * before skinning. Both have the primitive's vertex_count vectors; normal may
 * be NULL.
 */
void skin_stream_rebase(struct skin_stream *stream, const float (*position)[3],
	const float (*normal)[3], float position_scale);

/* Bytes of the stream, for reports. */
size_t skin_stream_bytes(const struct skin_stream *stream);

#endif
