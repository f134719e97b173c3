/* The monitor's boxes, and the part of the picture that it fills. */
#include "app/anim/math/vec.h"
#include "app/scene/stage/monitor.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <math.h>

/* In local units: the screen's half width and its frame. */
static const double half_width = 2.0 / 3, bezel = 0.055;

static void test_all_faces_are_rectangles_that_face_outward(void **state)
{
	static struct monitor monitor;

	(void)state;
	monitor_init(&monitor);
	for (int box = 0; box < MONITOR_BOXES; box++) {
		const float(*corner)[3] =
			(const float(*)[3])monitor.position + 24 * box;
		double area = 0, expected = 0;
		float low[3], high[3], middle[3];

		for (int axis = 0; axis < 3; axis++) {
			low[axis] = high[axis] = corner[0][axis];
			for (int v = 1; v < 24; v++) {
				low[axis] = fminf(low[axis], corner[v][axis]);
				high[axis] = fmaxf(high[axis], corner[v][axis]);
			}
			middle[axis] = 0.5f * (low[axis] + high[axis]);
		}
		for (int i = 36 * box; i < 36 * (box + 1); i += 3) {
			const uint16_t *index = monitor.index + i;
			const float *a = monitor.position[index[0]];
			const int8_t *n = monitor.normal[index[0]];
			float ab[3], ac[3], cross[3], out[3];

			vec_subtract(monitor.position[index[1]], a, ab);
			vec_subtract(monitor.position[index[2]], a, ac);
			vec_cross(ab, ac, cross);
			vec_subtract(a, middle, out);
			area += 0.5 * (double)vec_length(cross);
			/* As large as the part of the normal along them. */
			assert_true(vec_dot(out, cross) > 0);
			assert_near((n[0] * cross[0] + n[1] * cross[1] +
					    n[2] * cross[2]) /
					127.0f,
				vec_length(cross), 1e-6);
			for (int k = 1; k < 3; k++) {
				assert_memory_equal(
					monitor.normal[index[k]], n, 4);
			}
		}
		for (int axis = 0; axis < 3; axis++) {
			int next = (axis + 1) % 3;

			expected += 2 * (double)(high[axis] - low[axis]) *
				(double)(high[next] - low[next]);
		}
		assert_near(area, expected, 1e-5);
	}
}

static void test_the_frame_holds_the_screen_and_stands_on_a_foot(void **state)
{
	static struct monitor monitor;
	float low[3] = {9, 9, 9}, high[3] = {-9, -9, -9};

	(void)state;
	monitor_init(&monitor);
	for (int v = 0; v < MONITOR_VERTICES; v++) {
		for (int axis = 0; axis < 3; axis++) {
			float at = monitor.position[v][axis];

			low[axis] = fminf(low[axis], at);
			high[axis] = fmaxf(high[axis], at);
		}
	}
	assert_near(low[0], -half_width - bezel, 1e-6);
	assert_near(high[0], half_width + bezel, 1e-6);
	assert_near(low[1], 0, 0);
	assert_near(high[1], 0.55 + 1 + bezel, 1e-6);
	/* The frame, which is first, ends at the screen. */
	for (int v = 0; v < 24; v++) {
		assert_true(monitor.position[v][2] <= 0);
		assert_true(monitor.position[v][1] < 0.55f ||
			monitor.position[v][1] > 1.55f);
	}
}

/*
 * Its left edge is at 3% of the picture's width, and it has 46% of the width or
 * 42% of the height, where it stands behind the target.
 */
static void test_it_fills_a_part_at_the_left_wherever_the_target_is(void **state)
{
	static const float aspects[] = {0.5f, 0.75f, 0.9f, 1.0f, 1.5f};
	static const float shifts[] = {-0.3f, 0, 0.4f};

	(void)state;
	for (size_t i = 0; i < 3 * ARRAY_COUNT(aspects); i++) {
		float aspect = aspects[i / 3];
		static struct monitor monitor;
		struct camera camera = camera_default();
		double way[2], behind, across, half, width, wanted;

		camera.shift_x = shifts[i % 3];
		camera.yaw_rad = 0.4f * (float)i;
		camera.radius = 1.2f;
		camera.target[0] = 0.5f;
		camera.target[2] = -2;
		monitor_place(&monitor, &camera, aspect, -0.25f);
		way[0] = (double)(monitor.origin[0] - camera.target[0]);
		way[1] = (double)(monitor.origin[2] - camera.target[2]);
		behind = -way[0] * sin((double)camera.yaw_rad) -
			way[1] * cos((double)camera.yaw_rad);
		across = way[0] * cos((double)camera.yaw_rad) -
			way[1] * sin((double)camera.yaw_rad);
		half = (double)aspect * ((double)camera.distance + behind) *
			tan(0.5 * (double)camera.yfov_rad);
		width = 2 * (half_width + bezel) * (double)monitor.scale;
		wanted = fmin(0.46, 0.42 / (double)aspect);
		assert_near(behind, 0.55 * 1.2, 1e-5);
		assert_near(width / (2 * half), wanted, 1e-5);
		assert_near(
			(across - 0.5 * width) / half + (double)camera.shift_x,
			-0.94, 1e-5);
		assert_near(monitor.origin[1], -0.25, 0);
		assert_near(monitor.yaw_rad, camera.yaw_rad + 0.14f, 1e-6);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_faces_are_rectangles_that_face_outward),
		cmocka_unit_test(
			test_the_frame_holds_the_screen_and_stands_on_a_foot),
		cmocka_unit_test(
			test_it_fills_a_part_at_the_left_wherever_the_target_is),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
