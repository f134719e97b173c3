/*
 * Runs the loops of limber bench, for tests of what they compute: made-up loops
 * note where the results lie.
 */
#ifndef TESTS_UNIT_APP_CMD_BENCH_LOOPS_H
#define TESTS_UNIT_APP_CMD_BENCH_LOOPS_H

#include "app/cmd/bench/bench_job.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 61,
	INFLUENCES = 3,
	RESULTS = 3
};

/* The last run's results in order; the loops carry no context of the test. */
static struct {
	const void *result[RESULTS];
	int count;
	const struct bench_mesh *mesh;
} noted;

static inline void note(int count, const void *result)
{
	assert_int_equal(count, VERTICES);
	assert_true(noted.count < RESULTS);
	noted.result[noted.count++] = result;
}

static inline void mix(int count, const float (*source)[3],
	const float (*destiny)[3], float omega, float (*out)[3])
{
	for (int v = 0; v < count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			out[v][axis] = source[v][axis] +
				omega * (destiny[v][axis] - source[v][axis]);
		}
	}
}

struct loops {
	struct arena arena;
	struct bench_mesh mesh;
	void *state;
};

/* Runs one loop once; its results are in noted.result. */
static inline void run(struct loops *loops, const struct bench_loops *bench,
	const struct kernel *kernel, enum bench_work work)
{
	loops->arena = arena_empty();
	assert_int_equal(
		bench_mesh_make(&loops->mesh, VERTICES, INFLUENCES, 0), 0);
	loops->state = arena_alloc(&loops->arena, 1, bench->state_size);
	assert_non_null(loops->state);
	assert_int_equal(bench->prepare(loops->state, kernel, &loops->mesh,
				 work, &loops->arena),
		0);
	memset(&noted, 0, sizeof(noted));
	noted.mesh = &loops->mesh;
	bench->run[work](loops->state);
}

/* With ever more memory, a loop is refused until all of it is prepared. */
static inline void check_memory(const struct bench_loops *bench,
	const struct kernel *kernel, enum bench_work work)
{
	struct bench_mesh mesh;
	int error = -ENOMEM, refused = 0;

	/* Large arrays have blocks of their own. */
	assert_int_equal(
		bench_mesh_make(&mesh, 64 * VERTICES, INFLUENCES, 0), 0);
	for (size_t limit = 0; error == -ENOMEM; limit += 1 << 15) {
		struct memory_budget budget = {.limit_bytes = limit};
		struct arena arena = arena_within(&budget);
		void *state = calloc(1, bench->state_size);

		assert_non_null(state);
		error = bench->prepare(state, kernel, &mesh, work, &arena);
		refused += error == -ENOMEM;
		assert_true(error == 0 || budget.exceeded);
		assert_true(error != 0 || !budget.exceeded);
		free(state);
		arena_release(&arena);
	}
	assert_int_equal(error, 0);
	assert_true(refused > 1);
	bench_mesh_release(&mesh);
}

static inline void end(struct loops *loops)
{
	bench_mesh_release(&loops->mesh);
	arena_release(&loops->arena);
}

/* The results of the reference, and those of a step between two keys. */
static inline void expected(const struct bench_mesh *mesh, enum bench_work work,
	float (*out)[VERTICES][3])
{
	const struct model_primitive *primitive = &mesh->primitive;
	const float(*position)[3] = (const float(*)[3])primitive->position;
	const float(*normal)[3] = (const float(*)[3])primitive->normal;
	const float(*destiny)[3] = (const float(*)[3])mesh->destiny;
	const struct morph_term terms[] = {
		{.weight = 0.25f, .position = (const float(*)[3])mesh->delta[0]},
		{.weight = 0.5f, .position = (const float(*)[3])mesh->delta[1]}};
	struct arena arena = arena_empty();
	struct skin_stream stream;

	switch (work) {
	case BENCH_LERP:
	case BENCH_LERP_KEYS:
	case BENCH_LERP_NORMALS:
		mix(VERTICES, position, destiny, 0.3f, out[0]);
		mix(VERTICES, normal, (const float(*)[3])mesh->destiny_normal,
			0.3f, out[1]);
		break;
	case BENCH_BY_FRAMES:
		mix(VERTICES, position, destiny, 1.0f / 15.0f, out[0]);
		break;
	case BENCH_TARGETS:
		kernel_float.morph_targets(
			VERTICES, position, terms, 2, false, out[0]);
		break;
	default:
		assert_int_equal(
			skin_stream_init(&stream, primitive, 1.0f, &arena), 0);
		assert_int_equal(
			skin_stream_add_tangents(&stream, primitive, &arena), 0);
		kernel_float.skin(&stream, (const mat4 *)mesh->palette, 0,
			out[0], out[1]);
		kernel_float.skin_directions(&stream,
			(const float(*)[4])stream.tangent,
			(const mat4 *)mesh->palette, 0, out[2]);
		break;
	}
	arena_release(&arena);
}

/* How many arrays of vectors a loop computes. */
static inline int result_count(enum bench_work work)
{
	switch (work) {
	case BENCH_SKIN_TANGENTS:
		return 3;
	case BENCH_SKIN_NORMALS:
	case BENCH_LERP_NORMALS:
		return 2;
	default:
		return 1;
	}
}

#endif
