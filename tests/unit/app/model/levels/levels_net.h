/*
 * A model made of nets of quads, for tests of levels of detail.
 */
#ifndef TESTS_UNIT_APP_MODEL_LEVELS_LEVELS_NET_H
#define TESTS_UNIT_APP_MODEL_LEVELS_LEVELS_NET_H

#include "app/model/model.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	SIDE = 40, /* quads along each side of a net */
	ROW = SIDE + 1,
	COUNT = ROW * ROW,
	INDICES = SIDE * SIDE * 6,
};

/* A net of quads, which a function bends and colours. */
struct net {
	struct model *model;
	struct model_primitive *primitive;
};

typedef void (*shape_function)(
	float u, float v, float position[3], float normal[3], uint8_t color[4]);

static inline void list_triangles(uint32_t *next)
{
	for (uint32_t row = 0; row < SIDE; row++) {
		for (uint32_t column = 0; column < SIDE; column++) {
			uint32_t i = row * ROW + column;
			const uint32_t corner[6] = {
				i, i + 1, i + ROW, i + ROW, i + 1, i + ROW + 1};

			memcpy(next, corner, sizeof(corner));
			next += 6;
		}
	}
}

static inline void fill(struct model *model, struct model_primitive *primitive,
	shape_function shape, float shift)
{
	struct arena *arena = &model->arena;

	primitive->vertex_count = COUNT;
	primitive->index_count = INDICES;
	primitive->position = arena_alloc(arena, COUNT, sizeof(float[3]));
	primitive->normal = arena_alloc(arena, COUNT, sizeof(float[3]));
	primitive->color = arena_alloc(arena, COUNT, 4);
	primitive->index = ARENA_ARRAY(arena, uint32_t, INDICES);
	list_triangles(primitive->index);
	for (int i = 0; i < COUNT; i++) {
		shape((float)(i % ROW) / SIDE, (float)(i / ROW) / SIDE,
			primitive->position[i], primitive->normal[i],
			primitive->color[i]);
		primitive->position[i][0] += shift;
	}
}

/* primitives stand side by side, each from x = its number on. */
static inline struct net make_net(shape_function shape, int primitives)
{
	struct model *model = calloc(1, sizeof(*model));
	struct net net = {.model = model};

	assert_non_null(model);
	model->arena = arena_empty();
	model->mesh_count = 1;
	model->mesh = ARENA_NEW(&model->arena, struct model_mesh);
	net.primitive = ARENA_ARRAY(
		&model->arena, struct model_primitive, (size_t)primitives);
	model->mesh->primitive_count = primitives;
	model->mesh->primitive = net.primitive;
	for (int i = 0; i < primitives; i++) {
		fill(model, &net.primitive[i], shape, (float)i);
	}
	return net;
}

static inline void free_net(struct net *net)
{
	arena_release(&net->model->arena);
	free(net->model);
}

static inline void shape_flat(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	position[0] = u;
	position[1] = v;
	normal[2] = 1.0f;
	memset(color, 255, 4);
}

static inline bool has_vertex(const struct model_lod *lod, uint32_t vertex)
{
	for (int i = 0; i < lod->index_count; i++) {
		if (lod->index[i] == vertex) {
			return true;
		}
	}
	return false;
}

#endif
