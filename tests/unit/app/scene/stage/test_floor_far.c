/*
 * The floor of a model far from the origin: its texture coordinates, of which
 * drivers keep 16 bits and less behind the point, stay small.
 */
#include "app/scene/stage/floor.h"
#include "platform/base/fixed.h"
#include "platform/gl/gl_context.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	WIDTH = 240,
	HEIGHT = 320,
};

/* What the floor's calls pass, whose texture coordinates are in tiles. */
static const float (*coordinate)[2];
static const float (*vertex)[3];
static float largest, worst;

static void keep_coordinate(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	(void)size, (void)type, (void)stride;
	coordinate = pointer;
}

static void keep_vertex(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	(void)size, (void)type, (void)stride;
	vertex = pointer;
}

/* A tile's side is half a metre: the pattern's phase is that of the origin. */
static void check_arrays(GLenum mode, GLint first, GLsizei count)
{
	(void)mode;
	for (int i = first; i < first + count; i++) {
		float tiles = coordinate[i][0] - vertex[i][0] / 0.5f;

		largest = fmaxf(largest, fabsf(coordinate[i][0]));
		largest = fmaxf(largest, fabsf(coordinate[i][1]));
		worst = fmaxf(worst, fabsf(tiles - roundf(tiles)));
	}
}

static void draw(float away)
{
	const struct bounds bounds = {.low = {away - 0.5f, 0.0f, -away - 0.4f},
		.high = {away + 0.5f, 1.0f, -away + 0.4f}};
	const struct floor_content anything = {.bounded = false};
	struct camera camera = camera_default();
	struct log log = log_to_nowhere();
	struct gl_context *context;
	struct floor_sight sight;
	struct floor floor;
	struct gl gl;

	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &context),
		0);
	gl = context->gl;
	gl.TexCoordPointer = keep_coordinate;
	gl.VertexPointer = keep_vertex;
	gl.DrawArrays = check_arrays;
	assert_int_equal(floor_init(&floor, &gl, &bounds, 1.0f, 4.8f,
				 PIXELS_RGB565, &log),
		0);
	camera_frame(&camera, &bounds,
		&(struct camera_framing){.aspect = (float)WIDTH / HEIGHT,
			.pitch_rad = 0.3f,
			.margin = 1.1f});
	floor_find_sight(&floor, &camera, WIDTH, HEIGHT, &anything, &sight);
	floor_draw(&floor, &sight, &gl);
	floor_finish(&floor, &gl);
	context->driver->destroy(context);
}

static void test_tiles_have_small_coordinates_wherever_they_are(void **state)
{
	static const float away_m[] = {0, 0.3f, 5, -100, 4000, -16000, 30000};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(away_m); i++) {
		largest = worst = 0.0f;
		draw(away_m[i]);
		assert_true(largest > 0.0f);
		assert_true(largest < 64.0f);
		assert_near(worst, 0.0, 0.01);
	}
}

/* The strips that a camera sees of ground that is one metre wide. */
static struct floor_strips find_strips(
	const float center[2], const float way[2], const float target[2])
{
	const struct floor floor = {.radius = 1.0f,
		.tile = 0.5f,
		.center = {center[0], center[1]},
		.way = {way[0], way[1]}};
	const struct floor_content anything = {.bounded = false};
	struct camera camera = camera_default();
	struct floor_sight sight;

	camera.yaw_rad = 0.7f;
	camera.target[0] = target[0];
	camera.target[2] = target[1];
	floor_find_sight(&floor, &camera, WIDTH, HEIGHT, &anything, &sight);
	assert_true(sight.strips.opaque && sight.strips.fading);
	return sight.strips;
}

static void test_ground_fades_at_the_same_distance_from_its_middle(void **state)
{
	static const float none[2] = {0, 0}, center[2] = {3, -0.5f},
			   way[2] = {-0.75f, 4}, both[2] = {2.25f, 3.5f};
	const struct floor_strips here = find_strips(none, none, none);
	const struct floor_strips there = find_strips(center, way, both);

	(void)state;
	for (int i = 0; i < 6; i++) {
		assert_near(there.position[i][0], here.position[i][0] + both[0],
			1e-4);
		assert_near(there.position[i][2], here.position[i][2] + both[1],
			1e-4);
		assert_int_equal(there.alpha[i], here.alpha[i]);
	}
	assert_int_equal(there.covered_px, here.covered_px);
}

/* Ground as large as this, seen from so far ahead of its middle. */
static void check_end(float radius, float ahead, bool near)
{
	struct camera camera = camera_default();
	struct floor floor = {.radius = radius, .tile = 1, .y = -1};
	const struct floor_content anything = {.bounded = false};
	struct floor_strips expected;
	struct floor_sight sight;
	float eye[3], far, opaque_end;

	camera.yaw_rad = 0;
	camera_eye(&camera, eye);
	floor.center[0] = 17;
	floor.center[1] = eye[2] - ahead;
	far = 0.95f * fx16_to_float(camera_frustum(&camera, WIDTH, HEIGHT).far);
	assert_true(ahead + radius > far);
	opaque_end = near ? ahead + 0.5625f * radius : 0.5625f * far;
	floor_find_sight(&floor, &camera, WIDTH, HEIGHT, &anything, &sight);
	floor_strips_find(
		&expected, &camera, WIDTH, HEIGHT, floor.y, opaque_end, far);
	assert_true(expected.opaque && expected.fading);
	assert_all_near(
		sight.strips.position[0], expected.position[0], 18, 1e-4);
	assert_memory_equal(
		sight.strips.alpha, expected.alpha, sizeof(expected.alpha));
}

/* Opaque as far as its radius says, or up to the same part of the view. */
static void test_ground_beyond_the_view_fades_within_it(void **state)
{
	struct camera camera = camera_default();
	float far = fx16_to_float(camera_frustum(&camera, WIDTH, HEIGHT).far);

	(void)state;
	check_end(2 * far, 0.5f * far, false);
	check_end(2 * far, 0, false);
	check_end(2 * far, -0.8f * far, true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_tiles_have_small_coordinates_wherever_they_are),
		cmocka_unit_test(
			test_ground_fades_at_the_same_distance_from_its_middle),
		cmocka_unit_test(test_ground_beyond_the_view_fades_within_it),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
