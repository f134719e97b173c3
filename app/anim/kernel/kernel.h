/*
 * The vertex loops behind one table of functions, struct kernel.
 *
 * A kernel does all work that is done for each vertex in each frame. The
 * program chooses a kernel at start. Callers own all arrays; a kernel allocates
 * nothing, keeps no state and calls no C library maths.
 */
#ifndef APP_ANIM_KERNEL_KERNEL_H
#define APP_ANIM_KERNEL_KERNEL_H

#include "app/anim/skin.h"

/* A weighted morph target: deltas of all vertices, any of them NULL. */
struct morph_term {
	float weight;
	const float (*position)[3];
	const float (*normal)[3];
	const float (*tangent)[3];
};

/* The input of skin_morphed(): a primitive's arrays and weighted targets. */
struct morph_input {
	const float (*position)[3];
	const float (*normal)[3];  /* or NULL */
	const float (*tangent)[4]; /* or NULL */
	const struct morph_term *term;
	int term_count;
	float position_scale;       /* factor of positions and their deltas */
	const mat4 *normal_palette; /* matrices for normals; NULL: those of the
				       palette */
};

/* The output of skin_morphed(). normal and tangent may be NULL. */
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
	 * The fixed-point loops (fixed.h), or NULL for a float kernel. All
	 * kernels have the float loops below.
	 */
	const struct fixed_loops *fixed;

	/*
	 * Skins stream.vertex_count vertices by the max_influences heaviest
	 * influences of each (0: all), whose weights are scaled to sum to 1.
	 * normal may be NULL and must be NULL if the stream has no normals.
	 * Normals are written with unit length.
	 */
	void (*skin)(const struct skin_stream *stream, const mat4 *palette,
		int max_influences, float (*position)[3], float (*normal)[3]);

	/*
	 * out = destiny * omega + source * (1 - omega) + offset, count vectors.
	 * out may be source.
	 */
	void (*morph_lerp)(int count, const float (*source)[3],
		const float (*destiny)[3], float omega, const float offset[3],
		float (*out)[3]);

	/*
	 * out = base + the sum of weight * delta. The deltas are the terms'
	 * normals if use_normals is set, else their positions. Terms with
	 * weight 0 or without deltas are skipped. out may be base.
	 */
	void (*morph_targets)(int count, const float (*base)[3],
		const struct morph_term *term, int term_count, bool use_normals,
		float (*out)[3]);

	/* Normalises each vector; a zero vector stays zero. */
	void (*normalize)(int count, float (*vector)[3]);

	/*
	 * Skins one direction of each vertex and normalises it. base is the
	 * stream's normal or tangent. max_influences is that of skin().
	 */
	void (*skin_directions)(const struct skin_stream *stream,
		const float (*base)[4], const mat4 *palette, int max_influences,
		float (*direction)[3]);

	/*
	 * Morphs and skins in one pass, which AN4044's conclusion recommends
	 * for the best quality. Only the stream's influences are used, not its
	 * base vectors. Apart from rounding, the result is that of
	 * morph_targets(), skin_stream_rebase() and skin() in sequence.
	 * Directions that output asks for must be present in input.
	 */
	void (*skin_morphed)(const struct skin_stream *stream,
		const struct morph_input *input, const mat4 *palette,
		int max_influences, const struct skin_output *output);

	/*
	 * bitangent = attribute.w * (normal x tangent): AN4044, Example 2.
	 * normal and tangent are the skinned ones, attribute is the primitive's
	 * tangent, whose w is the bitangent's sign.
	 */
	void (*bitangents)(int count, const float (*normal)[3],
		const float (*tangent)[3], const float (*attribute)[4],
		float (*bitangent)[3]);
};

/* The reference in plain C and float, which is built for every target. */
extern const struct kernel kernel_float;

/* The target's kernels by toolchain/sources.mk, best first, then NULL. */
extern const struct kernel *const kernel_registry[];

/* Returns the kernel of that name or NULL; for name NULL the first kernel. */
const struct kernel *kernel_find(const char *name);

#endif
