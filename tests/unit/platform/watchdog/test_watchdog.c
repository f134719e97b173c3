#define _GNU_SOURCE

#include "platform/base/compiler.h"
#include "platform/watchdog/watchdog.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/watchdog.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
	FAKE_FD = 0 /* a descriptor like any other */
};

/* A simulated watchdog and what was written to it. */
static struct {
	char fed[64];
	int fed_count;
	int open_count;
	int set_count; /* calls that change its timeout; must stay 0 */
	int timeout_s; /* 0 if it cannot be read */
	int open_error, write_error;
} fake;

static int fake_open(const char *path, int flags)
{
	assert_string_equal(path, "/dev/wd");
	assert_int_equal(flags, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
	if (fake.open_error) {
		errno = fake.open_error;
		return -1;
	}
	fake.open_count++;
	return FAKE_FD;
}

static int fake_close(int fd)
{
	assert_int_equal(fd, FAKE_FD);
	fake.open_count--;
	return 0;
}

static ssize_t fake_write(int fd, const void *data, size_t size)
{
	assert_int_equal(fd, FAKE_FD);
	if (fake.write_error) {
		errno = fake.write_error;
		return -1;
	}
	assert_true(fake.fed_count + (int)size <= (int)sizeof(fake.fed));
	memcpy(fake.fed + fake.fed_count, data, size);
	fake.fed_count += (int)size;
	return (ssize_t)size;
}

static int fake_ioctl(int fd, unsigned long request, void *argument)
{
	assert_int_equal(fd, FAKE_FD);
	if (request != WDIOC_GETTIMEOUT) {
		fake.set_count++;
	}
	if (request != WDIOC_GETTIMEOUT || !fake.timeout_s) {
		errno = ENOTTY;
		return -1;
	}
	memcpy(argument, &fake.timeout_s, sizeof(int));
	return 0;
}

static const struct device_calls calls = {
	.open = fake_open,
	.close = fake_close,
	.write = fake_write,
	.ioctl = fake_ioctl,
};

static int forget(void **state)
{
	(void)state;
	memset(&fake, 0, sizeof(fake));
	return 0;
}

static void test_it_is_fed_once_a_second(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct watchdog watchdog;

	(void)state;
	fake.timeout_s = 2;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	assert_true(log_capture_has(&capture, LOG_NOTE,
		"/dev/wd: it restarts the board after 2 s"));
	assert_int_equal(fake.fed_count, 0);
	for (int64_t now_ms = -5000; now_ms <= 5000; now_ms += 10) {
		watchdog_feed(&watchdog, now_ms);
	}
	assert_int_equal(fake.fed_count, 11);
	assert_null(memchr(fake.fed, 'V', 11));
	watchdog_close(&watchdog);
	assert_int_equal(fake.fed[fake.fed_count - 1], 'V');
	assert_int_equal(fake.open_count, 0);
	assert_int_equal(fake.set_count, 0);
	assert_int_equal(log_capture_count(&capture, LOG_WARNING), 0);
	watchdog_feed(&watchdog, 100000);
	watchdog_close(&watchdog);
	assert_int_equal(fake.fed_count, 12);
}

static void test_a_timeout_of_one_second_is_met(void **state)
{
	struct log log = log_to_nowhere();
	struct watchdog watchdog;

	(void)state;
	fake.timeout_s = 1;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	for (int64_t now_ms = 0; now_ms < 2000; now_ms += 10) {
		watchdog_feed(&watchdog, now_ms);
	}
	assert_int_equal(fake.fed_count, 8);
	watchdog_close(&watchdog);
}

static double seconds_left(const struct watchdog *watchdog)
{
	struct itimerspec left = {0};

	assert_int_equal(timer_gettime(watchdog->timer, &left), 0);
	return (double)left.it_value.tv_sec +
		(double)left.it_value.tv_nsec * 1e-9;
}

static void test_feeding_moves_the_end_of_a_silent_process(void **state)
{
	const struct timespec pause = {.tv_nsec = 20000000};
	struct log log = log_to_nowhere();
	struct watchdog watchdog;

	(void)state;
	fake.timeout_s = 60;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	assert_in_range(seconds_left(&watchdog) * 1000.0, 57000, 58000);
	nanosleep(&pause, NULL);
	assert_in_range(seconds_left(&watchdog) * 1000.0, 1, 57981);
	watchdog_feed(&watchdog, 0);
	assert_in_range(seconds_left(&watchdog) * 1000.0, 57982, 58000);
	watchdog_close(&watchdog);
}

static void test_a_silent_process_ends_before_the_board_restarts(void **state)
{
	struct log log = log_to_nowhere();
	struct watchdog watchdog;
	int status = 0;
	pid_t child;

	(void)state;
	fake.timeout_s = 5;
	child = fork();
	if (child == 0) {
		(void)watchdog_open(&watchdog, "/dev/wd", &calls, &log);
		watchdog_feed(&watchdog, 0);
		sleep(20);
		_exit(0);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_true(WIFSIGNALED(status));
	assert_int_equal(WTERMSIG(status), SIGALRM);
}

static void test_the_longest_timeout_is_an_hour(void **state)
{
	struct log log = log_to_nowhere();
	struct watchdog watchdog;

	(void)state;
	fake.timeout_s = 3600;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	assert_in_range(seconds_left(&watchdog) * 1000.0, 3590000, 3598000);
	watchdog_close(&watchdog);
}

/* The process that has closed it may be silent. */
static void test_closing_it_ends_the_timer(void **state)
{
	struct log log = log_to_nowhere();
	struct itimerspec left = {0};
	struct watchdog watchdog;
	timer_t timer;

	(void)state;
	fake.timeout_s = 60;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	timer = watchdog.timer;
	watchdog_close(&watchdog);
	assert_int_equal(timer_gettime(timer, &left), -1);
	assert_int_equal(errno, EINVAL);
}

static void test_absurd_timeouts_set_no_timer(void **state)
{
	static const int timeouts_s[] = {INT_MIN, -1, 1, 4, 3601, INT_MAX};
	struct log log = log_to_nowhere();

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct watchdog watchdog;

		fake.timeout_s = timeouts_s[i];
		assert_int_equal(
			watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
		assert_int_equal(watchdog.limit_s, 0);
		watchdog_close(&watchdog);
	}
}

static void test_a_missing_watchdog_is_logged_once(void **state)
{
	static const int errors[] = {
		ENOENT, ENODEV, EBUSY, EACCES, EPERM, ENOTDIR};
	static const char *const advice[] = {"load its driver",
		"load its driver", "stop that program", "run as root",
		"run as root", "such as /dev/watchdog"};
	struct watchdog watchdog;

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);

		fake.open_error = errors[i];
		assert_int_equal(
			watchdog_open(&watchdog, "/dev/wd", &calls, &log),
			-errors[i]);
		assert_int_equal(capture.count, 1);
		assert_int_equal(capture.level[0], LOG_WARNING);
		assert_contains(capture.sentence[0], "/dev/wd");
		assert_contains(capture.sentence[0], advice[i]);
		watchdog_feed(&watchdog, 0);
		watchdog_close(&watchdog);
		assert_int_equal(fake.fed_count, 0);
	}
}

static void test_a_watchdog_that_cannot_be_fed_is_logged(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct watchdog watchdog;

	(void)state;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	fake.write_error = EIO;
	watchdog_feed(&watchdog, 0);
	assert_true(log_capture_has(&capture, LOG_WARNING, "cannot be fed"));
	watchdog_close(&watchdog);
	assert_int_equal(fake.open_count, 0);
}

/* A message each second would fill the board's disk. */
static void test_only_a_change_of_feeding_is_logged(void **state)
{
	static const struct {
		int error;
		const char *sentence; /* NULL: none */
	} seconds[] = {{EIO, "cannot be fed: Input/output error"}, {EIO, NULL},
		{EINTR, NULL}, {EIO, NULL},
		{ENODEV, "cannot be fed: No such device"}, {ENODEV, NULL},
		{0, "is fed again"}, {0, NULL}, {EINTR, NULL}, {0, NULL},
		{EIO, "cannot be fed: Input/output error"}};
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct watchdog watchdog;

	(void)state;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	for (int i = 0; i < (int)ARRAY_COUNT(seconds); i++) {
		capture.count = 0;
		fake.write_error = seconds[i].error;
		watchdog_feed(&watchdog, i * 1000);
		assert_int_equal(capture.count, seconds[i].sentence != NULL);
		if (seconds[i].sentence) {
			assert_contains(
				capture.sentence[0], seconds[i].sentence);
		}
	}
	fake.write_error = 0;
	watchdog_close(&watchdog);
}

/* It is fed again in a second. */
static void test_an_interrupted_call_is_no_warning(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct watchdog watchdog;

	(void)state;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	fake.write_error = EINTR;
	watchdog_feed(&watchdog, 0);
	fake.write_error = 0;
	assert_int_equal(capture.count, 0);
	watchdog_close(&watchdog);
}

static void test_a_watchdog_that_cannot_be_stopped_is_logged(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct watchdog watchdog;

	(void)state;
	assert_int_equal(watchdog_open(&watchdog, "/dev/wd", &calls, &log), 0);
	fake.write_error = EIO;
	watchdog_close(&watchdog);
	assert_int_equal(capture.count, 1);
	assert_true(log_capture_has(&capture, LOG_WARNING, "cannot be stopped"));
}

static void test_a_real_file_is_fed(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "watchdog");
	struct log log = log_to_nowhere();
	struct watchdog watchdog;
	size_t size;
	char *fed;

	(void)state;
	file_write(path.text, "", 0);
	assert_int_equal(
		watchdog_open(&watchdog, path.text, &device_calls_system, &log),
		0);
	watchdog_feed(&watchdog, 0);
	watchdog_feed(&watchdog, 1);
	watchdog_close(&watchdog);
	fed = file_read(path.text, &size);
	assert_int_equal(size, 2);
	assert_memory_equal(fed, "\0V", 2);
	free(fed);
	temp_dir_remove(&folder);
}

/* Feeding it would destroy that; nothing is opened. */
static void expect_data(const char *path)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct watchdog watchdog;

	assert_int_equal(watchdog_open(&watchdog, path, &calls, &log), -EEXIST);
	assert_int_equal(capture.count, 1);
	assert_int_equal(capture.level[0], LOG_WARNING);
	assert_contains(capture.sentence[0], path);
	assert_contains(capture.sentence[0], "it holds data");
	assert_int_equal(watchdog.fd, -1);
	assert_int_equal(fake.open_count, 0);
}

static void test_a_file_with_one_byte_is_no_watchdog(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "watchdog");

	(void)state;
	file_write(path.text, "1", 1);
	expect_data(path.text);
	temp_dir_remove(&folder);
}

static void test_a_block_device_is_no_watchdog(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "watchdog");
	bool made = mknod(path.text, S_IFBLK | 0600, makedev(7, 7)) == 0;

	(void)state;
	if (made) {
		expect_data(path.text);
	}
	temp_dir_remove(&folder);
	if (!made) {
		skip_because("only root can make a device");
	}
}

static void test_a_device_of_characters_may_be_one(void **state)
{
	struct log log = log_to_nowhere();
	struct watchdog watchdog;

	(void)state;
	assert_int_equal(watchdog_open(&watchdog, "/dev/null",
				 &device_calls_system, &log),
		0);
	watchdog_close(&watchdog);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(test_it_is_fed_once_a_second, forget),
		cmocka_unit_test_setup(
			test_a_timeout_of_one_second_is_met, forget),
		cmocka_unit_test_setup(
			test_feeding_moves_the_end_of_a_silent_process, forget),
		cmocka_unit_test_setup(
			test_a_silent_process_ends_before_the_board_restarts,
			forget),
		cmocka_unit_test_setup(
			test_the_longest_timeout_is_an_hour, forget),
		cmocka_unit_test_setup(test_closing_it_ends_the_timer, forget),
		cmocka_unit_test_setup(test_absurd_timeouts_set_no_timer, forget),
		cmocka_unit_test_setup(
			test_a_missing_watchdog_is_logged_once, forget),
		cmocka_unit_test_setup(
			test_a_watchdog_that_cannot_be_fed_is_logged, forget),
		cmocka_unit_test_setup(
			test_only_a_change_of_feeding_is_logged, forget),
		cmocka_unit_test_setup(
			test_an_interrupted_call_is_no_warning, forget),
		cmocka_unit_test_setup(
			test_a_watchdog_that_cannot_be_stopped_is_logged, forget),
		cmocka_unit_test_setup(test_a_real_file_is_fed, forget),
		cmocka_unit_test_setup(
			test_a_file_with_one_byte_is_no_watchdog, forget),
		cmocka_unit_test_setup(
			test_a_block_device_is_no_watchdog, forget),
		cmocka_unit_test_setup(
			test_a_device_of_characters_may_be_one, forget),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
