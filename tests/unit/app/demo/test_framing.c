/* Demos frame their figures beside or below their labels, at every size. */
#include "app/character/show/character_bounds.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/demo_overlay.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>

#include <cglm/cglm.h>

static const int sizes[][2] = {{480, 640}, {320, 240}, {240, 320}, {800, 480},
	{1920, 1080}, {640, 480}};

struct shown {
	struct log log;
	struct gl gl;
	const struct demo_driver *driver;
	struct demo *demo;
};

static void begin_env(struct shown *shown, const char *name,
	const char *character, const int size[2], bool no_labels)
{
	char path[64];
	struct demo_env env;

	shown->log = log_to_stderr(LOG_ERROR);
	shown->gl = gl_recorder_begin();
	shown->driver = demo_find(name);
	snprintf(path, sizeof(path), "assets/%s",
		shown->driver ? shown->driver->asset : name);
	shown->driver = shown->driver ? shown->driver : &demo_driver_viewer;
	env = (struct demo_env){
		.log = &shown->log,
		.gl = &shown->gl,
		.target = PIXELS_RGBA8888,
		.kernel = kernel_find("fixed"),
		.width = size[0],
		.height = size[1],
		.no_labels = no_labels,
		.model_path = path,
		.character = character,
		.repeat = CLIP_LOOP,
		.speed = 1.0f,
	};
	assert_int_equal(demo_create(shown->driver, &env, &shown->demo), 0);
	shown->driver->update(shown->demo, 0.02);
}

static void begin(struct shown *shown, const char *name, const int size[2],
	bool no_labels)
{
	begin_env(shown, name, NULL, size, no_labels);
}

static void end(struct shown *shown)
{
	demo_destroy(shown->driver, shown->demo);
}

/* A box of the scene as the picture shows it, -1 to 1. */
static struct camera_region project(const struct camera *camera,
	const int size[2], const float center[3], const float half_extent[3])
{
	const struct camera_frustum frustum =
		camera_frustum(camera, size[0], size[1]);
	struct camera_region region = {9.0f, -9.0f, 9.0f, -9.0f};
	mat4 view;

	camera_view(camera, view);
	for (int i = 0; i < 8; i++) {
		vec4 at = {0.0f, 0.0f, 0.0f, 1.0f}, eye;
		float x, y;

		for (int axis = 0; axis < 3; axis++) {
			float half = half_extent[axis];

			at[axis] = center[axis] + (i >> axis & 1 ? half : -half);
		}
		glm_mat4_mulv(view, at, eye);
		x = eye[0] / -eye[2] * (float)frustum.near;
		y = eye[1] / -eye[2] * (float)frustum.near;
		x = (2.0f * x - (float)(frustum.right + frustum.left)) /
			(float)(frustum.right - frustum.left);
		y = (2.0f * y - (float)(frustum.top + frustum.bottom)) /
			(float)(frustum.top - frustum.bottom);
		region.left = fminf(region.left, x);
		region.right = fmaxf(region.right, x);
		region.bottom = fminf(region.bottom, y);
		region.top = fmaxf(region.top, y);
	}
	return region;
}

/* The box of the figure as the picture shows it, -1 to 1. */
static struct camera_region seen(const struct shown *shown, const int size[2])
{
	const struct camera *camera =
		&((const struct demo_base *)shown->demo)->stage.camera;

	return project(camera, size, camera->target, camera->fit.half);
}

/* The whole figure is in the picture and fills a good part of it. */
static void check_whole(const struct camera_region *region)
{
	assert_true(region->left > -1.001f && region->right < 1.001f);
	assert_true(region->bottom > -1.001f && region->top < 1.001f);
}

static bool covers(const struct camera_region *region, const int size[2],
	int rows, int bars)
{
	int most = hud_group_rows_max(size[0], size[1]);
	struct hud_group_extent labels = hud_group_extent_of(size[0], size[1],
		rows < most ? rows : most, bars < most ? bars : most);
	float right = 2.0f * (float)labels.column / (float)size[0] - 1.0f;
	float bottom = 1.0f - 2.0f * (float)labels.top / (float)size[1];

	return region->left < right - 0.01f && region->top > bottom + 0.01f;
}

static const struct {
	const char *name;
	int rows, bars; /* of the labels */
} demos[] = {
	{"walker", 9, 8},
	{"arm", 6, 1},
	{"tuner", 12, 0},
	{"arm.glb", 2, 1},
	{"walker.glb", 2, 1},
};

static void test_labels_do_not_cover_the_figure(void **state)
{
	(void)state;
	for (size_t d = 0; d < sizeof(demos) / sizeof(demos[0]); d++) {
		for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
			struct shown shown;
			struct camera_region region;

			begin(&shown, demos[d].name, sizes[s], false);
			region = seen(&shown, sizes[s]);
			check_whole(&region);
			assert_false(covers(&region, sizes[s], demos[d].rows,
				demos[d].bars));
			end(&shown);
		}
	}
}

/* Whether a rectangle of pixels is over the figure, but for its outermost parts. */
static bool hides(const struct hud *hud, const struct camera_region *figure)
{
	float half[2] = {0.5f * (float)hud->width, 0.5f * (float)hud->height};
	float left = (figure->left + 1.0f) * half[0] + 2.0f;
	float right = (figure->right + 1.0f) * half[0] - 2.0f;
	float top = (1.0f - figure->top) * half[1] + 2.0f;
	float bottom = (1.0f - figure->bottom) * half[1] - 2.0f;

	for (int i = 0; i < hud->quad_count; i++) {
		const struct hud_vertex *a = &hud->vertex[4 * i];
		const struct hud_vertex *b = a + 3; /* the opposite corner */
		float x[2] = {fminf(a->x, b->x), fmaxf(a->x, b->x)};
		float y[2] = {fminf(a->y, b->y), fmaxf(a->y, b->y)};

		/* A group that got shorter leaves empty rectangles. */
		if (x[0] < x[1] && y[0] < y[1] && x[0] < right && x[1] > left &&
			y[0] < bottom && y[1] > top) {
			return true;
		}
	}
	return false;
}

/* Draws a frame and its labels; none of them is over the figure. */
static void check_labels_beside_figure(struct shown *shown, const int size[2])
{
	struct camera_region figure;
	struct hud hud;

	demo_draw(shown->driver, shown->demo, size[0], size[1]);
	assert_int_equal(hud_init(&hud, &shown->gl, &shown->log), 0);
	hud_begin(&hud, size[0], size[1]);
	demo_label(shown->driver, shown->demo, &hud);
	assert_true(hud.quad_count > 20);
	figure = seen(shown, size);
	check_whole(&figure);
	if (hides(&hud, &figure)) {
		fail_msg("%s %dx%d", shown->driver->name, size[0], size[1]);
	}
	hud_finish(&hud, &shown->gl);
}

static const char *const names[] = {
	"walker", "arm", "face", "crowd", "duel", "tuner"};

static void test_labels_of_buttons_do_not_cover_the_figures(void **state)
{
	(void)state;
	for (size_t d = 0; d < sizeof(names) / sizeof(names[0]); d++) {
		for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
			struct shown shown;

			begin(&shown, names[d], sizes[s], false);
			check_labels_beside_figure(&shown, sizes[s]);
			end(&shown);
		}
	}
}

static void test_labels_of_overlays_do_not_cover_the_figures(void **state)
{
	(void)state;
	for (size_t d = 0; d < sizeof(names) / sizeof(names[0]); d++) {
		for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
			const struct overlay_choice all = {
				.kinds = (1U << OVERLAY_KINDS) - 1};
			struct shown shown;

			begin(&shown, names[d], sizes[s], false);
			assert_int_equal(demo_overlay_make(shown.driver,
						 shown.demo, &all),
				0);
			check_labels_beside_figure(&shown, sizes[s]);
			end(&shown);
		}
	}
}

static void test_the_list_of_keys_does_not_cover_the_figure(void **state)
{
	(void)state;
	for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
		const struct button_event press = {
			.button = BUTTON_F6, .down = true};
		const int *size = sizes[s];
		struct camera_region figure;
		struct shown shown;

		begin(&shown, "arm", size, false);
		demo_press(shown.driver, shown.demo, &press);
		shown.driver->update(shown.demo, 0.04);
		check_labels_beside_figure(&shown, size);
		figure = seen(&shown, size);
		assert_true(figure.top - figure.bottom > 0.5f);
		end(&shown);
	}
}

/* The colour scale of the errors is above the heads. */
static void test_the_duels_scale_does_not_cover_the_figures(void **state)
{
	(void)state;
	for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
		const struct button_event paint = {
			.button = BUTTON_F8, .down = true};
		struct shown shown;

		begin(&shown, "duel", sizes[s], false);
		demo_press(shown.driver, shown.demo, &paint);
		check_labels_beside_figure(&shown, sizes[s]);
		end(&shown);
	}
}

/* But for what rigid parts are off at a sole. */
static void test_figures_of_the_duel_are_not_below_the_ground(void **state)
{
	(void)state;
	for (int step = 0; step < 12; step++) {
		struct overlay_figure figure;
		struct shown shown;

		begin(&shown, "duel", sizes[0], false);
		shown.driver->update(shown.demo, 0.1 * step + 0.1);
		for (int i = 0; i < 3; i++) {
			struct bounds bounds;
			float ground = ((const struct demo_base *)shown.demo)
					       ->stage.floor.y;

			assert_true(shown.driver->get_figure(
				shown.demo, i, &figure));
			bounds = bounds_of_instance(figure.instance);
			assert_true(bounds.low[1] > ground - 0.05f);
		}
		end(&shown);
	}
}

/* The box of what is shown now. */
static struct camera_region shown_now(
	const struct shown *shown, const int size[2])
{
	const struct demo_base *base = (const struct demo_base *)shown->demo;
	struct bounds bounds = bounds_of_instance(base->actor.instance);
	float center[3], half[3];

	bounds_center(&bounds, center);
	for (int axis = 0; axis < 3; axis++) {
		half[axis] = bounds.high[axis] - center[axis];
	}
	return project(&base->stage.camera, size, center, half);
}

/* Pitched back and turned aside as far as it goes. */
static void test_parts_that_buttons_turn_stay_in_the_picture(void **state)
{
	(void)state;
	for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
		struct button_event held = {.button = BUTTON_UP, .down = true};
		struct camera_region region;
		struct shown shown;

		begin(&shown, "arm", sizes[s], false);
		demo_press(shown.driver, shown.demo, &held);
		held.button = BUTTON_LEFT;
		demo_press(shown.driver, shown.demo, &held);
		for (int frame = 0; frame < 200; frame++) {
			shown.driver->update(shown.demo, 0.05 + 0.04 * frame);
		}
		region = shown_now(&shown, sizes[s]);
		check_whole(&region);
		end(&shown);
	}
}

static void test_without_labels_the_figure_is_in_the_middle(void **state)
{
	(void)state;
	for (size_t d = 0; d < sizeof(demos) / sizeof(demos[0]); d++) {
		for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
			struct shown shown;
			struct camera_region region;

			begin(&shown, demos[d].name, sizes[s], true);
			region = seen(&shown, sizes[s]);
			check_whole(&region);
			assert_near(region.left + region.right, 0.0, 0.01);
			assert_near(region.bottom + region.top, 0.0, 0.01);
			/* It fills the picture's width or its height. */
			assert_true(fmaxf(region.right, region.top) > 0.85f);
			end(&shown);
		}
	}
}

static void test_a_picture_of_another_size_is_framed_anew(void **state)
{
	(void)state;
	for (size_t from = 0; from < sizeof(sizes) / sizeof(sizes[0]); from++) {
		for (size_t to = 0; to < sizeof(sizes) / sizeof(sizes[0]); to++) {
			struct shown shown;
			struct camera_region region;

			begin_env(&shown, "arm.glb", "none", sizes[from], false);
			demo_draw(shown.driver, shown.demo, sizes[to][0],
				sizes[to][1]);
			region = seen(&shown, sizes[to]);
			check_whole(&region);
			assert_false(covers(&region, sizes[to], 2, 1));
			end(&shown);
		}
	}
}

/* The crowd's camera keeps its distance, and shifts the picture. */
static void test_a_crowd_is_framed_anew_in_another_size(void **state)
{
	(void)state;
	for (size_t to = 0; to < sizeof(sizes) / sizeof(sizes[0]); to++) {
		struct shown resized, fresh;
		const struct camera *a, *b;

		begin(&resized, "crowd", sizes[0], false);
		demo_draw(resized.driver, resized.demo, sizes[to][0],
			sizes[to][1]);
		resized.driver->update(resized.demo, 20.0);
		begin(&fresh, "crowd", sizes[to], false);
		a = &((const struct demo_base *)resized.demo)->stage.camera;
		b = &((const struct demo_base *)fresh.demo)->stage.camera;
		assert_near(a->distance, b->distance, 0.01);
		assert_near(a->shift_x, b->shift_x, 1e-4);
		assert_near(a->shift_y, b->shift_y, 1e-4);
		end(&fresh);
		end(&resized);
	}
}

static float ground_of(float rest, const float *low, int count)
{
	struct bounds clip[4];
	struct character_bounds bounds = {.clip = clip, .extent = 2.0f};

	bounds.rest = bounds.all =
		(struct bounds){{-1.0f, rest, -1.0f}, {1.0f, 2.0f, 1.0f}};
	for (int i = 0; i < count; i++) {
		clip[i] = bounds.rest;
		clip[i].low[1] = low[i];
	}
	return character_bounds_ground(&bounds, count);
}

static void test_the_ground_is_where_most_clips_stand(void **state)
{
	(void)state;
	/* One of them falls, and sinks a little. */
	assert_near(ground_of(0, (float[]){0, 0.01f, -0.2f}, 3), 0, 0);
	assert_near(ground_of(0, (float[]){-0.2f, 0.01f}, 2), 0.01, 1e-6);
	/* One leaps, and none is on the ground at rest. */
	assert_near(ground_of(-1, (float[]){0.3f, 0, 0}, 3), 0, 0);
	/* A bird lands far below. */
	assert_near(ground_of(1.6f, (float[]){1.6f, 0.1f}, 2), 0.1, 1e-6);
	assert_near(ground_of(0.5f, NULL, 0), 0.5, 0);
}

static void test_shapes_without_a_clip_are_in_the_picture_whole(void **state)
{
	(void)state;
	for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
		struct shown shown;
		struct demo_base *base;
		struct instance *instance;

		begin(&shown, "../tests/fixtures/gltf/mesh/weights.gltf",
			sizes[s], false);
		base = (struct demo_base *)shown.demo;
		instance = base->actor.instance;
		assert_int_equal(instance->model->clip_count, 0);
		assert_int_not_equal(instance->pose.weight_count, 0);
		for (int i = 0; i < instance->pose.weight_count; i++) {
			struct bounds bounds;
			float center[3], half[3];
			struct camera_region region;

			pose_rest(&instance->pose, instance->model);
			instance->pose.weight[i] = 1.0f;
			instance_update(instance);
			bounds = bounds_of_instance(instance);
			bounds_center(&bounds, center);
			for (int axis = 0; axis < 3; axis++) {
				half[axis] = bounds.high[axis] - center[axis];
			}
			region = project(
				&base->stage.camera, sizes[s], center, half);
			check_whole(&region);
		}
		end(&shown);
	}
}

static void test_a_target_that_moves_stays_in_the_picture(void **state)
{
	static const float center[3] = {-0.5f, 1.65f, 0.5f};
	static const float half[3] = {0.75f, 0.5f, 0.05f};

	(void)state;
	for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
		struct shown shown;
		struct camera_region region;

		begin_env(&shown, "walker.glb", "tests/fixtures/ball.character",
			sizes[s], false);
		region = project(&((struct demo_base *)shown.demo)->stage.camera,
			sizes[s], center, half);
		check_whole(&region);
		assert_false(covers(&region, sizes[s], 2, 1));
		end(&shown);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_labels_do_not_cover_the_figure),
		cmocka_unit_test(test_labels_of_buttons_do_not_cover_the_figures),
		cmocka_unit_test(
			test_labels_of_overlays_do_not_cover_the_figures),
		cmocka_unit_test(test_the_list_of_keys_does_not_cover_the_figure),
		cmocka_unit_test(test_the_duels_scale_does_not_cover_the_figures),
		cmocka_unit_test(
			test_figures_of_the_duel_are_not_below_the_ground),
		cmocka_unit_test(
			test_parts_that_buttons_turn_stay_in_the_picture),
		cmocka_unit_test(test_without_labels_the_figure_is_in_the_middle),
		cmocka_unit_test(test_a_picture_of_another_size_is_framed_anew),
		cmocka_unit_test(test_a_crowd_is_framed_anew_in_another_size),
		cmocka_unit_test(test_the_ground_is_where_most_clips_stand),
		cmocka_unit_test(
			test_shapes_without_a_clip_are_in_the_picture_whole),
		cmocka_unit_test(test_a_target_that_moves_stays_in_the_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
