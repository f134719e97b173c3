/* Borders of levels of detail: parts that overlap show no gaps between them. */
#include "app/model/levels/levels.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	SIDE = 40, /* quads along each side */
	ROW = SIDE + 1,
	COUNT = ROW * ROW,
	INDICES = SIDE * SIDE * 6,
};

static void list_triangles(uint32_t *next)
{
	for (uint32_t i = 0; i < SIDE * SIDE; i++) {
		uint32_t a = i / SIDE * ROW + i % SIDE;
		const uint32_t corner[6] = {
			a, a + 1, a + ROW, a + ROW, a + 1, a + ROW + 1};

		memcpy(next + 6 * i, corner, sizeof(corner));
	}
}

/* A flat band between two arcs. */
static struct model *make_band(void)
{
	struct model *model = calloc(1, sizeof(*model));
	struct model_primitive *band;

	assert_non_null(model);
	model->arena = arena_empty();
	model->mesh_count = 1;
	model->mesh = ARENA_NEW(&model->arena, struct model_mesh);
	band = ARENA_NEW(&model->arena, struct model_primitive);
	model->mesh->primitive_count = 1;
	model->mesh->primitive = band;
	band->vertex_count = COUNT;
	band->index_count = INDICES;
	band->position = arena_alloc(&model->arena, COUNT, sizeof(float[3]));
	band->normal = arena_alloc(&model->arena, COUNT, sizeof(float[3]));
	band->index = ARENA_ARRAY(&model->arena, uint32_t, INDICES);
	list_triangles(band->index);
	for (int i = 0; i < COUNT; i++) {
		float u = (float)(i % ROW) / SIDE;

		band->position[i][0] = u;
		band->position[i][1] =
			(float)(i / ROW) / SIDE + 0.2f * sinf(u * 3.1415927f);
		band->normal[i][2] = 1.0f;
	}
	return model;
}

/* How far a border's vertices are above those of a level, in row 0. */
static float find_border_gap(
	const struct model_primitive *primitive, const struct model_lod *lod)
{
	bool used[ROW] = {false};
	float most = 0.0f;
	int from = 0;

	for (int i = 0; i < lod->index_count; i++) {
		if (lod->index[i] < ROW) {
			used[lod->index[i]] = true;
		}
	}
	for (int to = 1; to < ROW; to++) {
		const float *a = primitive->position[from];
		const float *b = primitive->position[to];

		for (int i = from + 1; used[to] && i < to; i++) {
			const float *p = primitive->position[i];
			float share = (p[0] - a[0]) / (b[0] - a[0]);
			float gap = p[1] - a[1] - share * (b[1] - a[1]);

			most = gap > most ? gap : most;
		}
		from = used[to] ? to : from;
	}
	return most;
}

static void test_a_border_stays_within_its_levels_errors(void **state)
{
	struct model *model = make_band();
	const struct model_primitive *band = model->mesh->primitive;
	int count = 0;

	(void)state;
	assert_int_equal(levels_make(model), 0);
	for (int i = 0; i < band->lod_count; i++) {
		const struct model_lod *lod = &band->lod[i];

		if (!lod->shadow_only) {
			count++;
			assert_true(find_border_gap(band, lod) <
				1.4f * lod->error_m);
		}
	}
	assert_true(count > 1);
	arena_release(&model->arena);
	free(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_border_stays_within_its_levels_errors),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
