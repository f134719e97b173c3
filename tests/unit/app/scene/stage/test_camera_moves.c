/* How far the camera turns, zooms and sees, and when it moves. */
#include "app/scene/stage/camera.h"
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/stage/box.h"

#include <math.h>

static void test_orbit_turns_by_its_angles(void **state)
{
	static const float yaws[][3] = {{0.0f, 0.3f, 0.3f},
		{3.0f, 0.5f, 3.5f - 6.2831853f},
		{-3.0f, -0.5f, 6.2831853f - 3.5f}, {1.0f, -1.5f, -0.5f},
		{0.7f, 0.0f, 0.7f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(yaws); i++) {
		struct camera camera = camera_default();

		camera.yaw_rad = yaws[i][0];
		camera_orbit(&camera, yaws[i][1], 0.25f);
		assert_near(camera.yaw_rad, yaws[i][2], 1e-5);
		assert_near(camera.pitch_rad, 0.41, 1e-5);
		camera_orbit(&camera, 0.0f, -0.125f);
		assert_near(camera.yaw_rad, yaws[i][2], 1e-5);
		assert_near(camera.pitch_rad, 0.285, 1e-5);
	}
}

static void test_zoom_ends_at_a_32nd_and_at_32_times(void **state)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	struct camera camera = camera_default();
	struct bounds bounds = box(2.0f, 1.0f, 0.5f);
	float whole;

	(void)state;
	camera_frame(&camera, &bounds, &framing);
	whole = camera.distance;
	camera_zoom(&camera, 1e6f);
	assert_near(camera.distance, 32.0f * whole, 1e-3f * whole);
	camera_zoom(&camera, 1e-6f);
	assert_near(camera.distance, whole / 32.0f, 1e-3f * whole);
}

/* Such as the labels', which a demo sets in each frame. */
static void test_another_region_moves_the_camera_and_the_same_does_not(
	void **state)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	const struct camera_region whole = {-1.0f, 1.0f, -1.0f, 1.0f};
	const struct camera_region half = {0.0f, 1.0f, -1.0f, 1.0f};
	struct camera camera = camera_default(), other;
	struct bounds bounds = box(2.0f, 1.0f, 0.5f);
	struct camera_framing halved = framing;

	(void)state;
	camera_frame(&camera, &bounds, &framing);
	camera.distance *= 1.5f; /* which fitting would undo */
	other = camera;
	camera_set_region(&camera, &whole, 1.1f, 0.75f);
	assert_near(camera.distance, other.distance, 0.0);
	camera_set_region(&camera, &half, 1.1f, 0.75f);
	halved.region = half;
	camera_frame(&other, &bounds, &halved);
	assert_near(camera.distance, other.distance, 1e-4);
	assert_near(camera.shift_x, other.shift_x, 1e-4);
	camera_set_region(&camera, &half, 1.1f, 1.5f);
	halved.aspect = 1.5f;
	camera_frame(&other, &bounds, &halved);
	assert_near(camera.distance, other.distance, 1e-4);
	/* One that does not follow stays where it is. */
	halved.follow = false;
	camera_frame(&camera, &bounds, &halved);
	other = camera;
	camera_set_region(&camera, &whole, 1.1f, 0.75f);
	assert_near(camera.distance, other.distance, 0.0);
}

/* Of a box that fits a region, the rectangle around its corners. */
static void test_what_a_box_covers_is_the_region_that_it_fits(void **state)
{
	struct camera_framing framing = {.aspect = 0.75f,
		.margin = 1.0f,
		.pitch_rad = 0.3f,
		.region = {-0.25f, 0.75f, -0.5f, 1.0f},
		.follow = true};
	struct camera camera = camera_default();
	struct bounds bounds = box(2.0f, 0.25f, 0.5f);
	struct camera_region covered;

	(void)state;
	camera_frame(&camera, &bounds, &framing);
	covered = camera_covered(&camera);
	assert_near(covered.left, -0.25, 1e-3);
	assert_near(covered.right, 0.75, 1e-3);
	assert_near(covered.bottom + covered.top, 0.5, 1e-3);
	assert_true(covered.top - covered.bottom < 0.5f);
	bounds = box(0.25f, 2.0f, 0.25f);
	camera_frame(&camera, &bounds, &framing);
	covered = camera_covered(&camera);
	assert_near(covered.bottom, -0.5, 1e-3);
	assert_near(covered.top, 1.0, 1e-3);
	assert_near(covered.left + covered.right, 0.5, 1e-3);
	framing.follow = false;
	camera_frame(&camera, &bounds, &framing);
	covered = camera_covered(&camera);
	assert_near(covered.left, -0.25, 1e-6);
	assert_near(covered.top, 1.0, 1e-6);
}

static void check_farthest(const struct bounds *bounds, float yaw_rad)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	struct camera camera = camera_default();
	float farthest = 0.0f;

	camera_frame(&camera, bounds, &framing);
	camera_orbit(&camera, yaw_rad, 0.0f);
	for (int i = 0; i < 360; i++) {
		struct camera turned = camera;

		camera_orbit(&turned, 0.0174533f * (float)i, 0.0f);
		farthest = fmaxf(farthest, turned.distance);
	}
	assert_true(camera_farthest(&camera) > camera.distance * 1.5f);
	assert_near(camera_farthest(&camera), farthest, 0.05f * farthest);
	camera.fit.on = false;
	assert_near(camera_farthest(&camera), camera.distance, 0.0);
}

/* Seen from an end of each box, which is wide from the side. */
static void test_the_farthest_distance_is_that_of_the_widest_view(void **state)
{
	const struct bounds wide = box(3.0f, 1.0f, 1.0f);
	const struct bounds deep = box(1.0f, 1.0f, 3.0f);

	(void)state;
	check_farthest(&wide, 1.5707963f);
	check_farthest(&deep, 0.0f);
}

/* As far as the figure is from the eye, from 5% to 35% of the target's distance. */
static void test_the_near_plane_is_before_the_figure(void **state)
{
	static const float rows[][2] = {{1, 1.4f}, {2.5f, 1.4f}, {2.75f, 1.25f},
		{3.5f, 0.5f}, {3.75f, 0.25f}, {3.9f, 0.2f}, {8, 0.2f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct camera camera = camera_default();

		camera.pitch_rad = 1.2f; /* the ground is farther away */
		camera.distance = 4;
		camera.radius = rows[i][0];
		assert_near(
			fx16_to_float(camera_frustum(&camera, 480, 640).near),
			rows[i][1], 1e-3);
	}
}

/* From behind the ground below the picture to beyond where it fades. */
static void test_the_frustum_holds_the_figure_and_the_ground(void **state)
{
	const struct camera_framing framing = {.aspect = 0.75f,
		.margin = 1.1f,
		.pitch_rad = 0.2f,
		.follow = true};
	struct camera camera = camera_default();
	struct bounds bounds = box(1.0f, 2.0f, 1.0f);
	struct camera_frustum frustum;
	float near, far, tan_y;

	(void)state;
	camera_frame(&camera, &bounds, &framing);
	camera.shift_x = 0.25f;
	camera.shift_y = -0.125f;
	frustum = camera_frustum(&camera, 480, 640);
	near = fx16_to_float(frustum.near);
	far = fx16_to_float(frustum.far);
	tan_y = camera_tan_half(camera.yfov_rad);
	assert_true(near >= 0.02f * camera.distance - 1e-4f);
	assert_true(near <= 0.35f * camera.distance + 1e-4f);
	assert_true(near <= camera.distance - camera.radius);
	assert_near(far, 2.2f * camera.distance + 3.0f * camera.radius, 1e-3);
	assert_near(fx16_to_float(frustum.top), near * tan_y * (1.0f + 0.125f),
		1e-4);
	assert_near(fx16_to_float(frustum.bottom),
		near * tan_y * (-1.0f + 0.125f), 1e-4);
	assert_near(fx16_to_float(frustum.right),
		near * tan_y * 0.75f * (1.0f - 0.25f), 1e-4);
	assert_near(fx16_to_float(frustum.left),
		near * tan_y * 0.75f * (-1.0f - 0.25f), 1e-4);
	camera.rise = 10.0f;
	frustum = camera_frustum(&camera, 480, 640);
	assert_near(fx16_to_float(frustum.far), far + 11.0f * CAMERA_RISE_AHEAD,
		1e-2);
	camera.rise = 1e9f;
	frustum = camera_frustum(&camera, 480, 640);
	assert_near(fx16_to_float(frustum.far), 30000.0, 0.0);
}

/* So that GL can compute the width of the frustum in 16.16. */
static void test_a_frustum_ends_16000_from_its_axis(void **state)
{
	struct camera camera = camera_default();

	(void)state;
	for (int side = -1; side <= 1; side++) {
		struct camera_frustum frustum;

		camera.distance = 1e6f;
		camera.shift_x = 0.25f * (float)side;
		frustum = camera_frustum(&camera, 480, 640);
		assert_near(fx16_to_float(frustum.left), -16000.0, 0.0);
		assert_near(fx16_to_float(frustum.right), 16000.0, 0.0);
		assert_near(fx16_to_float(frustum.bottom), -16000.0, 0.0);
		assert_near(fx16_to_float(frustum.top), 16000.0, 0.0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_orbit_turns_by_its_angles),
		cmocka_unit_test(test_zoom_ends_at_a_32nd_and_at_32_times),
		cmocka_unit_test(
			test_another_region_moves_the_camera_and_the_same_does_not),
		cmocka_unit_test(
			test_what_a_box_covers_is_the_region_that_it_fits),
		cmocka_unit_test(
			test_the_farthest_distance_is_that_of_the_widest_view),
		cmocka_unit_test(
			test_the_frustum_holds_the_figure_and_the_ground),
		cmocka_unit_test(test_a_frustum_ends_16000_from_its_axis),
		cmocka_unit_test(test_the_near_plane_is_before_the_figure),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
