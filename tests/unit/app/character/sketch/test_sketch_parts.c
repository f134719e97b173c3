/* Which nodes of rigid models buttons turn. */
#include "app/character/sketch/sketch_parts.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	MOST = 12
};

/* A node, in the order of the file: parents before children. */
struct made {
	const char *name;
	int parent;
	bool shows; /* a mesh */
	float x;    /* of its place in the parent's frame */
};

/* Finds the parts of a model that nothing else moves. */
static struct sketch_parts find(const struct made *made, int count)
{
	static const bool no_joint[MOST],
		named[MOST] = {true, true, true, true, true, true, true, true,
			true, true, true, true};
	struct model_node node[MOST];
	struct model_mesh empty = {.primitive_count = 0};
	struct model model = {.node = node,
		.node_count = count,
		.mesh = &empty,
		.mesh_count = 1};
	struct sketch_parts parts;

	for (int i = 0; i < count; i++) {
		node[i] = (struct model_node){.name = made[i].name,
			.parent = made[i].parent,
			.in_scene = true,
			.rest = {{made[i].x, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}},
			.mesh = made[i].shows ? 0 : -1,
			.skin = -1,
			.camera = -1};
	}
	assert_int_equal(
		sketch_find_parts(&model, no_joint, named, true, &parts), 0);
	return parts;
}

static void expect_parts(const struct made *made, int count, bool moved,
	const char *const *wanted)
{
	struct sketch_parts parts = find(made, count);

	for (int i = 0; i < parts.count; i++) {
		assert_non_null(wanted[i]);
		assert_string_equal(made[parts.node[i]].name, wanted[i]);
	}
	assert_null(wanted[parts.count]);
	assert_int_equal(parts.moved, moved);
}

/* A robot arm whose meshes are not parents of the next meshes. */
static void test_nodes_that_hold_pivots_turn_their_meshes(void **state)
{
	static const struct made arm[] = {{"robot", -1, false, 0},
		{"foot", 0, true, 0}, {"axis1", 0, false, 1},
		{"drum1", 2, true, 0}, {"link1", 2, true, 0},
		{"cable", 2, true, 0.1f}, {"axis2", 2, false, 1},
		{"link2", 6, true, 0.5f}};

	(void)state;
	expect_parts(arm, ARRAY_COUNT(arm), true,
		(const char *const[]){"foot", "axis1", "cable", "axis2", NULL});
}

/* The node above all meshes would turn the whole model. */
static void test_meshes_side_by_side_are_parts_of_their_own(void **state)
{
	static const struct made car[] = {{"car", -1, false, 0},
		{"body", 0, true, 0}, {"wheel1", 0, true, 1},
		{"wheel2", 0, true, 2}};
	static const struct made wheels[] = {{"car", -1, false, 0},
		{"body", 0, true, 0}, {"hub1", 0, false, 1},
		{"tyre1", 2, true, 0}};

	(void)state;
	expect_parts(car, ARRAY_COUNT(car), false,
		(const char *const[]){"body", "wheel1", "wheel2", NULL});
	expect_parts(wheels, ARRAY_COUNT(wheels), false,
		(const char *const[]){"body", "hub1", NULL});
}

static void test_meshes_that_hang_on_meshes_are_parts(void **state)
{
	static const struct made arm[] = {{"base", -1, true, 0},
		{"arm", 0, true, 0}, {"hand", 1, true, 0}};

	(void)state;
	expect_parts(arm, ARRAY_COUNT(arm), true,
		(const char *const[]){"base", "arm", "hand", NULL});
}

/* The first node of a file may be one of these, or have them below it. */
static void test_a_pivot_of_a_single_mesh_stands_for_it(void **state)
{
	static const struct made wheel[] = {{"hub", -1, false, 0},
		{"tyre", 0, true, 1}, {"body", -1, true, 0}};
	static const struct made pair[] = {
		{"base", -1, true, 0}, {"arm", 0, true, 0}};
	static const struct made axle[] = {{"axle", -1, false, 0},
		{"left", 0, true, 0}, {"right", 0, true, 1},
		{"body", -1, true, 0}};

	(void)state;
	expect_parts(wheel, ARRAY_COUNT(wheel), false,
		(const char *const[]){"hub", "body", NULL});
	expect_parts(pair, ARRAY_COUNT(pair), true,
		(const char *const[]){"base", "arm", NULL});
	expect_parts(axle, ARRAY_COUNT(axle), true,
		(const char *const[]){"axle", "right", "body", NULL});
}

static void test_nodes_without_meshes_are_no_parts(void **state)
{
	static const struct made lamp[] = {{"base", -1, true, 0},
		{"arm", 0, true, 0}, {"light", 1, false, 0},
		{"empty", -1, false, 0}, {"group", 0, false, 0},
		{"inner", 4, false, 0}, {"shade", 5, true, 0}};

	(void)state;
	expect_parts(lamp, ARRAY_COUNT(lamp), true,
		(const char *const[]){"base", "arm", "inner", NULL});
}

enum {
	JOINTS = 15
};

/*
 * Finds the parts of a chain of joints. Each joint moves a triangle whose size
 * is given. One of them, or -1, has no name.
 */
static struct sketch_parts find_joints(const float size[JOINTS], int unnamed)
{
	struct model_node node[JOINTS + 1];
	int joint[JOINTS];
	float position[3 * JOINTS][3], weight[3 * JOINTS][4] = {{0}};
	uint16_t influence[3 * JOINTS][4] = {{0}};
	uint32_t index[3 * JOINTS];
	bool is_joint[JOINTS + 1] = {false}, named[JOINTS + 1] = {false};
	struct model_skin skin = {.joint = joint, .joint_count = JOINTS};
	struct model_primitive primitive = {.vertex_count = 3 * JOINTS,
		.position = position,
		.influences = 4,
		.joint = influence[0],
		.weight = weight[0],
		.index_count = 3 * JOINTS,
		.index = index};
	struct model_mesh mesh = {.primitive_count = 1, .primitive = &primitive};
	struct model model = {.node = node,
		.node_count = JOINTS + 1,
		.mesh = &mesh,
		.mesh_count = 1,
		.skin = &skin,
		.skin_count = 1};
	struct sketch_parts parts;

	for (int i = 0; i <= JOINTS; i++) {
		node[i] = (struct model_node){.name = "joint",
			.parent = i < JOINTS ? i - 1 : -1,
			.mesh = i < JOINTS ? -1 : 0,
			.skin = i < JOINTS ? -1 : 0};
		is_joint[i] = i < JOINTS;
		named[i] = i != unnamed;
	}
	for (int i = 0; i < 3 * JOINTS; i++) {
		int of = i / 3;
		float at[3][3] = {{0}, {size[of], 0, 0}, {0, size[of], 0}};

		joint[of] = of;
		memcpy(position[i], at[i % 3], sizeof(position[i]));
		influence[i][0] = (uint16_t)of;
		weight[i][0] = 1;
		index[i] = (uint32_t)i;
	}
	assert_int_equal(
		sketch_find_parts(&model, is_joint, named, true, &parts), 0);
	assert_true(parts.bones && parts.moved);
	return parts;
}

/* The first joints may be those of the first hand's fingers. */
static void test_the_joints_that_move_most_are_parts(void **state)
{
	static const float size[JOINTS] = {
		2, 2, 0.1f, 2, 2, 2, 0.1f, 2, 2, 2, 2, 2, 2, 2, 0.1f};
	static const int wanted[SKETCH_PARTS] = {
		0, 1, 3, 4, 5, 7, 8, 9, 10, 11, 12, 13};
	struct sketch_parts parts = find_joints(size, -1);

	(void)state;
	assert_int_equal(parts.count, SKETCH_PARTS);
	assert_memory_equal(parts.node, wanted, sizeof(wanted));
}

/* A root moves all by the joints below it; the end of a limb moves nothing. */
static void test_joints_that_move_nothing_are_no_parts(void **state)
{
	static const float size[JOINTS] = {0, 0, 2, 0, 2};
	struct sketch_parts parts = find_joints(size, -1);

	(void)state;
	assert_int_equal(parts.count, 5);
	for (int i = 0; i < parts.count; i++) {
		assert_int_equal(parts.node[i], i);
	}
}

static void test_joints_without_a_name_are_no_parts(void **state)
{
	static const float size[JOINTS] = {2, 2, 2};
	static const int wanted[] = {0, 2};
	struct sketch_parts parts = find_joints(size, 1);

	(void)state;
	assert_int_equal(parts.count, 2);
	assert_memory_equal(parts.node, wanted, sizeof(wanted));
}

static void test_a_single_joint_is_a_part(void **state)
{
	static const float size[JOINTS] = {2};
	struct sketch_parts parts = find_joints(size, -1);

	(void)state;
	assert_int_equal(parts.count, 1);
	assert_int_equal(parts.node[0], 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_nodes_that_hold_pivots_turn_their_meshes),
		cmocka_unit_test(test_meshes_side_by_side_are_parts_of_their_own),
		cmocka_unit_test(test_meshes_that_hang_on_meshes_are_parts),
		cmocka_unit_test(test_a_pivot_of_a_single_mesh_stands_for_it),
		cmocka_unit_test(test_nodes_without_meshes_are_no_parts),
		cmocka_unit_test(test_the_joints_that_move_most_are_parts),
		cmocka_unit_test(test_joints_that_move_nothing_are_no_parts),
		cmocka_unit_test(test_joints_without_a_name_are_no_parts),
		cmocka_unit_test(test_a_single_joint_is_a_part),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
