/* The system's calls for cameras, on files and pipes, which answer them, too. */
#include "platform/camera/v4l2/v4l2_calls.h"
#include "tests/support/test.h"

#include <errno.h>
#include <sys/ioctl.h>
#include <unistd.h>

static const struct v4l2_calls *const calls = &v4l2_calls_real;

static void test_a_request_gives_0_or_its_error(void **state)
{
	int ends[2], waiting = -1;

	(void)state;
	assert_int_equal(pipe(ends), 0);
	assert_int_equal(write(ends[1], "abc", 3), 3);
	errno = EPIPE;
	assert_int_equal(calls->ioctl(NULL, ends[0], FIONREAD, &waiting), 0);
	assert_int_equal(waiting, 3);
	assert_int_equal(
		calls->ioctl(NULL, ends[0], TIOCGWINSZ, &waiting), -ENOTTY);
	calls->close(NULL, ends[0]);
	assert_int_equal(
		calls->ioctl(NULL, ends[0], FIONREAD, &waiting), -EBADF);
	calls->close(NULL, ends[1]);
}

static void test_waiting_ends_with_a_picture_or_in_time(void **state)
{
	int64_t begun_ms = calls->now_ms(NULL);
	int ends[2];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	assert_int_equal(calls->wait(NULL, ends[0], 20), 0);
	assert_in_range(calls->now_ms(NULL) - begun_ms, 20, 10000);
	assert_int_equal(write(ends[1], "a", 1), 1);
	assert_int_equal(calls->wait(NULL, ends[0], 10000), 1);
	calls->close(NULL, ends[0]);
	calls->close(NULL, ends[1]);
}

static void test_a_device_is_opened_and_its_memory_shared(void **state)
{
	static const char path[] = "/dev/zero", missing[] = "/dev/no-camera";
	int fd = calls->open(NULL, path);
	char *memory;

	(void)state;
	assert_true(calls->exists(NULL, path));
	assert_false(calls->exists(NULL, missing));
	assert_int_equal(calls->open(NULL, missing), -ENOENT);
	assert_true(fd > 0);
	memory = calls->map(NULL, fd, 4096, 0);
	assert_non_null(memory);
	memory[4095] = 1;
	calls->unmap(NULL, memory, 4096);
	assert_null(calls->map(NULL, fd, 4096, 1));
	calls->close(NULL, fd);
	assert_null(calls->map(NULL, fd, 4096, 0));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_request_gives_0_or_its_error),
		cmocka_unit_test(test_waiting_ends_with_a_picture_or_in_time),
		cmocka_unit_test(test_a_device_is_opened_and_its_memory_shared),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
