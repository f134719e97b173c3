/*
 * What wakes the thread of a V4L2 source, what it gives back and how it ends.
 * The functions below replace the timed lock and what ends a thread: long waits
 * last much longer, so that it shows when nothing but the time has ended one.
 */
#define _GNU_SOURCE /* pthread_timedjoin_np() */

#include "platform/camera/v4l2/v4l2.h"

#include "platform/camera/v4l2/v4l2_thread.h"
#include "platform/process/clock.h"
#include "tests/support/fake/v4l2_fake.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/videodev2.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

extern const struct camera_driver camera_driver_v4l2;

enum {
	EMPTY_MS = 5,
	WAIT_MS = 100,
	LEAVE_MS = 300,
	LONGER = 20
};

static struct {
	bool as_long; /* waits last as long as they should */
	int error;    /* of making a lock */
	/* Waits by their length; and those of WAIT_MS and more that timed out. */
	atomic_int empty, wait, leave, other, overslept;
	atomic_int destroyed, joined, detached;
} lock;

int v4l2_timed_lock_init(struct v4l2_timed_lock *made)
{
	pthread_condattr_t attributes;

	pthread_condattr_init(&attributes);
	pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
	pthread_cond_init(&made->changed, &attributes);
	pthread_condattr_destroy(&attributes);
	pthread_mutex_init(&made->mutex, NULL);
	return lock.error;
}

void v4l2_timed_lock_destroy(struct v4l2_timed_lock *unused)
{
	pthread_cond_destroy(&unused->changed);
	pthread_mutex_destroy(&unused->mutex);
	lock.destroyed++;
}

static struct timespec after_ms(clockid_t clock, int ms)
{
	struct timespec until;

	clock_gettime(clock, &until);
	until.tv_sec += ms / 1000;
	until.tv_nsec += (long)(ms % 1000) * 1000000;
	if (until.tv_nsec >= 1000000000) {
		until.tv_sec++;
		until.tv_nsec -= 1000000000;
	}
	return until;
}

bool v4l2_timed_lock_wait(struct v4l2_timed_lock *held, int timeout_ms)
{
	bool is_long = timeout_ms == WAIT_MS || timeout_ms == LEAVE_MS;
	struct timespec until = after_ms(CLOCK_MONOTONIC,
		is_long && !lock.as_long ? timeout_ms * LONGER : timeout_ms);
	bool changed;

	lock.empty += timeout_ms == EMPTY_MS;
	lock.wait += timeout_ms == WAIT_MS;
	lock.leave += timeout_ms == LEAVE_MS;
	lock.other += !is_long && timeout_ms != EMPTY_MS;
	changed = pthread_cond_timedwait(
			  &held->changed, &held->mutex, &until) == 0;
	lock.overslept += is_long && !changed;
	return changed;
}

int pthread_join(pthread_t thread, void **result)
{
	const struct timespec until = after_ms(CLOCK_REALTIME, 10000);

	lock.joined++;
	return pthread_timedjoin_np(thread, result, &until);
}

int pthread_detach(pthread_t thread)
{
	(void)thread;
	lock.detached++;
	return 0;
}

/* A source with a device that has a picture when a test says so. */
struct rig {
	struct v4l2_fake *fake;
	struct log_capture capture;
	struct log log;
	struct camera_source *source;
};

static void prepare(struct rig *rig)
{
	*rig = (struct rig){.fake = v4l2_fake_new()};
	rig->log = log_capture_begin(&rig->capture);
	rig->fake->real_time = true;
	rig->fake->ready = 1;
	lock.as_long = false;
	lock.error = 0;
	lock.empty = lock.wait = lock.leave = lock.other = lock.overslept = 0;
	lock.destroyed = lock.joined = lock.detached = 0;
}

static int start(struct rig *rig, const char *path, const char *format)
{
	const struct camera_options options = {.argument = path,
		.format = format,
		.width = 32,
		.height = 24,
		.log = &rig->log};

	return v4l2_source_create(&options, &rig->fake->calls, &rig->source);
}

static void begin(struct rig *rig)
{
	assert_int_equal(start(rig, "/dev/video3", NULL), 0);
}

/* Ends the source, which a change must have told its thread. */
static void end(struct rig *rig)
{
	camera_driver_v4l2.destroy(rig->source);
	assert_int_equal(lock.overslept, 0);
	assert_int_equal(lock.other, 0);
	assert_int_equal(lock.destroyed, 1);
	assert_int_equal(lock.joined, 1);
	assert_int_equal(lock.detached, 0);
	assert_false(rig->fake->used_wrongly);
	assert_int_equal(rig->fake->maps, rig->fake->unmaps);
	v4l2_fake_free(rig->fake);
}

static void sleep_a_little(int64_t since_ms)
{
	const struct timespec time = {.tv_nsec = 1000000};

	assert_true(clock_monotonic_ms() - since_ms < 10000);
	nanosleep(&time, NULL);
}

static void await_waits(atomic_int *count, int wanted)
{
	int64_t since_ms = clock_monotonic_ms();

	while (*count < wanted) {
		sleep_a_little(since_ms);
	}
}

static void await_calls(struct rig *rig, const int *count, int wanted)
{
	int64_t since_ms = clock_monotonic_ms();

	while (v4l2_fake_get(rig->fake, count) != wanted) {
		sleep_a_little(since_ms);
	}
}

static void make_picture(struct rig *rig)
{
	pthread_mutex_lock(&rig->fake->lock);
	rig->fake->ready++;
	pthread_mutex_unlock(&rig->fake->lock);
}

/* Waits until the thread has published a picture. */
static void await_picture(struct rig *rig)
{
	int64_t since_ms = clock_monotonic_ms();

	camera_driver_v4l2.await(rig->source, 8000);
	assert_true(clock_monotonic_ms() - since_ms < 5000);
	lock.other = 0;
}

static enum camera_status take(struct rig *rig, struct camera_image *image)
{
	return camera_driver_v4l2.take(rig->source, 0, image);
}

static void test_the_end_wakes_a_thread_that_waits_for_a_device(void **state)
{
	struct rig rig;

	(void)state;
	prepare(&rig);
	rig.fake->open_error = -ENOENT;
	begin(&rig);
	await_waits(&lock.wait, 1);
	end(&rig);
	assert_int_equal(lock.leave, 1);
	assert_int_equal(lock.empty, 0);
}

/* It has buffer 0, which stays mapped as long as it is in use. */
static void test_a_picture_given_back_wakes_a_thread_that_closes(void **state)
{
	struct camera_image image;
	struct rig rig;

	(void)state;
	prepare(&rig);
	begin(&rig);
	await_picture(&rig);
	assert_int_equal(take(&rig, &image), CAMERA_NEW);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	await_waits(&lock.wait, 1);
	assert_int_equal(v4l2_fake_get(rig.fake, &rig.fake->unmaps), 0);
	assert_int_equal(image.plane[0][0], 0);
	camera_driver_v4l2.give_back(rig.source);
	await_calls(&rig, &rig.fake->closes, 1);
	assert_int_equal(take(&rig, &image), CAMERA_NONE);
	end(&rig);
}

static void test_the_end_gives_back_a_picture_that_is_in_use(void **state)
{
	struct camera_image image;
	struct rig rig;

	(void)state;
	prepare(&rig);
	begin(&rig);
	await_picture(&rig);
	assert_int_equal(take(&rig, &image), CAMERA_NEW);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	await_waits(&lock.wait, 1);
	end(&rig);
}

static void test_a_picture_of_a_closed_device_is_not_handed_out(void **state)
{
	struct camera_image image;
	struct rig rig;

	(void)state;
	prepare(&rig);
	begin(&rig);
	await_picture(&rig);
	v4l2_fake_set(rig.fake, &rig.fake->unplugged, true);
	await_calls(&rig, &rig.fake->closes, 1);
	assert_int_equal(take(&rig, &image), CAMERA_NONE);
	end(&rig);
}

/* Each buffer in turn is taken and given back, and then dropped. */
static void test_each_buffer_comes_back_to_the_driver(void **state)
{
	struct camera_image image;
	struct rig rig;
	int queues = V4L2_BUFFERS;

	(void)state;
	prepare(&rig);
	begin(&rig);
	for (int i = 0; i < V4L2_BUFFERS; i++) {
		await_picture(&rig);
		assert_int_equal(take(&rig, &image), CAMERA_NEW);
		camera_driver_v4l2.give_back(rig.source);
		await_calls(&rig, &rig.fake->queues, ++queues);
		make_picture(&rig);
	}
	await_picture(&rig);
	for (int i = 0; i < V4L2_BUFFERS; i++) {
		make_picture(&rig);
		await_calls(&rig, &rig.fake->queues, ++queues);
	}
	end(&rig);
}

static void test_the_thread_pauses_while_the_driver_has_no_buffer(void **state)
{
	struct camera_image image;
	struct rig rig;

	(void)state;
	prepare(&rig);
	rig.fake->buffers_most = 2;
	begin(&rig);
	await_picture(&rig);
	assert_int_equal(take(&rig, &image), CAMERA_NEW);
	make_picture(&rig);
	await_picture(&rig);
	lock.empty = 0;
	await_waits(&lock.empty, 3);
	camera_driver_v4l2.give_back(rig.source);
	end(&rig);
}

static void test_the_thread_pauses_when_there_is_no_picture_yet(void **state)
{
	struct rig rig;

	(void)state;
	prepare(&rig);
	rig.fake->ready = 0;
	begin(&rig);
	await_waits(&lock.empty, 1);
	end(&rig);
}

/* As if the last picture were long ago. */
static void test_a_picture_ends_the_silence(void **state)
{
	struct camera_image image;
	struct rig rig;

	(void)state;
	prepare(&rig);
	begin(&rig);
	await_picture(&rig);
	assert_int_equal(take(&rig, &image), CAMERA_NEW);
	camera_driver_v4l2.give_back(rig.source);
	pthread_mutex_lock(&rig.source->lock.mutex);
	rig.source->heard_ms -= V4L2_SILENCE_MS;
	pthread_mutex_unlock(&rig.source->lock.mutex);
	make_picture(&rig);
	await_picture(&rig);
	assert_int_equal(take(&rig, &image), CAMERA_NEW);
	camera_driver_v4l2.give_back(rig.source);
	assert_int_equal(rig.capture.count, 0);
	end(&rig);
}

static sigset_t blocked;
static int (*fake_open)(void *user, const char *path);

static int open_by_thread(void *user, const char *path)
{
	pthread_sigmask(SIG_SETMASK, NULL, &blocked);
	return fake_open(user, path);
}

static void test_the_thread_leaves_signals_to_the_others(void **state)
{
	static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGALRM};
	/* Blocked, these would end limber without a handler. */
	static const int faults[] = {
		SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGSYS, SIGTRAP};
	sigset_t own;
	struct rig rig;

	(void)state;
	prepare(&rig);
	fake_open = rig.fake->calls.open;
	rig.fake->calls.open = open_by_thread;
	begin(&rig);
	await_picture(&rig);
	pthread_sigmask(SIG_SETMASK, NULL, &own);
	for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
		assert_int_equal(sigismember(&blocked, signals[i]), 1);
		assert_int_equal(sigismember(&own, signals[i]), 0);
	}
	for (size_t i = 0; i < ARRAY_COUNT(faults); i++) {
		assert_int_equal(sigismember(&blocked, faults[i]), 0);
	}
	end(&rig);
}

static void test_a_thread_that_the_driver_blocks_ends_later(void **state)
{
	struct rig rig;

	(void)state;
	prepare(&rig);
	lock.as_long = true;
	rig.fake->vendor = true;
	rig.fake->buffers_most = 3;
	rig.fake->ready = 0;
	rig.fake->block_ms = 600;
	begin(&rig);
	await_calls(&rig, &rig.fake->starts, 1);
	camera_driver_v4l2.destroy(rig.source);
	assert_int_equal(lock.joined, 0);
	assert_int_equal(lock.detached, 1);
	assert_int_equal(lock.destroyed, 0);
	await_waits(&lock.destroyed, 1);
	assert_int_equal(v4l2_fake_get(rig.fake, &rig.fake->closes), 1);
	v4l2_fake_free(rig.fake);
}

static void test_a_source_without_a_lock_is_an_error(void **state)
{
	struct rig rig;

	(void)state;
	prepare(&rig);
	lock.error = -EAGAIN;
	assert_int_equal(start(&rig, "/dev/video3", NULL), -EAGAIN);
	assert_true(log_capture_has(
		&rig.capture, LOG_ERROR, "--camera: cannot start its thread"));
	assert_int_equal(v4l2_fake_get(rig.fake, &rig.fake->opens), 0);
	v4l2_fake_free(rig.fake);
}

static void test_names_have_a_greatest_length(void **state)
{
	char path[V4L2_PATH_BYTES + 1], wanted[64];
	struct rig rig;

	(void)state;
	memset(path, 'x', sizeof(path));
	path[0] = '/';
	path[V4L2_PATH_BYTES] = '\0';
	prepare(&rig);
	assert_int_equal(start(&rig, path, NULL), -EINVAL);
	snprintf(wanted, sizeof(wanted), "give a name of at most %d characters",
		V4L2_PATH_BYTES - 1);
	assert_true(log_capture_has(&rig.capture, LOG_ERROR, wanted));
	path[V4L2_PATH_BYTES - 1] = '\0';
	assert_int_equal(start(&rig, path, NULL), 0);
	await_picture(&rig);
	assert_string_equal(rig.fake->path, path);
	end(&rig);
}

static void test_the_format_is_the_one_that_was_asked_for(void **state)
{
	struct camera_image image;
	struct rig rig;

	(void)state;
	prepare(&rig);
	rig.fake->offered[1] = V4L2_PIX_FMT_NV12;
	assert_int_equal(start(&rig, "/dev/video3", "nothing"), -EINVAL);
	assert_true(log_capture_has(&rig.capture, LOG_ERROR,
		"no such format: nothing: choose rgb565, uyvy"));
	assert_int_equal(start(&rig, "/dev/video3", "nv12"), 0);
	await_picture(&rig);
	assert_int_equal(take(&rig, &image), CAMERA_NEW);
	assert_int_equal(image.format, CAMERA_NV12);
	camera_driver_v4l2.give_back(rig.source);
	end(&rig);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_end_wakes_a_thread_that_waits_for_a_device),
		cmocka_unit_test(
			test_a_picture_given_back_wakes_a_thread_that_closes),
		cmocka_unit_test(
			test_the_end_gives_back_a_picture_that_is_in_use),
		cmocka_unit_test(
			test_a_picture_of_a_closed_device_is_not_handed_out),
		cmocka_unit_test(test_each_buffer_comes_back_to_the_driver),
		cmocka_unit_test(
			test_the_thread_pauses_while_the_driver_has_no_buffer),
		cmocka_unit_test(
			test_the_thread_pauses_when_there_is_no_picture_yet),
		cmocka_unit_test(test_a_picture_ends_the_silence),
		cmocka_unit_test(test_the_thread_leaves_signals_to_the_others),
		cmocka_unit_test(test_a_thread_that_the_driver_blocks_ends_later),
		cmocka_unit_test(test_a_source_without_a_lock_is_an_error),
		cmocka_unit_test(test_names_have_a_greatest_length),
		cmocka_unit_test(test_the_format_is_the_one_that_was_asked_for),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
