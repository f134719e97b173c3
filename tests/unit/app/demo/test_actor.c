/* What a demo says of the model that it loads, and the pictures it frames. */
#include "app/character/character_data.h"
#include "app/character/show/character_bounds.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/demo_overlay.h"
#include "tests/support/demo_shown.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The begin of an accessor of write_dense()'s vertices. */
#define VIEW(offset, component, type)              \
	"{\"bufferView\":0,\"byteOffset\":" offset \
	",\"componentType\":" component ",\"type\":\"" type "\",\"count\":9216"

/* Loads the model and returns how many warnings and errors that brings. */
static int load(const char *path, size_t memory_bytes,
	struct log_capture *heard, int *error)
{
	struct log log = log_capture_begin(heard);
	struct gl gl = gl_recorder_begin();
	const struct demo_env env = {.log = &log,
		.gl = &gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.model_path = path,
		.memory_bytes = memory_bytes,
		.interpolation = CLIP_STEP};
	struct actor actor;

	*error = actor_load(&actor, &env);
	if (*error) {
		assert_null(actor.model);
	} else {
		assert_int_equal(actor.interpolation, CLIP_STEP);
		actor_unload(&actor, &gl);
	}
	return log_capture_count(heard, LOG_WARNING) +
		log_capture_count(heard, LOG_ERROR);
}

/*
 * Writes a .x file with a triangle, two metres long, at this place. If it is
 * animated, it begins at the origin.
 */
static void write_xfile(const char *path, const char *place, bool animated)
{
	char text[512];
	int length = snprintf(text, sizeof(text),
		"xof 0303txt 0032\nFrame F { FrameTransformMatrix { "
		"2,0,0,0,0,2,0,0,0,0,2,0,%s,1;; } Mesh M { 3; 0;0;0;, 1;0;0;, "
		"0;1;0;; 1; 3;0,1,2;; } }\n%s",
		place,
		animated ? "AnimationSet A { Animation { { F } AnimationKey { "
			   "2; 1; 0; 3; 0,0,0;;; } } }"
			 : "");

	file_write(path, text, (size_t)length);
}

/* It is moved to the origin unless a clip begins elsewhere. */
static void test_a_model_far_from_the_origin_is_drawn_or_named(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "far.gltf");
	struct log_capture heard;
	int error;

	(void)state;
	triangle_file_write(
		path.text, "{\"mesh\":0,\"translation\":[0,3e8,32001]}");
	assert_int_equal(load(path.text, 0, &heard, &error), 0);
	assert_int_equal(error, 0);
	write_xfile(path.text, "0,3e8,32001", false);
	assert_int_equal(load(path.text, 0, &heard, &error), 0);
	assert_int_equal(error, 0);
	write_xfile(path.text, "0,0,-31999", true);
	assert_int_equal(load(path.text, 0, &heard, &error), 0);
	write_xfile(path.text, "0,0,32001", true);
	assert_int_equal(load(path.text, 0, &heard, &error), 1);
	assert_int_equal(error, 0);
	assert_true(log_capture_has(&heard, LOG_WARNING,
		"stands 32001 m from the origin, 16000 times its size"));
	/* Rounding leaves it no size. */
	write_xfile(path.text, "0,3e8,0", true);
	assert_int_equal(load(path.text, 0, &heard, &error), 1);
	assert_true(log_capture_has(&heard, LOG_WARNING,
		"stands 300000000 m from the origin, where limber cannot"));
	temp_dir_remove(&folder);
}

static void test_a_model_without_triangles_is_named(void **state)
{
	struct log_capture heard;
	int error;

	(void)state;
	(void)load("tests/fixtures/gltf/scene/matrices.gltf", 0, &heard, &error);
	assert_int_equal(error, 0);
	assert_true(log_capture_has(
		&heard, LOG_WARNING, "has no triangles, so the stage stays"));
}

static void test_a_model_has_to_fit_its_memory(void **state)
{
	struct log_capture heard;
	int error;

	(void)state;
	assert_int_equal(load("assets/arm.glb", 4096, &heard, &error), 1);
	assert_int_not_equal(error, 0);
	assert_int_equal(load("assets/arm.glb", 0, &heard, &error), 0);
	assert_int_equal(error, 0);
}

static void test_demos_are_found_by_their_names(void **state)
{
	(void)state;
	for (int i = 0; demo_registry[i]; i++) {
		assert_ptr_equal(
			demo_find(demo_registry[i]->name), demo_registry[i]);
	}
	assert_string_equal(demo_registry[0]->name, "walker");
	assert_null(demo_find("walk"));
	assert_null(demo_find("viewer"));
}

/* The lower edge of the region that the figure has. */
static double bottom_of(const struct shown *shown)
{
	return (double)((const struct demo_base *)shown->demo)
		->stage.camera.fit.region.bottom;
}

/* While the row of a face's shapes is shown. */
static void test_small_pictures_take_room_below_the_figure(void **state)
{
	/* Heights of the region, of which 0.2 are left, and the row's room. */
	static const double regions[][2] = {
		{1.5, 1.0}, {0.3, 0.1}, {0.2, 0.0}, {0.1, 0.0}};
	static const int size[2] = {480, 640};
	struct shown shown;
	struct demo_base *base;
	struct overlay_row row;
	double before, room;

	(void)state;
	shown_begin(&shown, "face", size, false);
	base = (struct demo_base *)shown.demo;
	demo_draw(shown.driver, shown.demo, size[0], size[1]);
	before = bottom_of(&shown);
	for (size_t i = 0; i < ARRAY_COUNT(regions); i++) {
		base->stage.camera.fit.region.top =
			(float)(before + regions[i][0]);
		while (!base->overlay ||
			!overlay_shows(base->overlay, OVERLAY_KEYS)) {
			demo_show_next_overlay(shown.driver, shown.demo);
		}
		row = overlay_row_of(base->overlay, size[0], size[1]);
		room = 2.0 * (double)row.height / (double)size[1];
		for (int k = 0; k < 2; k++) {
			demo_draw(shown.driver, shown.demo, size[0], size[1]);
			assert_near(bottom_of(&shown),
				before + fmin(room, regions[i][1]), 1e-5);
		}
		while (overlay_shows(base->overlay, OVERLAY_KEYS)) {
			demo_show_next_overlay(shown.driver, shown.demo);
		}
		demo_draw(shown.driver, shown.demo, size[0], size[1]);
		assert_near(bottom_of(&shown), before, 1e-5);
	}
	shown_end(&shown);
}

/* Also while the figure is beside its labels, or was moved closer. */
static void test_each_small_picture_shows_the_figure_in_its_middle(void **state)
{
	static const int sizes[][2] = {{480, 640}, {320, 240}, {800, 480}};
	const struct overlay_choice keys = {.kinds = 1U << OVERLAY_KEYS};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(sizes); i++) {
		const int *size = sizes[i / 2];
		struct overlay_row row;
		struct camera_region seen;
		struct camera camera;
		struct shown shown;
		struct demo_base *base;
		int cell[2];

		shown_begin(&shown, "face", size, false);
		base = (struct demo_base *)shown.demo;
		assert_int_equal(
			demo_overlay_make(shown.driver, shown.demo, &keys), 0);
		camera_zoom(&base->stage.camera, i % 2 ? 0.5f : 1.0f);
		demo_draw(shown.driver, shown.demo, size[0], size[1]);
		row = overlay_row_of(base->overlay, size[0], size[1]);
		camera = overlay_row_camera(&row, &base->stage.camera);
		cell[0] = row.width;
		cell[1] = row.height;
		seen = shown_project(
			&camera, cell, camera.target, camera.fit.half);
		assert_near(seen.left + seen.right, 0, 0.01);
		assert_near(seen.bottom + seen.top, 0, 0.01);
		assert_near(fmax((double)(seen.right - seen.left),
				    (double)(seen.top - seen.bottom)),
			2.0 / 1.15, 0.01);
		shown_end(&shown);
	}
}

static void test_a_picture_of_another_size_has_its_own_room(void **state)
{
	static const int sizes[][2] = {{480, 640}, {320, 240}, {480, 640}};
	const struct overlay_choice keys = {.kinds = 1U << OVERLAY_KEYS};
	double bottom[ARRAY_COUNT(sizes)];
	struct shown shown;

	(void)state;
	shown_begin(&shown, "face", sizes[0], false);
	assert_int_equal(demo_overlay_make(shown.driver, shown.demo, &keys), 0);
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		demo_draw(shown.driver, shown.demo, sizes[i][0], sizes[i][1]);
		bottom[i] = bottom_of(&shown);
	}
	assert_near(bottom[2], bottom[0], 1e-5);
	shown_end(&shown);
}

/* --influences gives a cap, and the frame's budget a limit; 0 is none. */
static void test_the_lower_of_cap_and_limit_holds(void **state)
{
	static const int cases[][3] = {{0, 0, 0}, {0, 2, 2}, {3, 0, 3},
		{3, 2, 2}, {3, 3, 3}, {3, 4, 3}};
	struct shown shown;
	struct actor *actor;

	(void)state;
	shown_begin(&shown, "arm.glb", (const int[]){320, 240}, false);
	actor = &((struct demo_base *)shown.demo)->actor;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct demo_reduction reduction = {
			.max_influences = cases[i][1],
			.error_px = 2.0f * (float)i,
			.hold_normals = i % 2 == 0};

		actor->influence_cap = (struct influence_cap){
			INFLUENCE_CAP_FIXED, cases[i][0]};
		demo_set_reduction(shown.demo, &reduction);
		shown.driver->update(shown.demo, 0.1 * (double)(1 + i));
		assert_int_equal(actor->instance->max_influences, cases[i][2]);
		assert_near(actor->min_error_px, reduction.error_px, 0.0);
		assert_int_equal(
			actor->instance->hold_normals, reduction.hold_normals);
	}
	shown_end(&shown);
}

enum {
	SIDE = 96, /* vertices; together more than a plain actor's skin has */
	SQUARES = (SIDE - 1) * (SIDE - 1)
};

/* A hilly square from -1 to 1 that one joint moves. */
static void write_dense(const struct test_path *folder, const char *path)
{
	static const char text[] =
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0,1]}],"
		"\"nodes\":[{\"mesh\":0,\"skin\":0},{}],"
		"\"skins\":[{\"joints\":[1]}],"
		"\"meshes\":[{\"primitives\":[{\"indices\":4,\"attributes\":{"
		"\"POSITION\":0,\"NORMAL\":1,\"JOINTS_0\":2,\"WEIGHTS_0\":3}}]}],"
		"\"buffers\":[{\"uri\":\"dense.bin\",\"byteLength\":%zu}],"
		"\"bufferViews\":[{\"buffer\":0,\"byteLength\":%zu,"
		"\"byteStride\":44},"
		"{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}],"
		"\"accessors\":[" VIEW("0", "5126",
			"VEC3") ",\"min\":[-1,-1,-1],"
				"\"max\":[1,1,1]}," VIEW(
					"12", "5126", "VEC3") "}," VIEW("24",
					"5121", "VEC4") "}," VIEW("28", "5126",
					"VEC4") "},"
						"{\"bufferView\":1,\"componentType\":5123,\"type\":\"SCALAR\","
						"\"count\":%d}]}";
	static struct {
		struct {
			float position[3], normal[3];
			uint8_t joint[4];
			float weight[4];
		} vertex[SIDE * SIDE];
		uint16_t index[SQUARES][6];
	} data;
	const size_t vertices = sizeof(data.vertex);
	struct test_path bin = path_join(folder, "dense.bin");
	char json[sizeof(text) + 100];

	for (int v = 0; v < SIDE * SIDE; v++) {
		float x = (float)(v % SIDE) * 2 / (SIDE - 1) - 1;
		float y = (float)(v / SIDE) * 2 / (SIDE - 1) - 1;

		data.vertex[v].position[0] = x;
		data.vertex[v].position[1] = y;
		data.vertex[v].position[2] = 0.1f * sinf(5 * x) * sinf(4 * y);
		data.vertex[v].normal[2] = data.vertex[v].weight[0] = 1;
	}
	for (int q = 0; q < SQUARES; q++) {
		int at = q / (SIDE - 1) * SIDE + q % (SIDE - 1);
		const int corner[] = {at, at + 1, at + SIDE, at + 1,
			at + SIDE + 1, at + SIDE};

		for (int i = 0; i < 6; i++) {
			data.index[q][i] = (uint16_t)corner[i];
		}
	}
	snprintf(json, sizeof(json), text, sizeof(data), vertices, vertices,
		sizeof(data.index), SQUARES * 6);
	file_write(bin.text, &data, sizeof(data));
	file_write(path, json, strlen(json));
}

/* A character of it has bounds that are posed at all levels. */
static void expect_posed_bounds(struct instance *instance)
{
	static const float straight[2] = {0.0f, 0.0f};
	struct character_part part = {0};
	const struct character character = {
		.instance = instance, .part = &part, .part_count = 1};
	struct character_bounds bounds;
	struct bounds now = bounds_empty();

	assert_int_equal(character_bounds_init(&bounds, &character), 0);
	character_bounds_add(&bounds, instance, 0, 0.0f, straight, &now);
	assert_true(bounds_extent(&now) > 1.9f);
	for (int v = 0; v < SIDE * SIDE; v++) {
		instance->drawable[0].fixed->position[v].x = INT16_MAX;
	}
	instance_update(instance);
	now = bounds_empty();
	character_bounds_add(&bounds, instance, 0, 0.0f, straight, &now);
	assert_true(now.high[0] < 1.1f);
}

static void test_only_what_is_drawn_of_a_dense_skin_is_posed(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "dense.gltf");
	struct log log = log_to_nowhere();
	struct gl gl = gl_recorder_begin();
	const struct demo_env env = {.log = &log,
		.gl = &gl,
		.kernel = kernel_find("fixed"),
		.model_path = path.text};
	struct camera camera = camera_default();
	const struct fixed_vector *last;
	struct drawable *drawable;
	struct bounds bounds;
	struct actor actor;

	(void)state;
	write_dense(&folder, path.text);
	assert_int_equal(actor_load(&actor, &env), 0);
	drawable = &actor.instance->drawable[0];
	last = &drawable->fixed->position[SIDE * SIDE - 1];
	camera.distance = 20.0f * actor.extent;
	actor_update(&actor, &camera, 240);
	assert_in_range(drawable->lod, 1, 99);
	for (int v = 0; v < SIDE * SIDE; v++) {
		drawable->fixed->position[v].x = INT16_MAX;
	}
	actor_update(&actor, &camera, 240);
	assert_int_equal(drawable->posed_lod, drawable->lod);
	assert_int_equal(last->x, INT16_MAX);
	bounds = bounds_of_instance(actor.instance);
	assert_near(bounds_extent(&bounds) / actor.extent, 1.0, 0.02);
	expect_posed_bounds(actor.instance);
	camera.distance = 1.1f * actor.extent;
	actor_update(&actor, &camera, 64000);
	assert_int_equal(drawable->posed_lod, 0);
	assert_int_not_equal(last->x, INT16_MAX);
	actor_unload(&actor, &gl);
	temp_dir_remove(&folder);
}

static void test_only_a_camera_has_uses(void **state)
{
	static const struct camera_feed feed = {0};
	struct shown shown;
	struct live *live;

	(void)state;
	shown_begin(&shown, "arm.glb", (const int[]){320, 240}, false);
	live = &((struct demo_base *)shown.demo)->live;
	demo_next_camera_use(shown.demo);
	assert_int_equal(live->use, LIVE_BACKGROUND);
	live->feed = &feed;
	for (int use = LIVE_BACKGROUND; use < LIVE_USES; use++) {
		assert_int_equal(live->use, use);
		demo_next_camera_use(shown.demo);
	}
	assert_int_equal(live->use, LIVE_BACKGROUND);
	live->feed = NULL;
	shown_end(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_model_far_from_the_origin_is_drawn_or_named),
		cmocka_unit_test(test_a_model_without_triangles_is_named),
		cmocka_unit_test(test_a_model_has_to_fit_its_memory),
		cmocka_unit_test(test_demos_are_found_by_their_names),
		cmocka_unit_test(test_small_pictures_take_room_below_the_figure),
		cmocka_unit_test(
			test_each_small_picture_shows_the_figure_in_its_middle),
		cmocka_unit_test(test_a_picture_of_another_size_has_its_own_room),
		cmocka_unit_test(test_the_lower_of_cap_and_limit_holds),
		cmocka_unit_test(
			test_only_what_is_drawn_of_a_dense_skin_is_posed),
		cmocka_unit_test(test_only_a_camera_has_uses),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
