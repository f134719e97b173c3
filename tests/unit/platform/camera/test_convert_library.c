/* libv4lconvert with a made-up device; skipped where it is not installed. */
#include "platform/camera/v4l2/convert_library.h"
#include "tests/support/test.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum {
	WIDTH = 16,
	HEIGHT = 4,
	LIST_MAX = 64 /* questions to which a device may give answers */
};

/* A device that answers every question with zeros, and counts some. */
struct endless {
	uint32_t last_format; /* the highest index asked for */
	int calls;
};

static int answer(void *user, int fd, unsigned long request, void *argument)
{
	struct endless *device = user;
	uint32_t index;

	assert_int_equal(fd, -1);
	device->calls++;
	if (request == VIDIOC_ENUM_FMT) {
		memcpy(&index, argument, sizeof(index));
		device->last_format = index;
		return 0;
	}
	return request == VIDIOC_QUERYCAP ? 0 : -EINVAL;
}

static const struct v4l2_format yvyu = {
	.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
	.fmt.pix =
		{
			.width = WIDTH,
			.height = HEIGHT,
			.pixelformat = V4L2_PIX_FMT_YVYU,
			.bytesperline = WIDTH * 2,
			.sizeimage = WIDTH * HEIGHT * 2,
		},
};

/* Must be the first test: a library that was opened once stays open. */
static void test_a_library_that_cannot_be_opened_is_missing(void **state)
{
	struct convert_library *library = NULL;
	struct v4l2_calls calls = {.ioctl = answer};
	struct rlimit usual, none;

	(void)state;
	assert_int_equal(getrlimit(RLIMIT_NOFILE, &usual), 0);
	none = usual;
	none.rlim_cur = 0;
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
	assert_false(convert_library_is_available());
	assert_int_equal(
		convert_library_open(&calls, -1, &yvyu, &library), -ENOENT);
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &usual), 0);
	assert_null(library);
	convert_library_close(NULL);
}

static void skip_where_it_is_missing(void)
{
	void *handle = dlopen("libv4lconvert.so.0", RTLD_NOW | RTLD_LOCAL);

	if (!handle) {
		skip_because("libv4lconvert is not installed");
	}
	dlclose(handle);
	assert_true(convert_library_is_available());
}

static void test_a_device_cannot_keep_the_library_busy(void **state)
{
	struct endless device = {0, 0};
	struct v4l2_calls calls = {.ioctl = answer, .user = &device};
	struct convert_library *library;

	(void)state;
	skip_where_it_is_missing();
	assert_int_equal(convert_library_open(&calls, -1, &yvyu, &library), 0);
	assert_int_equal(device.last_format, LIST_MAX - 1);
	assert_in_range(device.calls, LIST_MAX, 10 * LIST_MAX);
	convert_library_close(library);
}

/* BT.601 of each pixel, of which the library takes rounder coefficients. */
static void expect_pixel(const uint8_t *rgb, double y, double cb, double cr)
{
	const double wanted[3] = {
		y + 1.402 * cr, y - 0.344 * cb - 0.714 * cr, y + 1.772 * cb};

	for (int i = 0; i < 3; i++) {
		double clamped = wanted[i] < 0 ? 0
			: wanted[i] > 255      ? 255
					       : wanted[i];

		assert_near(rgb[i], clamped, 9);
	}
}

static void test_a_picture_is_converted(void **state)
{
	struct endless device = {0, 0};
	struct v4l2_calls calls = {.ioctl = answer, .user = &device};
	struct convert_library *library;
	uint8_t in[WIDTH * HEIGHT * 2], rgb[WIDTH * HEIGHT * 3];

	(void)state;
	skip_where_it_is_missing();
	for (int i = 0; i < WIDTH * HEIGHT * 2; i++) {
		in[i] = (uint8_t)(i % 2 ? 100 + i % 61 : 40 + i * 3 % 180);
	}
	assert_int_equal(convert_library_open(&calls, -1, &yvyu, &library), 0);
	memset(rgb, 0, sizeof(rgb));
	assert_int_equal(convert_library_run(library, in, sizeof(in), rgb,
				 (int)sizeof(rgb)),
		0);
	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		const uint8_t *pair = in + i / 2 * 4;

		expect_pixel(&rgb[3 * i], in[2 * i], pair[3] - 128.0,
			pair[1] - 128.0);
	}
	/* A picture that ends too early, and room for too little of it. */
	assert_int_equal(convert_library_run(library, in, sizeof(in) / 2, rgb,
				 (int)sizeof(rgb)),
		-EIO);
	assert_int_equal(convert_library_run(library, in, sizeof(in), rgb,
				 (int)sizeof(rgb) - 1),
		-EIO);
	convert_library_close(library);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_library_that_cannot_be_opened_is_missing),
		cmocka_unit_test(test_a_device_cannot_keep_the_library_busy),
		cmocka_unit_test(test_a_picture_is_converted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
