/* The reports of a comparison that the test makes up. */
#include "app/compare/report/report.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/report_bench.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char csv[] =
	"technique,kind,us_per_frame,instructions_per_frame,"
	"arm11_us_predicted,arm11_instructions_predicted,"
	"arm11_drawing_us_predicted,ram_bytes,file_bytes,peak_px,mean_px,"
	"outline_px,normal_deg,shade_steps,front,advised\r\n"
	"\"skin\",skeletal,11.50,45000,900.00,6300,600.00,2048,3072,1.2500,"
	"0.1250,0.5000,2.500,3.50,yes,no\r\n"
	"\"morph, 9 keys\",morphing,23.00,,1800.00,12600,1200.00,4096,6144,"
	"2.5000,0.2500,1.0000,5.000,7.00,no,no\r\n";

static const char markdown[] =
	"| technique | kind | us_per_frame | instructions_per_frame | "
	"arm11_us_predicted | arm11_instructions_predicted | "
	"arm11_drawing_us_predicted | ram_bytes | file_bytes | peak_px | "
	"mean_px | outline_px | normal_deg | shade_steps | front | advised "
	"|\n"
	"|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
	"---:|---:|---:|\n"
	"| skin | skeletal | 11.50 | 45000 | 900.00 | 6300 | 600.00 | 2048 "
	"| 3072 | 1.2500 | 0.1250 | 0.5000 | 2.500 | 3.50 | yes | no |\n"
	"| morph, 9 keys | morphing | 23.00 |  | 1800.00 | 12600 | 1200.00 "
	"| 4096 | 6144 | 2.5000 | 0.2500 | 1.0000 | 5.000 | 7.00 | no | no "
	"|\n";

static void expect(struct bench *bench, const char *format, const char *wanted)
{
	assert_string_equal(print(bench, format), wanted);
	free(bench->text);
}

static void test_csv_leaves_unknown_instructions_empty(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.row[2].listed = false;
	expect(&bench, "csv", csv);
	expect(&bench, "md", markdown);
}

static double number_of(const json_t *json, const char *key)
{
	const json_t *value = json_object_get(json, key);

	if (!json_is_number(value)) {
		fail_msg("there is no number %s", key);
	}
	return json_number_value(value);
}

static void expect_cost(const json_t *json, const char *key, double wanted_us)
{
	const json_t *cost = json_object_get(json, key);

	assert_near(number_of(cost, "us_per_frame"), wanted_us, 1e-6);
	assert_near(number_of(cost, "instructions_per_frame"), 7.0 * wanted_us,
		1e-6);
}

static void expect_cells(const json_t *candidate, int number, double unit)
{
	const json_t *cells = json_object_get(candidate, "clips");

	assert_int_equal(json_array_size(cells), CLIPS);
	for (int c = 0; c < CLIPS; c++) {
		const json_t *cell = json_array_get(cells, (size_t)c);
		const json_t *split = json_object_get(cell, "arm11_split");
		double by = unit * (c + 1);

		assert_near(number_of(cell, "peak_px"), by, 1e-6);
		assert_near(number_of(cell, "samples"), 10 + c, 0.0);
		assert_near(number_of(cell, "ram_bytes_own"), 2, 0.0);
		expect_cost(cell, "arm11_predicted", 100.0 * by);
		expect_cost(split, "sample", 10.0 * by);
		expect_cost(split, "matrices", 20.0 * by);
		expect_cost(split, "vertices", 30.0 * by);
		expect_cost(split, "draw", 40.0 * by);
		assert_int_equal(
			json_object_get(cell, "instructions_per_frame") == NULL,
			number == 1);
		assert_int_equal(
			json_array_size(json_object_get(cell, "key_times_s")),
			number == 1 && c == 0 ? 3 : 0);
	}
}

static void test_json_has_all_rows_and_cells(void **state)
{
	static const double units[ROWS] = {1.0, 2.0, 4.0};
	struct bench bench;
	const json_t *candidates, *clip;
	json_t *root;

	(void)state;
	begin(&bench);
	bench.comparison.row[0].listed = false;
	bench.cell[1][0].keys = (struct fit_keys){3, bench.time_s};
	root = json_loads(print(&bench, "json"), 0, NULL);
	assert_non_null(root);
	candidates = json_object_get(root, "candidates");
	assert_int_equal(json_array_size(candidates), ROWS);
	for (int i = 0; i < ROWS; i++) {
		const json_t *one = json_array_get(candidates, (size_t)i);

		assert_near(
			number_of(one, "us_per_frame"), 11.5 * units[i], 1e-6);
		assert_near(number_of(one, "shade_steps"), 3.5 * units[i], 1e-6);
		assert_int_equal(
			json_is_true(json_object_get(one, "listed")), i != 0);
		assert_int_equal(
			json_is_true(json_object_get(one, "advised")), i == 2);
		assert_int_equal(
			json_is_true(json_object_get(one, "front")), i != 1);
		expect_cost(one, "arm11_predicted", 900.0 * units[i]);
		expect_cost(one, "arm11_drawing", 600.0 * units[i]);
		expect_cells(one, i, units[i]);
	}
	clip = json_array_get(json_object_get(root, "clips"), 1);
	assert_near(number_of(clip, "clip"), 2, 0.0);
	assert_string_equal(json_string_value(json_object_get(clip, "plan")),
		"morph, 9 keys");
	assert_near(json_number_value(
			    json_array_get(json_object_get(clip, "times_s"), 1)),
		0.75, 1e-7);
	assert_string_equal(
		json_string_value(json_object_get(root, "advised_by")),
		"arm11_predicted");
	assert_near(number_of(root, "ram_limit_bytes"), 51200, 0.0);
	assert_near(number_of(json_object_get(root, "mixed_plan"), "ram_bytes"),
		5120, 0.0);
	json_decref(root);
	free(bench.text);
}

/* In a file name any bytes are allowed, but a JSON string is UTF-8. */
static void test_json_refuses_a_name_that_is_not_utf8(void **state)
{
	struct bench bench;
	FILE *out = tmpfile();

	(void)state;
	begin(&bench);
	assert_non_null(out);
	bench.model.path = "dog\xff.glb";
	assert_int_equal(report_print_json(&bench.comparison, out), -EINVAL);
	assert_int_equal(ftell(out), 0);
	fclose(out);
}

static void test_formats_are_found_by_name(void **state)
{
	(void)state;
	assert_string_equal(report_find("md")->name, "md");
	assert_null(report_find("xml"));
	assert_null(report_find(""));
}

/* None was counted, which is not the same as no counter. */
static void test_no_instructions_are_a_number(void **state)
{
	struct bench bench;
	const json_t *one;
	json_t *root;

	(void)state;
	begin(&bench);
	bench.comparison.row[0].total.instructions = 0.0;
	bench.cell[0][0].time.instructions = 0.0;
	root = json_loads(print(&bench, "json"), 0, NULL);
	one = json_array_get(json_object_get(root, "candidates"), 0);
	assert_near(number_of(one, "instructions_per_frame"), 0.0, 0.0);
	one = json_array_get(json_object_get(one, "clips"), 0);
	assert_near(number_of(one, "instructions_per_frame"), 0.0, 0.0);
	json_decref(root);
	free(bench.text);
	assert_contains(print(&bench, "csv"), "\"skin\",skeletal,11.50,0,");
	free(bench.text);
}

/* Column by column, as glTF and GL ES store matrices. */
static void test_json_has_each_number_of_the_view(void **state)
{
	struct bench bench;
	const json_t *clip, *view;
	json_t *root;

	(void)state;
	begin(&bench);
	for (int i = 0; i < 16; i++) {
		bench.compared[1].screen.view[i / 4][i % 4] = (float)i + 0.5f;
	}
	root = json_loads(print(&bench, "json"), 0, NULL);
	assert_non_null(root);
	clip = json_array_get(json_object_get(root, "clips"), 1);
	view = json_object_get(json_object_get(clip, "screen"), "view");
	assert_int_equal(json_array_size(view), 16);
	for (int i = 0; i < 16; i++) {
		assert_near(json_number_value(json_array_get(view, (size_t)i)),
			i + 0.5, 0);
	}
	json_decref(root);
	free(bench.text);
}

/* Files that tools compare line by line, and terminals show as they are. */
static void test_json_is_ascii_on_short_lines(void **state)
{
	struct bench bench;
	const char *text;

	(void)state;
	begin(&bench);
	bench.model.path = "d\xC3\xB6g.glb";
	bench.time_s[1] = 0.1f;
	bench.comparison.mixed_us = 1.0 / 3.0;
	text = print(&bench, "json");
	assert_int_equal(strncmp(text, "{\n  \"", 5), 0);
	assert_string_equal(text + strlen(text) - 3, "\n}\n");
	assert_contains(text, "d\\u00F6g.glb");
	assert_contains(text, " 0.333333333\n");
	assert_contains(text, " 0.100000001,\n");
	for (int i = 0; text[i] != '\0'; i++) {
		assert_in_range(text[i], '\n', '~');
	}
	free(bench.text);
}

static void test_json_has_the_times_of_key_frames(void **state)
{
	(void)state;
	for (int count = 0; count < 3; count++) {
		struct bench bench;
		const json_t *cell, *times;
		json_t *root;

		begin(&bench);
		bench.cell[1][0].keys = (struct fit_keys){
			.count = count, .time_s = bench.time_s};
		root = json_loads(print(&bench, "json"), 0, NULL);
		cell = json_array_get(json_object_get(root, "candidates"), 1);
		cell = json_array_get(json_object_get(cell, "clips"), 0);
		times = json_object_get(cell, "key_times_s");
		assert_int_equal(times != NULL, count > 0);
		assert_int_equal(json_array_size(times), count);
		for (int i = 0; i < count; i++) {
			assert_near(json_number_value(
					    json_array_get(times, (size_t)i)),
				bench.time_s[i], 0);
		}
		json_decref(root);
		free(bench.text);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_csv_leaves_unknown_instructions_empty),
		cmocka_unit_test(test_no_instructions_are_a_number),
		cmocka_unit_test(test_json_has_all_rows_and_cells),
		cmocka_unit_test(test_json_refuses_a_name_that_is_not_utf8),
		cmocka_unit_test(test_formats_are_found_by_name),
		cmocka_unit_test(test_json_has_each_number_of_the_view),
		cmocka_unit_test(test_json_is_ascii_on_short_lines),
		cmocka_unit_test(test_json_has_the_times_of_key_frames),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
