/* Which vertices of a position become one, against a plain search. */
#include "app/model/levels/simplify_merge.h"

#include "app/model/levels/simplify_mesh.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	FANS = 2,
	SIDES_MAX = 66,
	VERTICES = FANS * 2 * SIDES_MAX,
	CASES = 400
};

/*
 * Two fans: triangles around a middle, with a closed rim. The vertices of both
 * take turns: those of the middle's position first, one a triangle, and then
 * those of the rim, which triangles share.
 */
struct fan {
	int sides;
	float position[VERTICES][3], normal[VERTICES][3];
	uint8_t color[VERTICES][4];
	uint32_t index[FANS * 3 * SIDES_MAX];
	bool shared[VERTICES];
	struct model_primitive primitive;
	struct simplify simplify;
};

static uint32_t number(int which, int vertex)
{
	return (uint32_t)(FANS * vertex + which);
}

/* The corner of a triangle that is at the middle. */
static int middle_of(int triangle)
{
	return 3 * triangle + triangle % 3;
}

static void list_triangle(struct fan *fan, int which, int i)
{
	int sides = fan->sides, triangle = which * sides + i;
	uint32_t *at = fan->index + 3 * triangle;

	at[triangle % 3] = number(which, i);
	at[(triangle + 1) % 3] = number(which, sides + i);
	at[(triangle + 2) % 3] = number(which, sides + (i + 1) % sides);
}

/* Rims have a radius of 1, or of 4, and normals point up. */
static void fill(struct fan *fan, int sides)
{
	memset(fan, 0, sizeof(*fan));
	fan->sides = sides;
	for (int i = 0; i < FANS * sides; i++) {
		int which = i / sides, side = i % sides;
		double turn = 6.283185307 * side / sides;
		float *rim = fan->position[number(which, sides + side)];

		rim[0] = (float)(cos(turn) * (which == 0 ? 1 : 4));
		rim[1] = (float)(sin(turn) * (which == 0 ? 1 : 4));
		list_triangle(fan, which, side);
	}
	for (int v = 0; v < FANS * 2 * sides; v++) {
		fan->position[v][2] = v % FANS == 0 ? 0.0f : 9.0f;
		fan->normal[v][2] = 1.0f;
	}
	fan->primitive =
		(struct model_primitive){.vertex_count = FANS * 2 * sides,
			.position = fan->position,
			.normal = fan->normal,
			.color = fan->color};
}

static void begin(struct fan *fan)
{
	const struct simplify_input input = {
		.primitive = &fan->primitive,
		.index = fan->index,
		.index_count = FANS * 3 * fan->sides,
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
static double size_of(const struct fan *fan, int which)
{
	double most = 0;

	for (int t = 0; t < fan->sides; t++) {
		const uint32_t *at = fan->index + 3 * (which * fan->sides + t);
		double u[3], v[3], square = 0;

		for (int i = 0; i < 3; i++) {
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
	double normal = 0, color = 0, factor = 3 * size_of(fan, (int)(a % FANS));

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
static bool expect(
	const struct fan *fan, int which, double limit, uint32_t becomes[])
{
	uint32_t list[SIDES_MAX];
	bool near[SIDES_MAX], any = false;
	int count = 0, most;

	for (int t = 0; t < fan->sides; t++) {
		uint32_t vertex = fan->index[middle_of(which * fan->sides + t)];
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
	int sides = fan->sides;

	begin(fan);
	simplify_merge(&fan->simplify, limit);
	for (int which = 0; which < FANS; which++) {
		uint32_t becomes[VERTICES];
		bool any = expect(fan, which, (double)limit, becomes);

		for (int i = 0; i < 3 * sides; i++) {
			int at = which * 3 * sides + i;
			uint32_t vertex = fan->index[at];

			assert_int_equal(simplify->index[at],
				at == middle_of(at / 3) ? becomes[vertex]
							: vertex);
		}
		for (int i = 0; i < 2 * sides; i++) {
			assert_int_equal(simplify->known[number(which, i)],
				any && (i == 0 || i >= sides) ? SIMPLIFY_NOTHING
							      : SIMPLIFY_BEST);
		}
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
	int turn = random_between(seed, 0, 2),
	    sides = random_between(seed, 3, 8);

	fill(fan, sides);
	for (int v = 0; v < FANS * 2 * sides; v++) {
		float *p = fan->position[v], from[3];

		memcpy(from, p, sizeof(from));
		for (int i = 0; i < 3; i++) {
			fan->normal[v][i] += random_part(seed, spread);
			p[(i + turn) % 3] = from[i] +
				(v < FANS * sides ? 0.3f
						  : random_part(seed, 0.4f));
		}
		if (random_one_in(seed, 3)) {
			fan->color[v][random_between(seed, 0, 3)] =
				(uint8_t)random_between(seed, 0, 255);
		}
	}
	for (int t = 1; t < FANS * sides; t++) {
		if (t != sides && random_one_in(seed, 4)) {
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

static void test_an_error_of_the_limit_is_allowed(void **state)
{
	static struct fan fan;

	(void)state;
	fill(&fan, 4);
	fan.color[number(0, 1)][0] = 1;
	begin(&fan);
	simplify_merge(&fan.simplify, 0.0f);
	for (int t = 0; t < 4; t++) {
		assert_int_equal(fan.simplify.index[middle_of(t)],
			number(0, t == 1 ? 1 : 0));
	}
	simplify_end(&fan.simplify);
}

static void test_normals_that_differ_by_half_are_the_last_merged(void **state)
{
	static struct fan fan;

	(void)state;
	fill(&fan, 3);
	fan.normal[number(0, 1)][0] = 0.5f;
	fan.normal[number(0, 2)][1] = 0.5078125f;
	begin(&fan);
	simplify_merge(&fan.simplify, 100.0f);
	assert_int_equal(fan.simplify.index[middle_of(0)],
		fan.simplify.index[middle_of(1)]);
	assert_int_equal(fan.simplify.index[middle_of(2)], number(0, 2));
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
		fan.simplify.index, fan.index, 24 * sizeof(uint32_t));
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
				number(0, sides == 64 ? 0 : t));
		}
		simplify_end(&fan.simplify);
	}
}

static bool is_divided(const struct fan *fan, int index_count)
{
	const struct simplify_input input = {
		.primitive = &fan->primitive,
		.index = fan->index,
		.index_count = index_count,
		.extent = 2.0f,
		.shared = fan->shared,
	};
	struct simplify simplify;
	bool divided;

	assert_int_equal(simplify_begin(&simplify, &input, NULL), 0);
	assert_int_equal(simplify.index_count, index_count);
	divided = simplify.divided;
	simplify_end(&simplify);
	return divided;
}

/*
 * An open fan whose triangles have vertices of their own: 12 at 6 positions, or
 * 15 at 7, or 14 if two triangles share one. Vertices without triangles do not
 * count.
 */
static void test_more_than_two_vertices_a_position_are_divided(void **state)
{
	static struct fan fan;

	(void)state;
	for (int test = 0; test < 3; test++) {
		uint32_t count = test == 0 ? 12 : 15;

		fill(&fan, 6);
		for (uint32_t i = 0; i < count; i++) {
			float *p = fan.position[i];

			fan.index[i] = i;
			p[0] = i % 3 == 0 ? 0.0f : 1.0f;
			p[1] = i % 3 == 0 ? 0.0f : (float)(i / 3 + i % 3);
			p[2] = 0.0f;
		}
		fan.index[3] = test == 2 ? 0 : 3;
		assert_int_equal(is_divided(&fan, (int)count), test == 1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_most_become_the_one_in_their_middle),
		cmocka_unit_test(test_an_error_of_the_limit_is_allowed),
		cmocka_unit_test(
			test_normals_that_differ_by_half_are_the_last_merged),
		cmocka_unit_test(test_only_divided_lists_are_merged),
		cmocka_unit_test(
			test_a_position_of_64_triangles_is_the_largest_merged),
		cmocka_unit_test(
			test_more_than_two_vertices_a_position_are_divided),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
