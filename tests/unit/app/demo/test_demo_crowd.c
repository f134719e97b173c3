/* The crowd: its walkers' positions and number. */
#include "app/demo/crowd/crowd_route.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <math.h>

static float distance(int a, int b, double time_s)
{
	struct crowd_route from = crowd_route(a), to = crowd_route(b);
	struct crowd_position p = crowd_position_at(&from, time_s);
	struct crowd_position q = crowd_position_at(&to, time_s);

	return hypotf(p.x - q.x, p.z - q.z);
}

static void test_no_two_walkers_meet(void **state)
{
	(void)state;
	for (int a = 0; a < CROWD_MAX; a++) {
		for (int b = 0; b < a; b++) {
			for (double at_s = 0.0; at_s < 60.0; at_s += 0.37) {
				assert_true(distance(a, b, at_s) > 0.7f);
			}
		}
	}
}

static void test_the_circle_holds_them_all_and_grows(void **state)
{
	(void)state;
	for (int i = 0; i < CROWD_MAX; i++) {
		struct crowd_route place = crowd_route(i);

		assert_true(place.radius_m < crowd_radius_m(i + 1));
		assert_true(crowd_radius_m(i + 1) <= crowd_radius_m(i + 2));
		assert_in_range((int)(place.phase * 1000.0f), 0, 999);
	}
}

static void test_walkers_go_where_they_look_as_fast_as_their_feet(void **state)
{
	(void)state;
	for (int i = 1; i < 60; i++) {
		struct crowd_route place = crowd_route(i % 30);
		struct crowd_position from, to;
		float x, z, speed = fabsf(place.speed_m_s);

		/* Also the other way round. */
		place.speed_m_s *= i < 30 ? 1.0f : -1.0f;
		from = crowd_position_at(&place, 5.0);
		to = crowd_position_at(&place, 5.01);
		x = to.x - from.x;
		z = to.z - from.z;

		assert_near(hypotf(x, z) / 0.01f, speed, 0.02f * speed);
		assert_true(x * sinf(from.yaw_rad) + z * cosf(from.yaw_rad) >=
			0.99f * hypotf(x, z));
	}
}

/* Feet stay on the ground, and the head is nearer to the ring's middle. */
static void test_runners_lean_into_their_circle(void **state)
{
	int leaning = 0;

	(void)state;
	for (int i = 0; i < 30; i++) {
		struct crowd_route route = crowd_route(i);
		struct crowd_position at = crowd_position_at(&route, 3.0);
		float speed = fabsf(route.speed_m_s);
		float feet, head;
		mat4 matrix;

		crowd_matrix(&route, &at, matrix);
		feet = hypotf(matrix[3][0], matrix[3][2]);
		head = hypotf(matrix[3][0] + matrix[1][0],
			matrix[3][2] + matrix[1][2]);
		assert_true(matrix[3][1] == 0.0f);
		assert_near(feet, route.radius_m, 1e-4);
		if (speed > 0.0f) {
			assert_near(tanf(fabsf(at.lean_rad)),
				speed * speed / (9.81f * route.radius_m), 1e-3);
			assert_near(feet - head,
				route.size * sinf(fabsf(at.lean_rad)), 1e-3);
			leaning++;
		} else {
			assert_near(head, feet, 1e-4);
		}
	}
	assert_true(leaning > 20);
}

static void test_walkers_differ_in_size_and_phase(void **state)
{
	(void)state;
	for (int a = 0; a < 12; a++) {
		struct crowd_route one = crowd_route(a);

		assert_true(one.size >= 0.9f && one.size <= 1.08f);
		for (int b = 0; b < a; b++) {
			struct crowd_route other = crowd_route(b);

			assert_true(fabsf(one.size - other.size) > 0.002f);
			assert_true(fabsf(one.phase - other.phase) > 0.02f);
		}
	}
}

static const struct demo_press presses[] = {
	{0.1, BUTTON_F8},    /* small ones keep all triangles */
	{1.0, BUTTON_UP},    /* 13 */
	{2.0, BUTTON_DOWN},  /* 12 */
	{3.0, BUTTON_RIGHT}, /* 17 */
	{4.0, BUTTON_LEFT},  /* 12, 7, 2, 1 */
	{5.0, BUTTON_LEFT}, {6.0, BUTTON_LEFT}, {7.0, BUTTON_LEFT},
	{8.0, BUTTON_DOWN}, {9.0, BUTTON_F6}, {11.0, BUTTON_RIGHT}, /* 6 */
};

static long triangles_at(double time_s)
{
	struct demo_run run;
	long triangles;

	demo_run_begin(&run, "crowd");
	demo_run_to(&run, time_s, 5, presses, (int)ARRAY_COUNT(presses));
	triangles = demo_get_facts(run.driver, run.demo).triangles;
	demo_run_end(&run);
	return triangles;
}

static void test_buttons_add_and_remove_walkers(void **state)
{
	long one = triangles_at(8.5);

	(void)state;
	assert_true(one > 1000);
	assert_int_equal(triangles_at(0.5), 12 * one);
	assert_int_equal(triangles_at(1.5), 13 * one);
	assert_int_equal(triangles_at(2.5), 12 * one);
	assert_int_equal(triangles_at(3.5), 17 * one);
	assert_int_equal(triangles_at(5.5), 7 * one);
	assert_int_equal(triangles_at(12.0), 6 * one);
}

/* Of all figures, however small. */
static void test_f6_leaves_out_the_shadows(void **state)
{
	static const struct demo_press press[] = {{1.0, BUTTON_F6}};
	int vertices[2];
	long triangles;
	struct demo_run run;

	(void)state;
	demo_run_begin(&run, "crowd");
	for (int i = 0; i < 2; i++) {
		demo_run_to(&run, 0.9 + (double)i, 10, press, 1);
		demo_run_draw(&run);
		vertices[i] = (int)gl_recorder_result()->vertex_count;
	}
	triangles = demo_get_facts(run.driver, run.demo).triangles;
	assert_true(vertices[0] > vertices[1] + triangles / 4);
	demo_run_end(&run);
}

static void test_small_figures_have_fewer_triangles(void **state)
{
	static const struct demo_press many[] = {{0.1, BUTTON_RIGHT},
		{0.3, BUTTON_RIGHT}, {0.5, BUTTON_RIGHT}, {0.7, BUTTON_RIGHT},
		{0.9, BUTTON_RIGHT}, {1.1, BUTTON_RIGHT}, {1.3, BUTTON_RIGHT},
		{1.5, BUTTON_RIGHT}, {6.0, BUTTON_F8}};
	struct demo_run run;
	long few, all;

	(void)state;
	demo_run_begin(&run, "crowd");
	demo_run_to(&run, 5.9, 10, many, (int)ARRAY_COUNT(many));
	few = demo_get_facts(run.driver, run.demo).triangles;
	demo_run_to(&run, 6.5, 10, many, (int)ARRAY_COUNT(many));
	all = demo_get_facts(run.driver, run.demo).triangles;
	assert_true(few > 50 * 300);
	assert_true(few < all / 2);
	demo_run_end(&run);
}

/* The frame of a crowd of small or of large figures with this reduction. */
static struct gl_recording frame_of(bool small, struct demo_reduction reduction)
{
	static const struct demo_press many[] = {{0.1, BUTTON_RIGHT},
		{0.3, BUTTON_RIGHT}, {0.5, BUTTON_RIGHT}, {0.7, BUTTON_RIGHT},
		{0.9, BUTTON_RIGHT}, {1.1, BUTTON_RIGHT}, {1.3, BUTTON_RIGHT},
		{1.5, BUTTON_RIGHT}};
	struct demo_run run;
	struct gl_recording frame;

	demo_run_begin(&run, "crowd");
	demo_set_reduction(run.demo, &reduction);
	demo_run_to(&run, small ? 5 : 1, 5, many,
		small ? (int)ARRAY_COUNT(many) : 0);
	demo_run_draw(&run);
	frame = *gl_recorder_result();
	demo_run_end(&run);
	return frame;
}

static void test_a_budget_holds_normals_and_caps_influences(void **state)
{
	const struct gl_recording all =
		frame_of(false, (struct demo_reduction){0});
	const struct gl_recording less = frame_of(false,
		(struct demo_reduction){
			.max_influences = 1, .hold_normals = true});

	(void)state;
	assert_int_equal(all.vertex_count, less.vertex_count);
	assert_true(fabs(all.sum[0] - less.sum[0]) > 1e-3);
}

/* Small figures have one or two influences a vertex anyway. */
static void test_the_lower_cap_of_influences_counts(void **state)
{
	uint64_t hash_of[4];

	(void)state;
	for (int i = 0; i < 4; i++) {
		hash_of[i] = frame_of(
			true, (struct demo_reduction){.max_influences = i})
				     .vertex_hash;
	}
	assert_true(hash_of[1] != hash_of[0]);
	assert_true(hash_of[2] == hash_of[0]);
	assert_true(hash_of[3] == hash_of[0]);
}

/* Where a figure's left is, in eye space, half a second after a press. */
static void find_left(enum button button, double left[3])
{
	const struct demo_press press[] = {{1.0, button}};
	const struct gl_recorded_draw *draw = gl_recorder_result()->draw;
	double length = 0.0;
	struct demo_run run;

	demo_run_begin(&run, "crowd");
	demo_run_to(&run, 1.5, 50, press, 1);
	demo_run_draw(&run);
	while (draw->matrix[0] == 1.0) {
		draw++; /* labels */
	}
	for (int i = 0; i < 3; i++) {
		length += draw->matrix[i] * draw->matrix[i];
	}
	for (int i = 0; i < 3; i++) {
		left[i] = draw->matrix[i] / sqrt(length);
	}
	demo_run_end(&run);
}

static double angle_between(const double a[3], const double b[3])
{
	return acos(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/* At 0.9 radians a second for the tenth of one that it is held, or at 0.08. */
static void test_the_camera_turns_while_enter_is_held_or_after_f9(void **state)
{
	double still[3], turned[3], drifted[3];

	(void)state;
	find_left(BUTTON_F6, still);
	find_left(BUTTON_ENTER, turned);
	find_left(BUTTON_F9, drifted);
	assert_near(angle_between(still, turned), 0.09, 1e-4);
	assert_near(angle_between(still, drifted), 0.04, 2e-3);
	assert_true(turned[0] < drifted[0] && drifted[0] < still[0]);
}

static void test_a_budget_removes_triangles_and_restores_them(void **state)
{
	const struct demo_reduction reduction = {.error_px = 4.0f},
				    nothing = {0};
	/* Two walkers are large enough for fine levels. */
	static const struct demo_press fewer[] = {
		{0.1, BUTTON_LEFT}, {0.5, BUTTON_LEFT}};
	struct demo_run run;
	long all, less, later;

	(void)state;
	demo_run_begin(&run, "crowd");
	demo_run_to(&run, 6.0, 25, fewer, 2);
	demo_run_to(&run, 7.0, 25, NULL, 0);
	later = demo_get_facts(run.driver, run.demo).triangles;
	demo_run_end(&run);
	demo_run_begin(&run, "crowd");
	demo_run_to(&run, 6.0, 25, fewer, 2);
	all = demo_get_facts(run.driver, run.demo).triangles;
	demo_set_reduction(run.demo, &reduction);
	demo_run_to(&run, 6.5, 25, NULL, 0);
	less = demo_get_facts(run.driver, run.demo).triangles;
	assert_true(less < 2 * all / 3);
	assert_true(less > all / 10);
	demo_set_reduction(run.demo, &nothing);
	demo_run_to(&run, 7.0, 25, NULL, 0);
	assert_int_equal(demo_get_facts(run.driver, run.demo).triangles, later);
	demo_run_end(&run);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_no_two_walkers_meet),
		cmocka_unit_test(test_the_circle_holds_them_all_and_grows),
		cmocka_unit_test(
			test_walkers_go_where_they_look_as_fast_as_their_feet),
		cmocka_unit_test(test_runners_lean_into_their_circle),
		cmocka_unit_test(test_walkers_differ_in_size_and_phase),
		cmocka_unit_test(test_buttons_add_and_remove_walkers),
		cmocka_unit_test(test_f6_leaves_out_the_shadows),
		cmocka_unit_test(test_small_figures_have_fewer_triangles),
		cmocka_unit_test(test_a_budget_holds_normals_and_caps_influences),
		cmocka_unit_test(test_the_lower_cap_of_influences_counts),
		cmocka_unit_test(
			test_the_camera_turns_while_enter_is_held_or_after_f9),
		cmocka_unit_test(
			test_a_budget_removes_triangles_and_restores_them),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
