/* The order of triangles, beside a plain form of the paper's algorithm. */
#include "app/compare/optimize/optimize_tipsify.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	CACHE = 16,
	CORNERS_MAX = 1200,
	VERTICES_MAX = 300
};

/* A first-in, first-out cache of 16 vertices. */
static int count_misses(const uint32_t *index, int count)
{
	uint32_t queue[CORNERS_MAX];
	int fetched = 0;

	for (int i = 0; i < count; i++) {
		bool held = false;

		for (int q = fetched > CACHE ? fetched - CACHE : 0; q < fetched;
			q++) {
			held = held || queue[q] == index[i];
		}
		if (!held) {
			queue[fetched++] = index[i];
		}
	}
	return fetched;
}

/*
 * Sander, Nehab, Barczak: Fast Triangle Reordering for Vertex Locality and
 * Reduced Overdraw (2007), figure 2, with the first corner's vertex first.
 */
struct paper {
	const uint32_t *index;
	int count;
	int live[VERTICES_MAX], stamp[VERTICES_MAX];
	bool emitted[CORNERS_MAX / 3];
	uint32_t out[CORNERS_MAX]; /* the dead-end stack is pushed alike */
	uint32_t dead[CORNERS_MAX];
	int out_count, dead_count, time, cursor;
};

static int next_vertex(struct paper *p, int first_candidate)
{
	int best = -1, most = -1;

	for (int i = first_candidate; i < p->out_count; i++) {
		int v = (int)p->out[i], age = p->time - p->stamp[v];
		int priority = age + 2 * p->live[v] <= CACHE ? age : 0;

		if (p->live[v] > 0 && priority > most) {
			best = v;
			most = priority;
		}
	}
	while (best < 0 && p->dead_count > 0) {
		int v = (int)p->dead[--p->dead_count];

		best = p->live[v] > 0 ? v : -1;
	}
	for (; best < 0 && p->cursor < VERTICES_MAX; p->cursor++) {
		best = p->live[p->cursor] > 0 ? p->cursor : -1;
	}
	return best;
}

static void emit(struct paper *p, int triangle)
{
	p->emitted[triangle] = true;
	for (int i = 3 * triangle; i < 3 * triangle + 3; i++) {
		int v = (int)p->index[i];

		p->out[p->out_count++] = (uint32_t)v;
		p->dead[p->dead_count++] = (uint32_t)v;
		p->live[v]--;
		if (p->time - p->stamp[v] > CACHE) {
			p->stamp[v] = p->time++;
		}
	}
}

static void order_like_the_paper(uint32_t *index, int count)
{
	static struct paper p;
	int fan = count > 0 ? (int)index[0] : -1;

	p = (struct paper){.index = index, .count = count, .time = CACHE + 1};
	for (int i = 0; i < count; i++) {
		p.live[index[i]]++;
	}
	while (fan >= 0) {
		int begin = p.out_count;

		for (int i = 0; i < count; i++) {
			if ((int)index[i] == fan && !p.emitted[i / 3]) {
				emit(&p, i / 3);
			}
		}
		fan = next_vertex(&p, begin);
	}
	assert_int_equal(p.out_count, count);
	memcpy(index, p.out, (size_t)count * sizeof(*index));
}

/* Passes follow while each saves more than a fiftieth. */
static void order(uint32_t *index, int count)
{
	while (count > 0) {
		uint32_t next[CORNERS_MAX];

		memcpy(next, index, (size_t)count * sizeof(*index));
		order_like_the_paper(next, count);
		if (count_misses(next, count) * 50 >=
			count_misses(index, count) * 49) {
			return;
		}
		memcpy(index, next, (size_t)count * sizeof(*index));
	}
}

static void expect_order(const uint32_t *index, int count, int vertices)
{
	uint32_t found[CORNERS_MAX], wanted[CORNERS_MAX];

	memcpy(found, index, (size_t)count * sizeof(*index));
	memcpy(wanted, index, (size_t)count * sizeof(*index));
	order(wanted, count);
	assert_int_equal(optimize_tipsify(found, count, vertices), 0);
	for (int i = 0; i < count; i++) {
		assert_int_equal(found[i], wanted[i]);
	}
	assert_int_equal(optimize_tipsify_misses(index, count, vertices),
		count_misses(index, count));
	assert_int_equal(optimize_tipsify_misses(found, count, vertices),
		count_misses(wanted, count));
}

/* A grid whose quads follow each other in steps; returns the corners. */
static int make_grid(uint32_t *out, int side, int step, uint32_t first)
{
	uint32_t row = (uint32_t)side + 1;
	int quads = side * side, count = 0;

	for (int q = 0; q < quads; q++) {
		int at = q * step % quads;
		uint32_t v = first + (uint32_t)(at / side) * row +
			(uint32_t)(at % side);
		const uint32_t corner[6] = {
			v, v + 1, v + row, v + 1, v + row + 1, v + row};

		memcpy(out + count, corner, sizeof(corner));
		count += 6;
	}
	return count;
}

static void test_grids_are_ordered_as_in_the_paper(void **state)
{
	static const int steps[] = {1, 3, 7, 11, 17, 43};
	uint32_t index[CORNERS_MAX];

	(void)state;
	for (int side = 2; side <= 13; side++) {
		for (int s = 0; s < 6; s++) {
			int count = make_grid(index, side, steps[s], 0);

			expect_order(index, count, (side + 1) * (side + 1));
		}
	}
}

/* The second begins where no triangle of the first leads to. */
static void test_separate_surfaces_are_all_written(void **state)
{
	uint32_t index[CORNERS_MAX];
	int count;

	(void)state;
	for (int step = 5; step < 14; step += 2) {
		count = make_grid(index, 6, step, 100);
		count += make_grid(index + count, 8, step, 10);
		expect_order(index, count, 160);
	}
}

/* A triangle that touches no other one is found by its vertices' numbers. */
static void test_triangles_apart_from_each_other_are_all_written(void **state)
{
	uint32_t index[30];

	(void)state;
	for (int step = 1; step < 10; step++) {
		for (int i = 0; i < 30; i++) {
			index[i] = (uint32_t)(3 + i / 3 * 3 * step % 30 + i % 3);
		}
		expect_order(index, step % 2 && step % 5 ? 30 : 3, 40);
	}
}

/* Any list, also with triangles that have a vertex twice. */
static void test_lists_without_any_order_are_ordered_as_in_the_paper(
	void **state)
{
	uint32_t random = 7;

	(void)state;
	for (int i = 0; i < 300; i++) {
		uint32_t index[180];
		int vertices = 1 + i % 60, count = 3 + 3 * (i * 7 % 60);

		for (int k = 0; k < count; k++) {
			random = random * 1664525u + 1013904223u;
			index[k] = (random >> 8) % (uint32_t)vertices;
		}
		expect_order(index, count, vertices);
	}
}

static void test_a_vertex_leaves_the_cache_after_16_others(void **state)
{
	uint32_t index[21];

	(void)state;
	for (int others = 14; others < 18; others++) {
		int count = 0;

		for (int i = 0; i <= others; i++) {
			index[count++] = (uint32_t)i;
		}
		index[count++] = 0;
		assert_int_equal(optimize_tipsify_misses(index, count, 20),
			others < 16 ? others + 1 : others + 2);
	}
	assert_int_equal(optimize_tipsify_misses(index, 0, 20), 0);
	assert_int_equal(optimize_tipsify(index, 0, 0), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_grids_are_ordered_as_in_the_paper),
		cmocka_unit_test(test_separate_surfaces_are_all_written),
		cmocka_unit_test(
			test_triangles_apart_from_each_other_are_all_written),
		cmocka_unit_test(
			test_lists_without_any_order_are_ordered_as_in_the_paper),
		cmocka_unit_test(test_a_vertex_leaves_the_cache_after_16_others),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
