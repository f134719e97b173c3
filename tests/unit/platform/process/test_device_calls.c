#include "platform/process/device_calls.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

static const struct device_calls *const calls = &device_calls_system;

static void test_what_is_written_into_a_mapping_is_in_the_file(void **state)
{
	struct test_path folder = temp_dir_make();
	char path[600], text[8] = "";
	char *mapped;
	int fd;

	(void)state;
	snprintf(path, sizeof(path), "%s/device", folder.text);
	fd = open(path, O_RDWR | O_CREAT, 0600);
	assert_int_equal(ftruncate(fd, 8192), 0);
	close(fd);
	fd = calls->open(path, O_RDWR);
	assert_true(fd >= 0);
	assert_int_equal(calls->write(fd, "camera", 6), 6);
	mapped = calls->map(fd, 4096, 4096);
	assert_ptr_not_equal(mapped, MAP_FAILED);
	mapped[1] = '7';
	assert_int_equal(calls->unmap(mapped, 4096), 0);
	assert_int_equal(pread(fd, text, 6, 0), 6);
	assert_string_equal(text, "camera");
	assert_int_equal(pread(fd, text, 2, 4096), 2);
	assert_int_equal(text[1], '7');
	assert_int_equal(calls->close(fd), 0);
	temp_dir_remove(&folder);
}

static void test_a_call_that_a_device_lacks_fails(void **state)
{
	int waiting = -1, ends[2];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	assert_int_equal(write(ends[1], "five!", 5), 5);
	assert_int_equal(device_control(calls, ends[0], FIONREAD, &waiting), 0);
	assert_int_equal(waiting, 5);
	assert_int_equal(
		device_control(calls, ends[0], TIOCGWINSZ, &waiting), -1);
	assert_int_equal(errno, ENOTTY);
	close(ends[0]);
	close(ends[1]);
}

static int interruptions;

static int interrupted_ioctl(int fd, unsigned long request, void *argument)
{
	(void)fd;
	(void)request;
	(void)argument;
	errno = EINTR;
	return interruptions-- > 0 ? -1 : 3;
}

static void test_an_interrupted_call_is_repeated(void **state)
{
	const struct device_calls busy = {.ioctl = interrupted_ioctl};

	(void)state;
	interruptions = 5;
	assert_int_equal(device_control(&busy, 0, 0, NULL), 3);
	assert_int_equal(interruptions, -1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_what_is_written_into_a_mapping_is_in_the_file),
		cmocka_unit_test(test_a_call_that_a_device_lacks_fails),
		cmocka_unit_test(test_an_interrupted_call_is_repeated),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
