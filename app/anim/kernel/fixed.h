/*
 * The fixed-point vertex loops.
 *
 * A core without much of a floating-point unit has a multiplier that takes two
 * 16-bit products at a time (SMLAD; pmaddwd on a PC). Everything here is laid
 * out for it. README.md tells why each number is what it is.
 *
 * A posed vector is a struct fixed_vector of 16-bit numbers; a placement says
 * what they mean:  vector * scale + offset  (a position in the unit of the
 * palette, or of the key frames). Directions have no placement: they come out
 * at no particular length, and want normalising by whoever lights them.
 *
 * There are three steps. Preparing (fixed_skin.h, fixed_morph.h) happens at
 * load and reserves memory in an arena. Once a frame, matrices or weights are
 * brought into 16 bits, with a check of ranges: what does not fit makes the
 * numbers coarser and never wraps. Then the loops of struct fixed_loops run.
 * The loops of all kernels give the same bits.
 */
#ifndef APP_ANIM_KERNEL_FIXED_H
#define APP_ANIM_KERNEL_FIXED_H

#include <stdbool.h>
#include <stdint.h>

/* What a vertex has; and what is wanted besides positions. */
enum fixed_attribute {
	FIXED_POSITION,
	FIXED_NORMAL,
	FIXED_TANGENT,
	FIXED_ATTRIBUTES
};

enum fixed_streams {
	FIXED_NORMALS = 1 << FIXED_NORMAL,
	FIXED_TANGENTS = 1 << FIXED_TANGENT
};

/*
 * What a loop writes. As a GL array: 3 GL_SHORT from &vector->x at a stride of
 * sizeof(struct fixed_vector). Aligned to 8 bytes.
 */
struct fixed_vector {
	int16_t fraction; /* of x, below its last bit: not for use */
	int16_t x, y, z;
};

struct fixed_placement {
	float scale; /* above 0 */
	float offset[3];
};

/* v * w and w of an influence, see fixed_skin.h. Aligned to 8 bytes. */
struct fixed_base {
	int16_t x, y, z, w;
};

/* A joint's matrix, in rows m0 m1 m2 t; 32 bytes. Aligned to 8 bytes. */
struct fixed_matrix {
	int16_t row[3][4];
	int16_t unused[4];
};

/*
 * Vertices that have the same number of influences, in runs that have the
 * same joints: each run is 1 + influences words, the number of its vertices
 * (at least 1) and the bytes from the palette's beginning to each joint.
 */
struct fixed_group {
	int influences; /* 1..8 */
	int run_count;
	const int32_t *run;
};

/*
 * A component of two key frames or of two targets, which one multiplication
 * weighs. A vertex is three of them.
 */
struct fixed_pair {
	int16_t a, b;
};

struct fixed_weights {
	int16_t a, b;
};

/* A vertex while targets are added, in 2^16 of a fixed_vector's unit. */
struct fixed_sum {
	int32_t x, y, z;
};

/* An influence of a vertex that targets move, see fixed_skin_morph.h. */
struct fixed_rebase {
	struct fixed_base rest; /* without any target */
	uint32_t at;            /* which base vector it is */
	uint16_t moved;         /* which of the moved vertices */
	int16_t weight_q16;     /* of what that moved, in the base's unit */
};

enum {
	/* In the fraction of vectors that morph_pair() and morph_begin() start
	   from: a half, for rounding. */
	FIXED_HALF = -32768
};

struct fixed_loops {
	/*
	 * Skins one stream of base vectors (positions, normals or tangents):
	 * out = the sum over its influences of matrix * base, >> 16. base has
	 * the influences of all groups one after the other, and one more of
	 * any content, which may be loaded; out a vector a vertex. Nothing
	 * wraps that fixed_palette_make() let through.
	 */
	void (*skin)(const struct fixed_group *group, int group_count,
		const struct fixed_base *base,
		const struct fixed_matrix *palette, struct fixed_vector *out);

	/* out = (pair.a * weights.a + pair.b * weights.b + 2^15) >> 16. */
	void (*lerp)(int count, const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_vector *out);

	/* vector += step, each number for itself, stopping at the ends. */
	void (*increment)(int count, const struct fixed_vector *step,
		struct fixed_vector *vector);

	/*
	 * out = base + (pair.a * weights.a + pair.b * weights.b) >> 16, with
	 * base's fraction for rounding. out may be base.
	 */
	void (*morph_pair)(int count, const struct fixed_vector *base,
		const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_vector *out);

	/* The same for many pairs: begin, add each, end. */
	void (*morph_begin)(int count, const struct fixed_vector *base,
		struct fixed_sum *sum);
	void (*morph_add)(int count, const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_sum *sum);
	void (*morph_end)(int count, const struct fixed_sum *sum,
		struct fixed_vector *out);

	/*
	 * base[at] = rest + (delta[moved] * weight_q16 + 2^15) >> 16; w stays
	 * rest's.
	 */
	void (*rebase)(int count, const struct fixed_rebase *rebase,
		const struct fixed_vector *delta, struct fixed_base *base);
};

/* Plain C; the assembly must give the same. */
extern const struct fixed_loops fixed_loops_c;

#endif
