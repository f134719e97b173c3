/*
 * What a picture costs, from what it consists of. The figures of the table are
 * read from its source, as `make bench-draw-fit` writes them anew.
 */
#include "app/compare/cost/board_cost.h"
#include "tests/support/test.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

enum {
	ROWS_MAX = 80
};

static const double pixels = 1000.0;

struct row {
	double cycles, instructions;
	char name[32];
};

struct table {
	int count;
	struct row row[ROWS_MAX];
};

static int read_table(void **state)
{
	static struct table table;
	char line[256];
	FILE *file = fopen("app/compare/cost/board_cost_draw.c", "r");

	assert_non_null(file);
	while (fgets(line, sizeof(line), file) && table.count < ROWS_MAX) {
		struct row *row = &table.row[table.count];

		table.count += sscanf(line, " {%lf, %lf}, /* %31[a-z ] */",
				       &row->cycles, &row->instructions,
				       row->name) == 3;
	}
	fclose(file);
	*state = &table;
	return 0;
}

static const struct row *find(const struct table *table, const char *name)
{
	for (int i = 0; i < table->count; i++) {
		const struct row *row = &table->row[i];
		size_t length = strlen(name);

		if (strncmp(row->name, name, length) == 0 &&
			strcmp(row->name + length, " ") == 0) {
			return row;
		}
	}
	fail_msg("the table has no row %s", name);
	return NULL;
}

/* Beyond an empty picture, a number of times what the row costs. */
static void expect_cost(
	const struct gl_counts *counts, const struct row *row, double times)
{
	const struct gl_counts none = {0};
	struct board_cost empty = board_cost_draw(&none, 0.0);
	struct board_cost cost = board_cost_draw(counts, 0.0);

	assert_near(cost.cycles - empty.cycles, times * row->cycles, 1e-4);
	assert_near(cost.instructions - empty.instructions,
		times * row->instructions, 1e-4);
}

static void test_an_empty_picture_costs_its_frame_and_pixels(void **state)
{
	const struct gl_counts none = {0};
	const struct row *frame = find(*state, "frame");
	const struct row *pixel = find(*state, "pixel");
	struct board_cost cost = board_cost_draw(&none, pixels);

	assert_near(cost.cycles, frame->cycles + pixels * pixel->cycles, 1e-6);
	assert_near(cost.instructions,
		frame->instructions + pixels * pixel->instructions, 1e-6);
}

static void test_each_piece_of_work_has_the_fitted_cost(void **state)
{
	static const struct {
		size_t place;
		const char *name;
	} pieces[] = {
		{offsetof(struct gl_counts, calls), "call"},
		{offsetof(struct gl_counts, listed), "listed"},
		{offsetof(struct gl_counts, vertices), "vertex"},
		{offsetof(struct gl_counts, again), "again"},
		{offsetof(struct gl_counts, single), "single"},
		{offsetof(struct gl_counts, shaded), "shaded"},
		{offsetof(struct gl_counts, hidden), "hidden"},
		{offsetof(struct gl_counts, skipped), "skipped"},
		{offsetof(struct gl_counts, fine), "fine"},
	};

	for (size_t i = 0; i < sizeof(pieces) / sizeof(pieces[0]); i++) {
		struct gl_counts counts = {0};

		*(double *)(void *)((char *)&counts + pieces[i].place) = 100.0;
		expect_cost(&counts, find(*state, pieces[i].name), 100.0);
	}
}

/* Of each kind a triangle, a row and a pixel, behind the single pieces. */
static void test_each_kind_of_triangle_has_the_fitted_cost(void **state)
{
	const struct table *table = *state;
	const struct row *first = find(table, "flat triangle");

	assert_ptr_equal(first + 3 * GL_WORK_KINDS, table->row + table->count);
	for (int i = 0; i < 3 * GL_WORK_KINDS; i++) {
		struct gl_counts counts = {0};
		struct gl_work *work = &counts.work[i / 3];

		*(i % 3 == 0                 ? &work->triangles
				: i % 3 == 1 ? &work->rows
					     : &work->pixels) = 10.0;
		expect_cost(&counts, &first[i], 10.0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_an_empty_picture_costs_its_frame_and_pixels),
		cmocka_unit_test(test_each_piece_of_work_has_the_fitted_cost),
		cmocka_unit_test(test_each_kind_of_triangle_has_the_fitted_cost),
	};

	return cmocka_run_group_tests(tests, read_table, NULL);
}
