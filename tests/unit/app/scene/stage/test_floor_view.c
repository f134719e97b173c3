/* A level plane in the rows of a picture, against the view's matrix. */
#include "app/scene/stage/floor_view.h"
#include "platform/base/fixed.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	WIDTH = 480,
	HEIGHT = 640
};

static float between(uint32_t *seed, float low, float high)
{
	return low +
		(high - low) * (float)random_between(seed, 0, 1000) / 1000.0f;
}

static struct camera random_camera(uint32_t *seed)
{
	struct camera camera = camera_default();

	camera.distance = between(seed, 2, 9);
	camera.yaw_rad = between(seed, -3, 3);
	camera.pitch_rad = between(seed, 0.1f, 1.3f);
	camera.shift_x = between(seed, -0.4f, 0.4f);
	camera.shift_y = between(seed, -0.4f, 0.4f);
	for (int i = 0; i < 3; i++) {
		camera.target[i] = between(seed, -1, 1);
	}
	return camera;
}

/* In eye space, in double. */
static void to_eye(const struct camera *camera, const float at[3], double out[3])
{
	mat4 view;

	camera_view(camera, view);
	for (int row = 0; row < 3; row++) {
		out[row] = (double)view[3][row];
		for (int i = 0; i < 3; i++) {
			out[row] += (double)view[i][row] * (double)at[i];
		}
	}
}

/* A row of the picture that shows the plane. */
static float choose_slope(const struct floor_view *view, uint32_t *seed)
{
	float horizon = view->sine / view->cosine;
	float top = view->top < horizon - 0.05f ? view->top : horizon - 0.05f;

	return between(seed, fminf(view->bottom, top - 0.1f), top);
}

static void test_a_point_of_the_plane_is_seen_in_its_row(void **state)
{
	uint32_t seed = 1;

	(void)state;
	for (int i = 0; i < 300; i++) {
		struct camera camera = random_camera(&seed);
		float ground = -1.5f, slope, across, at[3], ahead;
		struct floor_view view;
		double eye[3], level[2];

		floor_view_init(&view, &camera, WIDTH, HEIGHT, ground);
		slope = choose_slope(&view, &seed);
		across = between(&seed, view.left, view.right);
		floor_view_unproject(&view, slope, across, at);
		assert_near(at[1], ground, 1e-3);
		to_eye(&camera, at, eye);
		assert_near(eye[0] / -eye[2], across, 1e-4);
		assert_near(eye[1] / -eye[2], slope, 1e-4);
		assert_near(floor_view_depth(&view, slope), -eye[2],
			-eye[2] * 1e-4);
		assert_near(
			floor_view_slope(&view, (float)-eye[2]), slope, 1e-3);
		/* Ahead is along the level part of the view. */
		level[0] = (double)(view.eye[0] - at[0]);
		level[1] = (double)(view.eye[2] - at[2]);
		ahead = floor_view_ahead(&view, slope);
		assert_near(ahead,
			level[0] * sin((double)camera.yaw_rad) +
				level[1] * cos((double)camera.yaw_rad),
			1e-3 * fmax(1, fabs((double)ahead)));
		assert_near(floor_view_slope_ahead(&view, ahead), slope, 1e-3);
	}
}

/* A quarter of a pixel inside, which leaves each pixel's centre covered. */
static void test_the_view_ends_a_quarter_of_a_pixel_inside(void **state)
{
	uint32_t seed = 2;

	(void)state;
	for (int i = 0; i < 50; i++) {
		struct camera camera = random_camera(&seed);
		const struct camera_frustum frustum =
			camera_frustum(&camera, WIDTH, HEIGHT);
		double near = frustum.near;
		double column = (frustum.right - frustum.left) / near / WIDTH;
		double row = (frustum.top - frustum.bottom) / near / HEIGHT;
		struct floor_view view;

		floor_view_init(&view, &camera, WIDTH, HEIGHT, -1);
		assert_near(view.row, row, 1e-6);
		assert_near(view.edge, frustum.bottom / near, 1e-6);
		assert_near(view.left, frustum.left / near + column / 4, 1e-6);
		assert_near(view.right, frustum.right / near - column / 4, 1e-6);
		assert_near(view.bottom, frustum.bottom / near + row / 4, 1e-6);
		assert_near(view.top, frustum.top / near - row / 4, 1e-6);
		assert_near(view.height, view.eye[1] + 1, 1e-6);
		assert_near(view.near, 1.01 * near / FX16_ONE, 1e-4);
		assert_near(view.far, 0.99 * frustum.far / FX16_ONE, 1e-2);
	}
}

/* Behind the eye's own place there is only the lower edge. */
static void test_ground_behind_the_eye_is_at_the_lower_edge(void **state)
{
	struct camera camera = camera_default();
	struct floor_view view;

	(void)state;
	camera.pitch_rad = 0.2f;
	floor_view_init(&view, &camera, WIDTH, HEIGHT, -1);
	assert_near(floor_view_slope_ahead(&view, -100), view.bottom, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_point_of_the_plane_is_seen_in_its_row),
		cmocka_unit_test(test_the_view_ends_a_quarter_of_a_pixel_inside),
		cmocka_unit_test(test_ground_behind_the_eye_is_at_the_lower_edge),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
