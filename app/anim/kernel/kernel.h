/*
 * The vertex loops, behind one table.
 *
 * Everything that runs once a vertex and frame is here and nowhere else; one
 * table picks an implementation at start. Callers own all arrays; a kernel
 * allocates nothing, keeps nothing and calls no C library maths.
 */
#ifndef APP_ANIM_KERNEL_KERNEL_H
#define APP_ANIM_KERNEL_KERNEL_H

#include "app/anim/skin.h"

/* One weighted target of a morph; deltas may be NULL. */
struct morph_term {
	float weight;
	const float (*position)[3];
	const float (*normal)[3];
	const float (*tangent)[3];
};

/* What is morphed before it is skinned: a primitive's own arrays and terms. */
struct morph_input {
	const float (*position)[3];
	const float (*normal)[3];  /* or NULL */
	const float (*tangent)[4]; /* or NULL */
	const struct morph_term *term;
	int term_count;
	float position_scale; /* of positions, deltas included */
};

/* What is wanted of a vertex; position always, the others or NULL. */
struct skin_output {
	float (*position)[3];
	float (*normal)[3];
	float (*tangent)[3];
};

struct fixed_loops;

struct kernel {
	const char *name;
	const char *summary;

	/*
	 * The loops in fixed point (fixed.h), or NULL where the kernel is for
	 * float. Those below are there in any case, and in float.
	 */
	const struct fixed_loops *fixed;

	/*
	 * Skins stream.vertex_count vertices. At most max_influences of each
	 * are used (0: all); the weights of those that are left count as if
	 * they summed to one. normal may be NULL, and must be where the stream
	 * has none; normals come out unit length.
	 */
	void (*skin)(const struct skin_stream *stream, const mat4 *palette,
		int max_influences, float (*position)[3], float (*normal)[3]);

	/*
	 * out = destiny * omega + source * (1 - omega) + offset, a
	 * three-component array at a time. out may be source.
	 */
	void (*morph_lerp)(int count, const float (*source)[3],
		const float (*destiny)[3], float omega, const float offset[3],
		float (*out)[3]);

	/*
	 * out = base + the sum of weight * delta. Terms of weight 0 are
	 * skipped. which selects the terms' positions or normals.
	 */
	void (*morph_targets)(int count, const float (*base)[3],
		const struct morph_term *term, int term_count, bool use_normals,
		float (*out)[3]);

	/* Makes each vector unit length; a zero vector stays zero. */
	void (*normalize)(int count, float (*vector)[3]);

	/*
	 * Skins the stream's tangents, which must be there; they come out
	 * unit length. max_influences as for skin().
	 */
	void (*skin_tangents)(const struct skin_stream *stream,
		const mat4 *palette, int max_influences, float (*tangent)[3]);

	/*
	 * Morphs and skins in one pass, as AN4044's conclusion recommends for
	 * the best looks: each vertex is morphed, then carried by the stream's
	 * influences, whose base vectors are not used. The same as
	 * morph_targets(), skin_stream_rebase() and skin() one after the
	 * other, within rounding. Only what input has may be wanted.
	 */
	void (*skin_morphed)(const struct skin_stream *stream,
		const struct morph_input *input, const mat4 *palette,
		int max_influences, const struct skin_output *output);

	/*
	 * bitangent = attribute.w * (normal x tangent): AN4044, Example 2.
	 * normal and tangent are posed ones, attribute the primitive's.
	 */
	void (*bitangents)(int count, const float (*normal)[3],
		const float (*tangent)[3], const float (*attribute)[4],
		float (*bitangent)[3]);
};

/* The reference, plain C in float; always built in. */
extern const struct kernel kernel_float;

/* All kernels built in, best first, NULL at the end: toolchain/sources.mk. */
extern const struct kernel *const kernel_registry[];

/* The kernel of that name, or the first one for NULL; NULL when unknown. */
const struct kernel *kernel_find(const char *name);

#endif
