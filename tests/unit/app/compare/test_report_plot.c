/* The plot of a comparison that the test makes up. */
#include "app/compare/report/report.h"
#include "tests/support/files.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/report_bench.h"

#include <stdio.h>
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_axes_of_a_plot_enclose_the_numbers_in_decades),
		cmocka_unit_test(test_a_plot_shows_the_accepted_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
