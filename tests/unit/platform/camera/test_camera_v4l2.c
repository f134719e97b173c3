#include "platform/camera/v4l2/session.h"

#include "platform/camera/v4l2/format.h"
#include "tests/support/fake/v4l2_fake.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const struct v4l2_request request = {
	.path = "/dev/video7", .width = 37, .height = 27};

static struct v4l2_session begin(struct v4l2_fake *fake)
{
	struct v4l2_session session;

	v4l2_session_init(&session, &fake->calls, &request);
	return session;
}

/*
 * Closes the session, whose device may be closed again, and checks that
 * everything was released once.
 */
static void end(struct v4l2_fake *fake, struct v4l2_session *session)
{
	v4l2_device_close(&session->device);
	v4l2_device_close(&session->device);
	v4l2_fake_end(fake);
}

static int first_byte(const struct v4l2_session *session, int index)
{
	struct camera_image image = v4l2_device_image(&session->device, index);

	return image.plane[0][0];
}

static void test_a_common_driver_delivers_pictures(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);
	struct camera_image image;
	int index;

	(void)state;
	fake->stride_extra = 6;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(session.state, V4L2_OPEN);
	assert_string_equal(fake->path, "/dev/video7");
	assert_int_equal(fake->queued, V4L2_BUFFERS);
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(session.state, V4L2_OPEN);
	fake->ready = 1;
	index = v4l2_session_dequeue(&session, 20);
	assert_in_range(index, 0, V4L2_BUFFERS - 1);
	assert_int_equal(session.state, V4L2_ALIVE);
	image = v4l2_device_image(&session.device, index);
	assert_int_equal(image.format, CAMERA_YUYV);
	assert_int_equal(image.width, 36);
	assert_int_equal(image.height, 26);
	assert_int_equal(image.stride_bytes[0], 36 * 2 + 6);
	assert_int_equal(v4l2_device_queued(&session.device), 2);
	v4l2_session_queue(&session, index);
	assert_int_equal(v4l2_device_queued(&session.device), 3);
	end(fake, &session);
}

static void test_the_vendor_driver_delivers_pictures(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);
	struct camera_image image;

	(void)state;
	fake->vendor = true;
	fake->offered[0] = V4L2_PIX_FMT_NV12;
	fake->buffers_most = 3;
	fake->block_ms = 10000;
	assert_true(v4l2_session_open(&session));
	fake->ready = 2;
	for (int i = 0; i < 2; i++) {
		int index = v4l2_session_dequeue(&session, 20);

		assert_true(index >= 0);
		assert_int_equal(first_byte(&session, index), i);
		image = v4l2_device_image(&session.device, index);
		v4l2_session_queue(&session, index);
	}
	assert_int_equal(image.format, CAMERA_NV12);
	assert_int_equal(image.width, 32);
	assert_int_equal(image.height, 24);
	/* Then DQBUF blocks for ten seconds, which counts as silence. */
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(session.state, V4L2_FAILED);
	assert_contains(session.device.reason, "no picture for 2 s");
	end(fake, &session);
}

/* The format chosen among those of a driver. */
static void test_the_cheapest_format_is_chosen(void **state)
{
	static const struct {
		uint32_t offered[4];
		const char *wanted;
		enum camera_format format;
	} cases[] = {
		{{V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}, NULL, CAMERA_YUYV},
		{{V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_UYVY, V4L2_PIX_FMT_RGB565},
			NULL, CAMERA_RGB565},
		{{V4L2_PIX_FMT_UYVY, V4L2_PIX_FMT_YUYV}, NULL, CAMERA_UYVY},
		{{V4L2_PIX_FMT_YUV420, V4L2_PIX_FMT_NV12}, NULL, CAMERA_NV12},
		{{V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_YUV420}, "yuv420",
			CAMERA_YUV420},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct v4l2_fake *fake = v4l2_fake_new();
		struct v4l2_session session = begin(fake);

		memcpy(fake->offered, cases[i].offered,
			sizeof(cases[i].offered));
		if (cases[i].wanted) {
			session.request.fourcc =
				v4l2_format_find(cases[i].wanted);
		}
		assert_true(v4l2_session_open(&session));
		assert_int_equal(session.device.format, cases[i].format);
		end(fake, &session);
	}
}

static void test_format_names_and_codes_are_found(void **state)
{
	char text[5];

	(void)state;
	assert_int_equal(v4l2_format_find("uyvy"), V4L2_PIX_FMT_UYVY);
	assert_int_equal(v4l2_format_find("yuv420"), V4L2_PIX_FMT_YUV420);
	assert_int_equal(v4l2_format_find("mjpg"), V4L2_PIX_FMT_MJPEG);
	assert_int_equal(v4l2_format_find("nothing"), 0);
	v4l2_format_text(V4L2_PIX_FMT_MJPEG, text);
	assert_string_equal(text, "MJPG");
	v4l2_format_text(0x01020304, text);
	assert_string_equal(text, "????");
}

/* Checks that opening fails for this reason. */
static void assert_refused(struct v4l2_fake *fake, const char *reason)
{
	struct v4l2_session session = begin(fake);

	assert_false(v4l2_session_open(&session));
	assert_int_equal(session.state, V4L2_CLOSED);
	assert_contains(session.device.reason, reason);
	end(fake, &session);
}

static void test_the_reason_names_why_a_device_does_not_open(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();

	(void)state;
	fake->open_error = -ENOENT;
	assert_refused(fake, "plug it in");
	fake = v4l2_fake_new();
	fake->open_error = -EACCES;
	assert_refused(fake, "group video");
	fake = v4l2_fake_new();
	fake->format_error = -EBUSY;
	assert_refused(fake, "another program");
	fake = v4l2_fake_new();
	fake->buffers_most = 1;
	assert_refused(fake, "not enough memory");
	fake = v4l2_fake_new();
	fake->offered[0] = 0;
	assert_refused(fake, "single-planar");
}

static void test_two_buffers_are_enough(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->buffers_most = 2;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(session.device.buffer_count, 2);
	fake->ready = 1;
	assert_true(v4l2_session_dequeue(&session, 20) >= 0);
	end(fake, &session);
}

static void test_damaged_and_short_pictures_are_queued_again(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	assert_true(v4l2_session_open(&session));
	fake->damaged = true;
	fake->ready = 1;
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(fake->queued, 3);
	fake->damaged = false;
	fake->short_of = true;
	fake->ready = 1;
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(fake->queued, 3);
	fake->short_of = false;
	fake->excess = true;
	fake->ready = 1;
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(fake->queued, 3);
	fake->excess = false;
	fake->ready = 1;
	assert_true(v4l2_session_dequeue(&session, 20) >= 0);
	end(fake, &session);
}

static void test_an_unplugged_device_is_opened_again(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	assert_true(v4l2_session_open(&session));
	fake->unplugged = true;
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(session.state, V4L2_FAILED);
	assert_contains(session.device.reason, "unplugged");
	v4l2_session_close(&session);
	assert_int_equal(session.state, V4L2_CLOSED);
	fake->unplugged = false;
	/* It is too early; true, because nothing failed. */
	assert_true(v4l2_session_open(&session));
	assert_int_equal(session.state, V4L2_CLOSED);
	fake->now_ms += V4L2_RETRY_FIRST_MS;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(session.state, V4L2_OPEN);
	fake->ready = 1;
	assert_true(v4l2_session_dequeue(&session, 20) >= 0);
	end(fake, &session);
}

/* Once an hour; each time it fails in another call than the last time. */
static void test_a_camera_may_come_and_go_for_a_month(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);
	const int64_t hour_ms = 3600000;
	int refused = 0;

	(void)state;
	for (int hour = 1; hour <= 30 * 24; hour++) {
		fake->unplugged = false;
		fake->open_error = hour % 3 == 1 ? -ENODEV : 0;
		fake->format_error = hour % 3 == 2 ? -EIO : 0;
		refused += fake->open_error != 0;
		assert_int_equal(v4l2_session_open(&session), hour % 3 == 0);
		fake->now_ms = hour * hour_ms;
		fake->open_error = fake->format_error = 0;
		assert_true(v4l2_session_open(&session));
		assert_int_equal(session.state, V4L2_OPEN);
		fake->ready = 1;
		assert_true(v4l2_session_dequeue(&session, 20) >= 0);
		fake->unplugged = true;
		assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
		v4l2_session_close(&session);
		assert_int_equal(fake->closes, fake->opens - refused);
		assert_int_equal(fake->unmaps, fake->maps);
		fake->now_ms += hour_ms / 2;
	}
	fake->unplugged = false;
	end(fake, &session);
}

static void test_each_failure_doubles_the_wait(void **state)
{
	static const int waits_ms[] = {250, 500, 1000, 2000, 2000, 2000};
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->open_error = -EBUSY;
	for (size_t i = 0; i < ARRAY_COUNT(waits_ms); i++) {
		assert_false(v4l2_session_open(&session));
		fake->now_ms += waits_ms[i] - 1;
		assert_true(v4l2_session_open(&session));
		assert_int_equal(fake->opens, i + 1);
		fake->now_ms++;
	}
	/* After a picture the next wait is short again. */
	fake->open_error = 0;
	assert_true(v4l2_session_open(&session));
	fake->ready = 1;
	assert_true(v4l2_session_dequeue(&session, 20) >= 0);
	v4l2_session_close(&session);
	fake->now_ms += V4L2_RETRY_FIRST_MS;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(session.state, V4L2_OPEN);
	end(fake, &session);
}

static void test_a_silent_device_fails_after_two_seconds(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);
	int64_t from_ms;

	(void)state;
	/* The silence begins when the device is opened. */
	fake->now_ms = V4L2_SILENCE_MS;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(session.state, V4L2_OPEN);
	fake->now_ms += 500;
	fake->ready = 1;
	assert_true(v4l2_session_dequeue(&session, 20) >= 0);
	from_ms = fake->now_ms;
	while (session.state != V4L2_FAILED) {
		assert_int_equal(v4l2_session_dequeue(&session, 100), -1);
		assert_true(fake->now_ms - from_ms <= V4L2_SILENCE_MS);
	}
	assert_int_equal(fake->now_ms - from_ms, V4L2_SILENCE_MS);
	end(fake, &session);
}

static void test_temporary_errors_are_no_failure(void **state)
{
	static const int passing[] = {-EAGAIN, -EIO, -ETIME};
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	assert_true(v4l2_session_open(&session));
	for (size_t i = 0; i < ARRAY_COUNT(passing); i++) {
		fake->dequeue_error = passing[i];
		assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
		assert_int_equal(session.state, V4L2_OPEN);
	}
	fake->dequeue_error = -EINVAL;
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(session.state, V4L2_FAILED);
	end(fake, &session);
}

static void test_a_session_that_was_never_opened_closes_nothing(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	v4l2_device_close(&session.device);
	assert_int_equal(fake->closes, 0);
	end(fake, &session);
}

static void test_a_device_that_takes_no_buffer_back_has_failed(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);
	int index;

	(void)state;
	assert_true(v4l2_session_open(&session));
	fake->ready = 2;
	index = v4l2_session_dequeue(&session, 20);
	v4l2_session_queue(&session, index);
	assert_int_equal(session.state, V4L2_ALIVE);
	index = v4l2_session_dequeue(&session, 20);
	fake->unplugged = true;
	v4l2_session_queue(&session, index);
	assert_int_equal(session.state, V4L2_FAILED);
	end(fake, &session);
}

/* YVYU swaps Cr and Cb and needs libv4lconvert. Bytes of 128 are grey. */
static void test_other_formats_go_through_the_library(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);
	struct camera_image image;
	bool opened;
	int index;

	(void)state;
	fake->offered[0] = V4L2_PIX_FMT_YVYU;
	opened = v4l2_session_open(&session);
	if (!opened) {
		assert_contains(session.device.reason, "YVYU");
		assert_contains(session.device.reason, "libv4lconvert");
		end(fake, &session);
		skip_because("libv4lconvert is not installed");
	}
	fake->next = 128;
	fake->ready = 1;
	index = v4l2_session_dequeue(&session, 20);
	assert_true(index >= 0);
	image = v4l2_device_image(&session.device, index);
	assert_int_equal(image.format, CAMERA_RGB24);
	assert_int_equal(image.stride_bytes[0], 36 * 3);
	for (int i = 0; i < 36 * 26 * 3; i++) {
		assert_near(image.plane[0][i], 128, 4);
	}
	end(fake, &session);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_common_driver_delivers_pictures),
		cmocka_unit_test(test_the_vendor_driver_delivers_pictures),
		cmocka_unit_test(test_the_cheapest_format_is_chosen),
		cmocka_unit_test(test_format_names_and_codes_are_found),
		cmocka_unit_test(
			test_the_reason_names_why_a_device_does_not_open),
		cmocka_unit_test(test_two_buffers_are_enough),
		cmocka_unit_test(
			test_damaged_and_short_pictures_are_queued_again),
		cmocka_unit_test(test_an_unplugged_device_is_opened_again),
		cmocka_unit_test(test_a_camera_may_come_and_go_for_a_month),
		cmocka_unit_test(test_each_failure_doubles_the_wait),
		cmocka_unit_test(test_a_silent_device_fails_after_two_seconds),
		cmocka_unit_test(test_temporary_errors_are_no_failure),
		cmocka_unit_test(
			test_a_session_that_was_never_opened_closes_nothing),
		cmocka_unit_test(
			test_a_device_that_takes_no_buffer_back_has_failed),
		cmocka_unit_test(test_other_formats_go_through_the_library),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
