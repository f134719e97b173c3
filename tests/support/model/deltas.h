/*
 * Comparing the displacements of a morph target.
 */
#ifndef TESTS_SUPPORT_MODEL_DELTAS_H
#define TESTS_SUPPORT_MODEL_DELTAS_H

#include "app/model/model_deltas.h"
#include "tests/support/test.h"

/* Asserts that the deltas of count vertices are exactly those expected. */
static inline void assert_deltas(const struct model_deltas *deltas,
	const float (*expected)[3], int count)
{
	assert_int_equal(deltas->vertex_count, count);
	for (int v = 0; v < count; v++) {
		float got[3];

		model_deltas_get(deltas, v, got);
		for (int k = 0; k < 3; k++) {
			assert_near(got[k], expected[v][k], 0);
		}
	}
}

#endif
