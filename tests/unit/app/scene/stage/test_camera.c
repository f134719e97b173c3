#include "app/scene/stage/camera.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/stage/box.h"

#include <math.h>

#include <cglm/cglm.h>

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

/* A point's place in the picture that camera_frustum() describes. */
static void project_shifted(const struct camera *camera, float aspect,
	const float point[3], float out[2])
{
	project(camera, aspect, point, out);
	out[0] += camera->shift_x;
	out[1] += camera->shift_y;
}

struct extent {
	float low[2], high[2];
};

static struct extent extent_of(
	const struct camera *camera, float aspect, const struct bounds *bounds)
{
	struct extent extent = {{9.0f, 9.0f}, {-9.0f, -9.0f}};

	for (int i = 0; i < 8; i++) {
		float corner[3], at[2];

		for (int axis = 0; axis < 3; axis++) {
			corner[axis] = i >> axis & 1 ? bounds->high[axis]
						     : bounds->low[axis];
		}
		project_shifted(camera, aspect, corner, at);
		for (int k = 0; k < 2; k++) {
			extent.low[k] = fminf(extent.low[k], at[k]);
			extent.high[k] = fmaxf(extent.high[k], at[k]);
		}
	}
	return extent;
}

/* The box is in the region, in its middle, and touches two of its edges. */
static void check_region(const struct camera *camera, float aspect,
	const struct bounds *bounds, const struct camera_region *region)
{
	struct extent e = extent_of(camera, aspect, bounds);
	float wide = (e.high[0] - e.low[0]) / (region->right - region->left);
	float high = (e.high[1] - e.low[1]) / (region->top - region->bottom);

	assert_true(e.low[0] >= region->left - 1e-3f);
	assert_true(e.high[0] <= region->right + 1e-3f);
	assert_true(e.low[1] >= region->bottom - 1e-3f);
	assert_true(e.high[1] <= region->top + 1e-3f);
	assert_near(e.low[0] + e.high[0], region->left + region->right, 2e-3);
	assert_near(e.low[1] + e.high[1], region->bottom + region->top, 2e-3);
	assert_true(fmaxf(wide, high) > 0.98f);
}

static void check_following(struct bounds bounds, float aspect)
{
	const struct camera_framing framing = {.aspect = aspect,
		.yaw_rad = 0.45f,
		.pitch_rad = 0.16f,
		.margin = 1.0f,
		.region = {-0.3f, 1.0f, -1.0f, 0.8f},
		.follow = true};
	struct camera camera = camera_default();

	camera_frame(&camera, &bounds, &framing);
	for (int turn = 0; turn < 24; turn++) {
		check_region(&camera, aspect, &bounds, &framing.region);
		assert_true(
			camera.distance <= camera_farthest(&camera) * 1.0001f);
		camera_orbit(&camera, 0.2618f, turn < 12 ? 0.1f : -0.1f);
	}
}

static void test_follows_any_box_around(void **state)
{
	static const float aspects[] = {0.75f, 4.0f / 3, 5.0f / 3, 16.0f / 9};
	static const float sizes[][3] = {{6, 1, 0.2f}, {0.2f, 1, 6},
		{3, 0.01f, 3}, {0.15f, 14, 0.15f}, {0.001f, 0.001f, 0.002f},
		{450, 200, 300}, {0.5f, 0.5f, 20}};

	(void)state;
	for (size_t a = 0; a < 4; a++) {
		for (size_t s = 0; s < 7; s++) {
			struct bounds bounds =
				box(sizes[s][0], sizes[s][1], sizes[s][2]);

			check_following(bounds, aspects[a]);
			bounds.low[0] += 300.0f;
			bounds.high[0] += 300.0f;
			if (sizes[s][1] > 0.1f) {
				check_following(bounds, aspects[a]);
			}
		}
	}
}

static void test_an_empty_region_is_the_whole_picture(void **state)
{
	static const struct camera_region empty[] = {{0.0f, 0.0f, 0.0f, 0.0f},
		{-1.0f, 1.0f, 1.0f, 1.0f}, {0.5f, -0.5f, -1.0f, 1.0f},
		{-1.0f, 1.0f, 1.5f, 1.0f}};
	const struct camera_region whole = {-1.0f, 1.0f, -1.0f, 1.0f};
	struct bounds bounds = box(2.0f, 1.0f, 0.5f);

	(void)state;
	for (size_t i = 0; i < 4; i++) {
		const struct camera_framing framing = {.aspect = 0.75f,
			.margin = 1.0f,
			.region = empty[i],
			.follow = true};
		struct camera camera = camera_default();

		camera_frame(&camera, &bounds, &framing);
		check_region(&camera, 0.75f, &bounds, &whole);
	}
}

static void test_zoom_stays_when_the_camera_orbits(void **state)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	struct camera camera = camera_default();
	struct bounds bounds = box(2.0f, 1.0f, 0.5f);
	float whole;

	(void)state;
	camera_frame(&camera, &bounds, &framing);
	whole = camera.distance;
	camera_zoom(&camera, 0.5f);
	assert_near(camera.distance, 0.5 * whole, 1e-4);
	camera_orbit(&camera, 1.0f, 0.0f);
	camera_orbit(&camera, -1.0f, 0.0f);
	assert_near(camera.distance, 0.5 * whole, 1e-3 * whole);
}

/* A button that is held for minutes, or a frame that takes seconds. */
static void test_zoom_ends_where_a_picture_is_left(void **state)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	static const float factors[] = {0.98f, 1.02f, -0.2f, 1e9f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(factors); i++) {
		struct camera camera = camera_default();
		struct bounds bounds = box(2.0f, 1.0f, 0.5f);
		struct camera_frustum frustum;
		float whole;

		camera_frame(&camera, &bounds, &framing);
		whole = camera.distance;
		for (int frame = 0; frame < 20000; frame++) {
			camera_zoom(&camera, factors[i]);
		}
		frustum = camera_frustum(&camera, 240, 320);
		assert_true(frustum.near > 0 && frustum.far > frustum.near &&
			frustum.far < INT32_MAX);
		camera_zoom(&camera, 1.0f / camera.fit.zoom);
		assert_near(camera.distance, whole, 1e-3 * whole);
	}
}

static void test_frames_nothing_without_dividing_by_zero(void **state)
{
	const struct camera_framing framing = {.aspect = 0.75f, .margin = 1.1f};
	struct camera camera = camera_default();
	struct bounds nothing = bounds_empty();
	struct bounds point = box(0.0f, 0.0f, 0.0f);
	struct camera_framing follows;

	(void)state;
	camera_frame(&camera, &nothing, &framing);
	assert_true(camera.distance > 0.0f);
	camera_frame(&camera, &point, &framing);
	assert_true(camera.distance > 0.0f);
	follows = framing;
	follows.follow = true;
	camera_frame(&camera, &nothing, &follows);
	assert_true(camera.distance > 0.0f);
	camera_frame(&camera, &point, &follows);
	assert_true(camera.distance > 0.0f);
	assert_true(isfinite(camera.shift_x) && isfinite(camera.shift_y));
}

static void test_easing_to_nothing_leaves_the_camera(void **state)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	struct camera camera = camera_default();
	struct bounds bounds = box(1.0f, 2.0f, 0.5f);
	struct bounds nothing = bounds_empty();
	struct camera before;

	(void)state;
	camera_frame(&camera, &bounds, &framing);
	before = camera;
	camera_ease_to(&camera, &nothing, 0.5f);
	assert_near(camera.distance, before.distance, 0.0);
	assert_all_near(camera.target, before.target, 3, 0.0);
	assert_all_near(camera.fit.half, before.fit.half, 3, 0.0);
}

/* By halves of the way, to the same picture as if the box had been framed. */
static void test_easing_ends_at_the_other_box(void **state)
{
	const struct camera_framing framing = {
		.aspect = 0.75f, .margin = 1.1f, .follow = true};
	struct camera camera = camera_default(), other = camera_default();
	struct bounds first = box(1.0f, 2.0f, 0.5f), next = box(3, 1, 2);
	float halfway;

	(void)state;
	camera_frame(&other, &next, &framing);
	camera_frame(&camera, &first, &framing);
	halfway = 0.5f * (camera.target[1] + other.target[1]);
	camera_ease_to(&camera, &next, 0.5f);
	assert_near(camera.target[1], halfway, 1e-6);
	for (int i = 0; i < 30; i++) {
		camera_ease_to(&camera, &next, 0.5f);
	}
	assert_all_near(camera.target, other.target, 3, 1e-5);
	assert_near(camera.distance, other.distance, 1e-3 * other.distance);
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

/* The target in eye space by the matrix that GL gets, in 16.16. */
static void find_rounded(const struct camera *camera, double out[3])
{
	mat4 view;

	camera_view(camera, view);
	for (int i = 0; i < 3; i++) {
		out[i] = 0.0;
		for (int k = 0; k < 4; k++) {
			out[i] += (double)fx16_to_float(
					  fx16_from_float(view[k][i])) *
				(k < 3 ? (double)camera->target[k] : 1.0);
		}
	}
}

/* A picture of 640 rows shows 0.0033 scene units in each. */
static void test_a_far_target_stays_in_place_while_the_camera_orbits(
	void **state)
{
	(void)state;
	for (int i = 0; i < 400; i++) {
		struct camera camera = camera_default();
		double at[3];

		camera.target[0] = i % 2 ? 20000.0f : -90.0f;
		camera.target[1] = i % 3 ? 1.0f : 300.0f;
		camera.target[2] = i % 4 ? 12345.6f : 0.0f;
		camera.yaw_rad = 0.015f * (float)i - 3.0f;
		camera.pitch_rad = 0.003f * (float)i;
		find_rounded(&camera, at);
		assert_true(fabs(at[0]) < 0.0033 && fabs(at[1]) < 0.0033);
		assert_true(fabs(at[2] + 4.0) < 0.0066);
		assert_true(fabs(at[0]) <= (double)camera_view_error(&camera));
		assert_true(fabs(at[1]) <= (double)camera_view_error(&camera));
	}
}

static void test_only_what_lies_flat_is_seen_from_well_above(void **state)
{
	struct bounds nothing = bounds_empty();
	struct bounds map = box(2.5f, 0.9f, 2.5f), snake = box(9.0f, 1.0f, 1.9f);
	struct bounds picture = box(4.0f, 3.0f, 0.1f);

	(void)state;
	assert_near(camera_pitch_for(&map), 0.56, 1e-6);
	assert_near(camera_pitch_for(&snake), 0.16, 1e-6);
	assert_near(camera_pitch_for(&picture), 0.16, 1e-6);
	assert_near(camera_pitch_for(&nothing), 0.16, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_frames_any_box_from_all_sides),
		cmocka_unit_test(test_follows_any_box_around),
		cmocka_unit_test(test_an_empty_region_is_the_whole_picture),
		cmocka_unit_test(test_zoom_stays_when_the_camera_orbits),
		cmocka_unit_test(test_zoom_ends_where_a_picture_is_left),
		cmocka_unit_test(test_frames_nothing_without_dividing_by_zero),
		cmocka_unit_test(test_easing_to_nothing_leaves_the_camera),
		cmocka_unit_test(test_easing_ends_at_the_other_box),
		cmocka_unit_test(test_view_puts_the_target_straight_ahead),
		cmocka_unit_test(test_view_at_yaw_zero_looks_at_the_front),
		cmocka_unit_test(test_orbit_stays_above_the_floor_and_wraps),
		cmocka_unit_test(
			test_a_far_target_stays_in_place_while_the_camera_orbits),
		cmocka_unit_test(
			test_only_what_lies_flat_is_seen_from_well_above),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
