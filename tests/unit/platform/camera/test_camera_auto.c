/* Which camera --camera auto takes, and what it says if there is none. */
#include "platform/base/compiler.h"
#include "platform/camera/v4l2/session.h"
#include "tests/support/fake/v4l2_fake.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/videodev2.h>
#include <stdlib.h>
#include <string.h>

enum {
	DEVICES = 64
};

/* What each of the devices answers; the functions carry the fake alone. */
static struct {
	struct v4l2_calls fake;
	int open[DEVICES], query[DEVICES]; /* -errno or 0 */
	uint32_t capabilities;             /* 0: those of the fake */
	int number; /* of the device that was opened last */
} devices;

static int open_device(void *user, const char *path)
{
	devices.number = atoi(path + strlen("/dev/video"));
	assert_in_range(devices.number, 0, DEVICES - 1);
	return devices.open[devices.number] ? devices.open[devices.number]
					    : devices.fake.open(user, path);
}

static int call_device(void *user, int fd, unsigned long request, void *argument)
{
	struct v4l2_capability *capability = argument;
	int error;

	if (request == VIDIOC_QUERYCAP && devices.query[devices.number]) {
		return devices.query[devices.number];
	}
	error = devices.fake.ioctl(user, fd, request, argument);
	if (request == VIDIOC_QUERYCAP && devices.capabilities) {
		capability->capabilities = devices.capabilities;
	}
	return error;
}

static struct v4l2_session begin(struct v4l2_fake *fake)
{
	const struct v4l2_request any = {.width = 32, .height = 24};
	struct v4l2_session session;

	memset(&devices, 0, sizeof(devices));
	devices.fake = fake->calls;
	fake->calls.open = open_device;
	fake->calls.ioctl = call_device;
	v4l2_session_init(&session, &fake->calls, &any);
	return session;
}

static void end(struct v4l2_fake *fake, struct v4l2_session *session)
{
	v4l2_device_close(&session->device);
	assert_false(fake->open);
	assert_false(fake->used_wrongly);
	v4l2_fake_free(fake);
}

static void test_auto_takes_the_first_device_that_captures(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->open_error = -ENOENT;
	assert_false(v4l2_session_open(&session));
	assert_contains(session.device.reason, "no /dev/video");
	assert_string_equal(session.path, "auto");
	assert_int_equal(fake->opens, 64);
	assert_string_equal(fake->path, "/dev/video63");
	/* It is too early to look again. */
	fake->open_error = 0;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(fake->opens, 64);
	fake->now_ms += V4L2_RETRY_FIRST_MS;
	assert_true(v4l2_session_open(&session));
	assert_string_equal(session.path, "/dev/video0");
	assert_string_equal(fake->path, "/dev/video0");
	end(fake, &session);
}

static void test_auto_passes_a_camera_that_it_cannot_use(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->format_error = -EBUSY;
	strcpy(fake->useless, "/dev/video0");
	assert_true(v4l2_session_open(&session));
	assert_int_equal(session.state, V4L2_OPEN);
	assert_string_equal(session.path, "/dev/video1");
	end(fake, &session);
}

static void test_auto_says_why_the_first_camera_is_of_no_use(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->open_error = -EACCES;
	assert_false(v4l2_session_open(&session));
	assert_string_equal(session.path, "/dev/video0");
	assert_contains(session.device.reason, "join the group video");
	end(fake, &session);
}

/* Unless it is no camera at all. */
static void test_auto_names_the_first_camera_of_no_use_and_its_reason(
	void **state)
{
	static const struct {
		int open, query;
		const char *reason; /* NULL: it is no camera */
	} rows[] = {
		{-ENOENT, 0, NULL},
		{-ENODEV, 0, NULL},
		{-ENXIO, 0, NULL},
		{0, -ENOTTY, NULL},
		{0, -EINVAL, NULL},
		{0, -ENODEV, NULL},
		{-EACCES, 0, "no permission"},
		{-EBUSY, 0, "another program is using it"},
		{-EIO, 0, "it cannot be opened"},
		{0, -EIO, "it does not tell what it can do"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct v4l2_fake *fake = v4l2_fake_new();
		struct v4l2_session session = begin(fake);

		for (int d = 0; d < DEVICES; d++) {
			devices.open[d] = -ENOENT;
		}
		devices.open[2] = rows[i].open;
		devices.query[2] = rows[i].query;
		assert_false(v4l2_session_open(&session));
		assert_string_equal(
			session.path, rows[i].reason ? "/dev/video2" : "auto");
		assert_contains(session.device.reason,
			rows[i].reason ? rows[i].reason
				       : "no /dev/video device captures video");
		assert_int_equal(session.state, V4L2_CLOSED);
		/* Another one behind it changes nothing, unless it works. */
		devices.open[5] = -EPERM;
		fake->now_ms += V4L2_RETRY_FIRST_MS;
		assert_false(v4l2_session_open(&session));
		assert_string_equal(session.path,
			rows[i].reason ? "/dev/video2" : "/dev/video5");
		devices.open[DEVICES - 1] = 0;
		fake->now_ms += 2 * V4L2_RETRY_FIRST_MS;
		assert_true(v4l2_session_open(&session));
		assert_string_equal(session.path, "/dev/video63");
		assert_int_equal(session.state, V4L2_OPEN);
		end(fake, &session);
	}
}

/* Of the whole device unless the driver tells what this node can do. */
static void test_a_device_has_to_capture_and_to_stream(void **state)
{
	static const struct {
		uint32_t capabilities;
		bool is_camera;
	} rows[] = {
		{V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING, true},
		{V4L2_CAP_VIDEO_CAPTURE, false},
		{V4L2_CAP_STREAMING, false},
		{V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING |
				V4L2_CAP_DEVICE_CAPS,
			false},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct v4l2_fake *fake = v4l2_fake_new();
		struct v4l2_session session = begin(fake);

		devices.capabilities = rows[i].capabilities;
		v4l2_session_open(&session);
		assert_int_equal(session.state == V4L2_OPEN, rows[i].is_camera);
		end(fake, &session);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_auto_takes_the_first_device_that_captures),
		cmocka_unit_test(test_auto_passes_a_camera_that_it_cannot_use),
		cmocka_unit_test(
			test_auto_says_why_the_first_camera_is_of_no_use),
		cmocka_unit_test(
			test_auto_names_the_first_camera_of_no_use_and_its_reason),
		cmocka_unit_test(test_a_device_has_to_capture_and_to_stream),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
