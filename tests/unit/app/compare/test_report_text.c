/* The text that a comparison made up by the test is reported with. */
#include "tests/support/test.h"
#include "tests/unit/app/compare/report_bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char text_of_two_clips[] =
	"dog.glb, 2 clips: 3.75 s; 321 vertices, 1 node\n"
	"\"ARM11\" is the whole frame without labels, which is posing and "
	"drawing, predicted\n"
	"for an ARM1136 at 532 MHz by the timing model, not measured. "
	"Errors are in pixels\n"
	"of a 480x640 screen, normals in degrees, shades in 63rds of white.\n"
	"Board desk: a test; limits: 50 KiB, 12.5 ms, 1.5 px.\n"
	"\n"
	"  a frame takes             ARM11 us  posing  drawing  KiB RAM "
	"KiB file peak px\n"
	" *skin                           900   300.0      600      2.0    "
	"  3.0   1.250\n"
	"  morph, 9 keys                 1800   600.0     1200      4.0    "
	"  6.0   2.500\n"
	">*rigid parts                   3600  1200.0     2400      8.0    "
	" 12.0   5.000\n"
	"  *: on the Pareto front: nothing else is better in time, memory "
	"and peak error\n"
	"\n"
	"  how it looks; posing here  mean px  outline  normal  shade  us "
	"here k instr.\n"
	"  skin                         0.125    0.500    2.50    3.5     "
	"11.5       45\n"
	"  morph, 9 keys                0.250    1.000    5.00    7.0     "
	"23.0        -\n"
	"  rigid parts                  0.500    2.000   10.00   14.0     "
	"46.0      180\n"
	"  us here: of posing, measured on this machine, kernel float\n"
	"\n"
	"  clip                  seconds ARM11 us  peak px  technique in "
	"the mixed plan\n"
	"   1 walk?fast             1.50      100    1.000  skin\n"
	"   2                       2.25      400    4.000  morph, 9 keys\n"
	"\n"
	"  AN4044 rates them    control over        looks               to program\n"
	"  morphing             every vertex        good, soft things   fairly easy\n"
	"  hierarchical         pivots              solid parts only    easiest\n"
	"  skeletal             bones               good, characters    most difficult\n"
	"\n"
	"Take \"rigid parts\" for all clips: it is the test.\n"
	"On the ARM1136 its frame takes 60 us to sample the clip, 120 us "
	"for matrices,\n"
	"180 us for vertices and 240 us to draw it.\n"
	"A mixed plan, with the technique that the clips' table names for "
	"each, takes 777 us and 5 KiB.\n"
	"AN4044's example, 20 key frames of 4000 vertices, is 80000 "
	"vertices;\n"
	"here 20 key frames of 321 are 6420.\n";

static const char text_of_one_clip[] =
	"dog.glb, clip 1 walk?fast: 1.50 s; 1 vertex, 2 nodes\n"
	"\"ARM11\" is the whole frame without labels, which is posing and "
	"drawing, predicted\n"
	"for an ARM1136 at 532 MHz by the timing model, not measured. "
	"Errors are in pixels\n"
	"of a 480x640 screen, normals in degrees, shades in 63rds of white.\n"
	"Board desk: a test; limits: 50 KiB, 12.5 ms, 1.5 px.\n"
	"\n"
	"  a frame takes             ARM11 us  posing  drawing  KiB RAM "
	"KiB file peak px\n"
	"  morph, 9 keys                 1800   600.0     1200      4.0    "
	"  6.0   2.500\n"
	">*rigid parts                   3600  1200.0     2400      8.0    "
	" 12.0   5.000\n"
	"  *: on the Pareto front: nothing else is better in time, memory "
	"and peak error\n"
	"\n"
	"  how it looks; posing here  mean px  outline  normal  shade  us "
	"here k instr.\n"
	"  morph, 9 keys                0.250    1.000    5.00    7.0     "
	"23.0        -\n"
	"  rigid parts                  0.500    2.000   10.00   14.0     "
	"46.0      180\n"
	"  us here: of posing, measured on this machine, kernel float\n"
	"\n"
	"  AN4044 rates them    control over        looks               to program\n"
	"  morphing             every vertex        good, soft things   fairly easy\n"
	"  hierarchical         pivots              solid parts only    easiest\n"
	"\n"
	"Take \"rigid parts\": it is the test.\n"
	"On the ARM1136 its frame takes 40 us to sample the clip, 80 us "
	"for matrices,\n"
	"120 us for vertices and 160 us to draw it.\n"
	"AN4044's example, 20 key frames of 4000 vertices, is 80000 "
	"vertices;\n"
	"here 20 key frames of 1 are 20.\n";

static void expect(struct bench *bench, const char *wanted)
{
	assert_string_equal(print(bench, "text"), wanted);
	free(bench->text);
}

static void test_the_text_has_each_figure_in_its_column(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.mixed = true;
	expect(&bench, text_of_two_clips);
}

static void test_a_single_clip_needs_no_table_of_clips(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.clip_count = 1;
	bench.comparison.vertex_count = 1;
	bench.model.node_count = 2;
	bench.comparison.row[0].listed = false;
	expect(&bench, text_of_one_clip);
}

static void test_the_text_says_that_clips_were_compared_in_part(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.sampling.share = 0.0277;
	assert_contains(print(&bench, "text"),
		"1.5 px.\nThe clips are long together: errors are those of 2.8% of their moments");
	free(bench.text);
}

/* How many clips there are decides whether one could be chosen. */
static void test_the_text_states_the_share_of_moments(void **state)
{
	(void)state;
	for (int clips = 1; clips <= CLIPS; clips++) {
		struct bench bench;
		const char *text;

		begin(&bench);
		bench.comparison.clip_count = clips;
		bench.comparison.sampling.share = 0.9;
		text = print(&bench, "text");
		assert_contains(text, "errors are those of 90% of");
		assert_int_equal(
			strstr(text, "--clip compares one") != NULL, clips > 1);
		free(bench.text);
	}
}

static void test_the_text_shows_large_and_small_numbers(void **state)
{
	struct bench bench;
	const char *text;

	(void)state;
	begin(&bench);
	bench.comparison.row[0].total.memory_bytes = (size_t)100 << 20;
	bench.comparison.row[0].total.instructions = 0.0;
	bench.comparison.row[2].total.instructions = 5e7;
	text = print(&bench, "text");
	assert_contains(text, " 102400.0      3.0   1.250\n");
	assert_contains(text, "     11.5        0\n");
	assert_contains(text, "     46.0    50000\n");
	free(bench.text);
}

/* A clip has its number, and a name if the file names it. */
static void test_the_text_names_a_single_clip(void **state)
{
	static const char *const names[] = {"", "a", "jump"};
	static const char *const wanted[] = {", clip 1: 1.50 s",
		", clip 1 a: 1.50 s", ", clip 1 jump: 1.50 s"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct bench bench;

		begin(&bench);
		bench.comparison.clip_count = 1;
		bench.clip[1].name = names[i];
		assert_contains(print(&bench, "text"), wanted[i]);
		free(bench.text);
	}
}

/* Names of 17 to 40 letters widen their column; longer ones push the others. */
static void test_the_column_of_clips_is_as_wide_as_their_names(void **state)
{
	static const int lengths[][3] = {{3, 17, 17}, {18, 1, 18}, {2, 30, 30},
		{39, 39, 39}, {40, 7, 40}, {7, 41, 40}, {60, 50, 40}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(lengths); i++) {
		int width = lengths[i][2];
		char name[CLIPS][64], wanted[160];
		struct bench bench;

		begin(&bench);
		for (int c = 0; c < CLIPS; c++) {
			memset(name[c], 'x', sizeof(name[c]));
			name[c][lengths[i][c]] = '\0';
			bench.clip[c + 1].name = name[c];
		}
		print(&bench, "text");
		snprintf(wanted, sizeof(wanted), "\n  %-*s  seconds", width + 3,
			"clip");
		assert_contains(bench.text, wanted);
		for (int c = 0; c < CLIPS; c++) {
			snprintf(wanted, sizeof(wanted), "\n  %2d %-*s %8.2f ",
				c + 1, width, name[c], c == 0 ? 1.5 : 2.25);
			assert_contains(bench.text, wanted);
		}
		free(bench.text);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_text_has_each_figure_in_its_column),
		cmocka_unit_test(test_a_single_clip_needs_no_table_of_clips),
		cmocka_unit_test(
			test_the_text_says_that_clips_were_compared_in_part),
		cmocka_unit_test(test_the_text_states_the_share_of_moments),
		cmocka_unit_test(test_the_text_shows_large_and_small_numbers),
		cmocka_unit_test(test_the_text_names_a_single_clip),
		cmocka_unit_test(
			test_the_column_of_clips_is_as_wide_as_their_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
