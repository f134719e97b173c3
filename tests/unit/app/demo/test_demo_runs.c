/*
 * Runs every demo for a scripted minute. The final state is the same each time
 * and, within a tolerance, on each machine; no frame allocates.
 */
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#if defined(__SANITIZE_ADDRESS__)
#define COUNTS_ALLOCATIONS 0
#else
#define COUNTS_ALLOCATIONS 1
/* glibc's allocator, which the counting one below calls. */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *old, size_t size);

static long allocations;

void *malloc(size_t size)
{
	allocations++;
	return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
	allocations++;
	return __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
	allocations++;
	return __libc_realloc(old, size);
}
#endif

enum {
	RATE_HZ = 10, /* coarse, so that a minute is cheap under emulation */
	MINUTE_S = 60
};

/* Presses every button of every demo, some while others still act. */
static const struct demo_press presses[] = {
	{1.0, BUTTON_UP},
	{3.0, BUTTON_UP},
	{4.0, BUTTON_RIGHT},
	{4.2, BUTTON_LEFT},
	{6.0, BUTTON_ENTER},
	{7.0, BUTTON_F6},
	{8.0, BUTTON_F8},
	{9.0, BUTTON_F9},
	{30.0, BUTTON_DOWN},
	{31.0, BUTTON_F8},
	{33.0, BUTTON_F6},
	{34.0, BUTTON_F8},
	{36.0, BUTTON_RIGHT},
	{38.0, BUTTON_UP},
	{40.0, BUTTON_F10},
	{42.0, BUTTON_LEFT},
	{50.0, BUTTON_DOWN},
	{59.8, BUTTON_RIGHT},
};

static const char *const demos[] = {"walker", "arm", "face", "walker.glb"};

/* Only the last frame is drawn. */
static struct gl_recording minute(const char *name, const char *kernel)
{
	const int count = (int)ARRAY_COUNT(presses);
	struct gl_recording recording;
	struct demo_run run;

	demo_run_begin_by(&run, name, kernel);
	demo_run_to(&run, MINUTE_S, RATE_HZ, presses, count);
	demo_run_draw(&run);
	recording = *gl_recorder_result();
	demo_run_end(&run);
	return recording;
}

/* The first run of each demo by floats, which several tests look at. */
static struct gl_recording first[ARRAY_COUNT(demos)];

static int run_all_once(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(demos); i++) {
		first[i] = minute(demos[i], "float");
	}
	return 0;
}

/*
 * Compares the mean of all drawn vertices in eye space with a reference from an
 * x86-64 build; other machines may round differently. `make golden` writes the
 * reference, with GOLDEN_WRITE in the environment.
 */
static const char reference[] = "tests/golden/demo-runs.txt";

static void write_reference(void)
{
	FILE *out = fopen(reference, "w");

	assert_non_null(out);
	for (size_t i = 0; i < ARRAY_COUNT(demos); i++) {
		struct gl_recording end = first[i];
		double count = (double)end.vertex_count;

		fprintf(out, "%s %.6f %.6f %.6f\n", demos[i], end.sum[0] / count,
			end.sum[1] / count, end.sum[2] / count);
	}
	assert_int_equal(fclose(out), 0);
}

static void test_a_minute_ends_in_the_same_place_on_each_machine(void **state)
{
	FILE *in;

	(void)state;
	if (getenv("GOLDEN_WRITE")) {
		write_reference();
	}
	in = fopen(reference, "r");
	assert_non_null(in);
	for (size_t i = 0; i < ARRAY_COUNT(demos); i++) {
		struct gl_recording end = first[i];
		double expected[3];
		char name[32];

		assert_int_equal(
			fscanf(in, "%31s %lf %lf %lf", name, &expected[0],
				&expected[1], &expected[2]),
			4);
		assert_string_equal(name, demos[i]);
		assert_true(end.vertex_count > 1000);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(end.sum[axis] / (double)end.vertex_count,
				expected[axis], 1e-4);
		}
	}
	fclose(in);
}

/*
 * In fixed point the bytes are the same on every machine and by each
 * fixed-point kernel.
 */
static const char fixed_reference[] = "tests/golden/demo-runs-fixed.txt";

static void write_fixed_reference(void)
{
	FILE *out = fopen(fixed_reference, "w");

	assert_non_null(out);
	for (size_t i = 0; i < ARRAY_COUNT(demos); i++) {
		fprintf(out, "%s %016" PRIx64 "\n", demos[i],
			minute(demos[i], "fixed").vertex_hash);
	}
	assert_int_equal(fclose(out), 0);
}

static void test_a_minute_in_fixed_point_is_the_same_bytes(void **state)
{
	FILE *in;

	(void)state;
	if (getenv("GOLDEN_WRITE")) {
		write_fixed_reference();
	}
	in = fopen(fixed_reference, "r");
	assert_non_null(in);
	for (size_t i = 0; i < ARRAY_COUNT(demos); i++) {
		uint64_t hash;
		char name[32];

		assert_int_equal(fscanf(in, "%31s %" SCNx64, name, &hash), 2);
		assert_string_equal(name, demos[i]);
		for (int k = 0; kernel_registry[k]; k++) {
			const struct kernel *kernel = kernel_registry[k];

			if (kernel->fixed) {
				print_message(
					"# %s by %s\n", name, kernel->name);
				assert_true(minute(demos[i], kernel->name)
						    .vertex_hash == hash);
			}
		}
	}
	fclose(in);
}

static void test_a_minute_leaves_the_same_state_each_time(void **state)
{
	(void)state;
#ifdef __arm__
	skip_because(
		"qemu-arm takes half a minute for what is the same C elsewhere");
#endif
	for (size_t i = 0; i < ARRAY_COUNT(demos); i++) {
		struct gl_recording second = minute(demos[i], "float");

		assert_true(first[i].vertex_hash == second.vertex_hash);
	}
}

static void test_no_frame_after_the_first_allocates(void **state)
{
	(void)state;
#if COUNTS_ALLOCATIONS
	for (size_t i = 0; i < 2 * ARRAY_COUNT(demos); i++) {
		struct demo_run run;
		long before;

		demo_run_begin_by(&run, demos[i / 2], i % 2 ? "fixed" : "float");
		demo_run_to(&run, 0.1, RATE_HZ, NULL, 0);
		demo_run_draw(&run);
		before = allocations;
		assert_true(before > 0);
		for (double time_s = 0.2; time_s < 10.0; time_s += 0.1) {
			demo_run_to(&run, time_s, RATE_HZ, presses,
				(int)ARRAY_COUNT(presses));
			demo_run_draw(&run);
		}
		assert_int_equal(allocations - before, 0);
		demo_run_end(&run);
	}
#else
	skip_because("the sanitizers bring an allocator of their own");
#endif
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_minute_leaves_the_same_state_each_time),
		cmocka_unit_test(
			test_a_minute_ends_in_the_same_place_on_each_machine),
		cmocka_unit_test(test_a_minute_in_fixed_point_is_the_same_bytes),
		cmocka_unit_test(test_no_frame_after_the_first_allocates),
	};

	return cmocka_run_group_tests(tests, run_all_once, NULL);
}
