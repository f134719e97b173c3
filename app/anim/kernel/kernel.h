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
};

struct kernel {
	const char *name;
	const char *summary;

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
};

/* The reference, plain C in float; always built in. */
extern const struct kernel kernel_float;

/* All kernels built in, best first, NULL at the end. */
extern const struct kernel *const kernel_registry[];

/* The kernel of that name, or the first one for NULL; NULL when unknown. */
const struct kernel *kernel_find(const char *name);

#endif
