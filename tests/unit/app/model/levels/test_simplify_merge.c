/* Which vertices of a position become one, against a plain search. */
#include "app/model/levels/simplify_merge.h"

#include "app/model/levels/simplify_mesh.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDES_MAX = 70,
	VERTICES = 2 * SIDES_MAX,
	CASES = 400
};

/*
 * Triangles around the position of the vertices 0 to sides - 1. Those at its
 * rim follow; the rim is closed, and its vertices are shared.
 */
struct fan {
	int sides;
	float position[VERTICES][3], normal[VERTICES][3];
	uint8_t color[VERTICES][4];
	uint32_t index[3 * SIDES_MAX];
	bool shared[VERTICES];
	struct model_primitive primitive;
	struct simplify simplify;
};

/* The corner of a triangle that is at the middle. */
static int middle_of(int triangle)
{
	return 3 * triangle + triangle % 3;
}

/* A fan of a rim of radius 1, more or less, and normals that point up. */
static void fill(struct fan *fan, int sides)
{
	memset(fan, 0, sizeof(*fan));
	fan->sides = sides;
	for (int i = 0; i < sides; i++) {
		double turn = 6.283185307 * i / sides;
		float *rim = fan->position[sides + i];
		int at = middle_of(i), next = 3 * i;

		rim[0] = (float)cos(turn);
		rim[1] = (float)sin(turn);
		fan->normal[i][2] = fan->normal[sides + i][2] = 1.0f;
		fan->index[at] = (uint32_t)i;
		fan->index[next + (at + 1) % 3] = (uint32_t)(sides + i);
		fan->index[next + (at + 2) % 3] =
			(uint32_t)(sides + (i + 1) % sides);
	}
	fan->primitive = (struct model_primitive){.vertex_count = 2 * sides,
		.position = fan->position,
		.normal = fan->normal,
		.color = fan->color};
}

static void begin(struct fan *fan)
{
	const struct simplify_input input = {
		.primitive = &fan->primitive,
		.index = fan->index,
		.index_count = 3 * fan->sides,
		.extent = 2.0f,
		.shared = fan->shared,
	};

	assert_int_equal(simplify_begin(&fan->simplify, &input, NULL), 0);
	assert_int_equal(fan->simplify.index_count, input.index_count);
	fan->simplify.divided = true;
	memset(fan->simplify.known, SIMPLIFY_BEST,
		(size_t)fan->primitive.vertex_count);
}

/* The side of a square as large as the largest triangle, in extents. */
static double size_of(const struct fan *fan)
{
	double most = 0;

	for (int t = 0; t < 3 * fan->sides; t += 3) {
		double u[3], v[3], square = 0;

		for (int i = 0; i < 3; i++) {
			const uint32_t *at = fan->index + t;
			double from = (double)fan->position[at[0]][i];

			u[i] = ((double)fan->position[at[1]][i] - from) / 2;
			v[i] = ((double)fan->position[at[2]][i] - from) / 2;
		}
		for (int i = 0; i < 3; i++) {
			int j = (i + 1) % 3;

			square += pow(u[i] * v[j] - u[j] * v[i], 2);
		}
		most = fmax(most, sqrt(square) / 2);
	}
	return sqrt(most);
}

static bool are_near(const struct fan *fan, double limit, uint32_t a, uint32_t b)
{
	double normal = 0, color = 0, factor = 3 * size_of(fan);

	for (int i = 0; i < 3; i++) {
		normal += pow(
			(double)fan->normal[a][i] - (double)fan->normal[b][i],
			2);
		color += pow((fan->color[a][i] - fan->color[b][i]) / 255.0, 2);
	}
	return normal <= 0.25 &&
		normal * (factor * factor + 0.009 * 0.009) +
			0.05 * 0.05 * color <=
		limit * limit;
}

/* Those of a list that are near one of it, and how many there are. */
static int find_near(const struct fan *fan, double limit, const uint32_t *list,
	int count, int own, bool near[SIDES_MAX])
{
	int found = 0;

	for (int i = 0; i < count; i++) {
		near[i] = i == own || are_near(fan, limit, list[own], list[i]);
		found += near[i];
	}
	return found;
}

/* The near one whose normal is farthest along the sum of theirs. */
static int find_mean(const struct fan *fan, const uint32_t *list, int count,
	const bool near[SIDES_MAX])
{
	double sum[3] = {0, 0, 0}, most = 0;
	int found = -1;

	for (int i = 0; i < count; i++) {
		for (int axis = 0; near[i] && axis < 3; axis++) {
			sum[axis] += (double)fan->normal[list[i]][axis];
		}
	}
	for (int i = 0; i < count; i++) {
		const float *n = fan->normal[list[i]];
		double along = (double)n[0] * sum[0] + (double)n[1] * sum[1] +
			(double)n[2] * sum[2];

		if (near[i] && (found < 0 || along > most)) {
			found = i;
			most = along;
		}
	}
	return found;
}

/* Sets what each vertex becomes. Returns whether any becomes another one. */
static bool expect(const struct fan *fan, double limit, uint32_t becomes[])
{
	uint32_t list[SIDES_MAX];
	bool near[SIDES_MAX], any = false;
	int count = 0, most;

	for (int t = 0; t < fan->sides; t++) {
		uint32_t vertex = fan->index[middle_of(t)];
		bool known = false;

		for (int i = 0; i < count; i++) {
			known = known || list[i] == vertex;
		}
		list[count] = vertex;
		count += !known;
		becomes[vertex] = vertex;
	}
	do {
		int best = 0, left = 0;

		most = 0;
		for (int i = 0; i < count; i++) {
			int found = find_near(fan, limit, list, count, i, near);

			best = found > most ? i : best;
			most = found > most ? found : most;
		}
		if (most < 2) {
			return any;
		}
		find_near(fan, limit, list, count, best, near);
		best = find_mean(fan, list, count, near);
		find_near(fan, limit, list, count, best, near);
		for (int i = 0; i < count; i++) {
			any = any || (near[i] && i != best);
			becomes[list[i]] = list[near[i] ? best : i];
		}
		for (int i = 0; i < count; i++) {
			if (!near[i]) {
				list[left++] = list[i];
			}
		}
		count = left;
	} while (count > 0);
	return any;
}

static void check(struct fan *fan, float limit)
{
	const struct simplify *simplify = &fan->simplify;
	uint32_t becomes[SIDES_MAX];
	bool any = expect(fan, (double)limit, becomes);

	begin(fan);
	simplify_merge(&fan->simplify, limit);
	for (int i = 0; i < 3 * fan->sides; i++) {
		uint32_t vertex = fan->index[i];

		assert_int_equal(simplify->index[i],
			i == middle_of(i / 3) ? becomes[vertex] : vertex);
	}
	assert_int_equal(
		simplify->known[0], any ? SIMPLIFY_NOTHING : SIMPLIFY_BEST);
	for (int i = fan->sides; i < 2 * fan->sides; i++) {
		assert_int_equal(simplify->known[i], simplify->known[0]);
	}
	simplify_end(&fan->simplify);
}

static float random_part(uint32_t *seed, float most)
{
	return most * (float)random_within(seed, 10000) / 10000.0f;
}

/* Some triangles share a vertex, and some have a colour of their own. */
static void draw_case(struct fan *fan, uint32_t *seed)
{
	float spread = 0.1f * (float)random_between(seed, 1, 6);

	fill(fan, random_between(seed, 3, 8));
	for (int v = 0; v < 2 * fan->sides; v++) {
		for (int i = 0; i < 3; i++) {
			fan->normal[v][i] += random_part(seed, spread);
			if (v >= fan->sides) {
				fan->position[v][i] += random_part(seed, 0.2f);
			}
		}
		if (random_one_in(seed, 3)) {
			fan->color[v][random_between(seed, 0, 3)] =
				(uint8_t)random_between(seed, 0, 255);
		}
	}
	for (int t = 1; t < fan->sides; t++) {
		if (random_one_in(seed, 4)) {
			fan->index[middle_of(t)] = fan->index[middle_of(t - 1)];
		}
	}
}

static void test_the_most_become_the_one_in_their_middle(void **state)
{
	static struct fan fan;
	uint32_t seed = 7;

	(void)state;
	for (int i = 0; i < RANDOM_CASES(CASES); i++) {
		draw_case(&fan, &seed);
		check(&fan, 0.0001f * (float)random_between(&seed, 100, 5000));
		check(&fan, 10.0f);
	}
}

/* The error that is allowed counts, and not the next smaller one. */
static void test_an_error_of_the_limit_is_allowed(void **state)
{
	static struct fan fan;

	(void)state;
	fill(&fan, 4);
	fan.color[1][0] = 1;
	begin(&fan);
	simplify_merge(&fan.simplify, 0.0f);
	assert_int_equal(fan.simplify.index[middle_of(0)], 0);
	assert_int_equal(fan.simplify.index[middle_of(1)], 1);
	assert_int_equal(fan.simplify.index[middle_of(2)], 0);
	assert_int_equal(fan.simplify.index[middle_of(3)], 0);
	simplify_end(&fan.simplify);
}

/* Normals that differ by exactly a half may be one, and no others. */
static void test_edges_of_a_half_are_the_sharpest_to_be_merged(void **state)
{
	static struct fan fan;

	(void)state;
	fill(&fan, 3);
	fan.normal[1][0] = 0.5f;
	fan.normal[2][1] = 0.5078125f;
	begin(&fan);
	simplify_merge(&fan.simplify, 100.0f);
	assert_int_equal(fan.simplify.index[middle_of(0)],
		fan.simplify.index[middle_of(1)]);
	assert_int_equal(fan.simplify.index[middle_of(2)], 2);
	simplify_end(&fan.simplify);
}

static void test_only_divided_lists_are_merged(void **state)
{
	static struct fan fan;

	(void)state;
	fill(&fan, 4);
	begin(&fan);
	fan.simplify.divided = false;
	simplify_merge(&fan.simplify, 1.0f);
	assert_memory_equal(
		fan.simplify.index, fan.index, 12 * sizeof(uint32_t));
	simplify_end(&fan.simplify);
}

static void test_a_position_of_64_triangles_is_the_largest_merged(void **state)
{
	static struct fan fan;

	(void)state;
	for (int sides = 64; sides < 66; sides++) {
		fill(&fan, sides);
		begin(&fan);
		simplify_merge(&fan.simplify, 1.0f);
		for (int t = 0; t < sides; t++) {
			assert_int_equal(fan.simplify.index[middle_of(t)],
				sides == 64 ? 0 : t);
		}
		simplify_end(&fan.simplify);
	}
}

/* Three positions have two vertices each, or one of them a third one. */
static void test_a_third_vertex_of_one_position_divides(void **state)
{
	static struct fan fan;

	(void)state;
	for (int more = 0; more < 2; more++) {
		fill(&fan, 5);
		/* All triangles are at the positions of the first one. */
		for (int i = 0; i < 5; i++) {
			const uint32_t own = i < 2 ? (uint32_t)i : 0;
			const uint32_t corner[3] = {
				i == 2 && more ? 4 : own, 5 + own, 7 + own};

			for (int j = 0; j < 3; j++) {
				fan.index[middle_of(i) / 3 * 3 +
					(middle_of(i) + j) % 3] = corner[j];
			}
		}
		memcpy(fan.position[6], fan.position[5], sizeof(float[3]));
		memcpy(fan.position[8], fan.position[7], sizeof(float[3]));
		begin(&fan);
		assert_int_equal(
			simplify_merge_is_wanted(&fan.simplify), more == 1);
		simplify_end(&fan.simplify);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_most_become_the_one_in_their_middle),
		cmocka_unit_test(test_an_error_of_the_limit_is_allowed),
		cmocka_unit_test(
			test_edges_of_a_half_are_the_sharpest_to_be_merged),
		cmocka_unit_test(test_only_divided_lists_are_merged),
		cmocka_unit_test(
			test_a_position_of_64_triangles_is_the_largest_merged),
		cmocka_unit_test(test_a_third_vertex_of_one_position_divides),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
