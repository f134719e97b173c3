/* How flat parts of rigid models turn, and which parts come first. */
#include "app/character/sketch/sketch_parts.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	MOST = 4
};

/* A node and the box of its mesh, around the node's origin. */
struct made {
	const char *name;
	int parent;
	float low[3], high[3];
	float rotation[4];
};

struct scene {
	struct model_node node[MOST];
	struct model_mesh mesh[MOST];
	struct model_primitive primitive[MOST];
	float corner[MOST][2][3];
	struct model model;
};

static void make(const struct made *made, int count, struct scene *scene)
{
	static const float none[4] = {0};

	*scene = (struct scene){.model = {.node = scene->node,
					.node_count = count,
					.mesh = scene->mesh,
					.mesh_count = count}};
	for (int i = 0; i < count; i++) {
		struct transform rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}};

		if (memcmp(made[i].rotation, none, sizeof(none)) != 0) {
			memcpy(rest.rotation, made[i].rotation, sizeof(none));
		}
		memcpy(scene->corner[i][0], made[i].low, sizeof(made[i].low));
		memcpy(scene->corner[i][1], made[i].high, sizeof(made[i].high));
		scene->primitive[i] = (struct model_primitive){
			.vertex_count = 2, .position = scene->corner[i]};
		scene->mesh[i] = (struct model_mesh){.primitive_count = 1,
			.primitive = &scene->primitive[i]};
		scene->node[i] = (struct model_node){.name = made[i].name,
			.parent = made[i].parent,
			.in_scene = true,
			.rest = rest,
			.mesh = i,
			.skin = -1,
			.camera = -1};
	}
}

static struct sketch_parts find(
	const struct made *made, int count, struct scene *scene)
{
	static const bool no_joint[MOST], named[MOST] = {true, true, true, true};
	struct sketch_parts parts;

	make(made, count, scene);
	assert_int_equal(
		sketch_find_parts(&scene->model, no_joint, named, true, &parts),
		0);
	return parts;
}

/* Asks for the form and the axis of a single part. */
static void expect_turn(struct made one, enum sketch_turn_form form, int axis)
{
	struct scene scene;
	struct sketch_parts parts;

	one.name = "one";
	one.parent = -1;
	parts = find(&one, 1, &scene);
	assert_int_equal(parts.count, 1);
	assert_int_equal(parts.turn[0].form, form);
	assert_int_equal(parts.turn[0].axis, axis);
}

static void test_a_flat_part_turns_in_its_plane(void **state)
{
	(void)state;
	expect_turn((struct made){.low = {-0.05f, -0.1f, 0},
			    .high = {0.05f, 0.8f, 0}},
		SKETCH_TURN_NEEDLE, 2);
	expect_turn((struct made){.low = {-1, -0.01f, -0.05f},
			    .high = {0, 0.01f, 0.05f}},
		SKETCH_TURN_NEEDLE, 1);
	expect_turn((struct made){.low = {-0.1f, -0.33f, -0.33f},
			    .high = {0.1f, 0.33f, 0.33f}},
		SKETCH_TURN_DISC, 0);
	/* Three blades of a windmill. */
	expect_turn((struct made){.low = {-1.76f, -1.04f, -0.05f},
			    .high = {1.76f, 2, 0.05f}},
		SKETCH_TURN_DISC, 2);
}

static void test_a_part_on_a_hinge_or_a_thick_one_turns_freely(void **state)
{
	(void)state;
	/* A door, a flap, an arm, a head, and a needle beside its pivot. */
	expect_turn((struct made){.low = {-0.02f, -0.5f, -1},
			    .high = {0.02f, 0.5f, 0}},
		SKETCH_TURN_FREE, 0);
	expect_turn(
		(struct made){.low = {-2, -0.02f, -0.4f}, .high = {2, 0.02f, 0}},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.05f, -1, -0.05f},
			    .high = {0.05f, 0, 0.05f}},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.1f, -0.1f, -0.1f},
			    .high = {0.1f, 0.1f, 0.1f}},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.05f, 3, 0}, .high = {0.05f, 4, 0}},
		SKETCH_TURN_FREE, 0);
}

static void test_needles_come_first(void **state)
{
	static const struct made panel[] = {
		{"board", -1, {-3, -1, 0}, {3, 1, 0}, {0}},
		{"dial", 0, {-1, -1, 0}, {1, 1, 0}, {0}},
		{"knob", 0, {-0.1f, -0.1f, 0}, {0.1f, 0.1f, 0}, {0}},
		{"needle", 1, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, {0}}};
	static const char *const wanted[] = {"needle", "board", "dial", "knob"};
	struct scene scene;
	struct sketch_parts parts = find(panel, ARRAY_COUNT(panel), &scene);

	(void)state;
	assert_int_equal(parts.count, ARRAY_COUNT(panel));
	for (int i = 0; i < parts.count; i++) {
		assert_string_equal(panel[parts.node[i]].name, wanted[i]);
	}
}

static void test_buttons_move_a_needle_beside_its_dial(void **state)
{
	static const struct made gauge[] = {
		{"dial", -1, {-1, -1, -0.01f}, {1, 1, 0}, {0}},
		{"needle", -1, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, {0}}};
	struct scene scene;
	struct sketch_parts parts = find(gauge, ARRAY_COUNT(gauge), &scene);

	(void)state;
	assert_true(parts.moved);
	assert_int_equal(parts.node[0], 1);
	/* Alone, it would be turned by turning the camera. */
	assert_false(find(&gauge[1], 1, &scene).moved);
}

static void expect_buttons(struct made one, const char *wanted)
{
	struct made made[2] = {{"dial", -1, {-1, -1, -1}, {1, 1, 1}, {0}}, one};
	struct scene scene;
	struct sketch_parts parts = find(made, 2, &scene);
	char text[1024] = "";
	FILE *out = fmemopen(text, sizeof(text), "w");

	assert_non_null(out);
	sketch_write_part_buttons(
		&scene.model, &parts, parts.node[0] == 1 ? 0 : 1, out);
	assert_int_equal(fclose(out), 0);
	if (!strstr(text, wanted)) {
		fail_msg("%s lacks %s", text, wanted);
	}
}

/* The freedom is of the node's frame, the words are those of the picture. */
static void test_buttons_say_how_a_rotated_part_turns(void **state)
{
	const float half = 0.70710678f;
	struct made needle = {"part", 0, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, {0}};
	struct made wheel = {
		"part", 0, {-1, -1, -0.2f}, {1, 1, 0.2f}, {0, half, 0, half}};

	(void)state;
	expect_buttons(needle,
		"LEFT = move part bank 1 \"turn part left\"\n"
		"RIGHT = move part bank -1 \"turn part right\"\n"
		"UP = camera tilt");
	/* Seen from behind. */
	memcpy(needle.rotation, (float[4]){0, 1, 0, 0}, sizeof(needle.rotation));
	expect_buttons(needle, "LEFT = move part bank -1 \"turn part left\"\n");
	/* It lies on its back. */
	memcpy(needle.rotation, (float[4]){-half, 0, 0, half},
		sizeof(needle.rotation));
	expect_buttons(needle, "LEFT = move part bank 1 \"turn part left\"\n");
	/* A wheel whose axle is that of x. */
	expect_buttons(wheel,
		"UP = move part bank -1 \"turn part back\"\n"
		"DOWN = move part bank 1 \"turn part forward\"\n"
		"LEFT = camera turn");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_flat_part_turns_in_its_plane),
		cmocka_unit_test(
			test_a_part_on_a_hinge_or_a_thick_one_turns_freely),
		cmocka_unit_test(test_needles_come_first),
		cmocka_unit_test(test_buttons_move_a_needle_beside_its_dial),
		cmocka_unit_test(test_buttons_say_how_a_rotated_part_turns),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
