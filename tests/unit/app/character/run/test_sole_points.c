/* Points of a skin that are placed without posing its vertices. */
#include "app/character/run/sole.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	INFLUENCES = 4,
	VERTICES = 3
};

/* Of skin joints 0 to 3; a vertex's largest weight stands in any place. */
static float weights[VERTICES][INFLUENCES] = {
	{0.6f, 0.1f, 0.3f, 0.0f},
	{0.1f, 0.2f, 0.05f, 0.65f},
	{0.0f, 0.9f, 0.0f, 0.1f},
};
static uint16_t joints[VERTICES][INFLUENCES] = {
	{2, 1, 0, 3}, {1, 0, 2, 3}, {3, 2, 1, 0}};

static const struct model_primitive primitive = {
	.vertex_count = VERTICES,
	.influences = INFLUENCES,
	.joint = joints[0],
	.weight = weights[0],
};

/* The walker, whose skin's first joints have other nodes than their numbers. */
static int begin(struct acting *acting)
{
	int node = model_find_node(acting->model, "walker_body");

	assert_true(node >= 0);
	assert_true(acting->model->node[node].skin >= 0);
	return node;
}

static void expect_sole(const struct acting *acting, int node, int vertex,
	const int joint[2], const float weight[2])
{
	const float at[3] = {0.1f, 0.9f, -0.2f};
	const struct model_skin *skin =
		&acting->model->skin[acting->model->node[node].skin];
	struct character_sole sole = character_sole_of_vertex(
		acting->model, node, &primitive, vertex, at);
	float place[3];

	for (int i = 0; i < 2; i++) {
		assert_int_equal(sole.node[i], skin->joint[joint[i]]);
		assert_near(sole.weight[i], weight[i], 1e-6);
	}
	assert_int_equal(
		character_sole_mover(acting->model, node, &primitive, vertex),
		skin->joint[joint[0]]);
	/* In the rest pose each joint has it where it is in the mesh. */
	character_sole_place(&sole, acting->instance, place);
	assert_all_near(place, at, 3, 1e-5);
}

static void test_a_point_moves_with_the_two_nodes_of_most_weight(void **state)
{
	struct acting acting;
	int node;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	pose_rest(&acting.instance->pose, acting.model);
	instance_update(acting.instance);
	node = begin(&acting);
	expect_sole(&acting, node, 0, (int[]){2, 0},
		(float[]){0.6f / 0.9f, 0.3f / 0.9f});
	expect_sole(&acting, node, 1, (int[]){3, 0},
		(float[]){0.65f / 0.85f, 0.2f / 0.85f});
	expect_sole(&acting, node, 2, (int[]){2, 0}, (float[]){0.9f, 0.1f});
	acting_end(&acting);
}

/* The place is between those at which the nodes would have it. */
static void test_a_point_lies_between_the_places_of_its_nodes(void **state)
{
	const float at[3] = {0.1f, 0.9f, -0.2f};
	struct character_sole sole;
	struct acting acting;
	float place[3], wanted[3], moved = 0.0f;
	int node;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	pose_rest(&acting.instance->pose, acting.model);
	instance_update(acting.instance);
	node = begin(&acting);
	sole = character_sole_of_vertex(acting.model, node, &primitive, 0, at);
	acting.instance->world[sole.node[0]][3][0] += 3.0f;
	acting.instance->world[sole.node[1]][3][2] += 6.0f;
	character_sole_place(&sole, acting.instance, place);
	memcpy(wanted, at, sizeof(wanted));
	wanted[0] += 3.0f * 2 / 3;
	wanted[2] += 6.0f / 3;
	assert_all_near(place, wanted, 3, 1e-5);
	/* Without a second weight only the first node counts. */
	sole.weight[0] = 1.0f;
	sole.weight[1] = moved;
	character_sole_place(&sole, acting.instance, place);
	assert_near(place[0], at[0] + 3.0f, 1e-5);
	assert_near(place[2], at[2], 1e-5);
	acting_end(&acting);
}

/* Both nodes then move it alike. */
static void test_a_point_without_weights_moves_with_two_nodes(void **state)
{
	static float none[INFLUENCES];
	struct model_primitive bare = primitive;
	struct character_sole sole;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	bare.weight = none;
	sole = character_sole_of_vertex(acting.model, begin(&acting), &bare, 0,
		(float[3]){0.0f, 0.0f, 0.0f});
	assert_near(sole.weight[0], 0.5, 0);
	assert_near(sole.weight[1], 0.5, 0);
	assert_int_not_equal(sole.node[0], sole.node[1]);
	acting_end(&acting);
}

static void test_a_point_without_a_skin_moves_with_its_node(void **state)
{
	const float at[3] = {0.1f, 0.9f, -0.2f};
	struct model_primitive rigid = primitive;
	struct character_sole sole;
	struct acting acting;
	int body, hips;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	body = begin(&acting);
	hips = model_find_node(acting.model, "hips");
	sole = character_sole_of_vertex(acting.model, hips, &primitive, 1, at);
	assert_int_equal(sole.node[0], hips);
	assert_int_equal(sole.node[1], hips);
	assert_near(sole.weight[0], 1, 0);
	assert_near(sole.weight[1], 0, 0);
	assert_all_near(sole.at[0], at, 3, 0);
	assert_int_equal(
		character_sole_mover(acting.model, hips, &primitive, 1), hips);
	rigid.influences = 0;
	sole = character_sole_of_vertex(acting.model, body, &rigid, 1, at);
	assert_int_equal(sole.node[0], body);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_point_moves_with_the_two_nodes_of_most_weight),
		cmocka_unit_test(
			test_a_point_lies_between_the_places_of_its_nodes),
		cmocka_unit_test(
			test_a_point_without_weights_moves_with_two_nodes),
		cmocka_unit_test(test_a_point_without_a_skin_moves_with_its_node),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
