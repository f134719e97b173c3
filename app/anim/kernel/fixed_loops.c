/*
 * The fixed-point loops in portable C.
 */
#include "app/anim/kernel/fixed.h"

#include <string.h>

enum {
	INFLUENCES_MAX = 8
};

/* As SMLAD has it: should a sum not fit, it wraps and is nothing worse. */
static inline uint32_t dot(const int16_t row[4], const struct fixed_base *base)
{
	return (uint32_t)(row[0] * base->x) + (uint32_t)(row[1] * base->y) +
		(uint32_t)(row[2] * base->z) + (uint32_t)(row[3] * base->w);
}

static inline int16_t upper(uint32_t sum)
{
	return (int16_t)(sum >> 16);
}

static inline struct fixed_vector skin_vertex(int influences,
	const struct fixed_base *base, const struct fixed_matrix *matrix)
{
	uint32_t x = 0, y = 0, z = 0;

	for (int i = 0; i < influences; i++) {
		x += dot(matrix[i].row[0], &base[i]);
		y += dot(matrix[i].row[1], &base[i]);
		z += dot(matrix[i].row[2], &base[i]);
	}
	return (struct fixed_vector){(int16_t)x, upper(x), upper(y), upper(z)};
}

/* Inlined for each number of influences, so that inner loops unroll. */
static inline void skin_run(int influences, int count,
	const struct fixed_base *base, const struct fixed_matrix *matrix,
	struct fixed_vector *out)
{
	for (int v = 0; v < count; v++) {
		out[v] = skin_vertex(influences, base + v * influences, matrix);
	}
}

static void skin_run_of(int influences, int count, const struct fixed_base *base,
	const struct fixed_matrix *matrix, struct fixed_vector *out)
{
	switch (influences) {
	case 1:
		skin_run(1, count, base, matrix, out);
		break;
	case 2:
		skin_run(2, count, base, matrix, out);
		break;
	case 3:
		skin_run(3, count, base, matrix, out);
		break;
	case 4:
		skin_run(4, count, base, matrix, out);
		break;
	default:
		skin_run(influences, count, base, matrix, out);
		break;
	}
}

static void skin(const struct fixed_group *group, int group_count,
	const struct fixed_base *base, const struct fixed_matrix *palette,
	struct fixed_vector *out)
{
	for (int g = 0; g < group_count; g++) {
		const int32_t *run = group[g].run;
		int influences = group[g].influences;

		for (int r = 0; r < group[g].run_count; r++) {
			struct fixed_matrix matrix[INFLUENCES_MAX];
			int count = *run++;

			for (int i = 0; i < influences; i++) {
				memcpy(&matrix[i],
					(const char *)palette + *run++,
					sizeof(matrix[i]));
			}
			skin_run_of(influences, count, base, matrix, out);
			base += (size_t)count * (size_t)influences;
			out += count;
		}
	}
}

const struct fixed_loops fixed_loops_c = {
	.skin = skin,
};
