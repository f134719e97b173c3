/* What a path that an option names would be written to. */
#include "platform/base/compiler.h"
#include "platform/base/output_path.h"
#include "tests/support/output_scene.h"
#include "tests/support/test.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void test_a_path_tells_what_would_be_written_to(void **state)
{
	struct output_scene *scene = *state;
	const char *path = scene->path.text;

	assert_int_equal(output_path_kind(path), OUTPUT_NEW);
	assert_int_equal(output_path_kind(scene->folder.text), OUTPUT_FOLDER);
	file_write(path, "", 0);
	assert_int_equal(output_path_kind(path), OUTPUT_FILE);
	assert_int_equal(unlink(path), 0);
	assert_int_equal(mkfifo(path, 0600), 0);
	assert_int_equal(output_path_kind(path), OUTPUT_STREAM);
	assert_int_equal(output_path_kind("/dev/null"), OUTPUT_STREAM);
	assert_int_equal(output_path_kind("/dev/stderr"), OUTPUT_STREAM);
	assert_int_equal(output_path_kind("/dev/fd/7"), OUTPUT_STREAM);
	assert_false(output_path_is_stream(scene->folder.text));
	assert_true(output_path_is_stream(path));
}

/* A shell's >FILE and >>FILE make standard output a regular file. */
static void test_standard_output_is_no_file_whatever_it_leads_to(void **state)
{
	struct output_scene *scene = *state;
	static const char *const names[] = {
		"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
	int kept = dup(STDOUT_FILENO);
	enum output_kind kind[3], linked;

	fflush(stdout);
	file_write(scene->path.text, "kept", 4);
	assert_non_null(freopen(scene->path.text, "a", stdout));
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		kind[i] = output_path_kind(names[i]);
	}
	assert_int_equal(unlink(scene->path.text), 0);
	assert_int_equal(symlink("/dev/stdout", scene->path.text), 0);
	linked = output_path_kind(scene->path.text);
	assert_true(dup2(kept, STDOUT_FILENO) >= 0);
	close(kept);
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		assert_int_equal(kind[i], OUTPUT_STDOUT);
	}
	assert_int_equal(linked, OUTPUT_STDOUT);
}

static void test_a_report_keeps_out_of_its_output(void **state)
{
	struct output_scene *scene = *state;

	assert_ptr_equal(output_path_report(NULL), stdout);
	assert_ptr_equal(output_path_report(scene->path.text), stdout);
	assert_ptr_equal(output_path_report("/dev/null"), stdout);
	assert_ptr_equal(output_path_report("/dev/stdout"), stderr);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(
			test_a_path_tells_what_would_be_written_to,
			output_scene_setup, output_scene_teardown),
		cmocka_unit_test_setup_teardown(
			test_standard_output_is_no_file_whatever_it_leads_to,
			output_scene_setup, output_scene_teardown),
		cmocka_unit_test_setup_teardown(
			test_a_report_keeps_out_of_its_output,
			output_scene_setup, output_scene_teardown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
