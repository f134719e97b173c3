#include "tests/support/fake/fake_fb.h"
#include "tests/unit/platform/display/kms_scene.h"

#include <drm_fourcc.h>
#include <errno.h>
#include <string.h>

static void test_each_format_shows_its_colours(void **state)
{
	static const struct {
		uint32_t fourcc;
		enum pixel_format format;
		uint32_t red, green, blue;
	} cases[] = {
		{DRM_FORMAT_RGB565, PIXELS_RGB565, 1 << 11, 0x07E0, 0x001F},
		{DRM_FORMAT_XRGB8888, PIXELS_RGBA8888, 0x080000, 0x00FF00,
			0x0000FF},
		{DRM_FORMAT_XBGR8888, PIXELS_RGBA8888, 0x000008, 0x00FF00,
			0xFF0000},
	};
	struct scene scene = {0};

	for (int i = 0; i < 3; i++) {
		reset(state);
		memset(fake_card.fourccs, 0, sizeof(fake_card.fourccs));
		fake_card.fourccs[0] = cases[i].fourcc;
		assert_int_equal(scene_open(&scene), 0);
		assert_int_equal(draw(&scene, 1).format, cases[i].format);
		/* The next frame waits until this one is shown. */
		draw(&scene, 1);
		draw(&scene, 1);
		assert_int_equal(fake_card_seen(0, 0), cases[i].red);
		assert_int_equal(fake_card_seen(1, 0), cases[i].blue);
		assert_int_equal(
			fake_card_seen(WIDTH - 1, HEIGHT - 1), cases[i].green);
		scene_close(&scene);
	}
}

static void test_buffers_are_flipped_in_turn(void **state)
{
	struct scene scene = {0};
	struct display_info info;
	uint32_t last;

	(void)state;
	fake_card.preferred_depth = 16;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	scene.driver->get_info(scene.display, &info);
	assert_int_equal(info.format, PIXELS_RGB565);
	assert_int_equal(info.width, WIDTH);
	assert_int_equal(info.height, HEIGHT);
	assert_near(info.rate_hz, 50.0, 0.0);
	assert_int_equal(fake_card_seen(0, 0), 0);
	last = fake_card.shown_fb;
	for (int i = 1; i < 7; i++) {
		draw(&scene, i);
		if (i > 1) {
			assert_int_equal(fake_card_seen(0, 0), (i - 1) << 11);
			assert_int_not_equal(fake_card.shown_fb, last);
			last = fake_card.shown_fb;
		}
	}
	assert_int_equal(fake_card.set_count, 1);
	scene_close(&scene);
}

static void test_the_screen_is_restored(void **state)
{
	struct scene scene = {0};

	(void)state;
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene, 1);
	assert_int_equal(fake_card.shown_mode.hdisplay, WIDTH);
	scene_close(&scene);
	assert_int_equal(fake_card.shown_fb, 77);
	assert_int_equal(fake_card.shown_mode.hdisplay, 10);
}

static bool is_in_a_buffer(const uint8_t *at)
{
	for (int i = 0; i < 2; i++) {
		const uint8_t *memory = fake_card.buffers[i].memory;

		if (at >= memory && at < memory + FAKE_CARD_BUFFER_BYTES) {
			return true;
		}
	}
	return false;
}

/* The buffers of a card are slow to read, which blending does. */
static void test_nothing_is_drawn_in_a_buffer(void **state)
{
	static const int depths[] = {16, 24};

	for (int i = 0; i < 2; i++) {
		struct scene scene = {0};

		reset(state);
		fake_card.preferred_depth = (uint64_t)depths[i];
		assert_int_equal(scene_open(&scene), 0);
		for (int k = 1; k < 5; k++) {
			struct pixels pixels = draw(&scene, k);

			assert_false(is_in_a_buffer(pixels.data));
			assert_int_equal(pixels.stride_bytes,
				WIDTH * pixel_bytes(pixels.format));
		}
		scene_close(&scene);
	}
}

/* The screen shows the last picture while the next one is drawn. */
static void test_a_frame_begins_without_waiting_for_the_last_one(void **state)
{
	struct scene scene = {0};
	struct pixels pixels;

	(void)state;
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene, 1);
	assert_non_null(fake_card.flip_user);
	assert_int_equal(scene.driver->begin_frame(scene.display, &pixels), 0);
	assert_non_null(fake_card.flip_user);
	scene_close(&scene);
}

/* The picture that draw() makes, at its place on a black screen. */
static void check_screen(int left, int top, int width, int height)
{
	for (int y = 0; y < fake_card.shown_mode.vdisplay; y++) {
		for (int x = 0; x < fake_card.shown_mode.hdisplay; x++) {
			int column = x - left, row = y - top;
			bool inside = column >= 0 && column < width &&
				row >= 0 && row < height;
			bool last = column == width - 1 && row == height - 1;
			uint32_t wanted = column == 0 && row == 0 ? 1 << 11
				: last                            ? 0x07E0
				: inside                          ? 0x001F
								  : 0;

			assert_int_equal(fake_card_seen(x, y), wanted);
		}
	}
}

static void test_the_smallest_mode_that_holds_the_size_is_set(void **state)
{
	static const struct {
		int width, height, mode_width;
		int left, top, shown_width;
	} cases[] = {
		{24, 14, 24, 0, 0, 24},
		{22, 14, 24, 1, 0, 22},
		{24, 13, 24, 0, 0, 24},
		{24, 12, 24, 0, 1, 24},
		{18, 9, 20, 1, 1, 18},
		{10, 7, 10, 0, 0, 10},
		{21, 12, 24, 1, 1, 21},
		{25, 12, 24, 0, 1, 24},
	};

	for (size_t c = 0; c < sizeof(cases) / sizeof(cases[0]); c++) {
		struct scene scene = {.options = {.width = cases[c].width,
					      .height = cases[c].height,
					      .size_given = true,
					      .format_given = true,
					      .format = PIXELS_RGB565}};

		reset(state);
		assert_int_equal(scene_open(&scene), 0);
		assert_int_equal(
			fake_card.shown_mode.hdisplay, cases[c].mode_width);
		draw(&scene, 1);
		draw(&scene, 1);
		draw(&scene, 1);
		check_screen(cases[c].left, cases[c].top, cases[c].shown_width,
			cases[c].height);
		scene_close(&scene);
	}
}

static void test_without_page_flips_the_mode_is_set_again(void **state)
{
	struct scene scene = {
		.options = {.format_given = true, .format = PIXELS_RGB565}};
	struct display_info info;

	(void)state;
	fake_card.fail = CALL_FLIP;
	assert_int_equal(scene_open(&scene), 0);
	scene.driver->get_info(scene.display, &info);
	assert_near(info.rate_hz, 0.0, 0.0);
	for (int i = 1; i < 5; i++) {
		draw(&scene, i);
		assert_int_equal(fake_card_seen(0, 0), i << 11);
	}
	assert_int_equal(fake_card.flip_count, 0);
	scene_close(&scene);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 0);
}

static void test_a_single_buffer_is_copied_into_and_marked_dirty(void **state)
{
	struct scene scene = {
		.options = {.format_given = true, .format = PIXELS_RGB565}};

	(void)state;
	fake_card.fail = CALL_CREATE;
	fake_card.fail_from = 1;
	assert_int_equal(scene_open(&scene), 0);
	for (int i = 1; i < 5; i++) {
		draw(&scene, i);
		assert_int_equal(fake_card_seen(0, 0), i << 11);
		assert_int_equal(fake_card.dirty_count, i);
	}
	scene_close(&scene);
}

static void test_formats_that_the_screen_refuses_are_skipped(void **state)
{
	struct scene scene = {0};

	(void)state;
	/* XBGR8888 is tried first; only its framebuffer object is accepted. */
	fake_card.fail = CALL_SET;
	fake_card.fail_once = true;
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene, 1);
	draw(&scene, 1);
	assert_int_equal(fake_card.buffers[0].fourcc, DRM_FORMAT_XRGB8888);
	assert_int_equal(fake_card_seen(0, 0), 0x080000);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 0);
	scene_close(&scene);
}

/* As poll() where no event comes; what an earlier call left in errno stays. */
static int wait_in_vain(int fd, int timeout_ms)
{
	(void)fd;
	assert_in_range(timeout_ms, 100, 10000);
	errno = EBADF;
	return 0;
}

/* The card flips without saying so. */
static int lose_flip(int fd, int timeout_ms)
{
	fake_card.flip_user = NULL;
	fake_card.flip_fb = 0;
	return wait_in_vain(fd, timeout_ms);
}

static void open_on(struct scene *scene, const struct kms_calls *calls)
{
	scene->driver = &display_driver_kms;
	scene->log = log_capture_begin(&scene->capture);
	scene->options.log = &scene->log;
	assert_int_equal(
		kms_create_on(calls, &scene->options, &scene->display), 0);
}

/* Draws until a frame fails. Returns its number, or -1 if none of count does. */
static int draw_many(struct scene *scene, int count, int *error)
{
	struct pixels pixels;

	for (int frame = 0; frame < count; frame++) {
		*error = scene->driver->begin_frame(scene->display, &pixels);
		*error = *error ? *error
				: scene->driver->end_frame(scene->display);
		if (*error) {
			return frame;
		}
	}
	return -1;
}

/* The screen is off for a moment; a minute and a half is no moment. */
static void test_page_flips_that_stop_are_an_error_at_last(void **state)
{
	struct kms_calls calls = fake_card_calls;
	struct scene scene = {0};
	int error = 0;

	(void)state;
	open_on(&scene, &calls);
	calls.wait = lose_flip;
	assert_int_equal(draw_many(&scene, 99, &error), -1);
	calls.wait = fake_card_calls.wait;
	draw(&scene, 1);
	draw(&scene, 2);
	assert_int_equal(fake_card.shown_fb, fake_card.flip_fb == 1 ? 2 : 1);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 0);

	calls.wait = lose_flip;
	assert_in_range(draw_many(&scene, 102, &error), 99, 101);
	assert_int_equal(error, -ETIMEDOUT);
	assert_true(
		log_capture_has(&scene.capture, LOG_ERROR, strerror(ETIMEDOUT)));
	scene_close(&scene);
}

static int refuse_flip(
	int fd, uint32_t crtc, uint32_t fb, uint32_t flags, void *user)
{
	(void)fd;
	(void)crtc;
	(void)fb;
	(void)flags;
	(void)user;
	errno = EBUSY;
	return -EBUSY;
}

static int refuse_mode(int fd, uint32_t crtc, uint32_t fb, uint32_t x,
	uint32_t y, uint32_t *connectors, int count, drmModeModeInfoPtr mode)
{
	(void)fd;
	(void)crtc;
	(void)x;
	(void)y;
	(void)connectors;
	(void)count;
	(void)mode;
	errno = EINVAL;
	/* The end may restore the former picture. */
	return fb == 77 ? 0 : -EINVAL;
}

/* As the kernel does when the screen is unplugged, until the mode is set. */
static void test_an_unplugged_screen_shows_pictures_again(void **state)
{
	struct kms_calls calls = fake_card_calls;
	struct scene scene = {
		.options = {.format_given = true, .format = PIXELS_RGB565}};
	int error = 0;

	(void)state;
	open_on(&scene, &calls);
	draw(&scene, 1);
	calls.page_flip = refuse_flip;
	calls.set_crtc = refuse_mode;
	assert_int_equal(draw_many(&scene, 50, &error), -1);
	calls.set_crtc = fake_card_calls.set_crtc;
	draw(&scene, 9);
	assert_int_equal(fake_card_seen(0, 0), 9 << 11);
	calls.page_flip = fake_card_calls.page_flip;
	draw(&scene, 10);
	draw(&scene, 11);
	assert_int_equal(fake_card_seen(0, 0), 10 << 11);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 0);

	calls.page_flip = refuse_flip;
	calls.set_crtc = refuse_mode;
	assert_in_range(draw_many(&scene, 101, &error), 98, 100);
	assert_int_equal(error, -EBUSY);
	scene_close(&scene);
}

/* Another method works, so that nothing is wrong. */
static void test_page_flips_that_never_complete_are_not_used(void **state)
{
	struct kms_calls calls = fake_card_calls;
	struct scene scene = {0};
	struct display_info info;

	(void)state;
	calls.wait = lose_flip;
	open_on(&scene, &calls);
	scene.driver->get_info(scene.display, &info);
	assert_near(info.rate_hz, 0.0, 0.0);
	draw(&scene, 1);
	draw(&scene, 2);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 0);
	scene_close(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		KMS_TEST(test_each_format_shows_its_colours),
		KMS_TEST(test_buffers_are_flipped_in_turn),
		KMS_TEST(test_the_screen_is_restored),
		KMS_TEST(test_nothing_is_drawn_in_a_buffer),
		KMS_TEST(test_a_frame_begins_without_waiting_for_the_last_one),
		KMS_TEST(test_the_smallest_mode_that_holds_the_size_is_set),
		KMS_TEST(test_without_page_flips_the_mode_is_set_again),
		KMS_TEST(test_a_single_buffer_is_copied_into_and_marked_dirty),
		KMS_TEST(test_formats_that_the_screen_refuses_are_skipped),
		KMS_TEST(test_page_flips_that_stop_are_an_error_at_last),
		KMS_TEST(test_an_unplugged_screen_shows_pictures_again),
		KMS_TEST(test_page_flips_that_never_complete_are_not_used),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
