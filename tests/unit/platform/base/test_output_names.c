/*
 * Names of temporary files that other files have. While the clock stands still,
 * a process draws the same names again, as two processes may by chance.
 */
#include "platform/base/output_file.h"
#include "tests/support/output_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>
#include <time.h>

enum {
	NAMES = 100 /* that are tried */
};

int clock_gettime(clockid_t clock, struct timespec *out)
{
	(void)clock;
	*out = (struct timespec){.tv_sec = 5, .tv_nsec = 7};
	return 0;
}

/* Begins as many files as there are names, all of which become the same one. */
static int begin_all(
	struct output_scene *scene, struct output_file **file, int count)
{
	int begun = 0;

	for (int error = 0; begun < count && !error; begun += !error) {
		error = output_file_create(
			scene->path.text, &scene->log, &file[begun]);
	}
	return begun;
}

static void test_a_name_that_is_taken_is_drawn_again(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file[3];

	assert_int_equal(begin_all(scene, file, 3), 3);
	assert_int_equal(temp_dir_count(&scene->folder), 3);
	for (int i = 0; i < 3; i++) {
		fprintf(output_file_stream(file[i]), "%d", i);
		assert_int_equal(output_file_commit(file[i]), 0);
		assert_int_equal(temp_dir_count(&scene->folder), 3 - i);
		output_scene_expect(
			scene->path.text, (const char[]){(char)('0' + i), 0});
	}
}

static void test_after_100_names_a_file_is_refused(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file[NAMES + 1];

	assert_int_equal(begin_all(scene, file, NAMES + 1), NAMES);
	assert_null(file[NAMES]);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], strerror(EEXIST));
	assert_int_equal(temp_dir_count(&scene->folder), NAMES);
	for (int i = 0; i < NAMES; i++) {
		output_file_discard(file[i]);
	}
	assert_int_equal(temp_dir_count(&scene->folder), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(
			test_a_name_that_is_taken_is_drawn_again,
			output_scene_setup, output_scene_teardown),
		cmocka_unit_test_setup_teardown(
			test_after_100_names_a_file_is_refused,
			output_scene_setup, output_scene_teardown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
