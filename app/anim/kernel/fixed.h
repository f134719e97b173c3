/*
 * The fixed-point vertex loops and the formats of what they read and write.
 *
 * The ARM1136's floating-point unit is slow, but its multiplier makes two
 * products of 16 bits at a time (SMLAD; pmaddwd on a PC). All formats are made
 * for it; numbers.md says why each of them is as it is.
 *
 * Work is done in three steps. layout/ prepares a primitive at load, and again
 * when the cap on influences changes. run/ converts matrices and weights into
 * 16 bits once a frame and checks ranges: numbers that do not fit are made
 * coarser and never wrap. Then the loops of struct fixed_loops run. All
 * kernels' loops give the same bits.
 */
#ifndef APP_ANIM_KERNEL_FIXED_H
#define APP_ANIM_KERNEL_FIXED_H

#include <stdbool.h>
#include <stdint.h>

/* The attributes of a vertex. Normals and tangents are directions. */
enum fixed_attribute {
	FIXED_POSITION,
	FIXED_NORMAL,
	FIXED_TANGENT,
	FIXED_ATTRIBUTES
};

/* Flags for what is wanted of a skin or a morph besides positions. */
enum fixed_streams {
	FIXED_NORMALS = 1 << FIXED_NORMAL,
	FIXED_TANGENTS = 1 << FIXED_TANGENT,
	FIXED_TIERS = 1 << FIXED_ATTRIBUTES /* a skin in tiers, fixed_skin.h */
};

/*
 * The output of the loops. As a GL array it is 3 GL_SHORT from &vector->x at a
 * stride of sizeof(struct fixed_vector). Aligned to 8 bytes. Directions have no
 * particular length: the code that lights them normalises them.
 */
struct fixed_vector {
	int16_t fraction; /* the bits below x, for the loops alone */
	int16_t x, y, z;
};

/*
 * What positions mean: vector * scale + offset, in the unit of the palette or
 * of the key frames.
 */
struct fixed_placement {
	float scale; /* above 0 */
	float offset[3];
};

static inline void fixed_placement_apply(const struct fixed_placement *placement,
	const struct fixed_vector *vector, float out[3])
{
	out[0] = (float)vector->x * placement->scale + placement->offset[0];
	out[1] = (float)vector->y * placement->scale + placement->offset[1];
	out[2] = (float)vector->z * placement->scale + placement->offset[2];
}

/*
 * An influence: a vector times its weight, and the weight, see
 * layout/fixed_skin.h. Aligned to 8 bytes.
 */
struct fixed_base {
	int16_t x, y, z, w;
};

/* A joint's matrix, in rows m0 m1 m2 t; 32 bytes. Aligned to 8 bytes. */
struct fixed_matrix {
	int16_t row[3][4];
	int16_t unused[4];
};

/*
 * Vertices with the same number of influences, in runs with the same joints.
 * A run is 1 + influences words: the number of its vertices, at least 1, and
 * the offset in bytes of each joint's matrix in the palette.
 */
struct fixed_group {
	int influences; /* 1..8 */
	int run_count;
	const int32_t *run;
};

/*
 * One coordinate of two key frames or of two targets, which one multiplication
 * weighs. A vertex is three of them.
 */
struct fixed_pair {
	int16_t a, b;
};

struct fixed_weights {
	int16_t a, b;
};

/*
 * A vertex of a key frame: each number times -2, as in the pairs that a lerp
 * reads. An array of them is aligned to 4 bytes and has an even length.
 */
struct fixed_key {
	int16_t x, y, z;
};

/* A sum of targets, in 2^-16 of a fixed_vector's unit. */
struct fixed_sum {
	int32_t x, y, z;
};

/* An influence of a vertex that targets move. */
struct fixed_rebase {
	struct fixed_base rest; /* the base vector without any target */
	uint32_t base_index;    /* of the base vector in its stream */
	uint16_t delta_index;   /* of the vertex's delta */
	int16_t weight_q16;     /* of the delta, in the base vector's unit */
};

enum {
	/* A half, as the fraction of the vectors that morph_pair() and
	   morph_begin() start from, for rounding. */
	FIXED_HALF = -32768
};

struct fixed_loops {
	/*
	 * Skins one stream (positions, normals or tangents): out = the sum of
	 * matrix * base over a vertex's influences, >> 16. base has the
	 * influences of all groups in order and one more of any content, which
	 * may be loaded. out has a vector a vertex. Nothing wraps with matrices
	 * of fixed_palette_make().
	 */
	void (*skin)(const struct fixed_group *group, int group_count,
		const struct fixed_base *base,
		const struct fixed_matrix *palette, struct fixed_vector *out);

	/* out = (pair.a * weights.a + pair.b * weights.b + 2^15) >> 16. */
	void (*lerp)(int count, const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_vector *out);

	/*
	 * The same between two key frames that are stored one after the other:
	 * half the memory, and no pairs to prepare when the keys change. With
	 * an odd count one more key of each is loaded.
	 */
	void (*lerp_keys)(int count, const struct fixed_key *source,
		const struct fixed_key *destiny, struct fixed_weights weights,
		struct fixed_vector *out);

	/*
	 * vector += step, each number clamped to 16 bits: AN4044's morphing by
	 * frames (1.2.2), which `limber bench` compares.
	 */
	void (*increment)(int count, const struct fixed_vector *step,
		struct fixed_vector *vector);

	/*
	 * out = base + (pair.a * weights.a + pair.b * weights.b) >> 16, with
	 * base's fraction for rounding. out may be base.
	 */
	void (*morph_pair)(int count, const struct fixed_vector *base,
		const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_vector *out);

	/* The same for many pairs: begin, add each pair, end. */
	void (*morph_begin)(int count, const struct fixed_vector *base,
		struct fixed_sum *sum);
	void (*morph_add)(int count, const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_sum *sum);
	void (*morph_end)(int count, const struct fixed_sum *sum,
		struct fixed_vector *out);

	/*
	 * base[base_index] = rest + (delta[delta_index] * weight_q16 + 2^15)
	 * >> 16 in x, y and z; w stays rest's.
	 */
	void (*rebase)(int count, const struct fixed_rebase *rebase,
		const struct fixed_vector *delta, struct fixed_base *base);
};

/* Plain C. The assembly gives the same bits. */
extern const struct fixed_loops fixed_loops_c;

#endif
