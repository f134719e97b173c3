#include "tests/support/gl/twins.h"

#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

void twins_need_assembly(void)
{
#ifndef __arm__
	skip_because("there is only C here: the ARM build tests its assembly");
#endif
}

struct twins *twins_make(uint32_t *seed)
{
	struct twins *twins = calloc(1, sizeof(*twins));

	assert_non_null(twins);
	for (int i = 0; i < TWINS_PIXELS; i++) {
		twins->depth[0][i] = (uint16_t)next_random(seed);
		twins->pixel[0][i] = (uint16_t)next_random(seed);
	}
	memcpy(twins->depth[1], twins->depth[0], sizeof(twins->depth[0]));
	memcpy(twins->pixel[1], twins->pixel[0], sizeof(twins->pixel[0]));
	return twins;
}

void twins_place(const struct twins *twins, int which, uintptr_t *depth,
	uintptr_t *pixels)
{
	*depth = (uintptr_t)(twins->depth[which] + TWINS_ROW * TWINS_SIDE);
	*pixels = (uintptr_t)twins->pixel[which] -
		(uintptr_t)twins->depth[which] - 2;
}

void twins_edges(
	uint32_t *seed, int low, int high, uint32_t edge[2], uint32_t step[2])
{
	for (int side = 0; side < 2; side++) {
		int from = random_between(seed, low, high);
		int to = random_between(seed, low, high);

		edge[side] = (uint32_t)(from * 65536 + 0x7FFF);
		step[side] = (uint32_t)((to - from) * 65536 / TWINS_ROWS);
	}
}

void twins_check(struct twins *twins)
{
	assert_memory_equal(
		twins->depth[0], twins->depth[1], sizeof(twins->depth[0]));
	assert_memory_equal(
		twins->pixel[0], twins->pixel[1], sizeof(twins->pixel[0]));
	assert_memory_equal(twins->stencil[0], twins->stencil[1],
		sizeof(twins->stencil[0]));
	free(twins);
}
