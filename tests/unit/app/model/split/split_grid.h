/*
 * A grid of vertices and triangles, for the tests of their division.
 */
#ifndef TESTS_UNIT_APP_MODEL_SPLIT_SPLIT_GRID_H
#define TESTS_UNIT_APP_MODEL_SPLIT_SPLIT_GRID_H

#include "app/model/model.h"
#include "tests/support/test.h"

#include <string.h>

/* A grid of vertices, of which the first rows have triangles. */
struct grid {
	struct arena arena;
	struct model_primitive primitive;
};

static void grid_begin(struct grid *grid, int width, int height, int used_rows)
{
	struct model_primitive *primitive = &grid->primitive;
	int count = 0;

	*grid = (struct grid){.arena = arena_empty()};
	primitive->vertex_count = width * height;
	primitive->position = arena_alloc(&grid->arena,
		(size_t)primitive->vertex_count, sizeof(float[3]));
	primitive->index = ARENA_ARRAY(
		&grid->arena, uint32_t, 6 * (size_t)primitive->vertex_count);
	assert_non_null(primitive->position);
	assert_non_null(primitive->index);
	for (int v = 0; v < primitive->vertex_count; v++) {
		/* Neighbours in memory are far from each other. */
		primitive->position[v][0] = (float)(v * 7919 % width);
		primitive->position[v][1] = (float)(v / width);
	}
	for (int v = 0; v + width + 1 < width * used_rows; v++) {
		const uint32_t corner[] = {(uint32_t)v, (uint32_t)v + 1,
			(uint32_t)(v + width), (uint32_t)v + 1,
			(uint32_t)(v + width + 1), (uint32_t)(v + width)};

		memcpy(primitive->index + count, corner, sizeof(corner));
		count += 6;
	}
	primitive->index_count = count;
}

#endif
