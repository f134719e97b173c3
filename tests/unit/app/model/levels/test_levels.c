/* Levels of detail that are made for models without any. */
#include "app/model/levels/levels.h"
#include "app/model/model_loader.h"
#include "tests/unit/app/model/levels/levels_net.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* One black vertex in the middle. */
static void shape_spotted(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	shape_flat(u, v, position, normal, color);
	if (u == 0.5f && v == 0.5f) {
		memset(color, 0, 3);
	}
}

/* A ball, whose seam and poles have several vertices at one position. */
static void shape_ball(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	float around = u >= 1.0f ? 0.0f : u * 6.2831853f;
	float down = v <= 0.0f ? 0.0f : v * 3.1415927f;
	float ring = v <= 0.0f || v >= 1.0f ? 0.0f : sinf(down);

	position[0] = ring * cosf(around);
	position[1] = v >= 1.0f ? -1.0f : cosf(down);
	position[2] = ring == 0.0f ? 0.0f : -ring * sinf(around);
	if (ring == 0.0f) {
		position[0] = 0.0f;
	}
	memcpy(normal, position, sizeof(float[3]));
	memset(color, 255, 4);
}

/* The same, but the ends of its seam differ by the rounding of floats. */
static void shape_rounded_ball(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	shape_ball(u, v, position, normal, color);
	if (u >= 1.0f && position[0] != 0.0f) {
		position[0] *= 1.0000002f;
		position[2] = 2e-7f;
	}
}

static float area_of(const struct model_primitive *primitive,
	const uint32_t *index, int count)
{
	float sum = 0.0f;

	for (int i = 0; i < count; i += 3) {
		const float *a = primitive->position[index[i]];
		const float *b = primitive->position[index[i + 1]];
		const float *c = primitive->position[index[i + 2]];

		sum += 0.5f *
			((b[0] - a[0]) * (c[1] - a[1]) -
				(c[0] - a[0]) * (b[1] - a[1]));
	}
	return sum;
}

static void test_a_flat_net_keeps_its_area_with_few_triangles(void **state)
{
	struct net net = make_net(shape_flat, 1);

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	assert_true(net.primitive->lod_count > 0);
	for (int i = 0; i < net.primitive->lod_count; i++) {
		const struct model_lod *lod = &net.primitive->lod[i];

		assert_true(lod->index_count < INDICES / 20);
		assert_int_equal(lod->index_count % 3, 0);
		assert_true(fabsf(area_of(net.primitive, lod->index,
					  lod->index_count) -
				    1.0f) < 1e-4f);
	}
	free_net(&net);
}

static void test_levels_get_coarser_and_those_for_shadows_come_last(void **state)
{
	struct net net = make_net(shape_ball, 1);
	const struct model_lod *lod;
	bool shadow = false;

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	lod = net.primitive->lod;
	assert_true(net.primitive->lod_count >= 4);
	assert_true(lod[0].index_count <= INDICES * 8 / 10);
	for (int i = 1; i < net.primitive->lod_count; i++) {
		if (lod[i].shadow_only == lod[i - 1].shadow_only) {
			assert_true(lod[i].error_m > lod[i - 1].error_m);
			assert_true(lod[i].index_count < lod[i - 1].index_count);
		}
		assert_false(shadow && !lod[i].shadow_only);
		shadow = shadow || lod[i].shadow_only;
	}
	assert_true(shadow);
	free_net(&net);
}

/* How far a triangle's corners and its middle are from the unit ball. */
static float ball_error(
	const struct model_primitive *primitive, const uint32_t corner[3])
{
	float middle[3];

	for (int i = 0; i < 3; i++) {
		middle[i] = (primitive->position[corner[0]][i] +
				    primitive->position[corner[1]][i] +
				    primitive->position[corner[2]][i]) /
			3.0f;
	}
	return 1.0f -
		sqrtf(middle[0] * middle[0] + middle[1] * middle[1] +
			middle[2] * middle[2]);
}

static void test_a_ball_stays_round_within_its_levels_errors(void **state)
{
	struct net net = make_net(shape_ball, 1);

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	for (int i = 0; i < net.primitive->lod_count; i++) {
		const struct model_lod *lod = &net.primitive->lod[i];
		int beyond = 0;

		for (int t = 0; t < lod->index_count; t += 3) {
			float error = ball_error(net.primitive, lod->index + t);

			/* The full ball itself is 0.004 off. */
			beyond += error > 3.0f * lod->error_m + 0.004f;
		}
		assert_true(beyond * 20 <= lod->index_count / 3);
	}
	free_net(&net);
}

static bool are_at_one_place(
	const struct model_primitive *primitive, uint32_t a, uint32_t b)
{
	for (int i = 0; i < 3; i++) {
		if (fabsf(primitive->position[a][i] -
			    primitive->position[b][i]) > 1e-6f) {
			return false;
		}
	}
	return true;
}

/* How many triangles have the edge from place b to place a. */
static int count_opposite(const struct model_primitive *primitive,
	const struct model_lod *lod, uint32_t a, uint32_t b)
{
	int count = 0;

	for (int i = 0; i < lod->index_count; i++) {
		uint32_t from = lod->index[i];
		uint32_t to = lod->index[i % 3 == 2 ? i - 2 : i + 1];

		count += are_at_one_place(primitive, from, b) &&
			are_at_one_place(primitive, to, a);
	}
	return count;
}

static void assert_closed(
	const struct model_primitive *primitive, const struct model_lod *lod)
{
	for (int i = 0; i < lod->index_count; i++) {
		uint32_t to = lod->index[i % 3 == 2 ? i - 2 : i + 1];

		assert_int_equal(
			count_opposite(primitive, lod, lod->index[i], to), 1);
	}
}

static void test_a_closed_surface_stays_closed_at_its_seam(void **state)
{
	static const shape_function shapes[] = {shape_ball, shape_rounded_ball};

	(void)state;
	for (int s = 0; s < 2; s++) {
		struct net net = make_net(shapes[s], 1);

		assert_int_equal(levels_make(net.model), 0);
		assert_true(net.primitive->lod_count > 2);
		for (int l = 0; l < net.primitive->lod_count; l++) {
			assert_closed(net.primitive, &net.primitive->lod[l]);
		}
		free_net(&net);
	}
}

static void test_a_coloured_spot_stays_until_its_size_is_the_error(void **state)
{
	struct net net = make_net(shape_spotted, 1);
	uint32_t spot = (uint32_t)(ROW * (SIDE / 2) + SIDE / 2);

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	assert_true(net.primitive->lod_count > 0);
	for (int i = 0; i < net.primitive->lod_count; i++) {
		const struct model_lod *lod = &net.primitive->lod[i];

		if (lod->shadow_only) {
			assert_false(has_vertex(lod, spot));
		} else if (lod->error_m < 0.01f) {
			assert_true(has_vertex(lod, spot));
		}
	}
	free_net(&net);
}

static void test_primitives_that_touch_keep_their_common_border(void **state)
{
	struct net net = make_net(shape_flat, 2);

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	for (int p = 0; p < 2; p++) {
		const struct model_primitive *primitive = &net.primitive[p];

		assert_true(primitive->lod_count > 0);
		for (int l = 0; l < primitive->lod_count; l++) {
			for (uint32_t v = 0; v < ROW; v++) {
				uint32_t border = v * ROW + (p ? 0 : SIDE);

				assert_true(
					has_vertex(&primitive->lod[l], border));
			}
		}
	}
	free_net(&net);
}

/* A mirrored half of a model may have its border at -0 instead of 0. */
static void test_a_border_at_minus_zero_is_common_too(void **state)
{
	struct net net = make_net(shape_flat, 2);

	(void)state;
	for (int i = 0; i < COUNT; i++) {
		net.primitive[0].position[i][0] -= 1.0f;
		net.primitive[1].position[i][0] -= 1.0f;
	}
	for (int row = 0; row < ROW; row++) {
		net.primitive[0].position[row * ROW + SIDE][0] = -0.0f;
	}
	assert_int_equal(levels_make(net.model), 0);
	assert_true(net.primitive[0].lod_count > 0);
	for (int i = 0; i < net.primitive[0].lod_count; i++) {
		for (uint32_t row = 0; row < ROW; row++) {
			assert_true(has_vertex(
				&net.primitive[0].lod[i], row * ROW + SIDE));
		}
	}
	free_net(&net);
}

static void test_own_levels_of_a_file_stay(void **state)
{
	struct net net = make_net(shape_ball, 1);
	struct model_lod own = {.error_m = 0.5f,
		.index_count = 3,
		.index = net.primitive->index};

	(void)state;
	net.primitive->lod = &own;
	net.primitive->lod_count = 1;
	assert_int_equal(levels_make(net.model), 0);
	assert_true(net.primitive->lod_count > 1);
	assert_memory_equal(&net.primitive->lod[0], &own, sizeof(own));
	for (int i = 1; i < net.primitive->lod_count; i++) {
		assert_true(net.primitive->lod[i].shadow_only);
	}
	free_net(&net);
}

/* Triangles that no surface has: of one point, three at an edge, doubled. */
static void test_any_list_of_triangles_is_taken(void **state)
{
	struct net net = make_net(shape_ball, 1);
	uint32_t random = 1;

	(void)state;
	for (int i = 0; i < INDICES; i++) {
		random = random * 1664525u + 1013904223u;
		if (random >> 28 == 0) {
			net.primitive->index[i] = (random >> 8) % COUNT;
		}
	}
	assert_int_equal(levels_make(net.model), 0);
	for (int l = 0; l < net.primitive->lod_count; l++) {
		const struct model_lod *lod = &net.primitive->lod[l];

		for (int i = 0; i < lod->index_count; i++) {
			assert_true(lod->index[i] < COUNT);
		}
	}
	free_net(&net);
}

/* All triangles share a vertex: what takes each with each takes hours. */
static void test_a_hub_of_many_triangles_takes_no_longer(void **state)
{
	struct net net = make_net(shape_flat, 1);
	const int triangles = 600000;
	clock_t began;
	uint32_t *index =
		ARENA_ARRAY(&net.model->arena, uint32_t, 3 * (size_t)triangles);

	(void)state;
	assert_non_null(index);
	for (uint32_t i = 0; i < (uint32_t)triangles; i++) {
		index[3 * i] = 0;
		index[3 * i + 1] = 1 + i % (COUNT - 1);
		index[3 * i + 2] = 1 + (i + i / COUNT + 1) % (COUNT - 1);
	}
	net.primitive->index = index;
	net.primitive->index_count = 3 * triangles;
	began = clock();
	assert_int_equal(levels_make(net.model), 0);
	assert_true(clock() - began < 10 * CLOCKS_PER_SEC);
	free_net(&net);
}

static void test_without_memory_there_are_no_levels(void **state)
{
	struct net net = make_net(shape_ball, 1);
	struct memory_budget budget = {.limit_bytes = 4096};

	(void)state;
	net.model->budget = &budget;
	assert_int_equal(levels_make(net.model), 0);
	assert_int_equal(net.primitive->lod_count, 0);
	assert_int_equal(budget.used_bytes, 0);
	assert_false(budget.exceeded);
	/* Half of the budget is left to instances. */
	budget = (struct memory_budget){
		.limit_bytes = 64 << 20, .used_bytes = 33 << 20};
	assert_int_equal(levels_make(net.model), 0);
	assert_int_equal(net.primitive->lod_count, 0);
	budget.used_bytes = 1 << 20;
	assert_int_equal(levels_make(net.model), 0);
	assert_true(net.primitive->lod_count > 0);
	free_net(&net);
}

static void test_few_triangles_get_none(void **state)
{
	struct net net = make_net(shape_ball, 1);

	(void)state;
	net.primitive->index_count = 99;
	assert_int_equal(levels_make(net.model), 0);
	assert_int_equal(net.primitive->lod_count, 0);
	free_net(&net);
}

/* Their corners have the normals of the triangles that end in the same place. */
static void test_without_normals_levels_name_triangles_that_have_them(
	void **state)
{
	struct net net = make_net(shape_ball, 1);
	const struct model_primitive *primitive = net.primitive;
	int shaded = 0;

	(void)state;
	net.primitive->normal = NULL;
	assert_int_equal(levels_make(net.model), 0);
	for (int i = 0; i < primitive->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		assert_true(lod->index_count < INDICES);
		assert_int_equal(lod->corner == NULL, lod->shadow_only);
		shaded += !lod->shadow_only;
		for (int k = 0; lod->corner && k < lod->index_count; k++) {
			assert_true(lod->corner[k] < INDICES);
			assert_int_equal(primitive->index[lod->corner[k]],
				lod->index[k]);
		}
	}
	assert_true(shaded >= 3);
	assert_true(shaded < primitive->lod_count);
	free_net(&net);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_flat_net_keeps_its_area_with_few_triangles),
		cmocka_unit_test(
			test_levels_get_coarser_and_those_for_shadows_come_last),
		cmocka_unit_test(
			test_a_ball_stays_round_within_its_levels_errors),
		cmocka_unit_test(test_a_closed_surface_stays_closed_at_its_seam),
		cmocka_unit_test(
			test_a_coloured_spot_stays_until_its_size_is_the_error),
		cmocka_unit_test(
			test_primitives_that_touch_keep_their_common_border),
		cmocka_unit_test(test_a_border_at_minus_zero_is_common_too),
		cmocka_unit_test(test_own_levels_of_a_file_stay),
		cmocka_unit_test(test_any_list_of_triangles_is_taken),
		cmocka_unit_test(test_a_hub_of_many_triangles_takes_no_longer),
		cmocka_unit_test(test_without_memory_there_are_no_levels),
		cmocka_unit_test(test_few_triangles_get_none),
		cmocka_unit_test(
			test_without_normals_levels_name_triangles_that_have_them),
	};

	return cmocka_run_group_tests_name("levels", tests, NULL, NULL);
}
