/* The table of limber bench, of results that the test makes up. */
#include "app/cmd/bench/bench_report.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

#define LEGEND                                                         \
	"nanoseconds a vertex on this machine, the median of 5 runs\n" \
	"warm: run after run; cold: after reading 32 MiB of other data; x: speed relative to float, warm\n\n"

static const struct bench_row rows[] = {
	{"one", "the first row", BENCH_SKIN, 1, 24},
	{"two", "the second row", BENCH_LERP, 1, 24},
};

static void make_report(struct bench_report *report)
{
	const struct kernel *fixed = kernel_find("fixed");

	assert_non_null(fixed);
	*report = (struct bench_report){.runs = 5,
		.size_count = 2,
		.vertex_count = {100, 4000},
		.result_count = 3,
		.result = {
			{&rows[0], &kernel_float, {{8.0, 10.5}, {9.0, 12.25}}},
			{&rows[0], fixed, {{4.0, 6.0}, {0.0, 7.0}}},
			{&rows[1], fixed, {{1.0, 2.0}, {3.0, 4.0}}},
		}};
}

static char *print(const struct bench_report *report)
{
	char *text = NULL;
	size_t size;
	FILE *out = open_memstream(&text, &size);

	assert_non_null(out);
	bench_print_text(report, out);
	fclose(out);
	return text;
}

/* A row is named once; without float, or without a time, there is no speed. */
static void test_a_table_has_a_line_for_each_kernel(void **state)
{
	static struct bench_report report;
	char *text;

	(void)state;
	make_report(&report);
	text = print(&report);
	assert_string_equal(text,
		LEGEND "                                             "
		       "         100 vertices            4000 vertices    \n"
		       "                                             "
		       "     warm    cold       x     warm    cold       x\n"
		       "the first row                        float   "
		       "     8.00   10.50    1.00     9.00   12.25    1.00\n"
		       "                                     fixed   "
		       "     4.00    6.00    2.00     0.00    7.00        \n"
		       "the second row                       fixed   "
		       "     1.00    2.00             3.00    4.00        \n");
	free(text);
}

static void test_a_models_table_begins_with_its_name(void **state)
{
	static struct bench_report report;
	char *text;

	(void)state;
	make_report(&report);
	report.mesh = "a.glb";
	report.size_count = 1;
	report.result_count = 1;
	text = print(&report);
	assert_int_equal(strncmp(text, "a.glb: nanoseconds", 18), 0);
	assert_contains(text,
		"\nthe first row                        float   "
		"     8.00   10.50    1.00\n");
	assert_null(strstr(text, "second row"));
	free(text);
}

static void test_json_has_all_times(void **state)
{
	static struct bench_report report;
	struct log nowhere = log_to_nowhere();
	char *text = NULL;
	size_t size;
	FILE *out = open_memstream(&text, &size);
	const char *at;

	(void)state;
	assert_non_null(out);
	make_report(&report);
	assert_int_equal(bench_print_json(&report, &nowhere, out), 0);
	fclose(out);
	assert_contains(text, "\"model\": null");
	assert_contains(text, "\"runs\": 5");
	at = strstr(text, "\"name\": \"one\"");
	assert_non_null(at);
	at = strstr(at, "\"vertices\": 4000");
	assert_non_null(at);
	assert_contains(at, "\"warm_ns\": 9.0");
	assert_contains(at, "\"cold_ns\": 12.25");
	at = strstr(at, "\"name\": \"two\"");
	assert_non_null(at);
	assert_contains(at, "\"kernel\": \"fixed\"");
	free(text);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_table_has_a_line_for_each_kernel),
		cmocka_unit_test(test_a_models_table_begins_with_its_name),
		cmocka_unit_test(test_json_has_all_times),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
