/* What copying posed vertices for GL costs, and the lines that it reads. */
#include "app/compare/cost/board_cost.h"
#include "app/compare/cost/line_reads.h"
#include "tests/support/test.h"

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

/* A batch of which all triangles have vertices of their own. */
struct bench {
	struct model_primitive primitive;
	uint32_t index[VERTICES], source[2 * VERTICES], corner[2 * VERTICES];
	uint16_t list[VERTICES];
	struct drawable_fixed fixed;
	struct batch_lod lod[2];
	struct batch batch;
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
	bench->batch = (struct batch){.vertex_count = 900,
		.source = bench->source,
		.corner = bench->corner,
		.index = bench->list,
		.index_count = 900,
		.lod = bench->lod,
		.lod_count = 2};
	bench->drawable = (struct drawable){.primitive = &bench->primitive,
		.batch_count = 1,
		.batch = &bench->batch};
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
	bench.batch.source = NULL;
	cost = board_cost_gather(&bench.drawable);
	assert_true(cost.cycles == 0.0 && cost.instructions == 0.0);
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
		cmocka_unit_test(test_gathered_vertices_and_facets),
		cmocka_unit_test(test_gathered_levels_and_their_shadows),
		cmocka_unit_test(test_vertices_in_another_order_cost_more),
		cmocka_unit_test(
			test_vertices_that_lie_far_apart_cost_more_cycles),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
