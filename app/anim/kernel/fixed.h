/*
 * The fixed-point vertex loops and the formats of their input and output.
 *
 * The ARM1136's floating-point unit is slow, but its multiplier makes two
 * products of 16 bits at a time (SMLAD; pmaddwd on a PC). All formats are made
 * for this instruction; numbers.md gives the reasons for each format.
 *
 * Work is done in three steps. layout/ prepares a primitive at load, and again
 * when the cap on influences changes. run/ converts matrices and weights into
 * 16 bits once a frame and checks ranges: if numbers do not fit, their scale is
 * reduced, so that nothing wraps. Then the loops of struct fixed_loops run. The
 * loops of all kernels give the same bits.
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

/* Flags for what a skin or a morph computes besides positions. */
enum fixed_streams {
	FIXED_NORMALS = 1 << FIXED_NORMAL,
	FIXED_TANGENTS = 1 << FIXED_TANGENT,
	FIXED_TIERS = 1 << FIXED_ATTRIBUTES /* vertices of a skin sorted into
					       tiers, see fixed_skin.h */
};

/*
 * The output of the loops, aligned to 8 bytes. GL reads an array of these as 3
 * GL_SHORT from &vector->x at a stride of sizeof(struct fixed_vector).
 * Directions have no particular length: lighting normalises them.
 */
struct fixed_vector {
	int16_t fraction; /* the 16 bits below x; only the loops use it */
	int16_t x, y, z;
};

/*
 * How to convert positions to floats: vector * scale + offset is a position in
 * the unit of the palette or of the key frames.
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
 * One influence of a vertex: x, y, z are the vertex's vector times the weight,
 * w is -2 times the weight in Q14, or 0 for directions. Aligned to 8 bytes.
 */
struct fixed_base {
	int16_t x, y, z, w;
};

/*
 * A joint's matrix: three rows m0 m1 m2 t, where t is the translation, negated
 * for the negative weights. 32 bytes, aligned to 8 bytes.
 */
struct fixed_matrix {
	int16_t row[3][4];
	int16_t unused[4];
};

/*
 * Vertices with the same number of influences, in runs of vertices with the
 * same joints. A run is described by 1 + influences words: the number of its
 * vertices, at least 1, and the offset in bytes of each joint's matrix in the
 * palette.
 */
struct fixed_group {
	int influences; /* 1..8 */
	int run_count;
	const int32_t *run;
};

/*
 * One coordinate of two key frames or of two targets' deltas, so that one SMLAD
 * weighs both. A vertex has three of them.
 */
struct fixed_pair {
	int16_t a, b;
};

struct fixed_weights {
	int16_t a, b;
};

/*
 * A vertex of a key frame. Each number is stored times -2, as in the pairs that
 * lerp() reads. An array of these is aligned to 4 bytes and has an even length.
 */
struct fixed_key {
	int16_t x, y, z;
};

/* A vertex while targets are added, with 16 more bits of fraction. */
struct fixed_sum {
	int32_t x, y, z;
};

/* One influence of a vertex that targets move, for the loop rebase(). */
struct fixed_rebase {
	struct fixed_base rest; /* the base vector at target weights of 0 */
	uint32_t base_index;    /* index of the base vector in its stream */
	uint16_t delta_index;   /* index of the vertex's delta in the array
				   delta */
	int16_t weight_q16;     /* factor of the delta: the influence's weight
				   times the ratio of the units, in Q16 */
};

enum {
	/* A half. The base vectors of morph_pair() and morph_begin() have it as
	   fraction, so that results are rounded. */
	FIXED_HALF = -32768
};

struct fixed_loops {
	/*
	 * Skins one stream (positions, normals or tangents): out = the sum of
	 * matrix * base over a vertex's influences, >> 16. base has the
	 * influences of all groups in order, and one more of any content, since
	 * a loop may load one too many. out has one vector per vertex. With
	 * matrices of fixed_palette_make() no sum wraps.
	 */
	void (*skin)(const struct fixed_group *group, int group_count,
		const struct fixed_base *base,
		const struct fixed_matrix *palette, struct fixed_vector *out);

	/* out = (pair.a * weights.a + pair.b * weights.b + 2^15) >> 16. */
	void (*lerp)(int count, const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_vector *out);

	/*
	 * The same between two key frames that are not interleaved: this takes
	 * half the memory, and no pairs are prepared when the keys change. If
	 * count is odd, one more fixed_key of each is loaded.
	 */
	void (*lerp_keys)(int count, const struct fixed_key *source,
		const struct fixed_key *destiny, struct fixed_weights weights,
		struct fixed_vector *out);

	/*
	 * vector += step, where each number, the fraction too, is clamped to 16
	 * bits: AN4044's morphing by frames (1.2.2), for `limber bench`.
	 */
	void (*increment)(int count, const struct fixed_vector *step,
		struct fixed_vector *vector);

	/*
	 * out = (base * 2^16 + base.fraction + pair.a * weights.a + pair.b *
	 * weights.b) >> 16 in x, y and z. out may be base.
	 */
	void (*morph_pair)(int count, const struct fixed_vector *base,
		const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_vector *out);

	/*
	 * The same for many pairs: morph_begin(), morph_add() for each pair,
	 * morph_end().
	 */
	void (*morph_begin)(int count, const struct fixed_vector *base,
		struct fixed_sum *sum);
	void (*morph_add)(int count, const struct fixed_pair (*pair)[3],
		struct fixed_weights weights, struct fixed_sum *sum);
	void (*morph_end)(int count, const struct fixed_sum *sum,
		struct fixed_vector *out);

	/*
	 * For each rebase: base[base_index] = rest + ((delta[delta_index] *
	 * weight_q16 + 2^15) >> 16) in x, y and z; w is that of rest.
	 */
	void (*rebase)(int count, const struct fixed_rebase *rebase,
		const struct fixed_vector *delta, struct fixed_base *base);
};

/* The loops in plain C. The assembly gives the same bits. */
extern const struct fixed_loops fixed_loops_c;

#endif
