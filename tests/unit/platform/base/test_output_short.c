#define _DEFAULT_SOURCE /* syscall() */

/* Output files on a device that takes few bytes at a time, or none. */
#include "tests/support/output_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <sys/syscall.h>
#include <unistd.h>

/* How many bytes of a call the device takes; 0 leaves errno as it is. */
static size_t most = SIZE_MAX;

/* Replaces the C library's. */
ssize_t write(int fd, const void *bytes, size_t size)
{
	return most == 0 ? 0
			 : (ssize_t)syscall(SYS_write, fd, bytes,
				   size < most ? size : most);
}

static void test_a_write_of_few_bytes_goes_on(void **state)
{
	struct output_scene *scene = *state;

	most = 3;
	output_scene_write(scene, scene->path.text, "0123456789");
	most = SIZE_MAX;
	output_scene_expect(scene->path.text, "0123456789");
}

/* Neither an endless loop nor a success, whatever errno says. */
static void test_a_write_of_no_bytes_is_an_error(void **state)
{
	struct output_scene *scene = *state;
	struct output_file *file;

	output_scene_write(scene, scene->path.text, "old");
	file = output_scene_begin(scene, scene->path.text);
	fputs("new", output_file_stream(file));
	most = 0;
	errno = 0;
	assert_int_equal(output_file_commit(file), -EIO);
	most = SIZE_MAX;
	assert_int_equal(log_capture_count(&scene->logged, LOG_ERROR), 1);
	output_scene_expect(scene->path.text, "old");
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(test_a_write_of_few_bytes_goes_on,
			output_scene_setup, output_scene_teardown),
		cmocka_unit_test_setup_teardown(
			test_a_write_of_no_bytes_is_an_error,
			output_scene_setup, output_scene_teardown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
