/* How the viewer moves its camera and its ground. */
#include "app/demo/actor.h"
#include "app/demo/demo_figures.h"
#include "app/demo/demo_overlay.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct bench {
	struct log log;
	struct gl gl;
	struct test_path folder, character;
	struct demo *demo;
	struct demo_base *base;
	double now_s;
};

static void put_character(const struct bench *bench, const char *text)
{
	file_write(bench->character.text, text, strlen(text));
}

static void begin_as(struct bench *bench, const char *model,
	const char *character, enum clip_interpolation interpolation)
{
	struct demo_env env;

	*bench = (struct bench){.log = log_to_stderr(LOG_ERROR)};
	bench->gl = gl_recorder_begin();
	bench->folder = temp_dir_make();
	bench->character = path_join(&bench->folder, "scene.character");
	put_character(bench, character);
	env = (struct demo_env){
		.log = &bench->log,
		.gl = &bench->gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = 480,
		.height = 640,
		.model_path = model,
		.character = bench->character.text,
		.repeat = CLIP_LOOP,
		.interpolation = interpolation,
		.speed = 1.0f,
		.follow_file = true,
	};
	assert_int_equal(
		demo_create(&demo_driver_viewer, &env, &bench->demo), 0);
	bench->base = (struct demo_base *)bench->demo;
}

static void begin_model(
	struct bench *bench, const char *model, const char *character)
{
	begin_as(bench, model, character, CLIP_AUTO);
}

static void begin(struct bench *bench, const char *character)
{
	begin_model(bench, "assets/walker.glb", character);
}

static void end(struct bench *bench)
{
	demo_destroy(&demo_driver_viewer, bench->demo);
	temp_dir_remove(&bench->folder);
}

static void step(struct bench *bench, double by_s)
{
	bench->now_s += by_s;
	demo_driver_viewer.update(bench->demo, bench->now_s);
}

static void put(struct bench *bench, enum button button, bool down)
{
	const struct button_event event = {.button = button, .down = down};

	demo_press(&demo_driver_viewer, bench->demo, &event);
}

/* Holds a button for one frame, and returns the camera's zoom. */
static double zoom_after(struct bench *bench, enum button button, double by_s)
{
	put(bench, button, true);
	step(bench, by_s);
	put(bench, button, false);
	step(bench, 0.01);
	return (double)bench->base->stage.camera.fit.zoom;
}

/* As into a room, where it stays while it eases to what a clip needs. */
static void test_the_camera_begins_as_near_as_the_file_says(void **state)
{
	float distance_m[2];

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct bench bench;

		begin(&bench,
			i ? "[scene]\nzoom = 0.2\n[state a]\nclip = idle\n"
			  : "[state a]\nclip = idle\n");
		step(&bench, 0.1);
		step(&bench, 1.0);
		distance_m[i] = bench.base->stage.camera.distance;
		end(&bench);
	}
	assert_near(distance_m[1] / distance_m[0], 0.2, 1e-3);
}

/* By its percentage a second; a long frame halves or doubles it at most. */
static void test_a_frame_zooms_by_at_most_a_factor_of_two(void **state)
{
	struct bench bench;
	double zoom;

	(void)state;
	begin(&bench,
		"[state a]\nclip = rest\n[buttons]\n"
		"UP hold = camera zoom 40\nDOWN hold = camera zoom -40\n");
	step(&bench, 0.1);
	zoom = zoom_after(&bench, BUTTON_UP, 0.5);
	assert_near(zoom, 1.2, 1e-3);
	zoom = zoom_after(&bench, BUTTON_DOWN, 0.5) / zoom;
	assert_near(zoom, 0.8, 1e-3);
	zoom = (double)bench.base->stage.camera.fit.zoom;
	zoom = zoom_after(&bench, BUTTON_UP, 2.0) / zoom;
	assert_near(zoom, 1.8, 1e-3);
	zoom = (double)bench.base->stage.camera.fit.zoom;
	zoom = zoom_after(&bench, BUTTON_UP, 3.0) / zoom;
	assert_near(zoom, 2.0, 1e-3);
	zoom = (double)bench.base->stage.camera.fit.zoom;
	zoom = zoom_after(&bench, BUTTON_DOWN, 3.0) / zoom;
	assert_near(zoom, 0.5, 1e-3);
	end(&bench);
}

/* What remains of its way shrinks by e^-5 in a second. */
static void test_the_camera_eases_to_what_a_clip_needs(void **state)
{
	struct bench bench;
	float half[4];

	(void)state;
	begin(&bench,
		"[state a]\nclip = rest\n[state b]\nclip = jump\n"
		"[buttons]\nUP = go b\n");
	step(&bench, 0.1);
	put(&bench, BUTTON_UP, true);
	for (int i = 0; i < 4; i++) {
		step(&bench, 0.05);
		half[i] = bench.base->stage.camera.fit.half[1];
	}
	assert_true(half[1] > half[0] + 0.01f);
	for (int i = 2; i < 4; i++) {
		assert_near(
			(half[i] - half[i - 1]) / (half[i - 1] - half[i - 2]),
			expf(-5.0f * 0.05f), 1e-3);
	}
	end(&bench);
}

/* The box of the first update is that of the first state. */
static void test_the_first_frame_does_not_ease(void **state)
{
	struct bench bench;
	float half;

	(void)state;
	begin(&bench, "[state b]\nclip = jump\n");
	step(&bench, 0.001);
	half = bench.base->stage.camera.fit.half[1];
	step(&bench, 1.0);
	assert_near(bench.base->stage.camera.fit.half[1], half, 1e-4);
	end(&bench);
}

/* A triangle of 1.9 units, so many times as large. */
static const char triangle[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
	"\"nodes\":[{\"mesh\":0,\"scale\":[%d,%d,%d]}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
	"\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1.9,0]}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
	"\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
	"octet-stream;base64,%s\"}]}";
static const char corners[] = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAADMz8z8AAAAA";

/* In the unit of the model, which the scene may draw at another size. */
static float tile_of(int size)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "triangle.gltf");
	struct bench bench;
	char text[1000];
	float tile;

	snprintf(text, sizeof(text), triangle, size, size, size, corners);
	file_write(path.text, text, strlen(text));
	begin_model(&bench, path.text, "[state a]\nclip = rest\n");
	tile = bench.base->stage.floor.tile /
		bench.base->actor.instance->unit_scale;
	end(&bench);
	temp_dir_remove(&folder);
	return tile;
}

static void test_tiles_do_not_depend_on_the_unit_of_the_model(void **state)
{
	(void)state;
	assert_near(tile_of(1), 0.5, 1e-4);
	assert_near(tile_of(100), 50, 1e-2);
}

/* Those of a walk that stays in its place do, too. */
static void test_key_frames_are_shown_where_the_figure_is(void **state)
{
	const struct overlay_choice keys = {.kinds = 1U << OVERLAY_KEYS};
	const struct instance *ghost;
	struct bench bench;

	(void)state;
	begin_model(&bench, "tests/cli/slider.gltf",
		"[state a]\nclip = slide\n[motion]\nroot = slider\n");
	assert_int_equal(
		demo_overlay_make(&demo_driver_viewer, bench.demo, &keys), 0);
	step(&bench, 0.0);
	step(&bench, 1.0);
	demo_draw(&demo_driver_viewer, bench.demo, 480, 640);
	ghost = bench.base->overlay->ghost.instance;
	assert_near(bench.base->actor.instance->world[0][3][0], 0.0, 1e-6);
	assert_near(ghost->world[0][3][0], 0.0, 1e-6);
	end(&bench);
}

/* Whether the rotation is one of the channel's keys. */
static bool is_key(const struct model_channel *channel, const float rotation[4])
{
	for (int k = 0; k < channel->key_count; k++) {
		const float *key = channel->value + (size_t)k * 4;
		float dot = 0.0f;

		for (int i = 0; i < 4; i++) {
			dot += key[i] * rotation[i];
		}
		if (fabsf(dot) > 1.0f - 1e-6f) {
			return true;
		}
	}
	return false;
}

/* The channels of the walk have keys at different times. */
static void test_key_frames_are_interpolated_as_the_figure_is(void **state)
{
	const struct overlay_choice keys = {.kinds = 1U << OVERLAY_KEYS};
	const struct model_clip *clip;
	const struct pose *ghost;
	struct bench bench;
	int turned = 0;

	(void)state;
	begin_as(&bench, "assets/walker.glb", "[state a]\nclip = walk\n",
		CLIP_STEP);
	assert_int_equal(
		demo_overlay_make(&demo_driver_viewer, bench.demo, &keys), 0);
	step(&bench, 0.0);
	step(&bench, 0.3);
	demo_draw(&demo_driver_viewer, bench.demo, 480, 640);
	ghost = &bench.base->overlay->ghost.instance->pose;
	clip = &ghost->model->clip[model_find_clip(ghost->model, "walk")];
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->path == MODEL_ROTATION && !channel->constant &&
			channel->interpolation == MODEL_LINEAR) {
			assert_true(is_key(
				channel, ghost->local[channel->node].rotation));
			turned++;
		}
	}
	assert_true(turned > 0);
	end(&bench);
}

static void run_to(struct bench *bench, double time_s)
{
	while (bench->now_s < time_s) {
		step(bench, 0.05);
	}
}

/* The camera, and on which side labels take room, but not for other changes. */
static void test_a_changed_scene_is_framed_anew(void **state)
{
	struct bench bench;
	const struct camera *camera;
	float distance, turned;

	(void)state;
	begin(&bench, "[state a]\nclip = rest\n[scene]\nyaw = 10\n");
	camera = &bench.base->stage.camera;
	run_to(&bench, 1.0);
	assert_near(camera->yaw_rad, 0.174533, 1e-5);
	distance = camera->distance;
	put_character(&bench,
		"[state a]\nclip = rest\n[scene]\nyaw = 60\nmargin = 2\n");
	run_to(&bench, 4.3);
	assert_near(camera->yaw_rad, 1.047198, 1e-5);
	assert_true(camera->distance > 1.3f * distance);
	assert_false(bench.base->framing.labels_right);
	put_character(&bench,
		"[state a]\nclip = rest\n[scene]\nyaw = 60\nmargin = 2\n"
		"labels = right\n");
	run_to(&bench, 7.5);
	assert_true(bench.base->framing.labels_right);
	camera_orbit(&bench.base->stage.camera, 0.3f, 0.0f);
	turned = camera->yaw_rad;
	put_character(&bench,
		"[state a]\nclip = idle\n[scene]\nyaw = 60\nmargin = 2\n"
		"labels = right\n");
	run_to(&bench, 10.5);
	assert_near(camera->yaw_rad, turned, 0.0);
	end(&bench);
}

/* Whatever alone asks for another picture; the camera was moved before. */
static void test_each_change_of_the_scene_frames_it_anew(void **state)
{
	static const struct {
		const char *text;
		bool anew;
	} rows[] = {
		{"yaw = 60\npitch = 10\nmargin = 1.5\n[state a]\nclip = idle\n",
			false},
		{"yaw = 61\npitch = 10\nmargin = 1.5\n", true},
		{"yaw = 60\npitch = 12\nmargin = 1.5\n", true},
		{"yaw = 60\npitch = 10\nmargin = 1.6\n", true},
		{"yaw = 60\npitch = 10\nmargin = 1.5\nzoom = 0.5\n", true},
		{"yaw = 60\npitch = 10\nmargin = 1.5\nlabels = right\n", true},
		{"yaw = 60\npitch = 10\nmargin = 1.5\n[parameter v]\n"
		 "range = 0 1\n[buttons]\nUP = add v 1\n",
			true},
		{"yaw = 60\npitch = 10\nmargin = 1.5\n", false},
	};
	static const char before[] =
		"[scene]\nyaw = 60\npitch = 10\nmargin = 1.5\n";

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct bench bench;
		const struct camera *camera;
		char text[256];
		float turned;

		begin(&bench, before);
		camera = &bench.base->stage.camera;
		run_to(&bench, 1.0);
		camera_orbit(&bench.base->stage.camera, 0.3f, 0.0f);
		turned = camera->yaw_rad;
		snprintf(text, sizeof(text), "[scene]\n%s", rows[i].text);
		put_character(&bench, text);
		run_to(&bench, 4.3);
		assert_int_equal(
			fabsf(camera->yaw_rad - turned) > 0.1f, rows[i].anew);
		end(&bench);
	}
}

static int count_label_quads(const struct bench *bench)
{
	static struct hud hud;

	hud.font = &font_default;
	hud_begin(&hud, 240, 320);
	demo_driver_viewer.label(bench->demo, &hud);
	return hud.quad_count;
}

static void test_labels_stay_hidden_when_the_file_changes(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, "[state a]\nclip = rest\n[buttons]\nUP = labels\n");
	run_to(&bench, 1.0);
	assert_true(count_label_quads(&bench) > 0);
	put(&bench, BUTTON_UP, true);
	run_to(&bench, 1.5);
	assert_int_equal(count_label_quads(&bench), 0);
	put_character(
		&bench, "[state b]\nclip = walk\n[buttons]\nUP = labels\n");
	run_to(&bench, 4.3);
	assert_int_equal(count_label_quads(&bench), 0);
	put(&bench, BUTTON_UP, true);
	run_to(&bench, 4.5);
	assert_true(count_label_quads(&bench) > 0);
	end(&bench);
}

/* Blender's clips hold a pose until frame 1, but in the first round only. */
static void test_a_clip_that_begins_late_settles_after_a_round(void **state)
{
	static const struct {
		const char *model, *character;
		double settled_s;
	} runs[] = {{"tests/fixtures/gltf/clip/frame_one.gltf",
			    "[state a]\nclip = go\n", 1.0},
		{"tests/fixtures/gltf/clip/frame_one.gltf",
			"[state a]\nclip = go\nrate = 4\n", 0.25},
		{"tests/fixtures/gltf/clip/frame_one.gltf",
			"[state a]\nclip = go\nrepeat = ping-pong\n", 0.0},
		{"tests/fixtures/gltf/clip/frame_one.gltf",
			"[state a]\nclip = go\n[scene]\nperiod = 7\n", 0.0},
		{"tests/fixtures/gltf/clip/frame_one.gltf",
			"[state a]\nclip = rest\n", 0.0},
		{"assets/walker.glb", "[state a]\nclip = walk\n", 0.0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(runs); i++) {
		struct bench bench;

		begin_model(&bench, runs[i].model, runs[i].character);
		assert_near(demo_driver_viewer.settled_s(bench.demo),
			runs[i].settled_s, 1e-6);
		end(&bench);
	}
}

static void expect_pitch(
	const char *rotation, const char *scene, float pitch_rad)
{
	struct test_path folder = temp_dir_make();
	struct test_path model = path_join(&folder, "triangle.gltf");
	struct bench bench;
	char nodes[64];

	snprintf(nodes, sizeof(nodes), "{\"mesh\":0,\"rotation\":%s}", rotation);
	triangle_file_write(model.text, nodes);
	begin_model(&bench, model.text, scene);
	assert_near(bench.base->stage.camera.pitch_rad, pitch_rad, 1e-5);
	end(&bench);
	temp_dir_remove(&folder);
}

static void test_the_camera_looks_down_at_what_lies_flat(void **state)
{
	static const char lies[] = "[-0.7071068,0,0,0.7071068]";

	(void)state;
	expect_pitch("[0,0,0,1]", "", 0.16f);
	expect_pitch(lies, "", 0.56f);
	expect_pitch(lies, "[scene]\npitch = 9\n", 0.1570796f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_camera_begins_as_near_as_the_file_says),
		cmocka_unit_test(test_a_frame_zooms_by_at_most_a_factor_of_two),
		cmocka_unit_test(test_the_camera_eases_to_what_a_clip_needs),
		cmocka_unit_test(test_the_first_frame_does_not_ease),
		cmocka_unit_test(
			test_tiles_do_not_depend_on_the_unit_of_the_model),
		cmocka_unit_test(test_key_frames_are_shown_where_the_figure_is),
		cmocka_unit_test(
			test_key_frames_are_interpolated_as_the_figure_is),
		cmocka_unit_test(test_a_changed_scene_is_framed_anew),
		cmocka_unit_test(test_each_change_of_the_scene_frames_it_anew),
		cmocka_unit_test(test_labels_stay_hidden_when_the_file_changes),
		cmocka_unit_test(
			test_a_clip_that_begins_late_settles_after_a_round),
		cmocka_unit_test(test_the_camera_looks_down_at_what_lies_flat),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
