#include "app/scene/stage/camera.h"
#include "tests/support/test.h"

#include <math.h>

#include <cglm/cglm.h>

static struct bounds box(float x, float y, float z)
{
	return (struct bounds){.low = {-x, 0.0f, -z}, .high = {x, y, z}};
}

/* A point's normalized device coordinates. */
static void project(const struct camera *camera, float aspect,
	const float point[3], float out[2])
{
	float tan_y = tanf(0.5f * camera->yfov_rad);
	vec4 eye;
	mat4 view;

	camera_view(camera, view);
	glm_mat4_mulv(view, (vec4){point[0], point[1], point[2], 1.0f}, eye);
	assert_true(eye[2] < 0.0f);
	out[0] = eye[0] / -eye[2] / (tan_y * aspect);
	out[1] = eye[1] / -eye[2] / tan_y;
}

static void check_framing(struct bounds bounds, float aspect)
{
	struct camera camera = camera_default();
	const struct camera_framing framing = {.aspect = aspect,
		.yaw_rad = 0.3f,
		.pitch_rad = 0.16f,
		.margin = 1.1f};
	float largest = 0.0f;

	camera_frame(&camera, &bounds, &framing);
	for (int look = 0; look < 8 * 8; look++) {
		float corner[3], at[2];

		camera.yaw_rad = (float)(look / 8) * 0.785398f;
		for (int axis = 0; axis < 3; axis++) {
			corner[axis] = look >> axis & 1 ? bounds.high[axis]
							: bounds.low[axis];
		}
		project(&camera, aspect, corner, at);
		assert_true(fabsf(at[0]) <= 0.93f && fabsf(at[1]) <= 0.93f);
		largest = fmaxf(largest, fmaxf(fabsf(at[0]), fabsf(at[1])));
	}
	/* The box is not needlessly small: a corner is near the margin. */
	assert_true(largest > 0.8f);
}

static void test_frames_any_box_from_all_sides(void **state)
{
	(void)state;
	check_framing(box(0.4f, 1.75f, 0.3f), 0.75f);
	check_framing(box(2.0f, 0.1f, 0.5f), 0.75f);
	check_framing(box(0.5f, 0.5f, 0.5f), 1.78f);
	check_framing(box(0.01f, 0.03f, 0.01f), 1.0f);
}

static void test_frames_nothing_without_dividing_by_zero(void **state)
{
	const struct camera_framing framing = {.aspect = 0.75f, .margin = 1.1f};
	struct camera camera = camera_default();
	struct bounds nothing = bounds_empty();
	struct bounds point = box(0.0f, 0.0f, 0.0f);

	(void)state;
	camera_frame(&camera, &nothing, &framing);
	assert_true(camera.distance > 0.0f);
	camera_frame(&camera, &point, &framing);
	assert_true(camera.distance > 0.0f);
}

static void test_view_puts_the_target_straight_ahead(void **state)
{
	struct camera camera = camera_default();
	vec4 eye;
	mat4 view;

	(void)state;
	camera.target[0] = 1.0f;
	camera.target[1] = 2.0f;
	camera.distance = 5.0f;
	camera.yaw_rad = 2.1f;
	camera_view(&camera, view);
	glm_mat4_mulv(view, (vec4){1.0f, 2.0f, 0.0f, 1.0f}, eye);
	assert_all_near(eye, ((float[3]){0, 0, -5}), 3, 1e-5);
}

static void test_view_at_yaw_zero_looks_at_the_front(void **state)
{
	struct camera camera = camera_default();
	float eye[3];

	(void)state;
	camera.yaw_rad = camera.pitch_rad = 0.0f;
	camera.distance = 3.0f;
	camera_eye(&camera, eye);
	assert_all_near(eye, ((float[3]){0, 0, 3}), 3, 1e-5);
}

static void test_orbit_stays_above_the_floor_and_wraps(void **state)
{
	struct camera camera = camera_default();

	(void)state;
	for (int i = 0; i < 100; i++) {
		camera_orbit(&camera, 0.5f, -0.5f);
		assert_true(fabsf(camera.yaw_rad) <= 3.2f);
	}
	assert_true(camera.pitch_rad > 0.0f);
	for (int i = 0; i < 100; i++) {
		camera_orbit(&camera, 0.0f, 0.5f);
	}
	assert_true(camera.pitch_rad < 1.5708f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_frames_any_box_from_all_sides),
		cmocka_unit_test(test_frames_nothing_without_dividing_by_zero),
		cmocka_unit_test(test_view_puts_the_target_straight_ahead),
		cmocka_unit_test(test_view_at_yaw_zero_looks_at_the_front),
		cmocka_unit_test(test_orbit_stays_above_the_floor_and_wraps),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
