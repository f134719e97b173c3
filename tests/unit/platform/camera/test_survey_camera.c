#define _GNU_SOURCE /* syscall() */
#include "platform/camera/v4l2/v4l2.h"
#include "tests/support/fake/v4l2_fake.h"
#include "tests/support/survey_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/videodev2.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

/* The simulated machine has /dev/video2 only. */
struct machine {
	struct v4l2_fake *fake;
	struct v4l2_calls calls;
	int slow_ms;    /* how long open() blocks */
	uint32_t lacks; /* capabilities to remove */
};

/* How many seconds the machine's calendar is behind. */
static time_t calendar_behind_s;

/* In place of the C library's. */
int clock_gettime(clockid_t id, struct timespec *out)
{
#ifdef SYS_clock_gettime64
	int result = (int)syscall(SYS_clock_gettime64, id, out);
#else
	int result = (int)syscall(SYS_clock_gettime, id, out);
#endif

	if (id == CLOCK_REALTIME) {
		out->tv_sec -= calendar_behind_s;
	}
	return result;
}

static void pass(int ms)
{
	const struct timespec time = {
		.tv_sec = ms / 1000, .tv_nsec = (long)(ms % 1000) * 1000000};

	nanosleep(&time, NULL);
}

static int64_t now_ms(void)
{
	return v4l2_calls_real.now_ms(NULL);
}

static bool is_there(void *user, const char *path)
{
	(void)user;
	return strcmp(path, "/dev/video2") == 0;
}

static int open_one(void *user, const char *path)
{
	struct machine *machine = user;

	if (strcmp(path, "/dev/video2") != 0) {
		return -ENOENT;
	}
	pass(machine->slow_ms);
	return machine->fake->calls.open(machine->fake, path);
}

static void close_one(void *user, int fd)
{
	struct machine *machine = user;

	machine->fake->calls.close(machine->fake, fd);
}

/* A survey must not change the device or take it. */
static int ask_one(void *user, int fd, unsigned long request, void *argument)
{
	struct machine *machine = user;
	struct v4l2_capability *capability = argument;
	int error;

	if (request != VIDIOC_QUERYCAP && request != VIDIOC_ENUM_FMT) {
		machine->fake->used_wrongly = true;
	}
	error = machine->fake->calls.ioctl(machine->fake, fd, request, argument);
	if (!error && request == VIDIOC_QUERYCAP) {
		capability->capabilities &= ~machine->lacks;
	}
	return error;
}

static int setup(void **state)
{
	struct machine *machine = calloc(1, sizeof(*machine));

	assert_non_null(machine);
	machine->fake = v4l2_fake_new();
	machine->calls = machine->fake->calls;
	machine->calls.exists = is_there;
	machine->calls.open = open_one;
	machine->calls.close = close_one;
	machine->calls.ioctl = ask_one;
	machine->calls.user = machine;
	*state = machine;
	return 0;
}

static int teardown(void **state)
{
	struct machine *machine = *state;

	assert_false(machine->fake->used_wrongly);
	assert_int_equal(machine->fake->opens,
		machine->fake->closes +
			(machine->fake->open_error ? machine->fake->opens : 0));
	v4l2_fake_free(machine->fake);
	free(machine);
	return 0;
}

static void look(struct machine *machine, struct survey_capture *capture)
{
	const struct survey survey = survey_capture_begin(capture, NULL);

	v4l2_survey_on(&machine->calls, &survey);
	assert_int_equal(capture->count, 1);
}

static void test_a_camera_is_reported_with_its_formats(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->fake->offered[0] = V4L2_PIX_FMT_MJPEG;
	machine->fake->offered[1] = V4L2_PIX_FMT_UYVY;
	look(machine, &capture);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/dev/video2",
		"Fake camera, driver fake: (MJPG) UYVY", NULL);
}

static void test_a_driver_that_lists_no_formats_is_reported(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->fake->vendor = true;
	look(machine, &capture);
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/dev/video2",
		"lists no formats", NULL);
}

static void test_a_device_that_does_not_capture_is_unused(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->lacks = V4L2_CAP_VIDEO_CAPTURE;
	look(machine, &capture);
	survey_capture_expect(&capture, 0, SURVEY_UNUSED, "/dev/video2",
		"captures no video", NULL);
}

static void test_a_camera_in_use_is_taken(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->fake->open_error = -EBUSY;
	look(machine, &capture);
	survey_capture_expect(&capture, 0, SURVEY_TAKEN, "/dev/video2",
		"another program", "sudo fuser -v /dev/video2");
}

static void test_a_camera_without_permission_is_broken(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->fake->open_error = -EACCES;
	look(machine, &capture);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/video2",
		"no permission", "root");
	machine->fake->open_error = -EIO;
	look(machine, &capture);
	survey_capture_expect(
		&capture, 0, SURVEY_BROKEN, "/dev/video2", "", "dmesg");
}

static void test_no_camera_is_one_finding(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->fake->open_error = -ENOENT;
	look(machine, &capture);
	survey_capture_expect(&capture, 0, SURVEY_MISSING, "/dev/video*",
		"no camera", "--camera pattern");
}

static void wait_for_closes(struct machine *machine, int count)
{
	while (v4l2_fake_get(machine->fake, &machine->fake->closes) < count) {
		pass(20);
	}
	pass(50);
}

static void test_a_thread_blocked_in_a_driver_is_abandoned(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;
	int64_t begun_ms = now_ms();

	machine->slow_ms = 3000;
	look(machine, &capture);
	assert_true(now_ms() - begun_ms < 2500);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/video2",
		"does not answer within", "dmesg");
	/* The thread ends by itself and releases its data. */
	wait_for_closes(machine, 1);
}

/* Without a clock that is kept on, a board's calendar begins in 1970. */
static void test_a_slow_camera_is_waited_for_in_any_year(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;

	machine->slow_ms = 200;
	calendar_behind_s = 56 * 365 * 86400;
	look(machine, &capture);
	calendar_behind_s = 0;
	survey_capture_expect(&capture, 0, SURVEY_WORKS, "/dev/video2",
		"Fake camera, driver fake", NULL);
}

static void test_a_blocked_camera_is_abandoned_in_any_year(void **state)
{
	struct machine *machine = *state;
	struct survey_capture capture;
	int64_t begun_ms = now_ms();

	machine->slow_ms = 3000;
	calendar_behind_s = -3600;
	look(machine, &capture);
	calendar_behind_s = 0;
	assert_true(now_ms() - begun_ms < 2500);
	survey_capture_expect(&capture, 0, SURVEY_BROKEN, "/dev/video2",
		"does not answer within", "dmesg");
	wait_for_closes(machine, 1);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_a_camera_is_reported_with_its_formats),
		CASE(test_a_driver_that_lists_no_formats_is_reported),
		CASE(test_a_device_that_does_not_capture_is_unused),
		CASE(test_a_camera_in_use_is_taken),
		CASE(test_a_camera_without_permission_is_broken),
		CASE(test_no_camera_is_one_finding),
		CASE(test_a_thread_blocked_in_a_driver_is_abandoned),
		CASE(test_a_slow_camera_is_waited_for_in_any_year),
		CASE(test_a_blocked_camera_is_abandoned_in_any_year),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
