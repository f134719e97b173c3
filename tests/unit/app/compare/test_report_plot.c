/* The plot of a comparison that the test makes up. */
#include "app/compare/report/report.h"
#include "tests/support/files.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/report_bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The labels of a plot's grid: of each chart the x axis, then the y axis. */
static void expect_axes(const struct bench *bench, const char *wanted)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "plot.svg");
	char line[512], labels[128] = "";
	FILE *file;

	assert_int_equal(report_plot(&bench->comparison, path.text, &log), 0);
	file = fopen(path.text, "r");
	assert_non_null(file);
	while (fgets(line, sizeof(line), file)) {
		const char *label = strrchr(line, '/') - 1;

		if (strncmp(line, "<path class='grid'", 18) == 0) {
			while (label[-1] != '>') {
				label--;
			}
			strncat(labels, label, strcspn(label, "<"));
			strcat(labels, " ");
		}
	}
	fclose(file);
	assert_string_equal(labels, wanted);
	temp_dir_remove(&folder);
}

/* Three candidates take 300 to 1200 us. */
static void test_the_axes_of_a_plot_enclose_the_numbers_in_decades(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	for (int i = 0; i < ROWS; i++) {
		/* 200 to 800 KiB, and 1.25 to 5 pixels. */
		bench.comparison.row[i].total.memory_bytes *= 100;
	}
	expect_axes(&bench, "100 1000 1 10 100 1000 10000 1 10 ");
	for (int i = 0; i < ROWS; i++) {
		/* 0.02 to 0.08 KiB, and 0.0125 to 0.05 pixels. */
		bench.comparison.row[i].total.memory_bytes /= 10000;
		bench.comparison.row[i].total.peak_px /= 100.0f;
	}
	bench.comparison.request.bound_px = 0.05f;
	expect_axes(&bench, "0.01 0.1 0.01 0.1 100 1000 10000 0.01 0.1 ");
}

/* Errors from 1.25 to 5 pixels, and the line of the accepted error. */
static void test_a_plot_shows_the_accepted_error(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.request.bound_px = 150.0f;
	expect_axes(&bench, "1 10 1 10 100 1000 100 1000 10000 1 10 100 1000 ");
	bench.comparison.request.bound_px = 0.02f;
	expect_axes(&bench, "1 10 0.01 0.1 1 10 100 1000 10000 0.01 0.1 1 10 ");
}

/* The text of a plot; the caller frees it. */
static char *plot(const struct bench *bench)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "plot.svg");
	char *text;

	assert_int_equal(report_plot(&bench->comparison, path.text, &log), 0);
	text = file_read(path.text, NULL);
	temp_dir_remove(&folder);
	return text;
}

static int count(const char *text, const char *part)
{
	int found = 0;

	for (; (text = strstr(text, part)) != NULL; text++) {
		found++;
	}
	return found;
}

/* Rows of 1, 10 and 100 KiB, pixels and us: each decade is 400 / 3 wide. */
static void begin_decades(struct bench *bench)
{
	double power = 1.0;

	begin(bench);
	bench->comparison.request.bound_px = 100.0f;
	for (int i = 0; i < ROWS; i++, power *= 10.0) {
		struct comparison_total *total = &bench->comparison.row[i].total;

		total->memory_bytes = (size_t)(1024.0 * power);
		total->peak_px = (float)power;
		total->draw = us(5.0);
		total->board = us(5.0 + power);
	}
}

static void test_a_row_is_a_point_in_both_charts(void **state)
{
	struct bench bench;
	char *text;

	(void)state;
	begin_decades(&bench);
	text = plot(&bench);
	assert_ptr_equal(strstr(text,
				 "<svg xmlns='http://www.w3.org/2000/svg' "
				 "width='980' height='460' "
				 "viewBox='0 0 980 460'>"),
		text);
	assert_string_equal(text + strlen(text) - 7, "</svg>\n");
	assert_int_equal(count(text, "<title>"), 2 * ROWS);
	assert_contains(text,
		"<circle cx='64.0' cy='360.0' r='4' fill='#1d4ed8' stroke='black' stroke-width='2.5'><title>skin: 1.000 px</title>");
	assert_contains(text,
		"<circle cx='197.3' cy='260.0' r='4' fill='#c2410c' stroke='#c2410c'><title>morph, 9 keys: 10.000 px</title>");
	assert_contains(text,
		"<circle cx='330.7' cy='160.0' r='7' fill='#4d7c0f' stroke='black' stroke-width='2.5'><title>rigid parts: 100.000 px</title>");
	assert_contains(text, "<circle cx='544.0' cy='360.0' r='4'");
	assert_contains(text, "<circle cx='677.3' cy='260.0' r='4'");
	assert_contains(text, "<circle cx='810.7' cy='160.0' r='7'");
	assert_int_equal(
		count(text, "<path class='bound' d='M64.0 160.0 h400'/>"), 1);
	free(text);
}

/* Decades of 133 pixels across and 100 up, of which each has its number. */
static void test_the_axes_have_a_line_for_each_decade(void **state)
{
	struct bench bench;
	char *text;

	(void)state;
	begin_decades(&bench);
	bench.comparison.request.bound_px = 0.1f;
	for (int i = 0; i < ROWS; i++) {
		bench.comparison.row[i].total.peak_px /= 10.0f;
	}
	text = plot(&bench);
	assert_contains(text,
		"<path class='grid' d='M64.0 60 v300'/><text x='64.0' y='378' text-anchor='middle'>1</text>");
	assert_contains(text,
		"<path class='grid' d='M330.7 60 v300'/><text x='330.7' y='378' text-anchor='middle'>100</text>");
	assert_contains(text,
		"<path class='grid' d='M64.0 360.0 h400'/><text x='58.0' y='364.0' text-anchor='end'>0.1</text>");
	assert_contains(text,
		"<path class='grid' d='M544.0 160.0 h400'/><text x='538.0' y='164.0' text-anchor='end'>10</text>");
	assert_contains(text,
		"<path class='bound' d='M64.0 360.0 h400'/><text x='64.0' y='46' class='title'>");
	assert_contains(text, "<circle cx='197.3' cy='260.0' r='4'");
	free(text);
}

/* In the order of memory; a morph of even keys is hollow, and beside it. */
static void test_points_of_a_technique_are_joined(void **state)
{
	struct bench bench;
	char *text;

	(void)state;
	begin_decades(&bench);
	text = plot(&bench);
	assert_int_equal(count(text, "<path class='curve'"), 2 * ROWS);
	assert_contains(text,
		"<path class='curve' d='M197.3 260.0' stroke='#c2410c'/>");
	free(text);
	for (int i = 0; i < ROWS; i++) {
		bench.comparison.row[i].technique = TECHNIQUE_MORPHING;
	}
	bench.comparison.row[0].total.memory_bytes *= 20;
	text = plot(&bench);
	assert_int_equal(count(text, "<path class='curve'"), 2);
	assert_contains(text,
		"<path class='curve' d='M64.0 260.0 L124.2 360.0 L264.0 160.0' stroke='#c2410c'/>");
	free(text);
	bench.comparison.row[0].kind = COMPARISON_MORPH_EVEN;
	text = plot(&bench);
	assert_contains(text,
		"<path class='curve' d='M64.0 260.0 L264.0 160.0' stroke='#c2410c'/>");
	assert_contains(
		text, "<circle cx='124.2' cy='360.0' r='4' fill='white'");
	assert_int_equal(count(text, "fill='white' stroke="), 2);
	free(text);
}

/* One name after the other, of techniques that the table lists. */
static void test_the_legend_names_the_techniques(void **state)
{
	struct bench bench;
	char *text;

	(void)state;
	begin_decades(&bench);
	text = plot(&bench);
	assert_int_equal(count(text, "cy='422' r='5'"), ROWS);
	assert_contains(text,
		"<circle cx='64.0' cy='422' r='5' fill='#c2410c'/><text x='76.0' y='427'>morphing</text>");
	assert_contains(text,
		"<circle cx='168.0' cy='422' r='5' fill='#4d7c0f'/><text x='180.0' y='427'>hierarchical</text>");
	assert_contains(text,
		"<circle cx='304.0' cy='422' r='5' fill='#1d4ed8'/><text x='316.0' y='427'>skeletal</text>");
	assert_contains(text,
		"<text x='64' y='448'>Dashed: the accepted error, 100 px. Large: recommended, \"rigid parts\". Black rim: Pareto front. Hollow: even keys.</text>");
	free(text);
	bench.comparison.row[1].technique = TECHNIQUE_COMBINED;
	bench.comparison.row[0].listed = false;
	text = plot(&bench);
	assert_int_equal(count(text, "cy='422' r='5'"), 2);
	assert_contains(
		text, "<circle cx='200.0' cy='422' r='5' fill='#7e22ce'/>");
	free(text);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_axes_of_a_plot_enclose_the_numbers_in_decades),
		cmocka_unit_test(test_a_plot_shows_the_accepted_error),
		cmocka_unit_test(test_a_row_is_a_point_in_both_charts),
		cmocka_unit_test(test_the_axes_have_a_line_for_each_decade),
		cmocka_unit_test(test_points_of_a_technique_are_joined),
		cmocka_unit_test(test_the_legend_names_the_techniques),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
