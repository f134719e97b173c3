#include "platform/base/compiler.h"
#include "tests/support/fake/fbdev_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/kd.h>
#include <sys/ioctl.h>

enum {
	WIDTH = FBDEV_SCENE_WIDTH,
	HEIGHT = FBDEV_SCENE_HEIGHT
};

/* Blending would read what it draws on, from memory that is not cached. */
static void test_pictures_are_drawn_in_memory_and_copied_to_pages_in_turn(
	void **state)
{
	enum {
		STRIDE = WIDTH * 2 + 4
	};
	struct fbdev_scene scene = {0};
	uintptr_t first, end;

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, STRIDE,
		fbdev_scene_layout_565);
	fake_fb.has_wait = true;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	first = (uintptr_t)fake_fb.map;
	end = first + sizeof(fake_fb.map);
	for (int i = 0; i < 5; i++) {
		int back = !(i & 1);
		int waits = fake_fb.wait_count;
		struct pixels pixels;

		assert_int_equal(
			scene.driver->begin_frame(scene.display, &pixels), 0);
		assert_true((uintptr_t)pixels.data < first ||
			(uintptr_t)pixels.data >= end);
		assert_int_not_equal(fake_fb.var.yoffset, back * HEIGHT);
		pixels = fbdev_scene_draw(&scene);
		assert_int_equal(fake_fb.var.yoffset, back * HEIGHT);
		assert_int_equal(fake_fb.wait_count, waits + 1);
		fbdev_scene_expect_corners(0xF800, 0x07E0, 0x001F, 0xFFFF);
	}
	fbdev_scene_close(&scene);
	assert_int_equal(fake_fb.var.yoffset, 0);
}

/* Panning may end a frame before the page before has left the screen. */
static void test_a_device_that_cannot_wait_gets_a_third_page(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 3, HEIGHT * 2, WIDTH * 4,
		fbdev_scene_layout_8888);
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT * 3);
	for (int i = 1; i < 8; i++) {
		uint32_t before = fake_fb.var.yoffset;

		fbdev_scene_draw(&scene);
		assert_int_equal(fake_fb.var.yoffset, i % 3 * HEIGHT);
		assert_int_not_equal(fake_fb.var.yoffset, before);
		fbdev_scene_expect_corners(
			0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	}
	fbdev_scene_close(&scene);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT * 2);
}

static void test_a_device_that_waits_keeps_two_pages(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 3, HEIGHT, WIDTH * 4,
		fbdev_scene_layout_8888);
	fake_fb.has_wait = true;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT * 2);
	fbdev_scene_close(&scene);
}

static void test_a_second_page_is_requested_and_given_back(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH * 4,
		fbdev_scene_layout_8888);
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT * 2);
	for (int i = 0; i < 3; i++) {
		fbdev_scene_draw(&scene);
		fbdev_scene_expect_corners(
			0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	}
	assert_true(fake_fb.pan_count >= 3);
	fbdev_scene_close(&scene);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT);
	assert_int_equal(fake_fb.var.yoffset, 0);
}

static void test_a_mode_that_the_driver_changed_is_restored(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH * 4,
		fbdev_scene_layout_8888);
	fake_fb.rounds_width = true;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(fake_fb.var.xres, WIDTH);
	fbdev_scene_draw(&scene);
	fbdev_scene_expect_corners(0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	assert_int_equal(fake_fb.var.yoffset, 0);
	fbdev_scene_close(&scene);
}

static void test_a_single_page_is_drawn_where_the_screen_shows_it(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT + 4, HEIGHT + 4, WIDTH * 2 + 8,
		fbdev_scene_layout_565);
	fake_fb.var.xres_virtual = WIDTH + 4;
	fake_fb.var.xoffset = 2;
	fake_fb.var.yoffset = 3;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	fbdev_scene_draw(&scene);
	fbdev_scene_expect_corners(0xF800, 0x07E0, 0x001F, 0xFFFF);
	assert_int_equal(fake_fb.memory[0], 0xEE);
	fbdev_scene_close(&scene);
}

static void test_a_failure_is_logged_and_everything_closed(void **state)
{
	static const unsigned long requests[] = {
		FBIOGET_FSCREENINFO, FBIOGET_VSCREENINFO};
	struct fbdev_scene scene = {0};

	(void)state;
	for (int i = 0; i < 3; i++) {
		fbdev_scene_begin_565(2);
		fake_fb.has_console = true;
		fake_fb.fail_request = i < 2 ? requests[i] : 0;
		fake_fb.fail_map = i == 2;
		assert_true(fbdev_scene_open(&scene) < 0);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 1);
		assert_contains(scene.capture.sentence[0], "/dev/fb0");
		fbdev_scene_expect_closed();
		assert_int_equal(fake_fb.var.yres_virtual, HEIGHT);
	}
}

static void test_optional_calls_may_fail(void **state)
{
	static const unsigned long requests[] = {FBIOPUT_VSCREENINFO,
		FBIOPAN_DISPLAY, FBIO_WAITFORVSYNC, FBIOBLANK, KDGETMODE,
		KDSETMODE};
	struct fbdev_scene scene = {0};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(requests); i++) {
		fbdev_scene_begin_565(2);
		fake_fb.has_console = true;
		fake_fb.has_wait = true;
		fake_fb.fail_request = requests[i];
		assert_int_equal(fbdev_scene_open(&scene), 0);
		fbdev_scene_draw(&scene);
		fbdev_scene_expect_corners(0xF800, 0x07E0, 0x001F, 0xFFFF);
		fbdev_scene_close(&scene);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 0);
	}
}

static void test_a_failing_flip_is_logged(void **state)
{
	struct fbdev_scene scene = {0};
	struct pixels pixels;

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, WIDTH * 2,
		fbdev_scene_layout_565);
	assert_int_equal(fbdev_scene_open(&scene), 0);
	fake_fb.fail_request = FBIOPAN_DISPLAY;
	assert_int_equal(scene.driver->begin_frame(scene.display, &pixels), 0);
	assert_int_equal(scene.driver->end_frame(scene.display), -EIO);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 1);
	fbdev_scene_close(&scene);
}

/* As while the screen is off. */
static void test_a_busy_device_misses_pictures_but_not_for_ever(void **state)
{
	static const int errors[] = {ETIMEDOUT, EBUSY, EAGAIN};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(errors); i++) {
		struct fbdev_scene scene = {0};
		struct pixels first, pixels;
		int missed = 0;

		fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, WIDTH * 2,
			fbdev_scene_layout_565);
		fake_fb.has_wait = true;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		fbdev_scene_draw(&scene);
		for (int turn = 0; turn < 3; turn++) {
			fake_fb.fail_error = errors[i];
			fake_fb.fail_request = FBIOPAN_DISPLAY;
			first = fbdev_scene_draw(&scene);
			for (int frame = 0; frame < 50; frame++) {
				pixels = fbdev_scene_draw(&scene);
				assert_ptr_equal(pixels.data, first.data);
			}
			/* The screen is on again. */
			fake_fb.fail_request = 0;
			fbdev_scene_draw(&scene);
			fbdev_scene_expect_corners(
				0xF800, 0x07E0, 0x001F, 0xFFFF);
		}
		fake_fb.fail_request = FBIOPAN_DISPLAY;
		while (scene.driver->end_frame(scene.display) == 0) {
			missed++;
		}
		assert_int_equal(missed, 99);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 1);
		fake_fb.fail_request = 0;
		fbdev_scene_close(&scene);
	}
}

/* Its end wraps around where addresses have 32 bits. */
static void test_memory_beyond_all_addresses_is_refused(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fbdev_scene_begin_565(1);
	fake_fb.fix.smem_len = UINT32_MAX - FAKE_FB_LEAD / 2;
	fake_fb.fix.ypanstep = 0;
	assert_true(fbdev_scene_open(&scene) < 0);
	assert_int_equal(scene.capture.count, 1);
	fbdev_scene_expect_closed();
}

static void test_the_message_for_a_missing_device_gives_advice(void **state)
{
	static const struct {
		int error;
		const char *advice;
	} cases[] = {
		{ENOENT, "no such framebuffer"},
		{ENODEV, "no such framebuffer"},
		{EACCES, "group"},
		{EBUSY, "/dev/fbN"},
	};
	struct fbdev_scene scene = {.options = {.device = "/dev/fb7"}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		fbdev_scene_begin_565(1);
		fake_fb.open_error = cases[i].error;
		assert_true(fbdev_scene_open(&scene) < 0);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], "/dev/fb7");
		assert_contains(scene.capture.sentence[0], cases[i].advice);
		fbdev_scene_expect_closed();
	}
}

static void test_invalid_modes_are_refused(void **state)
{
	static const struct {
		uint32_t *member;
		uint32_t value;
	} cases[] = {
		{&fake_fb.var.bits_per_pixel, 0},
		{&fake_fb.var.bits_per_pixel, 64},
		{&fake_fb.var.bits_per_pixel, 4},
		{&fake_fb.var.red.offset, 12},
		{&fake_fb.var.red.offset, 4000000000u},
		{&fake_fb.var.green.length, 0},
		{&fake_fb.var.green.length, 4000000000u},
		{&fake_fb.var.blue.offset, 5}, /* overlaps green */
		{&fake_fb.var.red.msb_right, 1},
		{&fake_fb.var.nonstd, 1},
		{&fake_fb.var.grayscale, 0x56595559},
		{&fake_fb.var.xres, 0},
		{&fake_fb.var.yres, 4000000000u},
		{&fake_fb.var.xres, 100000},
		{&fake_fb.var.xoffset, 4000000000u},
		{&fake_fb.var.yoffset, 4000000000u},
		{&fake_fb.fix.line_length, WIDTH},
		{&fake_fb.fix.line_length, 4000000000u},
		{&fake_fb.fix.smem_len, WIDTH * 2 * HEIGHT - 1},
		{&fake_fb.fix.type, FB_TYPE_PLANES},
		{&fake_fb.fix.visual, FB_VISUAL_MONO01},
	};
	struct fbdev_scene scene = {0};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		fbdev_scene_begin_565(1);
		*cases[i].member = cases[i].value;
		if (fbdev_scene_open(&scene) != -ENOTSUP) {
			fail_msg("case %zu is accepted", i);
		}
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], "/dev/fb0");
		fbdev_scene_expect_closed();
	}
}

/* One less, or one more, is refused above. */
static void test_modes_at_the_limits_are_taken(void **state)
{
	static const struct {
		uint32_t *member;
		uint32_t value, refused;
	} cases[] = {
		{&fake_fb.var.xres, 1, 0},
		{&fake_fb.var.yres, 1, 0},
		{&fake_fb.var.yres, HEIGHT, HEIGHT + 1},
		{&fake_fb.var.xoffset, 0, 1},
		{&fake_fb.var.yoffset, 0, 1},
		{&fake_fb.fix.line_length, WIDTH * 2, WIDTH * 2 - 1},
		{&fake_fb.fix.line_length, 0, WIDTH * 2 + 1},
		{&fake_fb.fix.smem_len, WIDTH * 2 * HEIGHT,
			WIDTH * 2 * HEIGHT - 1},
	};
	struct fbdev_scene scene = {0};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		fbdev_scene_begin_565(1);
		*cases[i].member = cases[i].value;
		if (fbdev_scene_open(&scene) != 0) {
			fail_msg("case %zu is refused", i);
		}
		fbdev_scene_close(&scene);
		fbdev_scene_begin_565(1);
		*cases[i].member = cases[i].refused;
		if (fbdev_scene_open(&scene) != -ENOTSUP) {
			fail_msg("case %zu is accepted", i);
		}
		fbdev_scene_expect_closed();
	}
}

static void test_a_screen_has_at_most_so_many_pixels_a_side(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	for (int i = 0; i < 4; i++) {
		const uint32_t side = PIXELS_SIZE_MAX + (uint32_t)i / 2;
		const uint32_t width = i % 2 ? 1 : side;

		fbdev_scene_begin_565(1);
		fake_fb.var.xres = fake_fb.var.xres_virtual = width;
		fake_fb.var.yres = fake_fb.var.yres_virtual = i % 2 ? side : 1;
		fake_fb.fix.line_length = width * 2;
		fake_fb.fix.smem_len = side * 2;
		assert_int_equal(fbdev_scene_open(&scene), i < 2 ? 0 : -ENOTSUP);
		if (i < 2) {
			fbdev_scene_close(&scene);
		}
	}
}

/* A row of the largest stride, in memory that the device claims to have. */
static void test_a_picture_is_at_most_as_large_as_an_int(void **state)
{
	const uint32_t most = INT32_MAX / PIXELS_SIZE_MAX;
	struct fbdev_scene scene = {0};

	(void)state;
	for (uint32_t over = 0; over < 2; over++) {
		fbdev_scene_begin_565(1);
		fake_fb.var.yres = 1;
		fake_fb.fix.line_length = most + over;
		fake_fb.fix.smem_len = most + over;
		assert_int_equal(fbdev_scene_open(&scene), over ? -ENOTSUP : 0);
		if (!over) {
			fbdev_scene_close(&scene);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_pictures_are_drawn_in_memory_and_copied_to_pages_in_turn),
		cmocka_unit_test(
			test_a_device_that_cannot_wait_gets_a_third_page),
		cmocka_unit_test(test_a_device_that_waits_keeps_two_pages),
		cmocka_unit_test(test_a_second_page_is_requested_and_given_back),
		cmocka_unit_test(test_a_mode_that_the_driver_changed_is_restored),
		cmocka_unit_test(
			test_a_single_page_is_drawn_where_the_screen_shows_it),
		cmocka_unit_test(test_a_failure_is_logged_and_everything_closed),
		cmocka_unit_test(test_optional_calls_may_fail),
		cmocka_unit_test(test_a_failing_flip_is_logged),
		cmocka_unit_test(
			test_a_busy_device_misses_pictures_but_not_for_ever),
		cmocka_unit_test(test_memory_beyond_all_addresses_is_refused),
		cmocka_unit_test(
			test_the_message_for_a_missing_device_gives_advice),
		cmocka_unit_test(test_invalid_modes_are_refused),
		cmocka_unit_test(test_modes_at_the_limits_are_taken),
		cmocka_unit_test(test_a_screen_has_at_most_so_many_pixels_a_side),
		cmocka_unit_test(test_a_picture_is_at_most_as_large_as_an_int),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
