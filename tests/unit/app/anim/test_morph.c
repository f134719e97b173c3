#include "app/anim/kernel/kernel.h"
#include "app/anim/morph.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

/* Numbers that show a last step which is only nearly right. */
static const float A[2][3] = {{0.1f, 0.7f, -1.3f}, {1e6f, 3, 0.3333333f}};
static const float B[2][3] = {{5.9f, -0.2f, 2.7f}, {-17.77f, 1e-7f, 9}};
static const float C[2][3] = {{1, 1, 1}, {2, 2, 2}};
static const float NORMAL_A[2][3] = {{1, 0, 0}, {0, 1, 0}};
static const float NORMAL_B[2][3] = {{0, 1, 0}, {0, 0.6f, 0.8f}};

static const struct morph_key KEY_A = {A, NORMAL_A};
static const struct morph_key KEY_B = {B, NORMAL_B};
static const struct morph_key KEY_C = {C, NORMAL_A};

struct fixture {
	struct arena arena;
	struct morph morph;
	struct morph_motion motion;
};

static void set_up(
	struct fixture *f, enum morph_timing timing, enum morph_curve curve)
{
	*f = (struct fixture){.motion = morph_motion_default()};
	f->motion.timing = timing;
	f->motion.curve = curve;
	f->motion.duration_ms = 700;
	f->motion.frame_count = 7;
	assert_int_equal(morph_init(&f->morph, 2, KEY_A, &f->arena), 0);
}

static void tear_down(struct fixture *f)
{
	arena_release(&f->arena);
}

static void assert_between(
	const struct morph *morph, double omega, double bulge_y)
{
	for (int v = 0; v < 2; v++) {
		for (int k = 0; k < 3; k++) {
			double want = B[v][k] * omega + A[v][k] * (1 - omega);

			want += k == 1 ? bulge_y : 0;
			assert_near(morph->temporal[v][k], want,
				1e-6 * (1 + fabs(want)));
		}
	}
}

static void test_a_new_morph_rests_on_its_key(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_LINEAR);
	assert_memory_equal(f.morph.temporal, A, sizeof(A));
	assert_memory_equal(f.morph.temporal_normal, NORMAL_A, sizeof(A));
	assert_false(morph_update(&f.morph, 1000));
	assert_true(morph_omega(&f.morph, 1000) == 1);
	tear_down(&f);
}

static void test_over_time_begins_at_the_source(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_LINEAR);
	morph_trigger(&f.morph, KEY_B, &f.motion, 5000);
	assert_true(morph_update(&f.morph, 5000));
	assert_true(morph_omega(&f.morph, 5000) == 0);
	assert_memory_equal(f.morph.temporal, A, sizeof(A));
	tear_down(&f);
}

static void test_over_time_omega_is_the_part_that_has_passed(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_LINEAR);
	morph_trigger(&f.morph, KEY_B, &f.motion, 5000);
	for (int i = 0; i < 7; i++) {
		assert_true(morph_update(&f.morph, 5000 + i * 100));
		assert_near(
			morph_omega(&f.morph, 5000 + i * 100), i / 7.0, 1e-6);
		assert_between(&f.morph, i / 7.0, 0);
	}
	tear_down(&f);
}

static void test_by_frames_goes_on_by_equal_parts(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_BY_FRAMES, MORPH_LINEAR);
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	for (int i = 1; i < 7; i++) {
		assert_true(morph_update(&f.morph, 0));
		assert_near(morph_omega(&f.morph, 0), i / 7.0, 1e-6);
		assert_between(&f.morph, i / 7.0, 0);
	}
	assert_true(morph_update(&f.morph, 0));
	assert_memory_equal(f.morph.temporal, B, sizeof(B));
	assert_false(morph_update(&f.morph, 0));
	tear_down(&f);
}

/* Temporal += (Destiny - Source) / nFrames, bit for bit, and exact at the end. */
static void test_frames_add_as_in_the_document(void **state)
{
	const int frames = 7;
	struct fixture f;
	float expected[ARRAY_COUNT(A)][3];
	struct morph plain;

	(void)state;
	set_up(&f, MORPH_BY_FRAMES, MORPH_LINEAR);
	f.motion.frame_count = frames;
	memcpy(expected, A, sizeof(expected));
	assert_int_equal(morph_init(&plain, (int)ARRAY_COUNT(A),
				 (struct morph_key){A, NULL}, &f.arena),
		0);
	morph_trigger(&plain, (struct morph_key){B, NULL}, &f.motion, 0);
	for (int frame = 1; frame < frames; frame++) {
		for (size_t i = 0; i < ARRAY_COUNT(A); i++) {
			for (int k = 0; k < 3; k++) {
				expected[i][k] +=
					(B[i][k] - A[i][k]) / (float)frames;
			}
		}
		assert_true(morph_update(&plain, 0));
		assert_memory_equal(plain.temporal, expected, sizeof(expected));
	}
	assert_true(morph_update(&plain, 0));
	assert_memory_equal(plain.temporal, B, sizeof(B));
	tear_down(&f);
}

static float overshoot(const void *user, float omega)
{
	return omega < 0.5f ? *(const float *)user * omega : 1.2f;
}

static void test_a_shape_is_any_function_of_omega(void **state)
{
	static const float slope = 0.4f;
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_BY_FRAMES, MORPH_SHAPED);
	f.motion.shape = overshoot;
	f.motion.user = &slope;
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	for (int i = 1; i < 7; i++) {
		assert_true(morph_update(&f.morph, 0));
		assert_near(morph_omega(&f.morph, 0), i / 7.0, 1e-6);
		assert_between(&f.morph, i < 4 ? 0.4 * i / 7.0 : 1.2, 0);
	}
	assert_true(morph_update(&f.morph, 0));
	assert_memory_equal(f.morph.temporal, B, sizeof(B));
	tear_down(&f);
}

static void test_every_mode_ends_exactly_at_destiny(void **state)
{
	(void)state;
	for (int mode = 0; mode < 4; mode++) {
		struct fixture f;
		int updates = 0;

		set_up(&f, mode & 1 ? MORPH_BY_FRAMES : MORPH_OVER_TIME,
			mode & 2 ? MORPH_SINUSOIDAL : MORPH_LINEAR);
		morph_trigger(&f.morph, KEY_B, &f.motion, 50);
		while (morph_update(&f.morph, 50 + 33.3 * updates)) {
			updates++;
			assert_in_range(updates, 1, 30);
		}
		assert_int_equal(updates, mode & 1 ? 7 : 23);
		assert_memory_equal(f.morph.temporal, B, sizeof(B));
		assert_memory_equal(
			f.morph.temporal_normal, NORMAL_B, sizeof(NORMAL_B));
		assert_true(morph_omega(&f.morph, 1e9) == 1);
		tear_down(&f);
	}
}

static void test_sinusoidal_adds_a_bulge_that_is_zero_at_both_ends(void **state)
{
	(void)state;
	for (int timing = 0; timing < 2; timing++) {
		struct fixture f;

		set_up(&f, timing ? MORPH_BY_FRAMES : MORPH_OVER_TIME,
			MORPH_SINUSOIDAL);
		f.motion.amplitude = 0.5f;
		morph_trigger(&f.morph, KEY_B, &f.motion, 0);
		if (!timing) {
			assert_true(morph_update(&f.morph, 0));
			assert_memory_equal(f.morph.temporal, A, sizeof(A));
		}
		for (int i = 1; i < 7; i++) {
			assert_true(morph_update(&f.morph, 100 * i));
			assert_between(
				&f.morph, i / 7.0, 0.5 * sin(acos(-1) * i / 7));
		}
		tear_down(&f);
	}
}

static void test_a_trigger_in_flight_starts_from_the_current_shape(void **state)
{
	struct fixture f;
	float shape[2][3];

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_SINUSOIDAL);
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	morph_update(&f.morph, 300);
	memcpy(shape, f.morph.temporal, sizeof(shape));
	morph_trigger(&f.morph, KEY_C, &f.motion, 300);
	assert_memory_equal(f.morph.temporal, shape, sizeof(shape));
	morph_update(&f.morph, 300);
	assert_all_near(f.morph.temporal, shape, 6, 0);
	f.motion.curve = MORPH_LINEAR;
	morph_trigger(&f.morph, KEY_C, &f.motion, 300);
	morph_update(&f.morph, 650);
	assert_near(f.morph.temporal[0][0], 0.5 * (shape[0][0] + 1), 1e-5);
	morph_update(&f.morph, 1000);
	assert_memory_equal(f.morph.temporal, C, sizeof(C));
	tear_down(&f);
}

static void test_pitfall_16_normals_turn_along_and_stay_unit(void **state)
{
	struct fixture f;
	const float halfway[3] = {0.70710678f, 0.70710678f, 0};

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_SINUSOIDAL);
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	morph_update(&f.morph, 350);
	assert_all_near(f.morph.temporal_normal[0], halfway, 3, 1e-6);
	for (int i = 0; i < 7; i++) {
		morph_update(&f.morph, 351 + 40 * i);
		for (int v = 0; v < 2; v++) {
			const float *n = f.morph.temporal_normal[v];

			assert_near(sqrt((double)n[0] * n[0] + n[1] * n[1] +
					    n[2] * n[2]),
				1, 1e-6);
		}
	}
	tear_down(&f);
}

static void test_keys_without_normals_need_none(void **state)
{
	const struct morph_key bare_a = {A, NULL};
	const struct morph_key bare_b = {B, NULL};
	struct fixture f;

	(void)state;
	f = (struct fixture){.motion = morph_motion_default()};
	assert_int_equal(morph_init(&f.morph, 2, bare_a, &f.arena), 0);
	assert_null(f.morph.temporal_normal);
	morph_trigger(&f.morph, bare_b, &f.motion, 0);
	assert_true(morph_update(&f.morph, 250));
	assert_true(morph_update(&f.morph, 500));
	assert_memory_equal(f.morph.temporal, B, sizeof(B));
	tear_down(&f);
}

static void test_no_duration_arrives_at_the_next_update(void **state)
{
	(void)state;
	for (int timing = 0; timing < 2; timing++) {
		for (int sign = -1; sign <= 0; sign++) {
			struct fixture f;

			set_up(&f, timing ? MORPH_BY_FRAMES : MORPH_OVER_TIME,
				MORPH_SINUSOIDAL);
			f.motion.duration_ms = (float)sign * 10;
			f.motion.frame_count = sign * 10;
			morph_trigger(&f.morph, KEY_B, &f.motion, 100);
			assert_true(morph_update(&f.morph, 100));
			assert_memory_equal(f.morph.temporal, B, sizeof(B));
			assert_false(morph_update(&f.morph, 100));
			tear_down(&f);
		}
	}
}

static void test_late_updates_arrive(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_SINUSOIDAL);
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	assert_true(morph_update(&f.morph, 1e9));
	assert_memory_equal(f.morph.temporal, B, sizeof(B));
	tear_down(&f);
}

static void test_a_motion_takes_half_a_second_or_15_frames(void **state)
{
	const struct morph_motion motion = morph_motion_default();

	(void)state;
	assert_near(motion.duration_ms, 500, 0);
	assert_int_equal(motion.frame_count, 15);
	assert_near(motion.amplitude, 0.1, 1e-7);
}

static void test_a_morph_without_memory_is_refused(void **state)
{
	int refused = 0, made = 0;

	(void)state;
	for (size_t limit = 0; limit < 500; limit += 8) {
		struct memory_budget budget = {.limit_bytes = limit};
		struct arena arena = arena_within(&budget);
		struct morph morph;
		int error;

		arena.block_bytes = 16;
		error = morph_init(&morph, 2, KEY_A, &arena);
		if (error == 0) {
			assert_non_null(morph.source);
			assert_non_null(morph.source_normal);
			made++;
		} else {
			assert_int_equal(error, -ENOMEM);
			refused++;
		}
		arena_release(&arena);
	}
	assert_true(refused > 0 && made > 0);
}

static void test_a_trigger_in_flight_has_all_its_frames(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_BY_FRAMES, MORPH_LINEAR);
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	for (int i = 0; i < 3; i++) {
		assert_true(morph_update(&f.morph, 0));
	}
	morph_trigger(&f.morph, KEY_C, &f.motion, 0);
	for (int i = 0; i < 7; i++) {
		assert_near(morph_omega(&f.morph, 0), i / 7.0, 1e-6);
		assert_true(morph_update(&f.morph, 0));
	}
	assert_false(morph_update(&f.morph, 0));
	tear_down(&f);
}

static void test_a_morph_that_has_had_its_time_is_at_1(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_LINEAR);
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	assert_near(morph_omega(&f.morph, 700), 1, 0);
	assert_near(morph_omega(&f.morph, 900), 1, 0);
	f.motion.timing = MORPH_BY_FRAMES;
	f.motion.frame_count = 0;
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	assert_near(morph_omega(&f.morph, 0), 1, 0);
	tear_down(&f);
}

static void test_a_bulge_goes_along_all_axes_of_its_direction(void **state)
{
	static const float direction[3] = {2, 3, 5};
	struct fixture f;

	(void)state;
	set_up(&f, MORPH_OVER_TIME, MORPH_SINUSOIDAL);
	memcpy(f.motion.direction, direction, sizeof(direction));
	morph_trigger(&f.morph, KEY_B, &f.motion, 0);
	assert_true(morph_update(&f.morph, 350));
	for (int k = 0; k < 3; k++) {
		assert_near(f.morph.temporal[0][k],
			((double)A[0][k] + (double)B[0][k]) / 2 +
				0.1 * (double)direction[k],
			1e-5);
	}
	tear_down(&f);
}

static void test_keys_without_normals_go_over_time_as_well(void **state)
{
	struct fixture f = {.motion = morph_motion_default()};
	const struct morph_key from = {A, NULL}, to = {B, NULL};

	(void)state;
	assert_int_equal(morph_init(&f.morph, 2, from, &f.arena), 0);
	morph_trigger(&f.morph, to, &f.motion, 0);
	assert_true(morph_update(&f.morph, 125));
	assert_between(&f.morph, 0.25, 0);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_new_morph_rests_on_its_key),
		cmocka_unit_test(test_over_time_begins_at_the_source),
		cmocka_unit_test(
			test_over_time_omega_is_the_part_that_has_passed),
		cmocka_unit_test(test_by_frames_goes_on_by_equal_parts),
		cmocka_unit_test(test_frames_add_as_in_the_document),
		cmocka_unit_test(test_a_shape_is_any_function_of_omega),
		cmocka_unit_test(test_every_mode_ends_exactly_at_destiny),
		cmocka_unit_test(
			test_sinusoidal_adds_a_bulge_that_is_zero_at_both_ends),
		cmocka_unit_test(
			test_a_trigger_in_flight_starts_from_the_current_shape),
		cmocka_unit_test(
			test_pitfall_16_normals_turn_along_and_stay_unit),
		cmocka_unit_test(test_keys_without_normals_need_none),
		cmocka_unit_test(test_no_duration_arrives_at_the_next_update),
		cmocka_unit_test(test_late_updates_arrive),
		cmocka_unit_test(test_a_motion_takes_half_a_second_or_15_frames),
		cmocka_unit_test(test_a_morph_without_memory_is_refused),
		cmocka_unit_test(test_a_trigger_in_flight_has_all_its_frames),
		cmocka_unit_test(test_a_morph_that_has_had_its_time_is_at_1),
		cmocka_unit_test(
			test_a_bulge_goes_along_all_axes_of_its_direction),
		cmocka_unit_test(test_keys_without_normals_go_over_time_as_well),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
