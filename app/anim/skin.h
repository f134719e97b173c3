/*
 * Matrix palette skinning, laid out as AN4044 section 3.1 describes it.
 *
 * For each influence of each vertex there is a JointWeight and a base vector
 * that is already multiplied by the weight, so that a vertex is the plain sum
 * matrix0 * base0 + matrix1 * base1 + ... (its Example 5). Influences are
 * sorted by decreasing weight; next_vertex_offset leads from any of them to
 * the first of the next vertex, which makes capping their number free.
 */
#ifndef APP_ANIM_SKIN_H
#define APP_ANIM_SKIN_H

#include "app/model/model.h"

/* Example 3 of the document; offsets in bytes. */
struct joint_weight {
	float weight;
	int32_t joint_offset;       /* from the palette's first matrix */
	int32_t next_vertex_offset; /* from this one to the next vertex's first;
				       sizeof(struct joint_weight) at the last
				       influence */
};

enum {
	SKIN_INFLUENCES_MAX = 8
};

/* A skinned primitive made ready for the vertex loops. */
struct skin_stream {
	int vertex_count;
	int influence_count;                 /* of all vertices together */
	int max_influences;                  /* of any one vertex */
	int capped[SKIN_INFLUENCES_MAX + 1]; /* influences left at each cap */
	struct joint_weight *influence;      /* [influence_count] */
	float (*position)[4];                /* weight * (x, y, z, 1) */
	float (*normal)[4];  /* weight * (x, y, z, 0), or NULL */
	float (*tangent)[4]; /* the same, or NULL until asked for */
};

struct skin_influence {
	float weight;
	uint16_t joint;
};

/*
 * A vertex's influences by descending weight, equal ones in the file's order.
 * Weights that are not above 0 are left out; if none is left, the vertex's first
 * joint gets all the weight. Returns their number, 1..SKIN_INFLUENCES_MAX.
 */
int skin_gather_influences(const struct model_primitive *primitive,
	uint32_t vertex, struct skin_influence *out);

/* The counts that a primitive's stream has, and no arrays. */
void skin_stream_count(
	struct skin_stream *stream, const struct model_primitive *primitive);

/*
 * Builds the stream of a primitive that has influences. Zero weights are left
 * out. Positions are multiplied by position_scale. 0 or -ENOMEM.
 */
int skin_stream_init(struct skin_stream *stream,
	const struct model_primitive *primitive, float position_scale,
	struct arena *arena);

/*
 * Adds the primitive's tangents, for bump mapping. 0, -EINVAL when it has
 * none, or -ENOMEM.
 */
int skin_stream_add_tangents(struct skin_stream *stream,
	const struct model_primitive *primitive, struct arena *arena);

/*
 * Rewrites the base vectors from other positions and normals, as morphing
 * before skinning needs; shapes as in the primitive, normal may be NULL.
 */
void skin_stream_rebase(struct skin_stream *stream, const float (*position)[3],
	const float (*normal)[3], float position_scale);

/* Bytes of the stream, for `limber info`. */
size_t skin_stream_bytes(const struct skin_stream *stream);

#endif
