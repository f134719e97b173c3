/* The syntax of --camera, and the test picture. */
#include "platform/camera/camera.h"
#include "platform/camera/convert.h"
#include "platform/camera/motion.h"

#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static void assert_refused(const char *spec, const char *sentence)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct camera_feed feed;

	assert_int_equal(camera_feed_open(spec, &log, &feed), -EINVAL);
	assert_null(feed.driver);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], sentence);
	camera_feed_close(&feed);
}

static void test_a_wrong_spec_is_refused_with_its_reason(void **state)
{
	char long_spec[8192];

	(void)state;
	assert_refused("lens", "one of v4l2, pattern");
	assert_refused("pattern,", "a size or a format after the comma");
	assert_refused("pattern,320", "no size");
	assert_refused("pattern,320x", "no size");
	assert_refused("pattern,320x240x1", "no size");
	assert_refused("pattern,0x240", "no size");
	assert_refused("pattern,4096x240", "no size");
	assert_refused("pattern,9x9", "at least 16x16");
	assert_refused("pattern,blue", "no such format: blue");
	assert_refused("pattern:x", "no argument");
	assert_refused("/dev/video0,five5", "no such format: five5");
	memset(long_spec, '/', sizeof(long_spec) - 1);
	long_spec[sizeof(long_spec) - 1] = '\0';
	assert_refused(long_spec, "at most 4095 characters");
	long_spec[4096] = '\0';
	assert_refused(long_spec, "at most 4095 characters");
	/* Its sentence is cut behind the name. */
	long_spec[4095] = '\0';
	assert_refused(long_spec, "--camera //");
	long_spec[500] = '\0';
	assert_refused(long_spec, "a name of at most");
}

static struct camera_feed open_feed(const char *spec)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct camera_feed feed;

	assert_int_equal(camera_feed_open(spec, &log, &feed), 0);
	return feed;
}

static void test_a_spec_is_checked_without_a_device(void **state)
{
	static const char *const good[] = {
		"auto", "/dev/video0,640x480", "pattern", "v4l2"};
	static const char *const wrong[] = {
		"", "nosuch", "auto,", "pattern,0x5", "auto,1x", ",320x240"};
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	for (int i = 0; i < 4; i++) {
		assert_int_equal(camera_feed_check(good[i], &log), 0);
	}
	assert_int_equal(capture.count, 0);
	for (int i = 0; i < 6; i++) {
		assert_int_equal(camera_feed_check(wrong[i], &log), -EINVAL);
		assert_int_equal(capture.count, i + 1);
	}
}

static void test_a_device_that_is_missing_is_no_error(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct camera_image image;
	struct camera_feed feed;

	(void)state;
	assert_int_equal(
		camera_feed_open("/dev/no-such-camera", &log, &feed), 0);
	feed.driver->await(feed.source, 5000);
	assert_int_equal(feed.driver->take(feed.source, 0, &image), CAMERA_NONE);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0],
		"camera /dev/no-such-camera: no such device");
	camera_feed_close(&feed);
	camera_feed_close(&feed);
}

static void test_the_pattern_depends_on_the_time_only(void **state)
{
	struct camera_feed feed = open_feed("pattern,64x48,rgb24");
	struct camera_image image;
	uint8_t first[64 * 48 * 3];

	(void)state;
	assert_int_equal(
		feed.driver->take(feed.source, 400, &image), CAMERA_NEW);
	assert_int_equal(image.width, 64);
	assert_int_equal(image.height, 48);
	memcpy(first, image.plane[0], sizeof(first));
	feed.driver->give_back(feed.source);
	assert_int_equal(
		feed.driver->take(feed.source, 410, &image), CAMERA_SAME);
	assert_int_equal(
		feed.driver->take(feed.source, 440, &image), CAMERA_NEW);
	assert_memory_not_equal(first, image.plane[0], sizeof(first));
	feed.driver->give_back(feed.source);
	assert_int_equal(
		feed.driver->take(feed.source, 400, &image), CAMERA_NEW);
	assert_memory_equal(first, image.plane[0], sizeof(first));
	camera_feed_close(&feed);
}

/* Converts the test picture in a format to RGB565. */
static void convert_pattern(
	const char *format, struct camera_scaler *scaler, uint16_t out[48][64])
{
	const struct camera_part all = {0, 0, 64, 48};
	struct camera_image image;
	struct camera_feed feed;
	char spec[64] = "pattern,64x48,";

	strcat(spec, format);
	feed = open_feed(spec);
	assert_int_equal(feed.driver->take(feed.source, 0, &image), CAMERA_NEW);
	camera_convert(scaler, &image, &all, 64, 48, out[0], 64);
	camera_feed_close(&feed);
}

/* Whether all neighbours are equal, so that subsampled chroma is exact. */
static bool is_even_around(uint16_t (*color)[64], int x, int y)
{
	for (int i = 0; i < 9; i++) {
		if (color[y - 1 + i / 3][x - 1 + i % 3] != color[y][x]) {
			return false;
		}
	}
	return true;
}

static void test_all_formats_show_the_same(void **state)
{
	static const char *const formats[CAMERA_FORMATS] = {
		"rgb565", "uyvy", "yuyv", "nv12", "yuv420", "rgb24", "bgr24"};
	static uint16_t wanted[48][64], got[48][64];
	struct camera_scaler *scaler = malloc(sizeof(*scaler));
	int compared = 0;

	(void)state;
	assert_non_null(scaler);
	convert_pattern("rgb24", scaler, wanted);
	for (int format = 0; format < CAMERA_FORMATS; format++) {
		convert_pattern(formats[format], scaler, got);
		for (int i = 0; i < 46 * 62; i++) {
			int x = 1 + i % 62, y = 1 + i / 62;

			if (!is_even_around(wanted, x, y)) {
				continue;
			}
			assert_near(got[y][x] >> 11, wanted[y][x] >> 11, 1);
			assert_near(
				got[y][x] >> 5 & 63, wanted[y][x] >> 5 & 63, 2);
			assert_near(got[y][x] & 31, wanted[y][x] & 31, 1);
			compared++;
		}
	}
	assert_true(compared > 1000 * CAMERA_FORMATS);
	free(scaler);
}

/* Returns a grey picture in a format with that luma. */
static struct camera_image grey(
	enum camera_format format, uint8_t *data, int value)
{
	struct camera_layout layout = camera_layout_of(format, 64, 48, 0);

	memset(data, value, (size_t)layout.size);
	return camera_image_at(format, 64, 48, &layout, data);
}

static void test_motion_is_the_change_of_luma(void **state)
{
	static const enum camera_format formats[] = {CAMERA_UYVY, CAMERA_YUYV,
		CAMERA_NV12, CAMERA_YUV420, CAMERA_RGB24, CAMERA_BGR24};
	static uint8_t data[64 * 48 * 3];

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(formats); i++) {
		struct camera_motion motion = {0};
		struct camera_image image = grey(formats[i], data, 100);

		assert_int_equal(camera_motion_feed(&motion, &image), 0);
		assert_int_equal(camera_motion_feed(&motion, &image), 0);
		image = grey(formats[i], data, 140);
		assert_int_equal(camera_motion_feed(&motion, &image), 40 * 256);
		image = grey(formats[i], data, 90);
		assert_int_equal(camera_motion_feed(&motion, &image), 50 * 256);
		/* Noise is ignored. */
		image = grey(formats[i], data, 96);
		assert_int_equal(camera_motion_feed(&motion, &image), 0);
		camera_motion_reset(&motion);
		image = grey(formats[i], data, 200);
		assert_int_equal(camera_motion_feed(&motion, &image), 0);
	}
}

static void test_motion_is_proportional_to_the_moving_area(void **state)
{
	static uint8_t data[64 * 48 * 3];
	struct camera_motion motion = {0};
	struct camera_image image = grey(CAMERA_YUV420, data, 50);

	(void)state;
	camera_motion_feed(&motion, &image);
	memset(data, 90, 64 * 12);
	assert_int_equal(camera_motion_feed(&motion, &image), 10 * 256);
}

static void test_motion_of_rgb565_is_measured_in_green(void **state)
{
	static uint8_t data[64 * 48 * 3];
	struct camera_motion motion = {0};
	struct camera_image image = grey(CAMERA_RGB565, data, 0);

	(void)state;
	camera_motion_feed(&motion, &image);
	for (int i = 0; i < 64 * 48; i++) {
		data[2 * i] = 0xe0;
		data[2 * i + 1] = 0x07;
	}
	assert_int_equal(camera_motion_feed(&motion, &image), 255 * 256);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_wrong_spec_is_refused_with_its_reason),
		cmocka_unit_test(test_a_spec_is_checked_without_a_device),
		cmocka_unit_test(test_a_device_that_is_missing_is_no_error),
		cmocka_unit_test(test_the_pattern_depends_on_the_time_only),
		cmocka_unit_test(test_all_formats_show_the_same),
		cmocka_unit_test(test_motion_is_the_change_of_luma),
		cmocka_unit_test(test_motion_is_proportional_to_the_moving_area),
		cmocka_unit_test(test_motion_of_rgb565_is_measured_in_green),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
