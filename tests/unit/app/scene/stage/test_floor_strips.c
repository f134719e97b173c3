#include "app/scene/stage/floor_strips.h"
#include "platform/base/fixed.h"
#include "tests/support/test.h"

#include <math.h>

#include <cglm/cglm.h>

static const float ground = -0.3f;

static struct camera look(float pitch_rad, float distance)
{
	struct camera camera = camera_default();

	camera.yaw_rad = 0.7f;
	camera.pitch_rad = pitch_rad;
	camera.distance = distance;
	camera.radius = 0.4f * distance;
	camera.target[0] = 0.2f;
	camera.target[1] = 0.5f;
	return camera;
}

/* The pixel of a point, from the picture's lower left corner. */
static void project(const struct camera *camera, int width, int height,
	const float point[3], float out[2])
{
	const struct camera_frustum frustum =
		camera_frustum(camera, width, height);
	vec4 eye;
	mat4 view;

	camera_view(camera, view);
	glm_mat4_mulv(view, (vec4){point[0], point[1], point[2], 1.0f}, eye);
	assert_true(eye[2] < 0.0f);
	out[0] = (eye[0] / -eye[2] * (float)frustum.near - (float)frustum.left) /
		(float)(frustum.right - frustum.left) * (float)width;
	out[1] = (eye[1] / -eye[2] * (float)frustum.near -
			 (float)frustum.bottom) /
		(float)(frustum.top - frustum.bottom) * (float)height;
}

/* The level distance of a point ahead of the eye. */
static float ahead_of(const struct camera *camera, const float point[3])
{
	float eye[3];

	camera_eye(camera, eye);
	return (eye[0] - point[0]) * sinf(camera->yaw_rad) +
		(eye[2] - point[2]) * cosf(camera->yaw_rad);
}

static void check_inside(const struct floor_strips *strips,
	const struct camera *camera, int width, int height)
{
	for (int i = 0; i < 6; i++) {
		float at[2];

		project(camera, width, height, strips->position[i], at);
		assert_true(
			fabsf(at[0] - (i % 2 ? (float)width - 0.25f : 0.25f)) <
			0.05f);
		assert_true(at[1] > 0.2f && at[1] < (float)height - 0.2f);
		assert_true(strips->position[i][1] == ground);
	}
}

static void test_strips_extend_from_side_to_side(void **state)
{
	const struct camera camera = look(0.16f, 4.0f);
	struct floor_strips strips;
	float bottom[2], edge[2];

	(void)state;
	floor_strips_find(&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
	assert_true(strips.opaque && strips.fading);
	check_inside(&strips, &camera, 480, 640);
	for (int i = 0; i < 2; i++) {
		project(&camera, 480, 640, strips.position[i], bottom);
		assert_true(fabsf(bottom[1] - 0.25f) < 0.05f);
	}
	assert_true(fabsf(ahead_of(&camera, strips.position[2]) - 6.0f) < 1e-3f);
	assert_true(fabsf(ahead_of(&camera, strips.position[3]) - 6.0f) < 1e-3f);
	assert_true(fabsf(ahead_of(&camera, strips.position[4]) - 8.0f) < 1e-3f);
	assert_int_equal(strips.alpha[2], 255);
	assert_int_equal(strips.alpha[4], 0);
	project(&camera, 480, 640, strips.position[2], edge);
	assert_in_range((int)edge[1] - strips.covered_px, 0, 1);
}

static void test_nothing_that_fades_counts_as_covered(void **state)
{
	(void)state;
	for (int i = 0; i < 60; i++) {
		const struct camera camera =
			look(0.02f + 0.024f * (float)i, 4.0f);
		int width = i % 2 ? 320 : 480, height = i % 2 ? 120 : 640;
		struct floor_strips strips;
		float edge[2];

		floor_strips_find(
			&strips, &camera, width, height, ground, 5.0f, 9.0f);
		assert_true(strips.covered_px >= 0);
		if (strips.covered_px == 0) {
			continue;
		}
		assert_true(strips.opaque);
		project(&camera, width, height, strips.position[2], edge);
		assert_true((float)strips.covered_px <= edge[1]);
		project(&camera, width, height, strips.position[0], edge);
		assert_true(edge[1] < 0.5f);
	}
}

static void test_ground_seen_from_above_fills_the_picture(void **state)
{
	const struct camera camera = look(1.4f, 4.0f);
	struct floor_strips strips;

	(void)state;
	floor_strips_find(&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
	assert_true(strips.opaque && !strips.fading);
	check_inside(&strips, &camera, 480, 640);
	assert_in_range(strips.covered_px, 637, 640);
	assert_int_equal(strips.horizon_px, 640);
}

static void test_near_ground_that_is_cut_off_covers_nothing(void **state)
{
	struct camera camera = look(0.02f, 4.0f);
	struct floor_strips strips;

	(void)state;
	camera.radius = 0.0f;
	camera.target[1] = -0.35f;
	floor_strips_find(&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
	assert_true(strips.opaque);
	assert_int_equal(strips.covered_px, 0);
}

static void test_from_below_there_is_no_ground(void **state)
{
	struct camera camera = look(0.02f, 4.0f);
	struct floor_strips strips;

	(void)state;
	camera.target[1] = -2.0f;
	floor_strips_find(&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
	assert_false(strips.opaque || strips.fading);
	assert_int_equal(strips.covered_px, 0);
	assert_int_equal(strips.horizon_px, 640);
}

/* The eye is above the ground and looks up; the last row may have its edge. */
static void test_a_horizon_below_the_picture_leaves_a_row(void **state)
{
	const struct camera camera = look(-1.0f, 3.0f);
	struct floor_strips strips;

	(void)state;
	floor_strips_find(&strips, &camera, 480, 640, -9.0f, 4.0f, 8.0f);
	assert_int_equal(strips.horizon_px, 1);
	assert_int_equal(strips.covered_px, 0);
}

static void test_shadows_far_out_are_below_the_horizon(void **state)
{
	(void)state;
	for (int i = 0; i < 40; i++) {
		const struct camera camera =
			look(0.02f + 0.01f * (float)i, 4.0f);
		struct floor_strips strips;
		float eye[3], far[3], at[2];

		camera_eye(&camera, eye);
		far[0] = eye[0] - 1e4f * sinf(camera.yaw_rad);
		far[1] = ground;
		far[2] = eye[2] - 1e4f * cosf(camera.yaw_rad);
		floor_strips_find(
			&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
		project(&camera, 480, 640, far, at);
		assert_true((float)strips.horizon_px >= fminf(at[1], 640.0f));
		assert_true(
			(float)strips.horizon_px < fmaxf(at[1], 0.0f) + 2.0f);
		assert_true(strips.end_px <= strips.horizon_px);
		project(&camera, 480, 640, strips.position[4], at);
		assert_near(strips.end_px, at[1], 1.5);
	}
}

/* Units are so large that 16.16 cannot represent quarters of pixels. */
static void test_coarse_numbers_leave_no_gap_at_the_sides(void **state)
{
	struct camera camera = look(0.16f, 0.01f);
	struct floor_strips strips;

	(void)state;
	camera.target[0] = 0.0f;
	camera.target[1] = 0.001f;
	floor_strips_find(&strips, &camera, 480, 640, -0.001f, 0.02f, 0.03f);
	assert_true(strips.opaque);
	for (int i = 0; i < 6; i++) {
		float at[2];

		project(&camera, 480, 640, strips.position[i], at);
		assert_true(i % 2 ? at[0] > 484.0f : at[0] < -4.0f);
	}
}

/* With the view matrix rounded to 16.16, as GL gets it. */
static void project_rounded(
	const struct camera *camera, const float point[3], float out[2])
{
	const struct camera_frustum frustum = camera_frustum(camera, 480, 640);
	double eye[3];
	mat4 view;

	camera_view(camera, view);
	for (int i = 0; i < 3; i++) {
		eye[i] = 0.0;
		for (int k = 0; k < 4; k++) {
			eye[i] += (double)fx16_to_float(
					  fx16_from_float(view[k][i])) *
				(k < 3 ? (double)point[k] : 1.0);
		}
	}
	for (int i = 0; i < 2; i++) {
		out[i] = (float)(eye[i] / -eye[2] * (double)frustum.near);
	}
	out[0] -= (float)frustum.left;
	out[0] *= 480.0f / (float)(frustum.right - frustum.left);
	out[1] -= (float)frustum.bottom;
	out[1] *= 640.0f / (float)(frustum.top - frustum.bottom);
}

static void test_far_from_the_origin_is_no_gap_at_the_edges(void **state)
{
	(void)state;
	for (float far = 1.0f; far < 25000.0f; far *= 1.3f) {
		struct camera camera = look(0.16f, 4.0f);
		struct floor_strips strips;

		camera.target[0] = far;
		camera.target[2] = -0.7f * far;
		floor_strips_find(
			&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
		assert_true(strips.opaque);
		for (int i = 0; i < 2; i++) {
			float at[2];

			project_rounded(&camera, strips.position[i], at);
			assert_true(i % 2 ? at[0] > 479.5f : at[0] < 0.5f);
			assert_true(at[1] < 0.5f);
		}
	}
}

/* Rows that count as covered are not cleared: figures would vanish there. */
static void test_far_from_the_origin_covered_rows_are_covered(void **state)
{
	(void)state;
	for (float far = 1.0f; far < 25000.0f; far *= 1.1f) {
		struct camera camera = look(0.16f, 4.0f);
		struct floor_strips strips;

		camera.yaw_rad = far;
		camera.target[0] = far;
		camera.target[2] = -0.5f * far;
		floor_strips_find(
			&strips, &camera, 480, 640, ground, 6.0f, 8.0f);
		assert_true(strips.opaque && strips.covered_px > 200);
		for (int i = 0; i < 2; i++) {
			float at[2];

			project_rounded(&camera, strips.position[2 + i], at);
			assert_true((float)strips.covered_px <= at[1]);
		}
	}
}

/* Otherwise the background would leave rows as they were. */
static void test_ground_too_far_away_to_be_drawn_covers_nothing(void **state)
{
	struct camera camera = look(0.3f, 5.0f);
	struct floor_strips strips;

	(void)state;
	floor_strips_find(&strips, &camera, 240, 320, ground, 20.0f, 30.0f);
	assert_true(strips.covered_px > 0);
	camera.target[2] = 141421.0f;
	floor_strips_find(&strips, &camera, 240, 320, ground, 20.0f, 30.0f);
	assert_int_equal(strips.covered_px, 0);
}

/* Along each axis, 16.16 ends behind 32 km to either side. */
static void test_ground_is_drawn_up_to_the_last_numbers(void **state)
{
	(void)state;
	for (int i = 0; i < 12; i++) {
		int axis = i / 4;
		float sign = i % 2 ? -1.0f : 1.0f;
		bool in_reach = i % 4 < 2;
		struct camera camera = look(0.3f, 5.0f);
		struct floor_strips strips;

		camera.target[0] = camera.target[1] = 0.0f;
		camera.target[axis] = sign * (in_reach ? 31980.0f : 32020.0f);
		floor_strips_find(&strips, &camera, 240, 320,
			camera.target[1] - 0.5f, 20.0f, 30.0f);
		assert_true(strips.opaque);
		assert_int_equal(strips.covered_px > 0, in_reach);
	}
}

/* By its distance ahead, where the picture's edge cuts the ground off, too. */
static void test_ground_fades_between_its_two_distances(void **state)
{
	static const float opaque_end = 3.0f, end = 8.0f;
	int cut = 0;

	(void)state;
	for (int i = 0; i < 40; i++) {
		const struct camera camera =
			look(0.1f + 0.025f * (float)i, 4.0f);
		struct floor_strips strips;

		floor_strips_find(
			&strips, &camera, 480, 640, ground, opaque_end, end);
		assert_true(strips.opaque || strips.fading);
		for (int k = 0; k < 6; k++) {
			float ahead = ahead_of(&camera, strips.position[k]);
			float share = (end - ahead) / (end - opaque_end);

			share = fminf(1.0f, fmaxf(0.0f, share));
			assert_near(strips.alpha[k], 255.0 * share, 1.0);
		}
		cut += strips.alpha[4] > 0;
	}
	assert_in_range(cut, 5, 35);
}

/* The ground fades below the picture, or ends there. */
static void test_ground_out_of_the_picture_is_not_drawn(void **state)
{
	static const float none[6][3];
	const struct camera camera = look(0.02f, 4.0f);
	struct floor_strips strips;

	(void)state;
	floor_strips_find(&strips, &camera, 480, 640, ground, 0.1f, 8.0f);
	assert_false(strips.opaque);
	assert_true(strips.fading);
	assert_int_equal(strips.covered_px, 0);
	assert_true(strips.end_px > 0);
	floor_strips_find(&strips, &camera, 480, 640, ground, 0.1f, 0.2f);
	assert_false(strips.opaque);
	assert_false(strips.fading);
	assert_int_equal(strips.covered_px, 0);
	assert_int_equal(strips.end_px, 0);
	assert_all_near(strips.position, none, 18, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_strips_extend_from_side_to_side),
		cmocka_unit_test(test_nothing_that_fades_counts_as_covered),
		cmocka_unit_test(test_ground_seen_from_above_fills_the_picture),
		cmocka_unit_test(test_near_ground_that_is_cut_off_covers_nothing),
		cmocka_unit_test(test_from_below_there_is_no_ground),
		cmocka_unit_test(test_a_horizon_below_the_picture_leaves_a_row),
		cmocka_unit_test(test_shadows_far_out_are_below_the_horizon),
		cmocka_unit_test(test_coarse_numbers_leave_no_gap_at_the_sides),
		cmocka_unit_test(test_far_from_the_origin_is_no_gap_at_the_edges),
		cmocka_unit_test(
			test_far_from_the_origin_covered_rows_are_covered),
		cmocka_unit_test(
			test_ground_too_far_away_to_be_drawn_covers_nothing),
		cmocka_unit_test(test_ground_is_drawn_up_to_the_last_numbers),
		cmocka_unit_test(test_ground_fades_between_its_two_distances),
		cmocka_unit_test(test_ground_out_of_the_picture_is_not_drawn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
