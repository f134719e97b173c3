/* What limber doctor says about clips that move nothing that is shown. */
#include "app/model/examine/examine.h"
#include "tests/support/test.h"

#include <stdio.h>

enum {
	CAMERA,
	ROOT,
	JOINT,
	TIP,
	BODY,
	HIDDEN,
	NODES
};

static char heard[400];

static void keep(void *context, const char *finding)
{
	(void)context;
	snprintf(heard, sizeof(heard), "%s", finding);
}

/*
 * A root with a joint and a tip that is none, a camera, a body in either skin
 * of that joint, and a mesh out of the scene. Two clips move two nodes.
 */
static void expect(int first, int second, int primitives, const char *wanted)
{
	const struct examiner examiner = {keep, NULL};
	struct log log = log_to_stderr(LOG_WARNING);
	struct model_node node[NODES];
	struct model_primitive primitive = {0};
	struct model_mesh mesh = {
		.primitive = &primitive, .primitive_count = primitives};
	int joint = JOINT;
	struct model_skin skin[2] = {{.joint = &joint, .joint_count = 1},
		{.joint = &joint, .joint_count = 1}};
	struct model_channel channel[2] = {{.node = first}, {.node = second}};
	struct model_clip clip[2] = {
		{.name = "", .channel = &channel[0], .channel_count = 1},
		{.name = "look", .channel = &channel[1], .channel_count = 1}};
	struct model model = {.node = node,
		.node_count = NODES,
		.mesh = &mesh,
		.mesh_count = 1,
		.skin = skin,
		.skin_count = 2,
		.clip = clip,
		.clip_count = 2};

	for (int i = 0; i < NODES; i++) {
		node[i] = (struct model_node){.name = "",
			.parent = i == JOINT ? ROOT
				: i == TIP   ? JOINT
					     : -1,
			.mesh = i == BODY || i == HIDDEN ? 0 : -1,
			.skin = i == BODY ? 0 : -1,
			.in_scene = i != HIDDEN};
	}
	for (int s = 0; s < model.skin_count; s++) {
		node[BODY].skin = s;
		heard[0] = '\0';
		assert_int_equal(
			examine_still_clips(&model, &examiner, &log), 0);
		assert_string_equal(heard, wanted);
	}
}

static void test_a_clip_of_a_camera_is_named(void **state)
{
	(void)state;
	expect(JOINT, CAMERA, 1,
		"clips that move nothing that limber shows (1), such as look: "
		"they move cameras, lights, empty nodes or nothing at all, "
		"and the model stands still");
	expect(TIP, HIDDEN, 1,
		"clips that move nothing that limber shows (2), such as clip "
		"0: they move cameras, lights, empty nodes or nothing at all, "
		"and the model stands still");
}

static void test_joints_meshes_and_what_is_above_them_show_motion(void **state)
{
	(void)state;
	expect(ROOT, JOINT, 1, "");
	expect(BODY, ROOT, 1, "");
}

static void test_a_model_that_shows_nothing_has_no_still_clips(void **state)
{
	(void)state;
	expect(CAMERA, CAMERA, 0, "");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_clip_of_a_camera_is_named),
		cmocka_unit_test(
			test_joints_meshes_and_what_is_above_them_show_motion),
		cmocka_unit_test(
			test_a_model_that_shows_nothing_has_no_still_clips),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
