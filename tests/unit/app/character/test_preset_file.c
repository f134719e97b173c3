/* Saving presets in their file, directly and by the tuner. */
#include "app/character/presets/preset_file.h"
#include "app/model/model_file.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bench {
	struct log log;
	struct test_path folder, path;
};

static void write_file(const struct bench *bench, const char *text)
{
	file_write(bench->path.text, text, strlen(text));
}

static void read_back(const struct bench *bench, char *text, size_t size)
{
	char *all = file_read(bench->path.text, NULL);

	assert_true(snprintf(text, size, "%s", all) < (int)size);
	free(all);
}

static int begin(void **state)
{
	struct bench *bench = calloc(1, sizeof(*bench));

	assert_non_null(bench);
	bench->log = log_to_stderr(LOG_WARNING);
	bench->folder = temp_dir_make();
	bench->path = path_join(&bench->folder, "presets.ini");
	*state = bench;
	return 0;
}

static int end(void **state)
{
	struct bench *bench = *state;

	temp_dir_remove(&bench->folder);
	unsetenv("LIMBER_ASSETS");
	free(bench);
	return 0;
}

static const char before[] = "; About it all.\n"
			     "[one]\n"
			     "speed = 10 ; slow\n"
			     "translation = 0 1 0\n"
			     "\n"
			     "; About two.\n"
			     "[two]\n"
			     "  amplitude=0.5\n";

static const char after[] = "; About it all.\n"
			    "[one]\n"
			    "speed = 12.5 ; slow\n"
			    "translation = 0 1 -2\n"
			    "attenuation = -0.25\n"
			    "\n"
			    "; About two.\n"
			    "[two]\n"
			    "  amplitude=0.5\n";

static void test_saving_changes_only_the_section(void **state)
{
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	char text[1024];

	write_file(bench, before);
	strcpy(preset.name, "one");
	preset.speed = 12.5f;
	preset.translation[2] = -2.0f;
	preset.attenuation = -0.25f;
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, text, sizeof(text));
	assert_string_equal(text, after);
}

/* Comments may be of one character, and values may have none. */
static void test_saving_keeps_what_is_behind_a_value(void **state)
{
	static const struct {
		const char *line, *saved;
	} rows[] = {
		{"speed = 10", "speed = 12.5"},
		{"speed = 10;", "speed = 12.5 ;"},
		{"speed = 10 #", "speed = 12.5 #"},
		{"\tspeed=10;a", "speed = 12.5 ;a"},
	};
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	char text[1024], expected[1024];

	strcpy(preset.name, "one");
	preset.speed = 12.5f;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		snprintf(text, sizeof(text), "[one]\n%s\n", rows[i].line);
		write_file(bench, text);
		assert_int_equal(
			preset_file_save(bench->path.text, &preset, &bench->log),
			0);
		read_back(bench, text, sizeof(text));
		snprintf(expected, sizeof(expected), "[one]\n%s\n",
			rows[i].saved);
		assert_string_equal(text, expected);
	}
}

/* A name may have blanks, and begin as another one does. */
static void test_saving_finds_the_section_by_its_whole_name(void **state)
{
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	char text[1024];

	write_file(bench, "[cold wind]\nspeed = 1\n[ cold ]\nspeed = 2\n");
	strcpy(preset.name, "cold");
	preset.speed = 3.0f;
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, text, sizeof(text));
	assert_string_equal(
		text, "[cold wind]\nspeed = 1\n[ cold ]\nspeed = 3\n");
}

static void test_a_saved_preset_is_read_back(void **state)
{
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	struct procedural_preset read[4];
	char text[1024];

	write_file(bench, before);
	strcpy(preset.name, "three");
	for (int i = 0; i < PRESET_FIELDS; i++) {
		*preset_value(&preset, &preset_fields[i]) =
			0.125f * (float)(i + 1);
	}
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, text, sizeof(text));
	assert_int_equal(procedural_presets_parse(
				 text, bench->path.text, &bench->log, read, 4),
		3);
	assert_string_equal(read[2].name, "three");
	for (int i = 0; i < PRESET_FIELDS; i++) {
		assert_near(*preset_value(&read[2], &preset_fields[i]),
			0.125f * (float)(i + 1), 0.0);
	}
	assert_near(read[1].amplitude, 0.5, 0.0);
}

static void test_the_programs_own_file_stays_as_it_is(void **state)
{
	struct bench *bench = *state;
	struct model_file own;
	struct procedural_preset preset[PRESETS_MAX];
	char text[4096];
	int count;

	assert_int_equal(
		model_file_read("assets/presets.ini", NULL, &bench->log, &own),
		0);
	write_file(bench, (const char *)own.data);
	count = procedural_presets_parse((const char *)own.data, "own",
		&bench->log, preset, PRESETS_MAX);
	assert_true(count >= 3);
	for (int i = 0; i < count; i++) {
		assert_int_equal(preset_file_save(bench->path.text, &preset[i],
					 &bench->log),
			0);
	}
	read_back(bench, text, sizeof(text));
	assert_string_equal(text, (const char *)own.data);
	model_file_release(&own);
}

/* What the tuner changes with one press, and how far. */
static void test_fields_change_in_steps_between_limits(void **state)
{
	static const struct preset_field fields[] = {
		{"speed", "speed", 0, 1, 0, 200},
		{"amplitude", "amplitude", 0, 0.02f, 0, 4},
		{"attenuation", "attenuation", 0, 0.05f, -2, 2},
		{"modifier", "modifier", 0, 0.1f, 0, 4},
		{"shift", "translation", 3, 0.1f, -20, 20},
		{"turn", "rotation", 3, 0.02f, -3, 3}};
	const struct preset_field *field = preset_fields;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(fields); i++) {
		int axes = fields[i].element;

		for (int axis = 0; axis < (axes ? axes : 1); axis++, field++) {
			char name[16];

			snprintf(name, sizeof(name), axes ? "%s %c" : "%s",
				fields[i].name, 'x' + axis);
			assert_string_equal(field->name, name);
			assert_string_equal(field->key, fields[i].key);
			assert_int_equal(field->element, axis);
			assert_near(field->step, fields[i].step, 0);
			assert_near(field->low, fields[i].low, 0);
			assert_near(field->high, fields[i].high, 0);
		}
	}
	assert_ptr_equal(field, preset_fields + PRESET_FIELDS);
}

/* Of a file whose last line does not end. */
static void test_a_section_at_the_end_gets_lines_of_its_own(void **state)
{
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	char text[1024];

	strcpy(preset.name, "one");
	preset.speed = 12.5f;
	write_file(bench, "[one]");
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, text, sizeof(text));
	assert_string_equal(text, "[one]\nspeed = 12.5\n");
	strcpy(preset.name, "two");
	write_file(bench, "[one] ; it all");
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, text, sizeof(text));
	assert_string_equal(text, "[one] ; it all\n\n[two]\nspeed = 12.5\n");
}

/* Comments, blank lines and keys of other programs stand where they stood. */
static void test_saving_keeps_the_lines_between_values(void **state)
{
	static const char text[] = "[one]\n\n# a\n%s; b\nodd = 3 ; c\n"
				   "modifier = 1\n; d\n\n[two]\nspeed = 1\n";
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	char old[256], saved[256], read[256];

	snprintf(old, sizeof(old), text, "speed = 10\n");
	snprintf(saved, sizeof(saved), text, "speed = 12.5\n");
	strcpy(preset.name, "one");
	preset.speed = 12.5f;
	preset.modifier = 1;
	write_file(bench, old);
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, read, sizeof(read));
	assert_string_equal(read, saved);
	write_file(bench, "");
	preset.modifier = procedural_preset_default().modifier;
	assert_int_equal(
		preset_file_save(bench->path.text, &preset, &bench->log), 0);
	read_back(bench, read, sizeof(read));
	assert_string_equal(read, "\n[one]\nspeed = 12.5\n");
}

/* That of the document, whose unit is the centimetre. */
static void test_a_file_without_presets_has_the_default_one(void **state)
{
	struct bench *bench = *state;
	struct procedural_preset plain = procedural_preset_default();
	struct preset_file file = {.count = 7};

	plain.unit = 0.01f;
	assert_int_equal(setenv("LIMBER_ASSETS", bench->folder.text, 1), 0);
	write_file(bench, "; none\n");
	assert_int_equal(preset_file_find(&file, &bench->log), 0);
	assert_string_equal(file.path, bench->path.text);
	assert_int_equal(file.count, 1);
	for (int i = 0; i < PRESET_FIELDS; i++) {
		assert_near(*preset_value(&file.preset[0], &preset_fields[i]),
			*preset_value(&plain, &preset_fields[i]), 0);
	}
	assert_near(file.preset[0].unit, 0.01, 1e-9);
	write_file(bench, "[one]\nunit = 2\n[two]\n");
	assert_int_equal(preset_file_find(&file, &bench->log), 0);
	assert_int_equal(file.count, 2);
	assert_string_equal(file.preset[1].name, "two");
	assert_near(file.preset[0].unit, 2, 0);
}

static void test_a_malformed_file_has_no_presets(void **state)
{
	struct bench *bench = *state;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct preset_file file = {.count = 7};

	assert_int_equal(setenv("LIMBER_ASSETS", bench->folder.text, 1), 0);
	write_file(bench, "[one]\nspeed = fast\n");
	assert_int_equal(preset_file_find(&file, &log), -EINVAL);
	assert_int_equal(file.count, 0);
	file.count = 7;
	assert_int_equal(
		preset_file_load(&file, bench->path.text, &log), -EINVAL);
	assert_int_equal(file.count, 0);
	assert_int_equal(log_capture_count(&capture, LOG_ERROR), 2);
	assert_contains(capture.sentence[0], "presets.ini:2");
}

static void test_a_missing_file_is_reported(void **state)
{
	struct bench *bench = *state;
	struct procedural_preset preset = procedural_preset_default();
	struct log quiet = log_to_stderr(LOG_ERROR);

	assert_true(preset_file_save(bench->path.text, &preset, &quiet) < 0);
}

static void run_tuner(struct bench *bench,
	void (*begin_run)(struct demo_run *run, const char *name),
	struct procedural_preset read[4])
{
	static const struct demo_press presses[] = {
		{0.2, BUTTON_RIGHT},                   /* attenuation, 0.3 */
		{0.6, BUTTON_RIGHT}, {1.0, BUTTON_UP}, /* amplitude, 0.3 */
		{1.4, BUTTON_LEFT}, {1.8, BUTTON_ENTER}};
	struct demo_run run;
	char text[1024];

	write_file(bench, "[mine]\nspeed = 7\n");
	assert_int_equal(setenv("LIMBER_ASSETS", bench->folder.text, 1), 0);
	begin_run(&run, "tuner");
	demo_run_to(&run, 3.0, 20, presses, (int)ARRAY_COUNT(presses));
	demo_run_draw(&run);
	assert_true(gl_recorder_result()->vertex_count > 1000);
	demo_run_end(&run);
	read_back(bench, text, sizeof(text));
	assert_int_equal(procedural_presets_parse(
				 text, bench->path.text, &bench->log, read, 4),
		1);
	assert_near(read[0].speed, 7.0, 0.0);
}

static void test_the_tuner_changes_and_saves(void **state)
{
	struct procedural_preset read[4];

	run_tuner(*state, demo_run_begin_saving, read);
	assert_near(read[0].attenuation, 0.4, 1e-6);
	assert_near(read[0].amplitude, 0.28, 1e-6);
}

static void test_a_tuner_that_may_not_save_writes_nothing(void **state)
{
	struct procedural_preset read[4];

	run_tuner(*state, demo_run_begin, read);
	assert_near(read[0].attenuation, 0.3, 1e-6);
	assert_near(read[0].amplitude, 0.3, 1e-6);
}

/* The file may have other presets in its place by now. */
static void test_the_tuner_reads_its_preset_again(void **state)
{
	static const struct demo_press presses[] = {
		{0.2, BUTTON_F9}, {0.6, BUTTON_RIGHT}, {1.0, BUTTON_ENTER}};
	struct bench *bench = *state;
	struct demo_run run;
	char text[1024];

	write_file(bench, "[mine]\nspeed = 7\n");
	assert_int_equal(setenv("LIMBER_ASSETS", bench->folder.text, 1), 0);
	demo_run_begin_saving(&run, "tuner");
	write_file(bench, "[other]\nspeed = 3\n[mine]\nspeed = 9\n");
	demo_run_to(&run, 2.0, 20, presses, (int)ARRAY_COUNT(presses));
	demo_run_end(&run);
	read_back(bench, text, sizeof(text));
	assert_string_equal(text,
		"[other]\nspeed = 3\n[mine]\nspeed = 9\n"
		"attenuation = 0.35\n");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(
			test_saving_changes_only_the_section, begin, end),
		cmocka_unit_test_setup_teardown(
			test_saving_keeps_what_is_behind_a_value, begin, end),
		cmocka_unit_test_setup_teardown(
			test_saving_finds_the_section_by_its_whole_name, begin,
			end),
		cmocka_unit_test_setup_teardown(
			test_a_saved_preset_is_read_back, begin, end),
		cmocka_unit_test_setup_teardown(
			test_the_programs_own_file_stays_as_it_is, begin, end),
		cmocka_unit_test(test_fields_change_in_steps_between_limits),
		cmocka_unit_test_setup_teardown(
			test_a_section_at_the_end_gets_lines_of_its_own, begin,
			end),
		cmocka_unit_test_setup_teardown(
			test_saving_keeps_the_lines_between_values, begin, end),
		cmocka_unit_test_setup_teardown(
			test_a_file_without_presets_has_the_default_one, begin,
			end),
		cmocka_unit_test_setup_teardown(
			test_a_malformed_file_has_no_presets, begin, end),
		cmocka_unit_test_setup_teardown(
			test_a_missing_file_is_reported, begin, end),
		cmocka_unit_test_setup_teardown(
			test_the_tuner_changes_and_saves, begin, end),
		cmocka_unit_test_setup_teardown(
			test_a_tuner_that_may_not_save_writes_nothing, begin,
			end),
		cmocka_unit_test_setup_teardown(
			test_the_tuner_reads_its_preset_again, begin, end),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
