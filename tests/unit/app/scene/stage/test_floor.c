#include "app/anim/math/vec.h"
#include "app/scene/stage/floor.h"
#include "platform/base/compiler.h"
#include "platform/gl/gl_context.h"
#include "platform/gl/soft/raster/raster.h"
#include "tests/support/ray.h"
#include "tests/support/test.h"

#include <stdlib.h>

enum {
	WIDTH = 480,
	HEIGHT = 640,
};

static const struct floor_content anything = {.bounded = false};
static const float pitch_rad[] = {0.0f, 0.1f, 0.3f, 0.6f, 1.0f, 1.57079f};

/* A floor as large as the walker's, and a camera before it. */
struct scene {
	struct gl_context *context;
	struct floor floor;
	struct camera camera;
};

static void begin(struct scene *scene)
{
	const struct bounds bounds = {
		.low = {-0.5f, 0.0f, -0.4f}, .high = {0.6f, 1.9f, 0.8f}};
	struct log log = log_to_nowhere();

	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &scene->context),
		0);
	assert_int_equal(floor_init(&scene->floor, &scene->context->gl, &bounds,
				 1.0f, 4.8f, PIXELS_RGB565, &log),
		0);
	floor_set_wave_height(&scene->floor, 0.2f);
	scene->camera = camera_default();
	camera_frame(&scene->camera, &bounds,
		&(struct camera_framing){
			.aspect = (float)WIDTH / HEIGHT, .margin = 1.1f});
}

static void end(struct scene *scene)
{
	floor_finish(&scene->floor, &scene->context->gl);
	scene->context->driver->destroy(scene->context);
}

/* A point in a triangle, by two barycentric coordinates. */
static void mix(const struct floor_mesh *mesh, const uint16_t *corner, float a,
	float b, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = a * mesh->position[corner[0]][axis] +
			b * mesh->position[corner[1]][axis] +
			(1.0f - a - b) * mesh->position[corner[2]][axis];
	}
}

/*
 * The greatest distance of the opaque mesh from floor_height(), as a part of
 * the stated error there.
 */
static float find_sag(const struct scene *scene, const struct floor_mesh *mesh)
{
	const struct floor *floor = &scene->floor;
	float most = 0.0f, eye[3];

	camera_eye(&scene->camera, eye);
	for (int i = FLOOR_FADING_INDICES; i < FLOOR_INDICES; i += 3) {
		for (int n = 0; n < 10; n++) {
			float a = (float)(n % 4) / 3.0f,
			      b = (float)(n / 4) / 3.0f;
			float at[3], off;

			mix(mesh, floor->index + i, a, b * (1.0f - a), at);
			off = at[1] - floor_height(floor, at[0], at[2]);
			off = off < 0.0f ? -off : off;
			off /= floor_mesh_error(floor, eye, at[0], at[2]);
			most = off > most ? off : most;
		}
	}
	return most;
}

static void test_ground_is_drawn_where_it_is(void **state)
{
	struct scene scene;
	struct floor_sight sight;
	float most = 0.0f;

	(void)state;
	begin(&scene);
	for (int i = 0; i < 120; i++) {
		float sag;

		scene.camera.pitch_rad = pitch_rad[i % 5];
		scene.camera.yaw_rad = 0.3f * (float)i;
		floor_find_sight(&scene.floor, &scene.camera, WIDTH, HEIGHT,
			&anything, &sight);
		assert_true(sight.mesh.seen);
		sag = find_sag(&scene, &sight.mesh);
		most = sag > most ? sag : most;
		assert_true(sag < 1.0f);
		floor_scroll(&scene.floor, 0.07f, 0.11f);
	}
	/* The stated error is not much larger than the measured one. */
	assert_true(2.0f * most > 1.0f);
	end(&scene);
}

/* What the ray of a pixel meets of the ground, found step by step. */
static bool find_ground(
	const struct scene *scene, float x, float y, float out[3])
{
	float tangent = camera_tan_half(scene->camera.yfov_rad), eye[3];
	mat4 view;

	camera_eye(&scene->camera, eye);
	camera_view(&scene->camera, view);
	for (float depth = 0.2f; depth < 9.0f; depth += 0.01f) {
		for (int i = 0; i < 3; i++) {
			out[i] = eye[i] +
				depth *
					(view[i][0] * x * tangent * WIDTH /
							HEIGHT +
						view[i][1] * y * tangent -
						view[i][2]);
		}
		if (out[1] <= floor_height(&scene->floor, out[0], out[2])) {
			return true;
		}
	}
	return false;
}

static float turn(const float a[3], const float b[3], float x, float z)
{
	return (b[0] - a[0]) * (z - a[2]) - (b[2] - a[2]) * (x - a[0]);
}

static bool is_covered(const struct floor *floor, const struct floor_mesh *mesh,
	float x, float z)
{
	for (int i = 0; i < FLOOR_INDICES; i += 3) {
		const float *a = mesh->position[floor->index[i]];
		const float *b = mesh->position[floor->index[i + 1]];
		const float *c = mesh->position[floor->index[i + 2]];
		float ab = turn(a, b, x, z), bc = turn(b, c, x, z);
		float ca = turn(c, a, x, z);

		if ((ab >= 0 && bc >= 0 && ca >= 0) ||
			(ab <= 0 && bc <= 0 && ca <= 0)) {
			return true;
		}
	}
	return false;
}

/* However the camera looks, hills and troughs reach the picture's edges. */
static void test_the_mesh_covers_what_is_seen(void **state)
{
	struct scene scene;
	struct floor_sight sight;
	int found = 0;

	(void)state;
	begin(&scene);
	for (int i = 0; i < 30; i++) {
		scene.camera.pitch_rad = pitch_rad[i % 6];
		scene.camera.yaw_rad = 0.4f * (float)i;
		floor_find_sight(&scene.floor, &scene.camera, WIDTH, HEIGHT,
			&anything, &sight);
		for (int n = 0; n < 16; n++) {
			float along = -1.0f + 0.5f * (float)(n / 4), at[3];
			float x = n % 4 == 0 ? -1.0f
				: n % 4 == 1 ? 1.0f
					     : along;
			float y = n % 4 == 2 ? -1.0f
				: n % 4 == 3 ? 1.0f
					     : along;

			if (find_ground(&scene, 0.99f * x, 0.99f * y, at)) {
				found++;
				assert_true(is_covered(&scene.floor,
					&sight.mesh, at[0], at[2]));
			}
		}
		floor_scroll(&scene.floor, 0.07f, 0.11f);
	}
	assert_true(found > 200);
	end(&scene);
}

/* The driver's own DepthFunc(). */
static void (*set_depth_func)(GLenum function);

static void always_test_depth(GLenum function)
{
	set_depth_func(function == GL_ALWAYS ? GL_LESS : function);
}

static void draw_picture(
	const struct scene *scene, const struct gl *gl, struct pixels *picture)
{
	const struct gl_driver *driver = scene->context->driver;
	struct floor_sight sight;

	floor_find_sight(&scene->floor, &scene->camera, WIDTH, HEIGHT,
		&anything, &sight);
	assert_int_equal(driver->begin_frame(scene->context, picture), 0);
	gl->ClearColorx(0, 0, 0, 65536);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	gl->Enable(GL_DEPTH_TEST);
	camera_apply(&scene->camera, gl, WIDTH, HEIGHT);
	floor_draw(&scene->floor, &sight, gl);
	driver->end_frame(scene->context);
}

static int count_differences(const struct pixels *a, const struct pixels *b)
{
	const uint16_t *left = (const void *)a->data;
	const uint16_t *right = (const void *)b->data;
	int count = 0;

	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		count += left[i] != right[i];
	}
	return count;
}

/* A depth test finds nothing that the order of triangles does not. */
static void test_near_hills_hide_those_behind_them(void **state)
{
	struct log log = log_to_nowhere();
	struct pixels tested, ordered;
	struct scene scene;
	struct gl testing;

	(void)state;
	begin(&scene);
	/* What is not tested would be drawn by a path of its own, which rounds. */
	((struct soft *)(void *)scene.context)->fill = soft_rows_fill;
	((struct soft *)(void *)scene.context)->changed = GROUP_ALL;
	testing = scene.context->gl;
	set_depth_func = testing.DepthFunc;
	testing.DepthFunc = always_test_depth;
	assert_int_equal(
		pixels_alloc(&tested, WIDTH, HEIGHT, PIXELS_RGB565, &log), 0);
	assert_int_equal(
		pixels_alloc(&ordered, WIDTH, HEIGHT, PIXELS_RGB565, &log), 0);
	floor_set_wave_height(&scene.floor, 0.5f);
	for (int i = 0; i < 12; i++) {
		scene.camera.pitch_rad = pitch_rad[i % 4];
		scene.camera.yaw_rad = 0.5f * (float)i;
		draw_picture(&scene, &testing, &tested);
		draw_picture(&scene, &scene.context->gl, &ordered);
		/* Edges alone are tested with rounded depths. */
		assert_in_range(count_differences(&tested, &ordered), 0,
			WIDTH * HEIGHT / 1000);
		floor_scroll(&scene.floor, 0.17f, 0.31f);
	}
	free(ordered.data);
	free(tested.data);
	end(&scene);
}

/* Whether the line from a point to the eye passes through a triangle. */
static bool passes_through(const struct floor_mesh *mesh,
	const uint16_t *corner, const float from[3], const float eye[3])
{
	float way[3], t;

	vec_subtract(eye, from, way);
	t = ray_meet(from, way, mesh->position, corner);
	return t > 0.0f && t < 1.0f;
}

/* How many of the points on the ground in a box the mesh hides. */
static int count_hidden(const struct scene *scene,
	const struct floor_mesh *mesh, const struct bounds *box)
{
	const uint16_t *index = scene->floor.index;
	float eye[3];
	int hidden = 0;

	camera_eye(&scene->camera, eye);
	for (int k = 0; k < 25; k++) {
		float at[3];

		for (int axis = 0; axis < 3; axis++) {
			float part = 0.25f * (float)(axis ? k / 5 : k % 5);

			at[axis] = box->low[axis] +
				part * (box->high[axis] - box->low[axis]);
		}
		at[1] = floor_height(&scene->floor, at[0], at[2]);
		floor_lift(&scene->floor, eye, at);
		for (int i = 0; i < FLOOR_INDICES; i += 3) {
			if (passes_through(mesh, index + i, at, eye)) {
				hidden++;
				break;
			}
		}
	}
	return hidden;
}

static void test_hills_that_may_hide_a_box_are_found(void **state)
{
	int found[2] = {0, 0}, hiding = 0;
	struct floor_sight sight;
	struct scene scene;

	(void)state;
	begin(&scene);
	for (int i = 0; i < 400; i++) {
		float x = 0.3f * (float)(i % 7 - 3),
		      z = 0.5f * (float)(i % 9 - 4);
		const struct bounds box = {.low = {x - 0.3f, -0.5f, z - 0.2f},
			.high = {x + 0.3f, 0.5f, z + 0.2f}};
		float eye[3];
		bool may_hide;
		int hidden;

		floor_set_wave_height(&scene.floor, i % 2 ? 0.5f : 0.2f);
		scene.camera.pitch_rad = pitch_rad[i % 5];
		scene.camera.yaw_rad = 0.5f * (float)i;
		camera_eye(&scene.camera, eye);
		floor_find_sight(&scene.floor, &scene.camera, WIDTH, HEIGHT,
			&anything, &sight);
		may_hide = floor_mesh_may_hide(
			&sight.mesh, scene.floor.index, eye, &box);
		hidden = count_hidden(&scene, &sight.mesh, &box);
		assert_true(may_hide || hidden == 0);
		found[may_hide]++;
		hiding += hidden > 0;
		floor_scroll(&scene.floor, 0.17f, 0.31f);
	}
	/* It is not always the answer that is safe. */
	assert_true(hiding > 20);
	assert_true(found[0] > 100);
	end(&scene);
}

static void test_ground_above_the_eye_is_not_drawn(void **state)
{
	struct scene scene;
	struct floor_sight sight;

	(void)state;
	begin(&scene);
	scene.floor.y = 99.0f;
	floor_find_sight(
		&scene.floor, &scene.camera, WIDTH, HEIGHT, &anything, &sight);
	assert_false(sight.mesh.seen);
	assert_true(floor_mesh_may_hide(&sight.mesh, scene.floor.index,
		(const float[3]){0.0f, 1.0f, 4.0f},
		&(const struct bounds){.high = {1.0f, 1.0f, 1.0f}}));
	end(&scene);
}

/* Wide, deep, flat, tall and even ones, in metres and in millimetres. */
static const float half_sides[][3] = {{7.7f, 0.6f, 0.5f}, {1.0f, 0.06f, 1.5f},
	{0.5f, 0.06f, 8.0f}, {0.3f, 4.0f, 0.3f}, {0.02f, 0.02f, 0.02f}};

static const struct camera_region regions[] = {{-1.0f, 1.0f, -1.0f, 1.0f},
	{-1.0f, 1.0f, -0.2f, 0.9f}, {-0.1f, 1.0f, -1.0f, 1.0f}};

static void check_level_ground(const float half[3],
	const struct camera_region *region, int width, int height)
{
	const struct bounds bounds = {.low = {-half[0], 0.0f, -half[2]},
		.high = {half[0], 2.0f * half[1], half[2]}};
	struct camera_framing framing = {.aspect = (float)width / (float)height,
		.yaw_rad = 0.25f,
		.pitch_rad = 0.1f,
		.margin = 1.04f,
		.follow = true,
		.region = *region};
	struct camera camera = camera_default();
	struct floor floor = {.radius = 200.0f * bounds_extent(&bounds)};
	struct floor_sight sight;

	camera_frame(&camera, &bounds, &framing);
	floor.y = bounds_ground(&bounds);
	floor_find_sight(&floor, &camera, width, height, &anything, &sight);
	assert_true(sight.strips.covered_px > 0);
	if (sight.strips.horizon_px < height) {
		assert_int_equal(sight.strips.alpha[4], 0);
		assert_int_equal(sight.strips.alpha[5], 0);
	}
}

static void test_level_ground_begins_below_the_picture_and_fades(void **state)
{
	static const int sizes[][2] = {{480, 640}, {320, 240}, {800, 480}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(half_sides) * 9; i++) {
		check_level_ground(half_sides[i / 9], &regions[i % 3],
			sizes[i / 3 % 3][0], sizes[i / 3 % 3][1]);
	}
}

static void test_ground_is_not_in_the_plane_of_a_flat_box(void **state)
{
	const struct bounds flat = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 2.0f}};
	const struct bounds tall = {{0.0f, 0.5f, 0.0f}, {1.0f, 1.0f, 2.0f}};
	const struct bounds empty = bounds_empty();

	(void)state;
	assert_near(bounds_ground(&flat), -0.002, 1e-6);
	assert_near(bounds_ground(&tall), 0.5, 1e-6);
	assert_near(bounds_ground(&empty), 0.0, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ground_is_drawn_where_it_is),
		cmocka_unit_test(test_the_mesh_covers_what_is_seen),
		cmocka_unit_test(test_near_hills_hide_those_behind_them),
		cmocka_unit_test(test_hills_that_may_hide_a_box_are_found),
		cmocka_unit_test(test_ground_above_the_eye_is_not_drawn),
		cmocka_unit_test(
			test_level_ground_begins_below_the_picture_and_fades),
		cmocka_unit_test(test_ground_is_not_in_the_plane_of_a_flat_box),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
