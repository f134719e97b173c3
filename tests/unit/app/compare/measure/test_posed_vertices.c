/* Posed vertices in world space, of drawables of each kind, by hand. */
#include "app/compare/measure/posed_vertices.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <limits.h>
#include <math.h>
#include <string.h>

enum {
	VERTICES = 2
};

static const uint32_t swapped[VERTICES] = {1, 0};
static const struct model_primitive primitive = {.vertex_count = VERTICES};

/* Columns: the mirrored first node has no right angles, the second turns. */
static mat4 world[2] = {
	{{1, 2, 3, 0}, {4, 5, 6, 0}, {7, 8, 10, 0}, {11, 12, 13, 1}},
	{{0, 2, 0, 0}, {-3, 0, 0, 0}, {0, 0, 5, 0}, {6, 7, 8, 1}}};

static struct instance instance_of(struct drawable *drawable, int count)
{
	for (int i = 0; i < count; i++) {
		drawable[i].primitive = &primitive;
		drawable[i].vertex_scale = drawable[i].vertex_scale > 0.0f
			? drawable[i].vertex_scale
			: 1.0f;
	}
	return (struct instance){.drawable_count = count,
		.drawable = drawable,
		.world = world,
		.unit_scale = 4.0f};
}

/* Of each drawable alone: the same, and nothing else is written. */
static void expect_alone(const struct instance *instance,
	void (*write)(const struct instance *, float (*)[3]),
	float (*all)[VERTICES][3])
{
	static const float mark[3] = {7, 7, 7};

	for (int i = 0; i < instance->drawable_count; i++) {
		struct instance one = *instance;
		float own[VERTICES + 1][3];

		for (int v = 0; v <= VERTICES; v++) {
			memcpy(own[v], mark, sizeof(mark));
		}
		one.drawable = &instance->drawable[i];
		one.drawable_count = 1;
		write(&one, own);
		assert_memory_equal(own, all[i], sizeof(all[i]));
		assert_memory_equal(own[VERTICES], mark, sizeof(mark));
	}
}

static void test_positions_are_in_units_of_the_world(void **state)
{
	/* In the primitive's order. */
	static const float expected[][VERTICES][3] = {
		{{41, 48, 58}, {24, 26, 30}}, /* (1, 2, 3), (-1, 0, 2) */
		{{0, 9, 23}, {6, 5, 18}},
		{{1, 2, -3}, {2, 1, -1}}, /* a skin has no node's place */
		{{41, 48, 58}, {24, 26, 30}},
		{{24, 26, 30}, {41, 48, 58}},
		{{1, 2, -3}, {2, 1, -1}},
	};
	float doubled[VERTICES][3] = {{2, 4, 6}, {-2, 0, 4}};
	float local[VERTICES][3] = {{1, 2, 3}, {-1, 0, 2}};
	float scene[VERTICES][3] = {{4, 8, -12}, {8, 4, -4}};
	struct fixed_vector moved[VERTICES] = {{.x = 0}, {0, -4, -4, -2}};
	struct fixed_vector posed[VERTICES] = {{.x = 0}, {0, 2, -2, 4}};
	struct drawable_fixed rigid = {
		.position = moved, .placement = {0.5f, {1, 2, 3}}};
	struct drawable_fixed ordered = {.position = moved,
		.placement = {0.5f, {1, 2, 3}},
		.order = swapped,
		.inverse_order = swapped};
	struct drawable_fixed skinned = {
		.position = posed, .placement = {2.0f, {4, 8, -12}}};
	struct drawable drawable[] = {
		{.skin = -1, .vertex_scale = 2.0f, .position = doubled},
		{.skin = -1, .node = 1, .position = local},
		{.skin = 1, .position = scene},
		{.skin = -1, .fixed = &rigid},
		{.skin = -1, .fixed = &ordered},
		{.skin = 0, .fixed = &skinned},
	};
	int count = (int)ARRAY_COUNT(drawable);
	struct instance instance = instance_of(drawable, count);
	float position[ARRAY_COUNT(drawable)][VERTICES][3];

	(void)state;
	assert_int_equal(posed_vertices_count(&instance), count * VERTICES);
	posed_vertices_positions(&instance, position[0]);
	for (int i = 0; i < count * VERTICES * 3; i++) {
		assert_near(
			(&position[0][0][0])[i], (&expected[0][0][0])[i], 1e-5);
	}
	expect_alone(&instance, posed_vertices_positions, position);
}

/* Of length 1, or zeros. */
static void expect_direction(
	const float found[3], const float wanted[3], float wanted_squared)
{
	for (int axis = 0; axis < 3; axis++) {
		float length =
			wanted_squared > 0.0f ? sqrtf(wanted_squared) : 1.0f;

		assert_near(found[axis], wanted[axis] / length, 1e-6);
	}
}

/*
 * Two edges (2, -1, 0) and (3, 0, -1), whose normal is (1, 2, 3), become
 * (-2, -1, 0) and (-4, -2, -1): their normal is (1, -2, 0), or (-1, 2, 0) as
 * the node mirrors. The other node divides by 2, 3 and 5 and turns.
 */
static void test_normals_are_unit_vectors_in_the_world(void **state)
{
	static const struct {
		float normal[3], squared; /* of its length */
	} expected[][VERTICES] = {
		{{{-1, 2, 0}, 5}, {{0, 0, 0}, 0}},
		{{{-2, 3, 0}, 13}, {{-1, 1, 1}, 3}},
		{{{0, 3, 4}, 25}, {{0, 0, 0}, 0}},
		{{{-2, 3, 0}, 13}, {{-1, 1, 1}, 3}},
		{{{-1, 1, 1}, 3}, {{-2, 3, 0}, 13}},
		{{{2, 3, 5}, 38}, {{1, 1, 0}, 2}},
	};
	float any[VERTICES][3] = {{1, 2, 3}, {0, 0, 0}};
	float local[VERTICES][3] = {{1, 1, 0}, {2, 3, 5}};
	float posed[VERTICES][3] = {{0, 0.3f, 0.4f}, {0, 0, 0}};
	struct fixed_vector turned[VERTICES] = {{0, 1, 1, 0}, {0, 2, 3, 5}};
	struct drawable_fixed rigid = {.normal = turned};
	struct drawable_fixed ordered = {
		.normal = turned, .order = swapped, .inverse_order = swapped};
	struct drawable drawable[] = {
		{.skin = -1, .normal = any},
		{.skin = -1, .node = 1, .normal = local},
		{.skin = 0, .normal = posed},
		{.skin = -1, .node = 1, .fixed = &rigid},
		{.skin = -1, .node = 1, .fixed = &ordered},
		{.skin = 0, .node = 1, .fixed = &ordered},
	};
	int count = (int)ARRAY_COUNT(drawable);
	struct instance instance = instance_of(drawable, count);
	float normal[ARRAY_COUNT(drawable)][VERTICES][3];

	(void)state;
	posed_vertices_normals(&instance, normal[0]);
	for (int i = 0; i < count * VERTICES; i++) {
		expect_direction(normal[i / VERTICES][i % VERTICES],
			expected[i / VERTICES][i % VERTICES].normal,
			expected[i / VERTICES][i % VERTICES].squared);
	}
	expect_alone(&instance, posed_vertices_normals, normal);
}

static void expect_normal_matrix(const vec4 *node, const float wanted[9])
{
	mat3 matrix;

	posed_vertices_normal_matrix(node, matrix);
	for (int i = 0; i < 9; i++) {
		assert_near(matrix[i / 3][i % 3], wanted[i], 1e-6);
	}
}

/* Its columns are cross products, turned round if the node mirrors. */
static void test_a_matrix_for_normals_has_the_area_of_sides(void **state)
{
	static const mat4 half = {{0.5f, 0, 0, 0}, {0, 0.5f, 0, 0},
		{0, 0, 0.5f, 0}, {0, 0, 0, 1}};
	static const float of_half[9] = {0.25f, 0, 0, 0, 0.25f, 0, 0, 0, 0.25f};
	static const float of_first[9] = {-2, -2, 3, -4, 11, -6, 3, -6, 3};

	(void)state;
	expect_normal_matrix(half, of_half);
	expect_normal_matrix((const vec4 *)world[0], of_first);
}

static void test_flat_surfaces_have_zeros_for_normals(void **state)
{
	struct drawable_fixed fixed = {.normal = NULL};
	struct drawable drawable[] = {{.skin = -1}, {.skin = 0},
		{.skin = -1, .fixed = &fixed}, {.skin = 0, .fixed = &fixed}};
	int count = (int)ARRAY_COUNT(drawable);
	struct instance instance = instance_of(drawable, count);
	float normal[ARRAY_COUNT(drawable) * VERTICES + 1][3];

	(void)state;
	for (int v = 0; v <= count * VERTICES; v++) {
		normal[v][0] = normal[v][1] = normal[v][2] = 7.0f;
	}
	posed_vertices_normals(&instance, normal);
	for (int v = 0; v <= count * VERTICES; v++) {
		for (int axis = 0; axis < 3; axis++) {
			assert_near(normal[v][axis],
				v < count * VERTICES ? 0 : 7, 0);
		}
	}
}

static void test_more_vertices_than_an_int_has_are_no_number(void **state)
{
	const struct model_primitive most = {.vertex_count = INT_MAX - VERTICES};
	struct drawable drawable[3] = {{.skin = -1}};
	struct instance instance = instance_of(drawable, 3);

	(void)state;
	assert_int_equal(posed_vertices_count(&instance), 3 * VERTICES);
	drawable[1].primitive = &most;
	assert_int_equal(posed_vertices_count(&instance), -1);
	instance.drawable_count = 2;
	assert_int_equal(posed_vertices_count(&instance), INT_MAX);
	instance.drawable_count = 0;
	assert_int_equal(posed_vertices_count(&instance), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_positions_are_in_units_of_the_world),
		cmocka_unit_test(test_normals_are_unit_vectors_in_the_world),
		cmocka_unit_test(test_a_matrix_for_normals_has_the_area_of_sides),
		cmocka_unit_test(test_flat_surfaces_have_zeros_for_normals),
		cmocka_unit_test(
			test_more_vertices_than_an_int_has_are_no_number),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
