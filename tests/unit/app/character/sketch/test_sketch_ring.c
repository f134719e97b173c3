/* Which parts hang around an axis at equal angles. */
#include "app/character/sketch/sketch_ring.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	HUB,
	FIRST, /* blade */
	NODES = 40
};

struct rotor {
	struct model_node node[NODES];
	struct sketch_body body[NODES];
	struct model model;
	int axis, count, found[NODES];
};

static void hang_on(struct rotor *rotor, int node, int parent)
{
	rotor->node[node] = (struct model_node){.parent = parent,
		.mesh = -1,
		.skin = -1,
		.rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}}};
	rotor->body[node] = (struct sketch_body){.box = bounds_empty()};
}

/* Turns a blade and its place by so many steps about the rotor's axis. */
static void turn_to(struct rotor *rotor, int node, float step, float radius)
{
	struct transform *rest = &rotor->node[node].rest;
	float angle = 6.2831853f * step / (float)rotor->count;
	int axis = rotor->axis;

	rest->rotation[axis] = sinf(0.5f * angle);
	rest->rotation[3] = cosf(0.5f * angle);
	rest->translation[axis] = 0.5f;
	rest->translation[(axis + 1) % 3] = radius * cosf(angle);
	rest->translation[(axis + 2) % 3] = radius * sinf(angle);
}

static void show(struct rotor *rotor, int node)
{
	rotor->body[node] = (struct sketch_body){
		.box = {{-1, -1, -1}, {1, 1, 1}}, .reach = {1, 4, 9}};
}

static void begin(struct rotor *rotor, int axis, int count)
{
	*rotor = (struct rotor){.axis = axis, .count = count};
	rotor->model =
		(struct model){.node = rotor->node, .node_count = count + 1};
	hang_on(rotor, HUB, -1);
	for (int i = 0; i < count; i++) {
		hang_on(rotor, FIRST + i, HUB);
		turn_to(rotor, FIRST + i, (float)i, 4);
		show(rotor, FIRST + i);
	}
}

/* Asks for the axis of the hub; nothing hangs around the other nodes. */
static void expect_axis(struct rotor *rotor, int axis)
{
	assert_int_equal(
		sketch_find_rings(&rotor->model, rotor->body, rotor->found), 0);
	assert_int_equal(rotor->found[HUB], axis);
	for (int i = FIRST; i < rotor->model.node_count; i++) {
		assert_int_equal(rotor->found[i], -1);
	}
}

static void test_three_to_32_blades_are_a_ring(void **state)
{
	struct rotor rotor;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		for (int count = 1; count <= 33; count++) {
			begin(&rotor, axis, count);
			expect_axis(
				&rotor, count >= 3 && count <= 32 ? axis : -1);
		}
	}
}

/* A quaternion and its negative are the same rotation. */
static void test_blades_may_be_turned_either_way_round(void **state)
{
	struct rotor rotor;

	(void)state;
	for (int count = 3; count <= 5; count++) {
		begin(&rotor, 1, count);
		for (int i = 0; i < count; i += 2) {
			for (int k = 0; k < 4; k++) {
				rotor.node[FIRST + i].rest.rotation[k] *= -1;
			}
		}
		expect_axis(&rotor, 1);
	}
}

/* In any order, with the first one turned by any angle. */
static void test_the_first_blade_may_be_anywhere(void **state)
{
	static const float step[] = {3.3f, 1.3f, 0.3f, 4.3f, 2.3f};
	struct rotor rotor;

	(void)state;
	begin(&rotor, 2, 5);
	for (int i = 0; i < 5; i++) {
		turn_to(&rotor, FIRST + i, step[i], 4);
	}
	expect_axis(&rotor, 2);
}

static void test_each_step_has_one_blade(void **state)
{
	static const struct {
		int blade;
		float step;
		bool whole;
	} rows[] = {{1, 1.04f, true}, {1, 0.96f, true}, {1, 1.06f, false},
		{1, 0.94f, false}, {1, 0.5f, false}, {1, 0, false},
		{1, 2, false}, {2, 3, false}, {3, 1, false}, {3, 4, false},
		{2, 2.04f, true}, {2, 1.94f, false}};
	struct rotor rotor;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
			begin(&rotor, axis, 4);
			turn_to(&rotor, FIRST + rows[i].blade, rows[i].step, 4);
			/* Its place does not tell. */
			for (int k = 1; k <= 4; k++) {
				rotor.body[k].reach[0] = 1e6f;
			}
			expect_axis(&rotor, rows[i].whole ? axis : -1);
		}
	}
}

/* By up to 0.02 of the distance of its pivot and of its sides: 0.2 of 10. */
static void test_a_blade_may_be_a_little_out_of_place(void **state)
{
	static const float sides[3] = {1, 4, 25};
	struct rotor rotor;

	(void)state;
	for (int blade = 1; blade < 4; blade++) {
		for (int axis = 0; axis < 3; axis++) {
			float *at;

			begin(&rotor, 2, 4);
			/* 4.03 of its place, 1, 2 and 3 of its reach */
			at = &rotor.node[FIRST + blade].rest.translation[axis];
			*at += 0.195f;
			expect_axis(&rotor, 2);
			*at -= 0.39f;
			expect_axis(&rotor, 2);
			*at -= 0.015f;
			expect_axis(&rotor, -1);
			/* Only the first blade is measured. */
			memcpy(rotor.body[FIRST + blade].reach, sides,
				sizeof(sides));
			expect_axis(&rotor, -1);
			memcpy(rotor.body[FIRST].reach, sides, sizeof(sides));
			expect_axis(&rotor, 2);
		}
	}
}

/* All turn in the hub's middle. */
static void begin_middle(struct rotor *rotor, int axis)
{
	begin(rotor, axis, 4);
	for (int i = 0; i < 4; i++) {
		memset(rotor->node[FIRST + i].rest.translation, 0,
			sizeof(rotor->node[0].rest.translation));
	}
}

/* By 0.02 of a length of 1; half a turn may be tilted by 0.01. */
static void test_a_blade_may_be_off_by_the_most(void **state)
{
	static const struct {
		float tilt[2], away;
		bool whole;
	} rows[] = {{{0.01f, -0.01f}, 0.02f, true}, {{0, 0}, 0.021f, false},
		{{0.011f, 0}, 0, false}, {{0, -0.011f}, 0, false}};

	(void)state;
	for (int i = 0; i < 3 * (int)ARRAY_COUNT(rows); i++) {
		int axis = i % 3, a = (axis + 1) % 3, b = (axis + 2) % 3;
		struct rotor rotor;
		struct transform *rest = &rotor.node[FIRST + 2].rest;

		begin_middle(&rotor, axis);
		memcpy(rotor.body[FIRST].reach, (float[]){0, 1, 0},
			3 * sizeof(float));
		rest->rotation[3] = 0;
		rest->rotation[axis] = 1;
		rest->rotation[a] = rows[i / 3].tilt[0];
		rest->rotation[b] = rows[i / 3].tilt[1];
		rest->translation[b] = rows[i / 3].away;
		expect_axis(&rotor, rows[i / 3].whole ? axis : -1);
	}
}

/* Also if each of two axes would fit by itself. */
static void test_all_blades_turn_about_one_axis(void **state)
{
	struct rotor rotor;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		begin_middle(&rotor, axis);
		expect_axis(&rotor, axis);
		rotor.node[FIRST + 3].rest.rotation[(axis + 1) % 3] =
			rotor.node[FIRST + 3].rest.rotation[axis];
		rotor.node[FIRST + 3].rest.rotation[axis] = 0;
		expect_axis(&rotor, -1);
	}
}

static void test_what_shows_nothing_is_no_blade(void **state)
{
	struct rotor rotor;

	(void)state;
	/* A light, in the middle of the others. */
	begin(&rotor, 1, 4);
	hang_on(&rotor, FIRST + 4, HUB);
	rotor.model.node_count++;
	expect_axis(&rotor, 1);
	/* It shows something at last. */
	hang_on(&rotor, FIRST + 5, FIRST + 4);
	rotor.model.node_count++;
	show(&rotor, FIRST + 5);
	expect_axis(&rotor, -1);
	/* Blades whose nodes hold pivots alone, and the first one a bolt. */
	begin(&rotor, 1, 3);
	for (int i = 0; i < 3; i++) {
		rotor.body[FIRST + i].box = bounds_empty();
		hang_on(&rotor, FIRST + 3 + i, FIRST + i);
		show(&rotor, FIRST + 3 + i);
	}
	hang_on(&rotor, FIRST + 6, FIRST);
	show(&rotor, FIRST + 6);
	rotor.model.node_count += 4;
	expect_axis(&rotor, 1);
}

/* Its matrix may stretch it, so that nothing tells how it is turned. */
static void test_a_blade_with_a_matrix_is_in_no_ring(void **state)
{
	static const float column[4][4] = {{1}, {0, 1}, {0, 0, 1}, {0, 0, 0, 1}};
	struct rotor rotor;

	(void)state;
	for (int blade = 0; blade < 3; blade++) {
		begin(&rotor, 0, 3);
		rotor.node[FIRST + blade].matrix = column;
		expect_axis(&rotor, -1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_three_to_32_blades_are_a_ring),
		cmocka_unit_test(test_blades_may_be_turned_either_way_round),
		cmocka_unit_test(test_the_first_blade_may_be_anywhere),
		cmocka_unit_test(test_each_step_has_one_blade),
		cmocka_unit_test(test_a_blade_may_be_a_little_out_of_place),
		cmocka_unit_test(test_a_blade_may_be_off_by_the_most),
		cmocka_unit_test(test_all_blades_turn_about_one_axis),
		cmocka_unit_test(test_what_shows_nothing_is_no_blade),
		cmocka_unit_test(test_a_blade_with_a_matrix_is_in_no_ring),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
