/* What nodes turn, and how much of a model joints move. */
#include "app/character/sketch/sketch_body.h"
#include "app/character/sketch/sketch_joints.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	NODES = 4,
	CORNERS = 6,
	INFLUENCES = 4
};

/* A pivot, a mesh below it, and a mesh and a skin below that. */
struct pivot {
	struct model_node node[NODES];
	float position[2][3];
	struct model_primitive primitive;
	struct model_mesh mesh;
	struct model model;
	struct sketch_body body[NODES];
};

static void begin_pivot(struct pivot *pivot)
{
	static const float half = 0.70710678f;
	/* A quarter of a turn about z. */
	static const struct transform rest = {
		{10, 20, 30}, {0, 0, half, half}, {2, 3, 4}};
	static const float position[2][3] = {{1, 2, 3}, {-1, 0.5f, 0}};

	*pivot = (struct pivot){
		.model = {.node = pivot->node, .node_count = NODES}};
	memcpy(pivot->position, position, sizeof(position));
	pivot->primitive = (struct model_primitive){
		.vertex_count = 2, .position = pivot->position};
	pivot->mesh = (struct model_mesh){
		.primitive_count = 1, .primitive = &pivot->primitive};
	pivot->model.mesh = &pivot->mesh;
	for (int i = 0; i < NODES; i++) {
		pivot->node[i] = (struct model_node){.parent = i < 2 ? i - 1 : 1,
			.mesh = i > 0 ? 0 : -1,
			.skin = i == 3 ? 0 : -1,
			.rest = rest};
	}
}

static void expect_box(const struct sketch_body *body, const float low[3],
	const float high[3], const float reach[3])
{
	assert_all_near(body->box.low, low, 3, 1e-4);
	assert_all_near(body->box.high, high, 3, 1e-4);
	assert_all_near(body->reach, reach, 3, 1e-2);
}

/* With the node's scale, as seen from its origin. */
static void test_a_mesh_is_the_body_of_its_node(void **state)
{
	struct pivot pivot;

	(void)state;
	begin_pivot(&pivot);
	sketch_measure_bodies(&pivot.model, pivot.body);
	for (int i = 1; i < 3; i++) {
		expect_box(&pivot.body[i], (float[]){-2, 1.5f, 0},
			(float[]){2, 6, 12}, (float[]){180, 148, 40});
	}
	assert_true(bounds_is_empty(&pivot.body[3].box));
}

/* As their places and rotations say; a mesh that hangs on a mesh stays its own. */
static void test_a_pivot_turns_the_meshes_below_it(void **state)
{
	static const float column[4][4] = {{1}};
	struct pivot pivot;

	(void)state;
	begin_pivot(&pivot);
	sketch_measure_bodies(&pivot.model, pivot.body);
	expect_box(&pivot.body[0], (float[]){4, 18, 30}, (float[]){8.5f, 22, 42},
		(float[]){22 * 22 + 42 * 42, 4 * 4 + 42 * 42, 4 * 4 + 22 * 22});
	/* A matrix may stretch it. */
	pivot.node[1].matrix = column;
	sketch_measure_bodies(&pivot.model, pivot.body);
	assert_true(bounds_is_empty(&pivot.body[0].box));
	assert_false(bounds_is_empty(&pivot.body[1].box));
}

static void test_a_pivot_is_within_a_box_up_to_its_sides(void **state)
{
	static const struct {
		float low, high, part;
		bool within;
	} rows[] = {{-1, 3, 0.25f, true}, {-1, 3, 0.3f, false},
		{-3, 1, 0.25f, true}, {-3, 1, 0.3f, false}, {0, 4, 0, true},
		{-4, 0, 0, true}, {0.5f, 4, 0, false}, {-4, -0.5f, 0, false},
		{0, 0, 0, false}, {1, 1, 0, false}, {-1, -1, 0, false}};

	(void)state;
	for (int i = 0; i < 3 * (int)ARRAY_COUNT(rows); i++) {
		struct bounds box = {{-1, -1, -1}, {1, 1, 1}};

		box.low[i % 3] = rows[i / 3].low;
		box.high[i % 3] = rows[i / 3].high;
		assert_near(sketch_side(&box, i % 3),
			rows[i / 3].high - rows[i / 3].low, 0);
		assert_int_equal(
			sketch_is_pivot_within(&box, i % 3, rows[i / 3].part),
			rows[i / 3].within);
	}
}

/* A skin with the joints 1, 2 and 3, and triangles of an area of 1. */
struct skinned {
	struct model_node node[NODES + 2];
	int joint[3];
	float position[CORNERS][3];
	uint16_t influence[CORNERS][INFLUENCES];
	float weight[CORNERS][INFLUENCES];
	uint32_t index[3];
	struct model_skin skin;
	struct model_primitive primitive[2];
	struct model_mesh mesh[2];
	struct model model;
};

/* Node 4 shows the skin's triangle, and node 5 a rigid one. */
static void begin_skin(struct skinned *skinned)
{
	static const float corner[3][3] = {{1, 1, 1}, {1, 3, 1}, {1, 1, 2}};

	*skinned = (struct skinned){.joint = {1, 2, 3}, .index = {4, 3, 5}};
	for (int i = 0; i < CORNERS; i++) {
		memcpy(skinned->position[i], corner[i % 3], sizeof(corner[0]));
	}
	skinned->skin =
		(struct model_skin){.joint = skinned->joint, .joint_count = 3};
	for (int i = 0; i < 2; i++) {
		skinned->primitive[i] =
			(struct model_primitive){.vertex_count = CORNERS,
				.position = skinned->position,
				.influences = INFLUENCES,
				.joint = skinned->influence[0],
				.weight = skinned->weight[0],
				.index_count = 3,
				.index = skinned->index};
		skinned->mesh[i] = (struct model_mesh){.primitive_count = 1,
			.primitive = &skinned->primitive[i]};
	}
	for (int i = 0; i < NODES + 2; i++) {
		skinned->node[i] = (struct model_node){.parent = -1,
			.mesh = i < NODES ? -1 : i - NODES,
			.skin = i == NODES ? 0 : -1};
	}
	skinned->model = (struct model){.node = skinned->node,
		.node_count = NODES + 2,
		.skin = &skinned->skin,
		.skin_count = 1,
		.mesh = skinned->mesh,
		.mesh_count = 2};
}

/* The nodes that move most, as digits. */
static void expect_joints(
	const struct skinned *skinned, int most, const char *wanted)
{
	static const bool all[NODES + 2] = {true, true, true, true, true, true};
	char found[NODES + 3] = "";
	int node[NODES + 2], count = 9;

	assert_int_equal(
		sketch_find_joints(&skinned->model, all, most, node, &count), 0);
	assert_true(count <= most);
	for (int i = 0; i < count; i++) {
		found[i] = (char)('0' + node[i]);
	}
	assert_string_equal(found, wanted);
}

/* Of all corners of triangles, by their indices, and of no other vertices. */
static void test_each_influence_moves_some_of_a_model(void **state)
{
	struct skinned skinned;

	(void)state;
	for (int i = 0; i < CORNERS * INFLUENCES; i++) {
		begin_skin(&skinned);
		skinned.node[NODES + 1].mesh = -1;
		skinned.influence[i / INFLUENCES][i % INFLUENCES] = 2;
		skinned.weight[i / INFLUENCES][i % INFLUENCES] = 1;
		expect_joints(&skinned, 6, i / INFLUENCES < 3 ? "" : "3");
	}
}

/* A third of the area at each corner, as far as its weight says. */
static void test_areas_tell_what_moves_most(void **state)
{
	struct skinned skinned;

	(void)state;
	for (int larger = 0; larger < 2; larger++) {
		begin_skin(&skinned);
		skinned.index[0] = 0;
		skinned.index[1] = 1;
		skinned.index[2] = 2;
		for (int i = 0; i < 3; i++) {
			skinned.influence[i][0] = 1;
			skinned.weight[i][0] = larger ? 1 : 0.9f;
		}
		skinned.weight[0][0] = larger ? 1.2f : 0.9f;
		expect_joints(&skinned, 1, larger ? "2" : "5");
		expect_joints(&skinned, 2, "25");
	}
}

/* Equal ones in the file's order. */
static void test_the_first_of_equal_joints_stays(void **state)
{
	struct skinned skinned;

	(void)state;
	begin_skin(&skinned);
	for (int i = 3; i < CORNERS; i++) {
		skinned.influence[i][0] = 0;
		skinned.influence[i][1] = 2;
		skinned.weight[i][0] = skinned.weight[i][1] = 0.5f;
	}
	skinned.node[NODES + 1].mesh = -1;
	expect_joints(&skinned, 1, "1");
	expect_joints(&skinned, 2, "13");
	/* What they hang on carries them, also the last node of the file. */
	skinned.node[1].parent = skinned.node[3].parent = 0;
	expect_joints(&skinned, 6, "013");
	begin_skin(&skinned);
	skinned.node[NODES + 1].parent = 2;
	expect_joints(&skinned, 6, "25");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_mesh_is_the_body_of_its_node),
		cmocka_unit_test(test_a_pivot_turns_the_meshes_below_it),
		cmocka_unit_test(test_a_pivot_is_within_a_box_up_to_its_sides),
		cmocka_unit_test(test_each_influence_moves_some_of_a_model),
		cmocka_unit_test(test_areas_tell_what_moves_most),
		cmocka_unit_test(test_the_first_of_equal_joints_stays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
