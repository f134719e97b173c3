/* Which part, joint or target an overlay shows, and which overlay is next. */
#include "app/scene/overlay/overlay.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>

struct scene {
	struct model *model;
	struct instance *instance;
	struct gl gl;
	struct log_capture logged;
	struct overlay *overlay;
};

/* Creates the overlay; returns its error. joint may be "". */
static int begin(struct scene *scene, struct model *model, const char *joint)
{
	const struct log log = log_capture_begin(&scene->logged);
	struct overlay_choice choice = {.kinds = 0};
	struct overlay_subject subject = {.extent = 1};

	snprintf(choice.joint, sizeof(choice.joint), "%s", joint);
	scene->model = model;
	scene->instance = subject.instance = small_model_instance(model);
	scene->gl = gl_recorder_begin();
	scene->overlay = NULL;
	return overlay_create(
		&subject, &scene->gl, &choice, &log, &scene->overlay);
}

static void end(struct scene *scene)
{
	overlay_destroy(scene->overlay);
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

/* Triangles of these nodes; the first one is the root. */
static struct model *load_nodes(const char *nodes)
{
	struct test_path folder = temp_dir_make();
	struct test_path file = path_join(&folder, "nodes.gltf");
	struct log log = log_to_stderr(LOG_WARNING);
	struct model *model;

	triangle_file_write(file.text, nodes);
	assert_int_equal(model_load(file.text, &log, &model), 0);
	temp_dir_remove(&folder);
	return model;
}

static const char family[] =
	"{\"name\":\"a\",\"children\":[1,2]},{\"name\":\"b\",\"mesh\":0},"
	"{\"name\":\"c\",\"mesh\":0,\"children\":[3]},{\"name\":\"d\"}";

static int chosen_after(struct scene *scene, int step)
{
	overlay_choose(scene->overlay, step);
	return scene->overlay->chosen;
}

/* The first with the most vertices; then all parts, forth and back. */
static void test_parts_of_the_scene_are_chosen_in_turn(void **state)
{
	struct scene scene;

	(void)state;
	assert_int_equal(begin(&scene, load_nodes(family), ""), 0);
	assert_int_equal(scene.overlay->chosen, 1);
	assert_int_equal(chosen_after(&scene, 1), 2);
	assert_int_equal(chosen_after(&scene, 1), 3);
	assert_int_equal(chosen_after(&scene, 1), 0);
	assert_int_equal(chosen_after(&scene, -1), 3);
	assert_int_equal(chosen_after(&scene, -1), 2);
	end(&scene);
}

/* What only another scene of the file shows is not chosen. */
static void test_parts_outside_the_scene_are_left_out(void **state)
{
	struct model *model = load_nodes(family);
	struct scene scene;

	(void)state;
	model->node[0].in_scene = model->node[2].in_scene = false;
	assert_int_equal(begin(&scene, model, ""), 0);
	assert_int_equal(scene.overlay->chosen, 1);
	assert_int_equal(chosen_after(&scene, 1), 3);
	assert_int_equal(chosen_after(&scene, 1), 1);
	end(&scene);
	model = load_nodes(family);
	model->node[2].in_scene = false;
	assert_int_equal(begin(&scene, model, "c"), -EINVAL);
	assert_true(log_capture_has(&scene.logged, LOG_ERROR,
		"has no joint or part of that name: give one of a, b, d"));
	end(&scene);
}

static void test_a_part_is_chosen_by_its_name(void **state)
{
	struct scene scene;

	(void)state;
	for (int i = 0; i < 4; i++) {
		const char name[2] = {(char)('a' + i), 0};

		assert_int_equal(begin(&scene, load_nodes(family), name), 0);
		assert_int_equal(scene.overlay->chosen, i);
		end(&scene);
	}
	assert_int_equal(
		begin(&scene, load_nodes("{\"mesh\":0}"), "a"), -EINVAL);
	assert_true(log_capture_has(
		&scene.logged, LOG_ERROR, "of that name: none has a name"));
	end(&scene);
}

/* Only joints, and of them the one that shares the most with others. */
static void test_joints_of_a_skin_are_chosen(void **state)
{
	struct model *model =
		model_fixture("gltf/skin/eight_influences.gltf", NULL);
	const struct model_skin *skin = &model->skin[0];
	struct model_primitive *primitive;
	struct scene scene;
	int first;

	(void)state;
	assert_true(skin->joint_count >= 2);
	primitive = model->mesh[0].primitive;
	for (int wanted = 0; wanted < 2; wanted++) {
		int width = primitive->influences;

		/* Weights of 1 share nothing, whatever joint has them. */
		for (int i = 0; i < primitive->vertex_count * width; i++) {
			primitive->weight[i] = i % width == 0 ? 1 : 0;
			primitive->joint[i] = (uint16_t)!wanted;
		}
		primitive->weight[0] = 0.6f;
		primitive->joint[0] = (uint16_t)wanted;
		assert_int_equal(begin(&scene, model, ""), 0);
		first = scene.overlay->chosen;
		assert_int_equal(first, skin->joint[wanted]);
		for (int i = 0; i < skin->joint_count; i++) {
			bool joint = false;

			overlay_choose(scene.overlay, 1);
			for (int j = 0; j < skin->joint_count; j++) {
				joint = joint ||
					scene.overlay->chosen == skin->joint[j];
			}
			assert_true(joint);
		}
		assert_int_equal(scene.overlay->chosen, first);
		overlay_destroy(scene.overlay);
		instance_destroy(scene.instance);
	}
	model_destroy(model);
}

/* As bits of a word, until none is left. */
static unsigned kinds_in_turn(
	struct overlay *overlay, const struct overlay_motion *motion)
{
	unsigned kinds = 0, last = 0;

	for (int i = 0; i <= OVERLAY_KINDS; i++) {
		overlay_show_next(overlay, motion);
		if (!overlay->kinds) {
			return kinds;
		}
		/* One at a time, each but once. */
		assert_true(overlay->kinds > last);
		assert_int_equal(overlay->kinds & (overlay->kinds - 1), 0);
		last = overlay->kinds;
		kinds |= last;
	}
	fail_msg("there is always another overlay");
	return 0;
}

enum {
	ALWAYS = 1 << OVERLAY_WIREFRAME | 1 << OVERLAY_PIVOTS,
	PARTS = 1 << OVERLAY_SKELETON | 1 << OVERLAY_WEIGHTS
};

/* A skeleton of a single node, or a curve where nothing moves, is none. */
static void test_only_overlays_that_show_something_come_in_turn(void **state)
{
	struct overlay_motion still = overlay_motion_none();
	struct overlay_motion clip = still, morph = still, layers = still;
	struct scene scene;

	(void)state;
	clip.clip = 0;
	morph.morphing = true;
	layers.layer_count = 1;
	assert_int_equal(begin(&scene, load_nodes("{\"mesh\":0}"), ""), 0);
	assert_int_equal(kinds_in_turn(scene.overlay, &still), ALWAYS);
	end(&scene);
	assert_int_equal(begin(&scene, load_nodes(family), ""), 0);
	assert_int_equal(kinds_in_turn(scene.overlay, &still), ALWAYS | PARTS);
	assert_int_equal(kinds_in_turn(scene.overlay, &clip),
		ALWAYS | PARTS | 1 << OVERLAY_KEYS | 1 << OVERLAY_CURVE);
	assert_int_equal(kinds_in_turn(scene.overlay, &morph),
		ALWAYS | PARTS | 1 << OVERLAY_CURVE);
	assert_int_equal(kinds_in_turn(scene.overlay, &layers),
		ALWAYS | PARTS | 1 << OVERLAY_LAYERS);
	end(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_parts_of_the_scene_are_chosen_in_turn),
		cmocka_unit_test(test_parts_outside_the_scene_are_left_out),
		cmocka_unit_test(test_a_part_is_chosen_by_its_name),
		cmocka_unit_test(test_joints_of_a_skin_are_chosen),
		cmocka_unit_test(
			test_only_overlays_that_show_something_come_in_turn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
