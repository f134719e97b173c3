/* Interlaced video, and drivers whose pictures cannot be had or trusted. */
#include "platform/camera/v4l2/session.h"

#include "platform/base/compiler.h"
#include "tests/support/fake/v4l2_fake.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/videodev2.h>
#include <stdio.h>

static const struct v4l2_request request = {
	.path = "/dev/video7", .width = 32, .height = 24};

static struct v4l2_session begin(struct v4l2_fake *fake)
{
	struct v4l2_session session;

	v4l2_session_init(&session, &fake->calls, &request);
	return session;
}

static void end(struct v4l2_fake *fake, struct v4l2_session *session)
{
	v4l2_device_close(&session->device);
	v4l2_fake_end(fake);
}

/* Each answer to a request for progressive pictures, and then for woven ones. */
static void test_only_fields_that_make_one_picture_are_taken(void **state)
{
	static const struct {
		uint32_t field, interlaced;
		int taken; /* the field of the pictures; -1: refused */
	} cases[] = {
		{V4L2_FIELD_NONE, V4L2_FIELD_NONE, V4L2_FIELD_NONE},
		{V4L2_FIELD_ANY, V4L2_FIELD_NONE, V4L2_FIELD_ANY},
		{V4L2_FIELD_TOP, V4L2_FIELD_INTERLACED, V4L2_FIELD_TOP},
		{V4L2_FIELD_BOTTOM, V4L2_FIELD_INTERLACED, V4L2_FIELD_BOTTOM},
		{V4L2_FIELD_INTERLACED, V4L2_FIELD_ALTERNATE,
			V4L2_FIELD_INTERLACED},
		{V4L2_FIELD_INTERLACED_TB, V4L2_FIELD_ALTERNATE,
			V4L2_FIELD_INTERLACED_TB},
		{V4L2_FIELD_ALTERNATE, V4L2_FIELD_INTERLACED_BT,
			V4L2_FIELD_INTERLACED_BT},
		{V4L2_FIELD_SEQ_TB, V4L2_FIELD_INTERLACED, V4L2_FIELD_INTERLACED},
		{V4L2_FIELD_SEQ_BT, V4L2_FIELD_BOTTOM, V4L2_FIELD_BOTTOM},
		{V4L2_FIELD_ALTERNATE, V4L2_FIELD_ALTERNATE, -1},
		{V4L2_FIELD_SEQ_TB, V4L2_FIELD_SEQ_TB, -1},
		{V4L2_FIELD_SEQ_BT, V4L2_FIELD_ALTERNATE, -1},
		{99, 99, -1},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct v4l2_fake *fake = v4l2_fake_new();
		struct v4l2_session session = begin(fake);

		fake->field = cases[i].field;
		fake->interlaced = cases[i].interlaced;
		fake->ready = 1;
		assert_int_equal(
			v4l2_session_open(&session), cases[i].taken >= 0);
		if (cases[i].taken >= 0) {
			assert_int_equal(session.device.answer.fmt.pix.field,
				cases[i].taken);
			assert_true(v4l2_session_dequeue(&session, 20) >= 0);
		} else {
			assert_contains(session.device.reason,
				"fields of interlaced video apart: choose");
		}
		end(fake, &session);
	}
}

/* What the user asked for is refused with the same words. */
static void test_a_given_format_does_not_hide_the_reason(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	session.request.fourcc = V4L2_PIX_FMT_YUYV;
	fake->field = fake->interlaced = V4L2_FIELD_ALTERNATE;
	assert_false(v4l2_session_open(&session));
	assert_contains(session.device.reason, "interlaced");
	session.request.fourcc = V4L2_PIX_FMT_NV12;
	session.retry_at_ms = 0;
	assert_false(v4l2_session_open(&session));
	assert_contains(session.device.reason, "does not deliver NV12");
	end(fake, &session);
}

static void test_pictures_that_are_too_large_get_useful_advice(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	/* No size can be given that helps. */
	fake->large = CAMERA_SIDE_MAX + 2;
	assert_false(v4l2_session_open(&session));
	assert_contains(session.device.reason,
		"of 1x1 to 2048x2048 pixels, but 2050x2050 in rows of 4100 bytes: choose another camera");
	/* A smaller size does. */
	fake->large_above = 20;
	fake->side_least = 16;
	session.retry_at_ms = 0;
	assert_false(v4l2_session_open(&session));
	assert_contains(session.device.reason,
		"2050x2050 are too large: give a smaller size, such as 16x16");
	fake->large = 0;
	fake->stride_extra = 65536;
	session.retry_at_ms = 0;
	assert_false(v4l2_session_open(&session));
	assert_contains(session.device.reason, "choose another camera");
	fake->stride_extra = 0;
	session.retry_at_ms = 0;
	assert_true(v4l2_session_open(&session));
	end(fake, &session);
}

/* As a camera that has small pictures as YUYV, and raw ones of its sensor. */
static void test_a_format_whose_pictures_are_too_large_is_passed_over(
	void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->offered[0] = V4L2_PIX_FMT_UYVY;
	fake->offered[1] = V4L2_PIX_FMT_YUYV;
	fake->offered[2] = 0;
	fake->large_fourcc = V4L2_PIX_FMT_UYVY;
	fake->large = 3000;
	assert_true(v4l2_session_open(&session));
	assert_int_equal(
		session.device.answer.fmt.pix.pixelformat, V4L2_PIX_FMT_YUYV);
	assert_int_equal(session.device.width, 32);
	end(fake, &session);
}

/* The frame loop may be reading the first picture. */
static void test_a_buffer_that_comes_twice_is_a_failure(void **state)
{
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session = begin(fake);

	(void)state;
	fake->repeats = true;
	assert_true(v4l2_session_open(&session));
	fake->ready = 2;
	assert_int_equal(v4l2_session_dequeue(&session, 20), 0);
	assert_int_equal(v4l2_session_dequeue(&session, 20), -1);
	assert_int_equal(session.state, V4L2_FAILED);
	assert_contains(session.device.reason, "a buffer that it does not have");
	end(fake, &session);
}

/* A capture card without a signal must not hide the camera behind it. */
static void test_auto_passes_a_device_that_never_delivers(void **state)
{
	static const struct v4l2_request any = {.width = 32, .height = 24};
	struct v4l2_fake *fake = v4l2_fake_new();
	struct v4l2_session session;

	(void)state;
	v4l2_session_init(&session, &fake->calls, &any);
	assert_true(v4l2_session_open(&session));
	assert_string_equal(session.path, "/dev/video0");
	for (int silences = 1; silences < 66; silences++) {
		char next[32];

		while (session.state != V4L2_FAILED) {
			assert_int_equal(
				v4l2_session_dequeue(&session, 500), -1);
		}
		v4l2_session_close(&session);
		fake->now_ms += V4L2_RETRY_LAST_MS;
		assert_true(v4l2_session_open(&session));
		snprintf(next, sizeof(next), "/dev/video%d", silences % 64);
		assert_string_equal(session.path, next);
	}
	/* One that has delivered pictures is tried again first. */
	fake->ready = 1;
	assert_true(v4l2_session_dequeue(&session, 500) >= 0);
	while (session.state != V4L2_FAILED) {
		assert_int_equal(v4l2_session_dequeue(&session, 500), -1);
	}
	v4l2_session_close(&session);
	fake->now_ms += V4L2_RETRY_LAST_MS;
	assert_true(v4l2_session_open(&session));
	assert_string_equal(session.path, "/dev/video1");
	end(fake, &session);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_only_fields_that_make_one_picture_are_taken),
		cmocka_unit_test(test_a_given_format_does_not_hide_the_reason),
		cmocka_unit_test(
			test_pictures_that_are_too_large_get_useful_advice),
		cmocka_unit_test(
			test_a_format_whose_pictures_are_too_large_is_passed_over),
		cmocka_unit_test(test_a_buffer_that_comes_twice_is_a_failure),
		cmocka_unit_test(test_auto_passes_a_device_that_never_delivers),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
