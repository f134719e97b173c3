/*
 * Targets of positions, normals and tangents, of numbers that a test holds.
 */
#ifndef TESTS_UNIT_APP_ANIM_KERNEL_TARGET_VIEWS_H
#define TESTS_UNIT_APP_ANIM_KERNEL_TARGET_VIEWS_H

#include "app/model/model_deltas.h"

/*
 * Makes count targets that view delta, which is float[count][3][vertices][3]
 * and must outlive them.
 */
static inline void target_views(struct model_target *target, int count,
	const float *delta, int vertices)
{
	for (int t = 0; t < count; t++) {
		struct model_deltas *deltas[] = {&target[t].position,
			&target[t].normal, &target[t].tangent};

		for (int a = 0; a < 3; a++) {
			*deltas[a] = model_deltas_view(
				(const float(*)[3])delta, vertices);
			delta += 3 * vertices;
		}
	}
}

#endif
