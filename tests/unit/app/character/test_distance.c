/* The distance of two segments: against the least of many pairs of points. */
#include "app/character/parts/distance.h"
#include "platform/base/compiler.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	STEPS = 64, /* points of a segment */
	TRIALS = 300
};

struct segment {
	float end[2][3];
};

static struct segment random_segment(uint32_t *seed)
{
	struct segment segment;

	for (int i = 0; i < 6; i++) {
		segment.end[i / 3][i % 3] =
			(float)random_between(seed, -100, 100) / 100.0f;
	}
	return segment;
}

static float distance(const struct segment *a, const struct segment *b)
{
	return character_line_distance(
		a->end[0], a->end[1], b->end[0], b->end[1]);
}

/* The squared distance of the points that divide the segments at s and t. */
static float square_at(
	const struct segment *a, const struct segment *b, float s, float t)
{
	float sum = 0.0f;

	for (int i = 0; i < 3; i++) {
		float d = a->end[0][i] + s * (a->end[1][i] - a->end[0][i]) -
			b->end[0][i] - t * (b->end[1][i] - b->end[0][i]);

		sum += d * d;
	}
	return sum;
}

static float least_distance(const struct segment *a, const struct segment *b)
{
	float least = INFINITY;

	for (int i = 0; i <= STEPS; i++) {
		for (int k = 0; k <= STEPS; k++) {
			least = fminf(least,
				square_at(a, b, (float)i / STEPS,
					(float)k / STEPS));
		}
	}
	return sqrtf(least);
}

/* Segments are up to 3.5 long: two points miss the nearest by half a step each. */
static void expect_distance(const struct segment *a, const struct segment *b)
{
	float found = distance(a, b), least = least_distance(a, b);

	assert_true(found <= least + 1e-5f);
	assert_true(found >= least - 3.5f / STEPS);
	assert_near(distance(b, a), found, 1e-5);
	/* Away from contact the distance changes by the square of a step. */
	if (least > 0.2f) {
		assert_near(found, least, 0.01);
	}
}

static void test_segments_of_all_kinds(void **state)
{
	uint32_t seed = 11;

	(void)state;
	for (int trial = 0; trial < TRIALS; trial++) {
		struct segment a = random_segment(&seed);
		struct segment b = random_segment(&seed);

		if (random_one_in(&seed, 4)) { /* parallel */
			for (int i = 0; i < 3; i++) {
				b.end[1][i] = b.end[0][i] +
					0.7f * (a.end[1][i] - a.end[0][i]);
			}
		}
		if (random_one_in(&seed, 8)) { /* a point */
			a.end[1][0] = a.end[0][0];
			a.end[1][1] = a.end[0][1];
			a.end[1][2] = a.end[0][2];
		}
		expect_distance(&a, &b);
	}
}

/* A power of two scales numbers without rounding. */
static void test_distances_scale_with_the_segments(void **state)
{
	static const float scales[] = {1.0f / 1024.0f, 1024.0f};
	uint32_t seed = 12;

	(void)state;
	for (int trial = 0; trial < 50; trial++) {
		struct segment a = random_segment(&seed);
		struct segment b = random_segment(&seed);
		double whole = (double)distance(&a, &b);

		for (size_t k = 0; k < ARRAY_COUNT(scales); k++) {
			struct segment one = a, other = b;
			float scale = scales[k];

			for (int i = 0; i < 6; i++) {
				one.end[i / 3][i % 3] *= scale;
				other.end[i / 3][i % 3] *= scale;
			}
			assert_near((double)(distance(&one, &other) / scale),
				whole, 1e-6);
		}
	}
}

static void test_points_at_rest_in_a_place(void **state)
{
	struct segment a = {{{0, 0, 0}, {0, 0, 0}}};
	struct segment b = {{{0, 3, 4}, {0, 3, 4}}};

	(void)state;
	assert_near(distance(&a, &b), 5.0, 1e-6);
	assert_near(distance(&a, &a), 0.0, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_segments_of_all_kinds),
		cmocka_unit_test(test_distances_scale_with_the_segments),
		cmocka_unit_test(test_points_at_rest_in_a_place),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
