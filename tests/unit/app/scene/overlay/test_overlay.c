/* Overlays of the demos and of the viewer. */
#include "app/anim/kernel/kernel.h"
#include "app/anim/math/vec.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/model/model_deltas.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/overlay/overlay_curve.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <malloc.h>
#include <string.h>

static const struct demo_base *base_of(const struct demo_run *run)
{
	return (const struct demo_base *)run->demo;
}

static void draw(struct demo_run *run)
{
	gl_recorder_clear();
	demo_draw(run->driver, run->demo, 480, 640);
	assert_int_equal(gl_recorder_result()->depth, 0);
}

static void next(struct demo_run *run)
{
	demo_show_next_overlay(run->driver, run->demo);
}

static void begin(struct demo_run *run, const char *name)
{
	demo_run_begin(run, name);
	demo_run_to(run, 0.2, 20.0, NULL, 0);
}

/* Shows all overlays of a demo, one after the other, in three frames each. */
static void check_all(const char *name, const char *expected)
{
	struct demo_run run;
	char shown[128] = "";

	begin(&run, name);
	draw(&run);
	for (int i = 0; i <= OVERLAY_KINDS; i++) {
		unsigned kinds;
		struct mallinfo2 before, after;

		next(&run);
		kinds = base_of(&run)->overlay->kinds;
		if (!kinds) {
			break;
		}
		for (int kind = 0; kind < OVERLAY_KINDS; kind++) {
			if (kinds >> kind & 1) {
				strcat(shown,
					overlay_kind_name(
						(enum overlay_kind)kind));
				strcat(shown, " ");
			}
		}
		draw(&run);
		before = mallinfo2();
		demo_run_to(&run, run.now_s + 0.1, 20.0, NULL, 0);
		draw(&run);
		after = mallinfo2();
		assert_int_equal(before.uordblks, after.uordblks);
	}
	assert_string_equal(shown, expected);
	demo_run_end(&run);
}

static void test_every_demo_has_the_overlays_that_apply(void **state)
{
	(void)state;
	check_all("walker",
		"skeleton weights wireframe keys pivots curve layers ");
	check_all("arm", "skeleton weights wireframe pivots ");
	check_all("face", "weights wireframe keys pivots curve ");
	check_all("crowd", "skeleton weights wireframe keys pivots curve ");
	check_all("duel", "skeleton weights wireframe keys pivots curve ");
	check_all("tuner",
		"skeleton weights wireframe keys pivots curve layers ");
	check_all("walker.glb", "skeleton weights wireframe keys pivots curve ");
}

static void test_a_frame_with_weights_leaves_the_materials(void **state)
{
	const struct model *model;
	const void *color;
	struct demo_run run;

	(void)state;
	begin(&run, "walker");
	model = base_of(&run)->actor.instance->model;
	color = base_of(&run)->actor.instance->drawable[0].batch[0].color;
	next(&run);
	next(&run);
	assert_true(overlay_shows(base_of(&run)->overlay, OVERLAY_WEIGHTS));
	draw(&run);
	assert_ptr_equal(base_of(&run)->actor.instance->model, model);
	assert_ptr_equal(
		base_of(&run)->actor.instance->drawable[0].batch[0].color,
		color);
	demo_run_end(&run);
}

/* In fixed point the vertices have another order; the colours follow it. */
static void test_heat_is_the_weight_of_the_joint(void **state)
{
	struct demo_run run;
	struct instance *instance;
	struct overlay_heat heat;
	struct arena arena = arena_empty();
	float value[64] = {0.0f};
	int joint, hot = 0;

	(void)state;
	demo_run_begin_by(&run, "walker", "fixed");
	instance = base_of(&run)->actor.instance;
	joint = model_find_node(instance->model, "forearm.L");
	value[joint] = 1.0f;
	assert_int_equal(overlay_heat_init(&heat, instance, &arena), 0);
	overlay_heat_paint_nodes(&heat, value);
	overlay_heat_switch(&heat, true);
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		const struct batch *batch = &drawable->batch[0];

		for (int i = 0; drawable->skin >= 0 && i < batch->vertex_count;
			i++) {
			uint32_t v = batch->source ? batch->source[i]
				: drawable->fixed && drawable->fixed->order
				? drawable->fixed->order[i]
				: (uint32_t)i;
			const struct model_primitive *p = drawable->primitive;
			float weight = 0.0f;
			uint8_t rgb[3];

			for (int k = 0; k < p->influences; k++) {
				size_t at =
					v * (size_t)p->influences + (size_t)k;

				if (instance->model->skin[drawable->skin]
						.joint[p->joint[at]] == joint) {
					weight += p->weight[at];
				}
			}
			overlay_heat_ramp(weight, rgb);
			hot += weight > 0.5f;
			for (int c = 0; c < 3; c++) {
				assert_near(batch->color[i][c], rgb[c], 2.0);
			}
		}
	}
	overlay_heat_switch(&heat, false);
	assert_true(hot > 20);
	arena_release(&arena);
	demo_run_end(&run);
}

/* The second mesh of the model has no targets. */
static void test_heat_of_a_target_leaves_other_meshes_cold(void **state)
{
	struct model *model = model_fixture("gltf/accessor/zeros.gltf", NULL);
	struct arena arena = arena_empty();
	struct instance *instance;
	struct overlay_heat heat;
	uint8_t cold[3];

	(void)state;
	overlay_heat_ramp(0.0f, cold);
	assert_int_equal(
		instance_create(model, &kernel_float, NULL, &instance), 0);
	assert_int_equal(overlay_heat_init(&heat, instance, &arena), 0);
	for (int target = 0; target < 2; target++) {
		overlay_heat_paint_target(&heat, target);
		overlay_heat_switch(&heat, true);
		assert_int_equal(instance->drawable_count, 2);
		for (int v = 0; v < 3; v++) {
			assert_memory_equal(
				instance->drawable[1].batch[0].color[v], cold,
				3);
		}
		overlay_heat_switch(&heat, false);
	}
	arena_release(&arena);
	instance_destroy(instance);
	model_destroy(model);
}

/* How far a target moves a vertex of a drawable whose mesh has it. */
static float moved(const struct drawable *drawable, int target, int vertex)
{
	float by[3];

	model_deltas_get(
		&drawable->primitive->target[target].position, vertex, by);
	return vec_length(by);
}

static float farthest_of(const struct drawable *drawable, int target)
{
	float farthest = 0.0f;

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float distance = moved(drawable, target, v);

		farthest = distance > farthest ? distance : farthest;
	}
	return farthest;
}

/* Compared with the vertex of any mesh that it moves farthest. */
static void test_heat_of_a_target_is_how_far_it_moves_a_vertex(void **state)
{
	struct log log = log_to_stderr(LOG_ERROR);
	struct arena arena = arena_empty();
	struct instance *instance;
	struct overlay_heat heat;
	struct model *model;

	(void)state;
	assert_int_equal(model_load("assets/face.glb", &log, &model), 0);
	assert_int_equal(
		instance_create(model, &kernel_float, &log, &instance), 0);
	assert_int_equal(overlay_heat_init(&heat, instance, &arena), 0);
	overlay_heat_switch(&heat, true);
	for (int target = 0; target < 4; target++) {
		float farthest = 0.0f;

		for (int d = 0; d < instance->drawable_count; d++) {
			float one = drawable_target_count(instance,
					    &instance->drawable[d]) > target
				? farthest_of(&instance->drawable[d], target)
				: 0.0f;

			farthest = one > farthest ? one : farthest;
		}
		assert_true(farthest > 0.0f);
		overlay_heat_paint_target(&heat, target);
		for (int d = 0; d < instance->drawable_count; d++) {
			const struct drawable *drawable = &instance->drawable[d];
			const struct batch *batch = drawable->batch;
			bool has_it = drawable_target_count(
					      instance, drawable) > target;

			for (int i = 0; i < batch->vertex_count; i++) {
				int v = batch_vertex(drawable, batch, i);
				uint8_t rgb[3];

				overlay_heat_ramp(has_it
						? moved(drawable, target, v) /
							farthest
						: 0.0f,
					rgb);
				assert_memory_equal(batch->color[i], rgb, 3);
			}
		}
	}
	overlay_heat_switch(&heat, false);
	arena_release(&arena);
	instance_destroy(instance);
	model_destroy(model);
}

/* Both sides of a material stay visible, and its bumps come back. */
static void test_heat_replaces_materials_as_long_as_it_is_shown(void **state)
{
	struct log log = log_to_stderr(LOG_ERROR);
	struct arena arena = arena_empty();
	struct instance *instance;
	struct overlay_heat heat;
	struct model *model;

	(void)state;
	assert_int_equal(model_load("assets/walker.glb", &log, &model), 0);
	for (int i = 0; i < model->material_count; i++) {
		model->material[i].double_sided = i % 2;
	}
	for (int mapping = 0; mapping < 2; mapping++) {
		assert_int_equal(
			instance_create(model, &kernel_float, &log, &instance),
			0);
		assert_int_equal(overlay_heat_init(&heat, instance, &arena), 0);
		instance->normal_mapping = mapping;
		for (int twice = 0; twice < 2; twice++) {
			overlay_heat_switch(&heat, true);
			assert_false(instance->normal_mapping);
			assert_ptr_not_equal(instance->model, model);
		}
		for (int i = 0; i < model->material_count; i++) {
			const struct model_material *shown =
				&instance->model->material[i];

			assert_int_equal(shown->double_sided, i % 2);
			assert_all_near(shown->base_color,
				model_plain_material.base_color, 4, 0.0);
			assert_int_equal(shown->texture, -1);
			assert_int_equal(shown->normal_texture, -1);
		}
		for (int twice = 0; twice < 2; twice++) {
			overlay_heat_switch(&heat, false);
			assert_int_equal(instance->normal_mapping, mapping);
			assert_ptr_equal(instance->model, model);
		}
		instance_destroy(instance);
	}
	arena_release(&arena);
	model_destroy(model);
}

static void test_joints_are_chosen_in_turn(void **state)
{
	struct demo_run run;
	const struct overlay *overlay;
	int first;

	(void)state;
	begin(&run, "walker");
	demo_choose_joint(run.demo, 1); /* nothing is shown: no effect */
	next(&run);
	overlay = base_of(&run)->overlay;
	first = overlay->chosen;
	assert_true(overlay->is_bone[first]);
	demo_choose_joint(run.demo, 1);
	assert_int_not_equal(overlay->chosen, first);
	demo_choose_joint(run.demo, -1);
	assert_int_equal(overlay->chosen, first);
	demo_run_end(&run);
}

static void test_a_joint_that_the_model_lacks_is_named(void **state)
{
	const struct overlay_choice choice = {
		.kinds = 1u << OVERLAY_WEIGHTS, .joint = "tail"};
	struct log_capture logged;
	const struct log log = log_capture_begin(&logged);
	struct overlay *other = NULL;
	struct demo_run run;
	const struct overlay *overlay;

	(void)state;
	begin(&run, "walker");
	next(&run);
	overlay = base_of(&run)->overlay;
	assert_int_equal(overlay_create(&overlay->subject, overlay->gl, &choice,
				 &log, &other),
		-EINVAL);
	assert_null(other);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0],
		"has no joint or part of that name: give one of ponytail.1, ");
	demo_run_end(&run);
}

static void test_onion_skins_are_key_frames(void **state)
{
	static const float a[] = {0.0f, 0.5f, 1.0f};
	static const float b[] = {0.0f, 0.3f, 0.7f, 1.0f};
	struct model_channel channel[2] = {
		{.key_count = 3, .time_s = a}, {.key_count = 4, .time_s = b}};
	const struct model_clip clip = {
		.duration_s = 1.0f, .channel_count = 2, .channel = channel};

	(void)state;
	assert_near(overlay_ghost_key_time(&clip, 0.4f, 0.05f), 0.5, 1e-6);
	assert_near(overlay_ghost_key_time(&clip, 0.4f, 0.15f), 0.7, 1e-6);
	assert_near(overlay_ghost_key_time(&clip, 0.4f, -0.05f), 0.3, 1e-6);
	assert_near(overlay_ghost_key_time(&clip, 0.4f, -0.2f), 0.0, 1e-6);
	assert_true(overlay_ghost_key_time(&clip, 0.99f, 0.05f) < 0.0f);
	assert_true(overlay_ghost_key_time(&clip, 0.02f, -0.05f) < 0.0f);
}

static float square(const void *user, float omega)
{
	(void)user;
	return omega * omega;
}

static void test_the_morph_curve_begins_at_0_and_ends_at_1(void **state)
{
	const struct overlay_way straight = {0}, wavy = {.wave = 0.35f},
				 bent = {.shape = square};
	struct overlay_curve line = overlay_curve_of_morph(&straight, 0.25f);
	struct overlay_curve wave = overlay_curve_of_morph(&wavy, 0.25f);
	struct overlay_curve shaped = overlay_curve_of_morph(&bent, 0.25f);
	int last = OVERLAY_CURVE_POINTS - 1;

	(void)state;
	assert_int_equal(line.count, 1);
	assert_int_equal(wave.count, 3);
	assert_near(line.value[0][0], 0.0, 1e-6);
	assert_near(line.value[0][last], 1.0, 1e-6);
	assert_near(wave.value[0][0], 0.0, 1e-5);
	assert_near(wave.value[0][last], 1.0, 1e-5);
	assert_near(wave.value[0][last / 2 + 1], 0.51 + 0.35, 0.01);
	assert_near(wave.at, 0.25, 1e-6);
	assert_int_equal(shaped.count, 1);
	assert_near(shaped.value[0][last], 1.0, 1e-6);
	assert_near(shaped.value[0][last / 3], 1.0 / 9.0, 1e-4);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_demo_has_the_overlays_that_apply),
		cmocka_unit_test(test_a_frame_with_weights_leaves_the_materials),
		cmocka_unit_test(test_heat_is_the_weight_of_the_joint),
		cmocka_unit_test(test_heat_of_a_target_leaves_other_meshes_cold),
		cmocka_unit_test(
			test_heat_of_a_target_is_how_far_it_moves_a_vertex),
		cmocka_unit_test(
			test_heat_replaces_materials_as_long_as_it_is_shown),
		cmocka_unit_test(test_joints_are_chosen_in_turn),
		cmocka_unit_test(test_a_joint_that_the_model_lacks_is_named),
		cmocka_unit_test(test_onion_skins_are_key_frames),
		cmocka_unit_test(test_the_morph_curve_begins_at_0_and_ends_at_1),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
