/* levels_divide.h: triangles with vertices of their own, and back. */
#include "app/model/levels/levels_divide.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

enum {
	VERTICES = 4,
	CORNERS = 6
};

/* Two triangles in different planes, which share an edge. */
static float position[VERTICES][3] = {
	{5, 5, 5}, {5.25f, 5, 5}, {5, 5.5f, 5}, {5, 5, 5.125f}};
static float texcoord[VERTICES][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}};
static uint8_t color[VERTICES][4] = {
	{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
static uint16_t joint[VERTICES * 2] = {0, 1, 2, 3, 4, 5, 6, 7};
static float weight[VERTICES * 2] = {
	0.5f, 0.5f, 0.25f, 0.75f, 1, 0, 0.125f, 0.875f};
static uint32_t corner[CORNERS] = {0, 1, 2, 0, 2, 3};
static const bool shared[VERTICES] = {true, false, false, true};

static struct model_primitive make(void)
{
	return (struct model_primitive){.vertex_count = VERTICES,
		.position = position,
		.index_count = CORNERS,
		.index = corner};
}

static void divide(const struct model_primitive *whole, struct arena *arena,
	struct levels_divided *out)
{
	*arena = arena_empty();
	assert_int_equal(levels_divide(whole, shared, arena, out), 0);
	assert_int_equal(out->primitive.vertex_count, CORNERS);
	assert_int_equal(out->primitive.index_count, CORNERS);
}

static void test_each_corner_becomes_a_vertex(void **state)
{
	struct model_primitive whole = make();
	struct levels_divided divided;
	struct arena arena;

	(void)state;
	whole.texcoord = texcoord;
	whole.color = color;
	whole.influences = 2;
	whole.joint = joint;
	whole.weight = weight;
	divide(&whole, &arena, &divided);
	assert_int_equal(divided.primitive.influences, 2);
	for (int i = 0; i < CORNERS; i++) {
		uint32_t v = corner[i];

		assert_int_equal(divided.primitive.index[i], i);
		assert_int_equal(divided.source[i], v);
		assert_int_equal(divided.shared[i], shared[v]);
		assert_memory_equal(divided.primitive.position[i], position[v],
			sizeof(position[v]));
		assert_memory_equal(divided.primitive.texcoord[i], texcoord[v],
			sizeof(texcoord[v]));
		assert_memory_equal(
			divided.primitive.color[i], color[v], sizeof(color[v]));
		assert_memory_equal(divided.primitive.joint + 2 * i,
			joint + 2 * v, 2 * sizeof(*joint));
		assert_memory_equal(divided.primitive.weight + 2 * i,
			weight + 2 * v, 2 * sizeof(*weight));
	}
	arena_release(&arena);
}

static void test_what_the_primitive_lacks_is_not_made(void **state)
{
	struct model_primitive whole = make();
	struct levels_divided divided;
	struct arena arena;

	(void)state;
	divide(&whole, &arena, &divided);
	assert_null(divided.primitive.texcoord);
	assert_null(divided.primitive.color);
	assert_null(divided.primitive.joint);
	assert_null(divided.primitive.weight);
	assert_non_null(divided.primitive.normal);
	arena_release(&arena);
}

/* Joints take half the memory of weights. */
static void test_a_skin_of_which_only_joints_fit_is_a_failure(void **state)
{
	enum {
		MANY = 8192 /* influences, so that both arrays have blocks */
	};
	static uint16_t joints[VERTICES * MANY];
	static float weights[VERTICES * MANY];
	struct model_primitive whole = make();
	struct memory_budget budget = {
		.limit_bytes = CORNERS * MANY * 3 + 65536 + 512};
	struct arena arena = arena_within(&budget);
	struct levels_divided divided;

	(void)state;
	whole.influences = MANY;
	whole.joint = joints;
	whole.weight = weights;
	assert_int_equal(
		levels_divide(&whole, shared, &arena, &divided), -ENOMEM);
	assert_true(divided.primitive.joint || divided.primitive.weight);
	arena_release(&arena);
}

static void expect_normal(const struct levels_divided *divided, int triangle,
	const float wanted[3])
{
	for (int i = 3 * triangle; i < 3 * triangle + 3; i++) {
		assert_all_near(divided->primitive.normal[i], wanted, 3, 1e-6);
	}
}

/* Of any size and at any place; a triangle without an area has none. */
static void test_corners_have_the_normal_of_their_plane(void **state)
{
	static const float sizes[] = {128, 1, 1.0f / 1024};
	static const float line[VERTICES][3] = {
		{0, 0, 0}, {0, 0, 7}, {3, 0, 7}, {6, 0, 14}};

	(void)state;
	for (int n = 0; n < 6; n++) {
		struct model_primitive whole = make();
		struct levels_divided divided;
		float scaled[VERTICES][3];
		struct arena arena;

		whole.position = scaled;
		for (int v = 0; v < VERTICES; v++) {
			for (int i = 0; i < 3; i++) {
				float at =
					n % 2 ? line[v][i] : position[v][i] - 5;

				scaled[v][i] =
					(at + 3 - (float)i) * sizes[n / 2];
			}
		}
		divide(&whole, &arena, &divided);
		expect_normal(&divided, 0,
			(const float[]){0, (float)(n % 2), (float)!(n % 2)});
		expect_normal(
			&divided, 1, (const float[]){(float)!(n % 2), 0, 0});
		arena_release(&arena);
	}
}

/* A level's corners, counted over those of the whole list of triangles. */
static void test_a_level_knows_both_vertices_and_corners(void **state)
{
	uint32_t level[] = {3, 5, 4, 2, 0, 1};
	struct model_lod lod = {.index_count = 6, .index = level};
	struct model_primitive whole = make();
	struct levels_divided divided;
	struct arena arena;

	(void)state;
	divide(&whole, &arena, &divided);
	assert_int_equal(levels_join(&divided, &lod, &arena), 0);
	assert_memory_equal(
		lod.corner, ((uint32_t[]){3, 5, 4, 2, 0, 1}), sizeof(level));
	assert_memory_equal(
		lod.index, ((uint32_t[]){0, 3, 2, 2, 0, 1}), sizeof(level));
	arena_release(&arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_corner_becomes_a_vertex),
		cmocka_unit_test(test_what_the_primitive_lacks_is_not_made),
		cmocka_unit_test(
			test_a_skin_of_which_only_joints_fit_is_a_failure),
		cmocka_unit_test(test_corners_have_the_normal_of_their_plane),
		cmocka_unit_test(test_a_level_knows_both_vertices_and_corners),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
