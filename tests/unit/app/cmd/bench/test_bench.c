/*
 * The meshes, jobs and times of limber bench.
 */
#include "app/cmd/bench/bench_rows.h"
#include "app/cmd/bench/bench_time.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void test_makes_the_same_mesh_every_time(void **state)
{
	struct bench_mesh one, two;

	(void)state;
	assert_int_equal(bench_mesh_make(&one, 100, 3, 24), 0);
	assert_int_equal(bench_mesh_make(&two, 100, 3, 24), 0);
	assert_memory_equal(one.primitive.position, two.primitive.position,
		sizeof(float[100][3]));
	assert_memory_equal(one.primitive.weight, two.primitive.weight,
		sizeof(float[100][4]));
	bench_mesh_release(&one);
	bench_mesh_release(&two);
}

static void test_meshes_have_the_influences_asked_for(void **state)
{
	(void)state;
	for (int influences = 1; influences <= 4; influences++) {
		struct bench_mesh mesh;

		assert_int_equal(bench_mesh_make(&mesh, 500, influences, 24), 0);
		for (int v = 0; v < 500; v++) {
			const float *weight = mesh.primitive.weight + v * 4;
			const uint16_t *joint = mesh.primitive.joint + v * 4;
			int count = 0;
			double sum = 0;

			for (int i = 0; i < 4; i++) {
				count += weight[i] > 0;
				sum += (double)weight[i];
				assert_true(joint[i] < mesh.joint_count);
				assert_true(i >= influences || i == 0 ||
					joint[i] != joint[i - 1]);
			}
			assert_int_equal(count, influences);
			assert_near(sum, 1, 1e-6);
		}
		bench_mesh_release(&mesh);
	}
}

static int count_sets(const struct bench_mesh *mesh)
{
	int count = 0;

	for (int v = 0; v < mesh->primitive.vertex_count; v++) {
		const uint16_t *joint = mesh->primitive.joint + v * 4;
		bool is_new = true;

		for (int w = 0; w < v && is_new; w++) {
			is_new = memcmp(joint, mesh->primitive.joint + w * 4,
					 sizeof(uint16_t[4])) != 0;
		}
		count += is_new;
	}
	return count;
}

static void test_meshes_have_the_joint_sets_asked_for(void **state)
{
	struct bench_mesh mesh;

	(void)state;
	assert_int_equal(bench_mesh_make(&mesh, 1024, 3, 24), 0);
	assert_in_range(count_sets(&mesh), 20, 24);
	bench_mesh_release(&mesh);
	assert_int_equal(bench_mesh_make(&mesh, 1024, 3, 0), 0);
	assert_in_range(count_sets(&mesh), 500, 1024);
	bench_mesh_release(&mesh);
}

/* The number in a row's name, as in "skin-normals-8"; 1 if there is none. */
static int influences_in(const char *name)
{
	const char *digit = strpbrk(name, "0123456789");

	return digit ? atoi(digit) : 1;
}

/* Published figures are of 24 sets of joints, and of as many influences as the
 * row's name says. */
static void test_rows_measure_the_meshes_that_their_names_say(void **state)
{
	(void)state;
	for (const struct bench_row *row = bench_rows; row->name; row++) {
		bool scattered = strstr(row->name, "scattered") != NULL;

		assert_int_equal(row->joint_sets, scattered ? 0 : 24);
		if (row->work <= BENCH_SKIN_TANGENTS) {
			assert_int_equal(
				row->influences, influences_in(row->name));
		}
	}
}

static void test_every_kernel_runs_every_job_or_refuses_it(void **state)
{
	(void)state;
	for (const struct bench_row *row = bench_rows; row->name; row++) {
		struct bench_mesh mesh;
		int done = 0;

		assert_int_equal(bench_mesh_make(&mesh, 64, row->influences,
					 row->joint_sets),
			0);
		for (int k = 0; kernel_registry[k]; k++) {
			struct arena arena = arena_empty();
			struct bench_job job;
			int error = bench_job_prepare(kernel_registry[k]->name,
				&mesh, row->work, &arena, &job);

			assert_true(error == 0 || error == -ENOTSUP);
			if (!error) {
				assert_int_equal(job.vertex_count, 64);
				job.run(job.state);
				done++;
			}
			arena_release(&arena);
		}
		assert_true(done >= 1);
		bench_mesh_release(&mesh);
	}
}

static void test_refuses_an_unknown_kernel(void **state)
{
	struct arena arena = arena_empty();
	struct bench_mesh mesh;
	struct bench_job job;

	(void)state;
	assert_int_equal(bench_mesh_make(&mesh, 8, 1, 0), 0);
	assert_int_equal(
		bench_job_prepare("none", &mesh, BENCH_SKIN, &arena, &job),
		-EINVAL);
	bench_mesh_release(&mesh);
	arena_release(&arena);
}

static void sleep_1_ms(void *user)
{
	struct timespec millisecond = {.tv_nsec = 1000000};

	(void)user;
	nanosleep(&millisecond, NULL);
}

static void test_times_a_vertex(void **state)
{
	const struct bench_job job = {.vertex_count = 10, .run = sleep_1_ms};
	struct bench_evictor evictor;
	struct bench_time time;

	(void)state;
	assert_int_equal(bench_evictor_init(&evictor), 0);
	time = bench_time_job(&job, &evictor, 3);
	bench_evictor_release(&evictor);
	/* nanosleep() never returns early; a busy machine may delay it a lot. */
	assert_true(time.warm_ns >= 1e5 && time.warm_ns < 1e8);
	assert_true(time.cold_ns >= 1e5 && time.cold_ns < 1e8);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_makes_the_same_mesh_every_time),
		cmocka_unit_test(test_meshes_have_the_influences_asked_for),
		cmocka_unit_test(test_meshes_have_the_joint_sets_asked_for),
		cmocka_unit_test(
			test_rows_measure_the_meshes_that_their_names_say),
		cmocka_unit_test(test_every_kernel_runs_every_job_or_refuses_it),
		cmocka_unit_test(test_refuses_an_unknown_kernel),
		cmocka_unit_test(test_times_a_vertex),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
