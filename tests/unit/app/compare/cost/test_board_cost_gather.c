/* What copying posed vertices for GL costs, and the lines that it reads. */
#include "app/compare/cost/board_cost.h"
#include "app/compare/cost/line_reads.h"
#include "platform/base/scalar.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 4096
};

static void expect_lines(
	const struct line_reads *reads, double cached, double missed)
{
	assert_near(reads->cached, cached, 0.0);
	assert_near(reads->missed, missed, 0.0);
}

static void read_all(struct line_reads *reads, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		line_reads_add(reads, 0, i, 8);
	}
}

static void test_a_line_is_read_once_while_a_cache_has_it(void **state)
{
	struct line_reads reads;

	(void)state;
	line_reads_begin(&reads);
	read_all(&reads, 1000);
	expect_lines(&reads, 0, 250);
	read_all(&reads, 1000);
	expect_lines(&reads, 0, 250);
	line_reads_add(&reads, 1, 0, 8);
	expect_lines(&reads, 0, 251);
}

/* 64 KiB fit the second-level cache alone; 1 MiB fits neither. */
static void test_lines_leave_caches_that_are_full(void **state)
{
	struct line_reads reads;
	double missed;

	(void)state;
	line_reads_begin(&reads);
	read_all(&reads, 8192);
	expect_lines(&reads, 0, 2048);
	read_all(&reads, 8192);
	assert_in_range((int)reads.cached, 1900, 2048);
	assert_in_range((int)reads.missed, 2048, 2148);
	missed = reads.missed;
	read_all(&reads, 131072);
	assert_true(reads.missed > missed + 29000.0);
}

/*
 * Ways of a full set whose lines give place, one after the other: the last two
 * bits of the numbers of a shift register that begins with 0xace1 and is fed
 * back by 0xb400, 0xe270, 0x7138, 0x389c, 0x1c4e, 0x0e27...
 */
static void test_a_full_set_loses_the_line_that_the_board_would_lose(
	void **state)
{
	static const int lost[] = {0, 0, 0, 2, 3, 3, 1, 0, 2, 1, 0};
	uint32_t way[LINE_READS_NEAR_WAYS];
	struct line_reads reads;

	(void)state;
	line_reads_begin(&reads);
	for (uint32_t i = 0; i < LINE_READS_NEAR_WAYS; i++) {
		way[i] = i;
		line_reads_add(&reads, 0, i * LINE_READS_NEAR_SETS, 32);
	}
	for (uint32_t i = 0; i < ARRAY_COUNT(lost); i++) {
		double sum;

		way[lost[i]] = LINE_READS_NEAR_WAYS + i;
		line_reads_add(
			&reads, 0, way[lost[i]] * LINE_READS_NEAR_SETS, 32);
		sum = reads.cached + reads.missed;
		for (int k = 0; k < LINE_READS_NEAR_WAYS; k++) {
			line_reads_add(
				&reads, 0, way[k] * LINE_READS_NEAR_SETS, 32);
		}
		assert_near(reads.cached + reads.missed, sum, 0.0);
	}
}

/* A batch of which all triangles have vertices of their own. */
struct bench {
	struct model_primitive primitive;
	uint32_t index[VERTICES], source[2 * VERTICES], corner[2 * VERTICES];
	uint16_t list[VERTICES];
	struct drawable_fixed fixed;
	struct batch_lod lod[2];
	struct batch batch[2]; /* the second one is not drawn */
	struct drawable drawable;
};

static void begin(struct bench *bench, uint32_t stride)
{
	*bench = (struct bench){.primitive = {.vertex_count = VERTICES,
					.index_count = VERTICES / 3 * 3,
					.index = bench->index}};
	for (uint32_t i = 0; i < VERTICES; i++) {
		bench->index[i] = i * stride % VERTICES;
		bench->list[i] = (uint16_t)(i % 600);
		bench->source[i] = bench->index[i];
		bench->source[VERTICES + i] = i;
		bench->corner[VERTICES + i] = i * stride % (VERTICES - 1);
	}
	bench->lod[0] = (struct batch_lod){.index = bench->list,
		.index_count = 600,
		.first_vertex = VERTICES,
		.vertex_count = 600,
		.flat = true};
	bench->lod[1] = (struct batch_lod){.index = bench->list,
		.index_count = 300,
		.first_vertex = VERTICES + 600,
		.vertex_count = 300};
	bench->batch[0] = (struct batch){.vertex_count = 900,
		.source = bench->source,
		.corner = bench->corner,
		.index = bench->list,
		.index_count = 900,
		.lod = bench->lod,
		.lod_count = 2};
	bench->batch[1] = bench->batch[0];
	bench->drawable = (struct drawable){.primitive = &bench->primitive,
		.batch_count = 1,
		.batch = bench->batch};
}

static double cycles_of_all(struct bench *bench)
{
	return board_cost_gather(&bench->drawable).cycles;
}

static double instructions_of(struct bench *bench)
{
	return board_cost_gather_drawn(&bench->drawable).instructions;
}

static void test_gathered_vertices_and_facets(void **state)
{
	static float normal[1][3];
	struct board_cost cost;
	struct bench bench;

	(void)state;
	begin(&bench, 1);
	cost = board_cost_gather(&bench.drawable);
	assert_near(cost.instructions, 900 * 10.1 + 300 * 84.0, 1e-6);
	/* 900 sources, 900 vectors that are copied and 600 that are read again,
	   of four a line, and 900 indices */
	assert_near(cost.cycles,
		900 * 14.8 + 300 * 101.6 + 78.0 * (113 + 225 + 150 + 57), 100.0);
	bench.primitive.normal = normal;
	cost = board_cost_gather(&bench.drawable);
	assert_near(cost.instructions, 900 * 10.1, 1e-6);
	assert_near(cost.cycles, 900 * 14.8 + 78.0 * (113 + 225 + 225), 100.0);
	bench.batch[0].source = NULL;
	cost = board_cost_gather(&bench.drawable);
	assert_true(cost.cycles == 0.0 && cost.instructions == 0.0);
}

/* Two facets of vertices that lie far apart, and four of those that do not. */
static void test_corners_of_facets_are_read(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, 0);
	for (uint16_t i = 0; i < 7; i++) {
		bench.list[i] = (uint16_t)(40 * i);
	}
	bench.batch[0].vertex_count = 6;
	bench.batch[0].index_count = 6;
	assert_near(cycles_of_all(&bench),
		6 * 14.8 + 2 * 101.6 + 78.0 * (1 + 1 + 1 + 6), 1e-6);
	bench.batch[0].index = NULL;
	bench.batch[0].vertex_count = 12;
	assert_near(cycles_of_all(&bench),
		12 * 14.8 + 4 * 101.6 + 78.0 * (2 + 1 + 3), 1e-6);
}

/* A level takes the vertices of its list, and of its shadow's if that is another. */
static void test_gathered_levels_and_their_shadows(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench, 1);
	bench.drawable.lod = bench.drawable.shadow_lod = 1;
	assert_near(instructions_of(&bench), 600 * 10.1 + 200 * 84.0, 1e-6);
	bench.drawable.shadow_lod = 2;
	assert_near(instructions_of(&bench), 900 * 10.1 + 200 * 84.0, 1e-6);
	bench.drawable.lod = 2;
	assert_near(instructions_of(&bench), 300 * (10.1 + 91.0), 1e-6);
	bench.drawable.lod = bench.drawable.shadow_lod = 0;
	assert_near(instructions_of(&bench), 900 * 10.1 + 300 * 84.0, 1e-6);
}

/* A shadow may be drawn from vertices that the surface takes, or from others. */
static void test_a_shadow_takes_vertices_of_its_own(void **state)
{
	const double full = 900 * 10.1 + 300 * 84.0;
	struct bench bench;

	(void)state;
	begin(&bench, 1);
	bench.drawable.shadow_lod = 2; /* beside all triangles */
	assert_near(instructions_of(&bench), full + 300 * 10.1, 1e-6);
	bench.lod[1].first_vertex = 1;
	assert_near(instructions_of(&bench), full + 300 * 10.1, 1e-6);
	bench.lod[1].first_vertex = 0;
	assert_near(instructions_of(&bench), full, 1e-6);
	bench.drawable.lod = 1;
	bench.drawable.shadow_lod = 0; /* all triangles beside a level */
	assert_near(instructions_of(&bench),
		600 * 10.1 + 200 * 84.0 + 900 * 10.1, 1e-6);
}

/* Lets a level have so many vertices, and all arrays point to element 0. */
static void begin_corners(struct bench *bench, int vertex_count)
{
	begin(bench, 0);
	memset(bench->corner, 0, sizeof(bench->corner));
	memset(bench->source, 0, sizeof(bench->source));
	bench->lod[1].first_vertex = 100;
	bench->lod[1].vertex_count = vertex_count;
	bench->drawable.lod = bench->drawable.shadow_lod = 2;
}

static double level_cycles(struct bench *bench)
{
	return board_cost_gather_drawn(&bench->drawable).cycles;
}

/*
 * The normal of a level's vertex is that of a triangle of the full list, whose
 * corner the vertex is. Its three positions may be anywhere.
 */
static void test_corners_of_a_level_read_their_triangles(void **state)
{
	static const uint32_t far_apart[2][3] = {
		{40, 2000, 2400}, {3000, 3400, 80}};
	static uint32_t order[VERTICES];
	struct bench bench;
	double before;

	(void)state;
	begin_corners(&bench, 2);
	for (int i = 0; i < 3; i++) {
		bench.index[300 + i] = far_apart[0][i];
		bench.index[600 + i] = far_apart[1][i];
	}
	bench.index[303] = 1000;
	bench.index[603] = 1500;
	for (uint32_t i = 0; i < 3; i++) {
		bench.corner[100] = 300 + i;
		bench.corner[101] = 600 + (i + 1) % 3;
		/* lines of the source, the copied position and the corners, two
		   of the index and six of the triangles' positions */
		assert_near(level_cycles(&bench),
			2 * (14.8 + 111.0) + 78.0 * (1 + 1 + 1 + 2 + 6), 1e-6);
	}
	bench.corner[101] = 299; /* whose index is in the line of 300 */
	before = level_cycles(&bench);
	assert_near(before, 2 * (14.8 + 111.0) + 78.0 * (3 + 1 + 3), 1e-6);
	for (uint32_t i = 0; i < VERTICES; i++) {
		order[i] = i;
	}
	bench.fixed.inverse_order = order;
	bench.drawable.fixed = &bench.fixed;
	/* That of each vertex is read from the order; 0 twice, at the same place. */
	assert_near(level_cycles(&bench),
		before + 2 * (18.2 - 14.8 + 114.0 - 111.0) + 78.0 * (3 + 1),
		1e-6);
}

/* Corners lie beside each other, eight in a line. */
static void test_corners_of_a_level_are_read_in_lines(void **state)
{
	struct bench bench;

	(void)state;
	begin_corners(&bench, 36);
	/* 36 sources and corners from 100 on are in five or six lines each */
	assert_near(level_cycles(&bench),
		36 * (14.8 + 111.0) + 78.0 * (5 + 5 + 1 + 1), 1e-6);
	bench.batch[0].corner = NULL; /* flat: indices, 16 a line */
	assert_near(level_cycles(&bench),
		36 * 14.8 + 100 * 101.6 + 78.0 * (5 + 1 + 19 + 75), 1e-6);
}

/* 1024 lines of positions are more than the first cache has. */
static void test_what_is_read_again_comes_from_the_second_cache(void **state)
{
	static float normal[1][3];
	struct bench bench;
	double first, again;

	(void)state;
	begin(&bench, 4);
	bench.primitive.normal = normal;
	bench.batch[0].vertex_count = 1024;
	first = cycles_of_all(&bench);
	assert_near(first, 1024 * 14.8 + 78.0 * (128 + 2 * 1024), 78.0);
	bench.batch[0].vertex_count = 2048;
	again = cycles_of_all(&bench) - first - 1024 * 14.8 - 78.0 * 128;
	/* some of them are in the first one still */
	assert_near(again, 10.0 * 2048, 500.0);
}

static void test_vertices_in_another_order_cost_more(void **state)
{
	static uint32_t order[VERTICES];
	struct bench bench;

	(void)state;
	begin(&bench, 1);
	bench.fixed.inverse_order = order;
	bench.drawable.fixed = &bench.fixed;
	bench.drawable.lod = bench.drawable.shadow_lod = 2;
	assert_near(instructions_of(&bench), 300 * (11.1 + 91.0), 1e-6);
}

/* Each vector of vertices that lie far apart comes from a line of its own. */
static void test_vertices_that_lie_far_apart_cost_more_cycles(void **state)
{
	struct bench near, far;
	double cycles;

	(void)state;
	begin(&near, 1);
	begin(&far, 909);
	cycles = cycles_of_all(&far) - cycles_of_all(&near);
	/* 900 vectors of which each has a line of 1024, and not four a line */
	assert_in_range((int)(cycles / 78.0), 250, 675);
	near.drawable.lod = near.drawable.shadow_lod = 2;
	far.drawable.lod = far.drawable.shadow_lod = 2;
	cycles = board_cost_gather_drawn(&far.drawable).cycles -
		board_cost_gather_drawn(&near.drawable).cycles;
	assert_true(cycles > 300 * 78.0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_line_is_read_once_while_a_cache_has_it),
		cmocka_unit_test(test_lines_leave_caches_that_are_full),
		cmocka_unit_test(
			test_a_full_set_loses_the_line_that_the_board_would_lose),
		cmocka_unit_test(test_gathered_vertices_and_facets),
		cmocka_unit_test(test_corners_of_facets_are_read),
		cmocka_unit_test(test_gathered_levels_and_their_shadows),
		cmocka_unit_test(test_a_shadow_takes_vertices_of_its_own),
		cmocka_unit_test(test_corners_of_a_level_read_their_triangles),
		cmocka_unit_test(test_corners_of_a_level_are_read_in_lines),
		cmocka_unit_test(
			test_what_is_read_again_comes_from_the_second_cache),
		cmocka_unit_test(test_vertices_in_another_order_cost_more),
		cmocka_unit_test(
			test_vertices_that_lie_far_apart_cost_more_cycles),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
