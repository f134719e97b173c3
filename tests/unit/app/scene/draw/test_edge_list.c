/* The lines that edge_list_draw() draws of lists of triangles. */
#include "app/scene/draw/edge_list.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 40,
	TRIANGLES = 2000,
	LINES_MAX = 65536
};

static struct {
	int calls, count;
	uint16_t line[LINES_MAX][2];
} drawn;

static void draw_elements(
	GLenum mode, GLsizei count, GLenum type, const void *index)
{
	assert_int_equal(mode, GL_LINES);
	assert_int_equal(type, GL_UNSIGNED_SHORT);
	assert_true(count > 0 && count % 2 == 0);
	assert_true(drawn.count + count / 2 <= LINES_MAX);
	memcpy(drawn.line[drawn.count], index, (size_t)count * sizeof(uint16_t));
	drawn.count += count / 2;
	drawn.calls++;
}

static void draw(const uint16_t *index, int count)
{
	const struct gl gl = {.DrawElements = draw_elements};

	drawn.calls = drawn.count = 0;
	edge_list_draw(&gl, index, count);
}

static void check(const uint16_t *index, int count, const uint16_t (*wanted)[2],
	int lines)
{
	draw(index, count);
	assert_int_equal(drawn.count, lines);
	assert_memory_equal(drawn.line, wanted, (size_t)lines * sizeof(*wanted));
	assert_int_equal(drawn.calls, lines > 0);
}

static void test_few_triangles(void **state)
{
	static const uint16_t triangle[] = {7, 5, 9}, flat[] = {3, 3, 8};
	static const uint16_t quad[] = {0, 1, 2, 2, 1, 3};
	static const uint16_t point[] = {4, 4, 4};

	(void)state;
	check(triangle, 3, (const uint16_t[][2]){{7, 5}, {5, 9}, {9, 7}}, 3);
	/* One edge is a call, too, and no edge is none. */
	check(flat, 3, (const uint16_t[][2]){{3, 8}}, 1);
	check(point, 3, NULL, 0);
	check(triangle, 2, NULL, 0);
	check(triangle, 0, NULL, 0);
	/* The edge of both is drawn once. */
	check(quad, 6,
		(const uint16_t[][2]){{0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 2}},
		5);
	/* What is left of a list is no triangle. */
	check(quad, 5, (const uint16_t[][2]){{0, 1}, {1, 2}, {2, 0}}, 3);
}

static void test_all_edges_of_many_triangles_are_drawn(void **state)
{
	static uint16_t index[3 * TRIANGLES];
	static bool wanted[VERTICES][VERTICES], found[VERTICES][VERTICES];
	uint32_t seed = 5;

	(void)state;
	for (int i = 0; i < 3 * TRIANGLES; i++) {
		index[i] = (uint16_t)random_between(&seed, 0, VERTICES - 1);
	}
	for (int i = 0; i < 3 * TRIANGLES; i++) {
		int from = index[i];
		int to = index[i % 3 == 2 ? i - 2 : i + 1];

		wanted[from][to] = wanted[to][from] = from != to;
	}
	draw(index, 3 * TRIANGLES);
	for (int i = 0; i < drawn.count; i++) {
		const uint16_t *line = drawn.line[i];

		assert_true(line[0] != line[1]);
		found[line[0]][line[1]] = found[line[1]][line[0]] = true;
	}
	assert_memory_equal(found, wanted, sizeof(found));
	/* Of 6000 edges, few of the 780 kinds are drawn twice. */
	assert_true(drawn.count < 2000);
}

static void test_long_lists_take_several_calls(void **state)
{
	static uint16_t index[3 * TRIANGLES];

	(void)state;
	for (int i = 0; i < 3 * TRIANGLES; i++) {
		index[i] = (uint16_t)i;
	}
	draw(index, 3 * TRIANGLES);
	assert_int_equal(drawn.count, 3 * TRIANGLES);
	for (int i = 0; i < 3 * TRIANGLES; i++) {
		assert_int_equal(drawn.line[i][0], i);
		assert_int_equal(drawn.line[i][1], i % 3 == 2 ? i - 2 : i + 1);
	}
	/* 256 triangles fill a call; a full call at the end is the last. */
	assert_int_equal(drawn.calls, (TRIANGLES + 255) / 256);
	draw(index, 3 * 512);
	assert_int_equal(drawn.calls, 2);
}

static void test_without_a_list_vertices_follow_each_other(void **state)
{
	(void)state;
	check(NULL, 6,
		(const uint16_t[][2]){
			{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}},
		6);
	/* 16 bits number the vertices of 21845 triangles. */
	draw(NULL, 65535);
	assert_int_equal(drawn.count, 65535);
	draw(NULL, 65538);
	assert_int_equal(drawn.count, 65535);
	draw(NULL, 3000000);
	assert_int_equal(drawn.count, 65535);
	assert_int_equal(drawn.line[65534][0], 65534);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_few_triangles),
		cmocka_unit_test(test_all_edges_of_many_triangles_are_drawn),
		cmocka_unit_test(test_long_lists_take_several_calls),
		cmocka_unit_test(test_without_a_list_vertices_follow_each_other),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
