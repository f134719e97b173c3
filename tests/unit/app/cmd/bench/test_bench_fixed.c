/*
 * What the timed loops in fixed point compute: a made-up kernel passes each
 * call on to the loop in C.
 */
#include "app/anim/kernel/fixed.h"
#include "app/anim/kernel/layout/fixed_skin.h"
#include "tests/unit/app/cmd/bench/loops.h"

#include <math.h>

static void note_fixed_skin(const struct fixed_group *group, int group_count,
	const struct fixed_base *base, const struct fixed_matrix *palette,
	struct fixed_vector *out)
{
	fixed_loops_c.skin(group, group_count, base, palette, out);
	note(VERTICES, out);
}

static void note_fixed_lerp(int count, const struct fixed_pair (*pair)[3],
	struct fixed_weights weights, struct fixed_vector *out)
{
	fixed_loops_c.lerp(count, pair, weights, out);
	note(count, out);
}

static void note_lerp_keys(int count, const struct fixed_key *source,
	const struct fixed_key *destiny, struct fixed_weights weights,
	struct fixed_vector *out)
{
	fixed_loops_c.lerp_keys(count, source, destiny, weights, out);
	note(count, out);
}

static void note_increment(
	int count, const struct fixed_vector *step, struct fixed_vector *vector)
{
	fixed_loops_c.increment(count, step, vector);
	note(count, vector);
}

static void note_pair(int count, const struct fixed_vector *base,
	const struct fixed_pair (*pair)[3], struct fixed_weights weights,
	struct fixed_vector *out)
{
	fixed_loops_c.morph_pair(count, base, pair, weights, out);
	note(count, out);
}

/* The number of axis 0, 1 or 2. */
static double axis_of(const struct fixed_vector *vector, int axis)
{
	return axis == 0 ? vector->x : axis == 1 ? vector->y : vector->z;
}

/*
 * Fails unless the vectors are the wanted ones, times a scale, moved by an
 * offset. Returns the scale.
 */
static double check_placed(
	const struct fixed_vector *found, const float (*wanted)[3])
{
	double mean_f[3] = {0.0}, mean_w[3] = {0.0}, both = 0.0, square = 0.0;
	double scale, most = 0.0;

	for (int i = 0; i < VERTICES * 3; i++) {
		mean_f[i % 3] += axis_of(&found[i / 3], i % 3) / VERTICES;
		mean_w[i % 3] += (double)wanted[i / 3][i % 3] / VERTICES;
	}
	for (int i = 0; i < VERTICES * 3; i++) {
		double w = (double)wanted[i / 3][i % 3] - mean_w[i % 3];

		both += w * (axis_of(&found[i / 3], i % 3) - mean_f[i % 3]);
		square += w * w;
	}
	scale = both / square;
	for (int i = 0; i < VERTICES * 3; i++) {
		double w = (double)wanted[i / 3][i % 3] - mean_w[i % 3];
		double f = axis_of(&found[i / 3], i % 3) - mean_f[i % 3];

		most = fmax(most, fabs(f - scale * w));
	}
	/* Rounding moves a number of 14 bits by a few steps. */
	assert_true(scale > 100.0);
	assert_true(most < 8.0);
	return scale;
}

static void check_directions(
	const struct fixed_vector *found, const float (*wanted)[3])
{
	for (int v = 0; v < VERTICES; v++) {
		double dot = 0.0, f2 = 0.0, w2 = 0.0;

		for (int axis = 0; axis < 3; axis++) {
			double f = axis_of(&found[v], axis);
			double w = (double)wanted[v][axis];

			dot += f * w;
			f2 += f * f;
			w2 += w * w;
		}
		assert_true(dot > 0.999 * sqrt(f2 * w2));
	}
}

/* Puts vertices into the order of the skin in fixed point. */
static void sort(
	const struct model_primitive *primitive, float (*result)[VERTICES][3])
{
	struct arena arena = arena_empty();
	struct fixed_skin skin;
	float sorted[VERTICES][3];

	assert_int_equal(fixed_skin_init(&skin, primitive, 0, &arena), 0);
	for (int i = 0; i < RESULTS; i++) {
		for (int v = 0; v < VERTICES; v++) {
			memcpy(sorted[v], result[i][skin.order[v]],
				sizeof(sorted[v]));
		}
		memcpy(result[i], sorted, sizeof(sorted));
	}
	arena_release(&arena);
}

static void test_fixed_loops_compute_what_they_are_named_for(void **state)
{
	static const enum bench_work works[] = {BENCH_SKIN, BENCH_SKIN_NORMALS,
		BENCH_SKIN_TANGENTS, BENCH_LERP, BENCH_LERP_NORMALS,
		BENCH_LERP_KEYS, BENCH_TARGETS, BENCH_BY_FRAMES};
	struct fixed_loops fixed = fixed_loops_c;
	const struct kernel kernel = {.name = "noted", .fixed = &fixed};
	double scale = 0.0;

	(void)state;
	fixed.skin = note_fixed_skin;
	fixed.lerp = note_fixed_lerp;
	fixed.lerp_keys = note_lerp_keys;
	fixed.increment = note_increment;
	fixed.morph_pair = note_pair;
	for (size_t w = 0; w < ARRAY_COUNT(works); w++) {
		float wanted[RESULTS][VERTICES][3];
		struct loops loops;

		run(&loops, &bench_fixed_loops, &kernel, works[w]);
		assert_int_equal(noted.count, result_count(works[w]));
		expected(&loops.mesh, works[w], wanted);
		if (works[w] <= BENCH_SKIN_TANGENTS) {
			sort(&loops.mesh.primitive, wanted);
		}
		if (works[w] == BENCH_BY_FRAMES) {
			/* The first step is from 0, and so the step itself. */
			for (int i = 0; i < VERTICES * 3; i++) {
				wanted[0][i / 3][i % 3] -=
					loops.mesh.primitive.position[i / 3][i % 3];
			}
		}
		if (works[w] == BENCH_BY_FRAMES || works[w] == BENCH_LERP) {
			double found = check_placed(
				noted.result[0], (const float(*)[3])wanted[0]);

			scale = works[w] == BENCH_LERP ? found : scale;
			assert_near(found / scale, 1.0, 2e-3);
		} else {
			check_placed(
				noted.result[0], (const float(*)[3])wanted[0]);
		}
		for (int i = 1; i < noted.count; i++) {
			check_directions(
				noted.result[i], (const float(*)[3])wanted[i]);
		}
		end(&loops);
	}
}

static void test_loops_without_memory_are_refused(void **state)
{
	const struct kernel kernel = {.name = "c", .fixed = &fixed_loops_c};

	(void)state;
	for (int work = BENCH_SKIN; work < BENCH_WORKS; work++) {
		check_memory(&bench_fixed_loops, &kernel, (enum bench_work)work);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_fixed_loops_compute_what_they_are_named_for),
		cmocka_unit_test(test_loops_without_memory_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
