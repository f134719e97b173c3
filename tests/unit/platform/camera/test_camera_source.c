/* The V4L2 source with its thread, in real time. */
#include "platform/camera/v4l2/v4l2.h"

#include "tests/support/fake/v4l2_fake.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>
#include <time.h>

extern const struct camera_driver camera_driver_v4l2;

/* A source with a simulated device. */
struct rig {
	struct v4l2_fake *fake;
	struct log_capture capture;
	struct log log;
	struct camera_source *source;
	int last; /* number of the picture taken last */
};

static int64_t now_ms(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static void sleep_ms(int ms)
{
	struct timespec time = {
		.tv_sec = ms / 1000, .tv_nsec = (long)(ms % 1000) * 1000000};

	nanosleep(&time, NULL);
}

static void rig_prepare(struct rig *rig)
{
	*rig = (struct rig){.fake = v4l2_fake_new(), .last = -1};
	rig->log = log_capture_begin(&rig->capture);
	rig->fake->real_time = true;
	rig->fake->period_ms = 10;
}

static void rig_start(struct rig *rig)
{
	const struct camera_options options = {.argument = "/dev/video3",
		.width = 32,
		.height = 24,
		.log = &rig->log};

	assert_int_equal(
		v4l2_source_create(&options, &rig->fake->calls, &rig->source),
		0);
}

static void rig_finish(struct rig *rig)
{
	camera_driver_v4l2.destroy(rig->source);
	assert_false(rig->fake->open);
	assert_false(rig->fake->used_wrongly);
	assert_int_equal(rig->fake->maps, rig->fake->unmaps);
	v4l2_fake_free(rig->fake);
}

/* Takes a picture, which must be complete and newer than the last one. */
static enum camera_status rig_take(struct rig *rig)
{
	struct camera_image image;
	int64_t from_ms = now_ms();
	enum camera_status status =
		camera_driver_v4l2.take(rig->source, 0, &image);

	/* take() must not wait, but other programs may delay it. */
	assert_true(now_ms() - from_ms < 200);
	if (status == CAMERA_NEW) {
		int number = image.plane[0][0];

		for (int i = 0; i < image.stride_bytes[0] * image.height; i++) {
			assert_int_equal(image.plane[0][i], number);
		}
		assert_true(rig->last < 0 || ((number - rig->last) & 255) < 128);
		assert_int_not_equal(number, rig->last);
		rig->last = number;
		camera_driver_v4l2.give_back(rig->source);
	}
	return status;
}

/* Waits up to five seconds, because the machine may be busy. */
static void wait_for(struct rig *rig, enum camera_status wanted)
{
	int64_t until_ms = now_ms() + 5000;

	while (rig_take(rig) != wanted) {
		assert_true(now_ms() < until_ms);
		sleep_ms(2);
	}
}

static void test_new_pictures_are_handed_out(void **state)
{
	struct rig rig;

	(void)state;
	rig_prepare(&rig);
	rig_start(&rig);
	for (int i = 0; i < 20; i++) {
		wait_for(&rig, CAMERA_NEW);
	}
	assert_int_equal(rig.capture.count, 0);
	rig_finish(&rig);
}

static void test_pictures_that_nobody_took_are_dropped(void **state)
{
	struct rig rig;
	int before, made;

	(void)state;
	rig_prepare(&rig);
	rig_start(&rig);
	wait_for(&rig, CAMERA_NEW);
	before = rig.last;
	sleep_ms(200);
	made = v4l2_fake_get(rig.fake, &rig.fake->next);
	wait_for(&rig, CAMERA_NEW);
	/* The newest picture or nearly so, not the next one. */
	assert_true(rig.last - before > 2);
	assert_true(rig.last >= made - 2);
	rig_finish(&rig);
}

static void test_a_picture_in_use_does_not_change(void **state)
{
	struct camera_image image;
	struct rig rig;
	int number;

	(void)state;
	rig_prepare(&rig);
	rig_start(&rig);
	camera_driver_v4l2.await(rig.source, 5000);
	assert_int_equal(
		camera_driver_v4l2.take(rig.source, 0, &image), CAMERA_NEW);
	number = image.plane[0][0];
	sleep_ms(200);
	assert_int_equal(image.plane[0][0], number);
	assert_int_equal(image.plane[0][100], number);
	camera_driver_v4l2.give_back(rig.source);
	assert_true(v4l2_fake_get(rig.fake, &rig.fake->next) > number + 3);
	wait_for(&rig, CAMERA_NEW);
	rig_finish(&rig);
}

static void test_two_buffers_do_not_stall(void **state)
{
	struct rig rig;

	(void)state;
	rig_prepare(&rig);
	rig.fake->buffers_most = 2;
	rig_start(&rig);
	for (int i = 0; i < 10; i++) {
		wait_for(&rig, CAMERA_NEW);
	}
	rig_finish(&rig);
}

/*
 * Waits until the driver has counted so far, without taking a picture; up to
 * ten seconds, as a busy machine may be slow.
 */
static void wait_for_count(struct rig *rig, const int *count, int wanted)
{
	int64_t until_ms = now_ms() + 10000;

	while (v4l2_fake_get(rig->fake, count) < wanted) {
		assert_true(now_ms() < until_ms);
		sleep_ms(2);
	}
}

static void test_an_unplugged_device_is_logged_once_and_comes_back(void **state)
{
	struct rig rig;

	(void)state;
	rig_prepare(&rig);
	rig_start(&rig);
	wait_for(&rig, CAMERA_NEW);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	wait_for(&rig, CAMERA_NONE);
	/* Two attempts fail. */
	wait_for_count(&rig, &rig.fake->opens, 3);
	assert_int_equal(rig_take(&rig), CAMERA_NONE);
	assert_true(v4l2_fake_get(rig.fake, &rig.fake->opens) > 2);
	assert_int_equal(log_capture_count(&rig.capture, LOG_WARNING), 1);
	assert_true(log_capture_has(&rig.capture, LOG_WARNING,
		"camera /dev/video3: it was unplugged"));
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, false);
	wait_for(&rig, CAMERA_NEW);
	assert_true(log_capture_has(&rig.capture, LOG_NOTE, "it is back"));
	/* A second outage is logged again. */
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	wait_for(&rig, CAMERA_NONE);
	assert_int_equal(log_capture_count(&rig.capture, LOG_WARNING), 2);
	rig_finish(&rig);
}

static void test_an_outage_between_two_frames_is_logged_with_its_end(
	void **state)
{
	struct rig rig;

	(void)state;
	rig_prepare(&rig);
	rig_start(&rig);
	wait_for(&rig, CAMERA_NEW);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	wait_for_count(&rig, &rig.fake->opens, 2);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, false);
	wait_for_count(&rig, &rig.fake->next,
		v4l2_fake_get(rig.fake, &rig.fake->next) + 3);
	wait_for(&rig, CAMERA_NEW);
	assert_int_equal(log_capture_count(&rig.capture, LOG_WARNING), 1);
	assert_true(log_capture_has(&rig.capture, LOG_WARNING,
		"camera /dev/video3: it was unplugged"));
	assert_true(log_capture_has(&rig.capture, LOG_NOTE, "it is back"));

	/* Of two such outages the second one goes on. */
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	wait_for_count(&rig, &rig.fake->opens,
		v4l2_fake_get(rig.fake, &rig.fake->opens) + 1);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, false);
	wait_for_count(&rig, &rig.fake->next,
		v4l2_fake_get(rig.fake, &rig.fake->next) + 3);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	wait_for_count(&rig, &rig.fake->opens,
		v4l2_fake_get(rig.fake, &rig.fake->opens) + 2);
	wait_for(&rig, CAMERA_NONE);
	assert_int_equal(log_capture_count(&rig.capture, LOG_WARNING), 2);
	assert_int_equal(log_capture_count(&rig.capture, LOG_NOTE), 1);
	rig_finish(&rig);
}

static void test_a_device_that_is_busy_is_tried_again(void **state)
{
	struct rig rig;

	(void)state;
	rig_prepare(&rig);
	rig.fake->format_error = -EBUSY;
	rig_start(&rig);
	sleep_ms(600);
	assert_int_equal(rig_take(&rig), CAMERA_NONE);
	assert_int_equal(log_capture_count(&rig.capture, LOG_WARNING), 1);
	assert_true(log_capture_has(
		&rig.capture, LOG_WARNING, "another program is using it"));
	pthread_mutex_lock(&rig.fake->lock);
	rig.fake->format_error = 0;
	pthread_mutex_unlock(&rig.fake->lock);
	wait_for(&rig, CAMERA_NEW);
	rig_finish(&rig);
}

/* The thread is blocked in DQBUF, so take() logs the silence. */
static void test_silence_is_logged_although_the_driver_blocks(void **state)
{
	struct rig rig;

	(void)state;
	rig_prepare(&rig);
	rig.fake->vendor = true;
	rig.fake->buffers_most = 3;
	rig.fake->block_ms = 3500;
	rig.fake->period_ms = 0;
	rig.fake->ready = 1;
	rig_start(&rig);
	wait_for(&rig, CAMERA_NEW);
	assert_int_equal(rig_take(&rig), CAMERA_SAME);
	sleep_ms(2100);
	rig_take(&rig);
	assert_int_equal(rig_take(&rig), CAMERA_NONE);
	assert_int_equal(log_capture_count(&rig.capture, LOG_WARNING), 1);
	assert_true(log_capture_has(
		&rig.capture, LOG_WARNING, "no picture for 2 s"));
	/* The driver returns from DQBUF. */
	pthread_mutex_lock(&rig.fake->lock);
	rig.fake->period_ms = 10;
	rig.fake->next_due_ms = now_ms();
	pthread_mutex_unlock(&rig.fake->lock);
	wait_for(&rig, CAMERA_NEW);
	rig_finish(&rig);
}

static void test_destroy_returns_soon_although_the_driver_blocks(void **state)
{
	struct rig rig;
	int64_t from_ms;

	(void)state;
	rig_prepare(&rig);
	rig.fake->vendor = true;
	rig.fake->buffers_most = 3;
	rig.fake->block_ms = 1500;
	rig.fake->period_ms = 0;
	rig_start(&rig);
	sleep_ms(100);
	from_ms = now_ms();
	camera_driver_v4l2.destroy(rig.source);
	assert_true(now_ms() - from_ms < 1000);
	/* When the driver returns, the thread releases everything. */
	sleep_ms(2000);
	assert_int_equal(v4l2_fake_get(rig.fake, &rig.fake->closes), 1);
	assert_int_equal(rig.fake->maps, rig.fake->unmaps);
	assert_false(rig.fake->used_wrongly);
	v4l2_fake_free(rig.fake);
}

static void test_await_waits_for_a_picture_but_not_for_a_missing_device(
	void **state)
{
	struct rig rig;
	int64_t from_ms;

	(void)state;
	rig_prepare(&rig);
	rig_start(&rig);
	camera_driver_v4l2.await(rig.source, 5000);
	assert_int_equal(rig_take(&rig), CAMERA_NEW);
	rig_finish(&rig);
	rig_prepare(&rig);
	rig.fake->open_error = -ENOENT;
	from_ms = now_ms();
	rig_start(&rig);
	camera_driver_v4l2.await(rig.source, 5000);
	assert_true(now_ms() - from_ms < 2500);
	assert_int_equal(rig_take(&rig), CAMERA_NONE);
	rig_finish(&rig);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_new_pictures_are_handed_out),
		cmocka_unit_test(test_pictures_that_nobody_took_are_dropped),
		cmocka_unit_test(test_a_picture_in_use_does_not_change),
		cmocka_unit_test(test_two_buffers_do_not_stall),
		cmocka_unit_test(
			test_an_unplugged_device_is_logged_once_and_comes_back),
		cmocka_unit_test(
			test_an_outage_between_two_frames_is_logged_with_its_end),
		cmocka_unit_test(test_a_device_that_is_busy_is_tried_again),
		cmocka_unit_test(
			test_silence_is_logged_although_the_driver_blocks),
		cmocka_unit_test(
			test_destroy_returns_soon_although_the_driver_blocks),
		cmocka_unit_test(
			test_await_waits_for_a_picture_but_not_for_a_missing_device),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
