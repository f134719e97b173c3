/*
 * The boxes around what the joints of a skinned primitive move, and the scale
 * of its base vectors.
 */
#include "app/anim/kernel/layout/fixed_skin.h"
#include "app/model/model_deltas.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 4,
	WIDTH = 2
};

struct fixture {
	float position[VERTICES][3];
	uint16_t joint[VERTICES][WIDTH];
	float weight[VERTICES][WIDTH];
	float delta[VERTICES][3];
	struct model_target target;
	struct model_primitive primitive;
	struct arena arena;
	struct fixed_skin skin;
};

static void set_up(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.influences = WIDTH,
		.joint = f->joint[0],
		.weight = f->weight[0],
		.target = &f->target};
}

static void lay_out(struct fixture *f)
{
	assert_int_equal(
		fixed_skin_init(&f->skin, &f->primitive, 0, &f->arena), 0);
}

/*
 * Two joints, each with two vertices at a distance of half from its middle. The
 * middles are 2 apart along an axis.
 */
static void set_pair(struct fixture *f, int axis, float half, float size,
	const float from[3])
{
	for (int v = 0; v < VERTICES; v++) {
		float side = v % 2 ? half : -half;

		for (int k = 0; k < 3; k++) {
			f->position[v][k] = from[k] + size * 0.25f * side;
		}
		f->position[v][axis] =
			from[axis] + size * (side + (v < 2 ? 0 : 2));
		f->joint[v][0] = v < 2 ? 3 : 5;
		f->weight[v][0] = 1;
	}
}

static void assert_box(const struct fixed_joint *joint, int number,
	const float middle[3], const float half[3])
{
	assert_int_equal(joint->joint, number);
	assert_true(joint->used);
	assert_all_near(joint->middle, middle, 3, 1e-5);
	assert_all_near(joint->half, half, 3, 1e-5);
}

static void test_a_joints_box_is_around_its_vertices(void **state)
{
	static const float position[VERTICES][3] = {
		{11, 22, 33}, {13, 21, 37}, {-5, -60, -70}, {-4, -50, -73}};
	static const float middle[2][3] = {
		{12, 21.5f, 35}, {-4.5f, -55, -71.5f}};
	static const float half[2][3] = {{1, 0.5f, 2}, {0.5f, 5, 1.5f}};
	static const float origin[3];
	static struct fixture f;

	(void)state;
	set_up(&f);
	set_pair(&f, 0, 1, 1, origin);
	memcpy(f.position, position, sizeof(position));
	lay_out(&f);
	assert_int_equal(f.skin.joint_count, 2);
	assert_box(&f.skin.joint[0], 3, middle[0], half[0]);
	assert_box(&f.skin.joint[1], 5, middle[1], half[1]);
	arena_release(&f.arena);
}

/*
 * 1 is 28672 / 65536 in the matrices. The bind pose and a quarter reach 32767
 * at a scale of 59916.8 / half its side; the joints' middles, half of that, at
 * 29957.5. Then the scale is doubled up to twice, while the base vectors stay
 * below 32766.
 */
static void test_the_scale_fills_what_is_narrowest(void **state)
{
	static const struct {
		float half;
		double scale;
	} cases[] = {
		{0.01f, 4 * 29957.486}, /* three doublings would fit */
		{0.25f, 4 * 29957.486},
		{0.28f, 2 * 29957.486}, /* 32766 / 0.28 is below 4 of them */
		{0.4f, 2 * 29957.486},
		{0.5f, 2 * 29957.486},
		{0.6f, 29957.486},
		{1.2f, 59916.8 / 2.2},
		{2, 32766 / 2.0},
		{4, 32766 / 4.0},
	};
	static const float from[3][3] = {
		{0, 0, 0}, {1, 2, 3}, {-100, -200, -300}};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases) * 9; i++) {
		size_t c = i / 9;
		float size = (float[]){0.125f, 1, 64}[i % 3];

		set_up(&f);
		set_pair(&f, (int)(i / 3 % 3), cases[c].half, size, from[i % 3]);
		lay_out(&f);
		assert_near(f.skin.scale[FIXED_POSITION] * size / cases[c].scale,
			1, i % 3 == 2 ? 1e-5 : 4e-6);
		arena_release(&f.arena);
	}
}

/* Without the light joint, which stays in the list with an empty box. */
static void test_the_cap_leaves_joints_out_of_the_scale(void **state)
{
	static const float none[3];
	static struct fixture f;

	(void)state;
	for (int sign = -1; sign <= 1; sign += 2) {
		for (int heavy = 0; heavy < 2; heavy++) {
			set_up(&f);
			for (int v = 0; v < VERTICES; v++) {
				f.position[v][0] = (float)(sign * (10 + v % 2));
				f.joint[v][0] = (uint16_t)heavy;
				f.joint[v][1] = (uint16_t)!heavy;
				f.weight[v][0] = 0.75f;
				f.weight[v][1] = 0.25f;
			}
			lay_out(&f);
			assert_near(f.skin.scale[FIXED_POSITION], 32766 / 0.375,
				0.1);
			fixed_skin_set_cap(&f.skin, 1);
			assert_near(
				f.skin.scale[FIXED_POSITION], 32766 / 0.5, 0.1);
			assert_true(f.skin.joint[heavy].used);
			assert_false(f.skin.joint[!heavy].used);
			assert_all_near(f.skin.joint[!heavy].middle, none, 3, 0);
			assert_all_near(f.skin.joint[!heavy].half, none, 3, 0);
			arena_release(&f.arena);
		}
	}
}

struct vertex {
	float at;
	uint16_t joint[WIDTH];
	float weight[WIDTH];
};

/* Bases are measured at the weights of the side that is farthest. */
static void test_the_scale_knows_weights_and_nested_boxes(void **state)
{
	static const struct {
		struct vertex vertex[VERTICES];
		double scale;
	} cases[] = {
		/* The heavy vertex is above the middle, or below it. */
		{{{10.5f, {0}, {1}}, {10, {0, 1}, {0.5f, 0.5f}}, {10, {1}, {1}},
			 {10, {1}, {1}}},
			32766 / 0.25},
		{{{10, {1}, {1}}, {10, {1}, {1}}, {10, {0, 1}, {0.5f, 0.5f}},
			 {9.5f, {0}, {1}}},
			32766 / 0.25},
		/* Joint 1 reaches to both ends, with little weight. */
		{{{10, {0, 1}, {0.55f, 0.45f}}, {14, {1, 2}, {0.25f, 0.75f}},
			 {10, {0}, {1}}, {14, {2}, {1}}},
			29957.486},
		/* A box within others, which share the outer vertices. */
		{{{10.1f, {0}, {1}}, {9.9f, {0}, {1}},
			 {11, {1, 2}, {0.5f, 0.5f}}, {9, {1, 2}, {0.5f, 0.5f}}},
			59916.8},
	};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases) * 3; i++) {
		set_up(&f);
		for (int v = 0; v < VERTICES; v++) {
			const struct vertex *from = &cases[i / 3].vertex[v];

			f.position[v][i % 3] = from->at;
			memcpy(f.joint[v], from->joint, sizeof(f.joint[v]));
			memcpy(f.weight[v], from->weight, sizeof(f.weight[v]));
		}
		lay_out(&f);
		assert_near(f.skin.scale[FIXED_POSITION] / cases[i / 3].scale,
			1, 4e-6);
		arena_release(&f.arena);
	}
}

/* Along each axis in turn: by half a unit of a box of two units. */
static void test_targets_make_the_boxes_larger(void **state)
{
	static struct fixture f;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		float half[3] = {0, 0, 0}, middle[3] = {0, 0, 0};

		set_up(&f);
		for (int v = 0; v < VERTICES; v++) {
			f.position[v][axis] = v % 2 ? 8 : 6;
			f.weight[v][0] = 1;
			f.delta[v][axis] = v % 2 ? 0.125f : -0.125f;
		}
		f.target.position =
			model_deltas_view((const float(*)[3])f.delta, VERTICES);
		lay_out(&f);
		assert_near(f.skin.scale[FIXED_POSITION], 32766, 0.1);
		assert_int_equal(
			fixed_skin_add_targets(&f.skin, 1, &f.arena), 0);
		middle[axis] = 7;
		half[axis] = 1.125f;
		assert_box(&f.skin.joint[0], 0, middle, half);
		assert_near(f.skin.scale[FIXED_POSITION], 32766 / 1.125, 0.1);
		arena_release(&f.arena);
	}
}

/* A delta may not be larger than a half of its number in the base vectors. */
static void test_large_deltas_limit_the_scale(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int v = 0; v < VERTICES; v++) {
		f.position[v][0] = v % 2 ? 1 : -1;
		f.weight[v][0] = 1;
	}
	f.delta[2][1] = 8;
	f.target.position =
		model_deltas_view((const float(*)[3])f.delta, VERTICES);
	lay_out(&f);
	assert_int_equal(fixed_skin_add_targets(&f.skin, 1, &f.arena), 0);
	/* The largest delta is 16383 at a weight of 1. */
	assert_near(f.skin.scale[FIXED_POSITION], 16383 / 8.0 / 2, 0.01);
	arena_release(&f.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_joints_box_is_around_its_vertices),
		cmocka_unit_test(test_the_scale_fills_what_is_narrowest),
		cmocka_unit_test(test_the_cap_leaves_joints_out_of_the_scale),
		cmocka_unit_test(test_the_scale_knows_weights_and_nested_boxes),
		cmocka_unit_test(test_targets_make_the_boxes_larger),
		cmocka_unit_test(test_large_deltas_limit_the_scale),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
