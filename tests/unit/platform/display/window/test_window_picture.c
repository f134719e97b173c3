#include "tests/support/test.h"

#if __has_include(<SDL.h>)
#include "platform/display/display.h"
#include "tests/support/log_capture.h"
#include "tests/support/random.h"

#include <SDL.h>
#include <stdlib.h>
#include <string.h>

extern const struct display_driver display_driver_window;

enum {
	WIDTH = 17, /* odd, so that rows have gaps */
	HEIGHT = 9,
	WINDOWS_MAX = 1000
};

/* The window that is open. SDL counts all windows of a process. */
static SDL_Surface *window_surface(void)
{
	for (Uint32 id = 1; id < WINDOWS_MAX; id++) {
		SDL_Window *window = SDL_GetWindowFromID(id);

		if (window) {
			return SDL_GetWindowSurface(window);
		}
	}
	return NULL;
}

static void fill_at_random(const struct pixels *pixels, uint32_t *seed)
{
	for (int y = 0; y < pixels->height; y++) {
		for (int x = 0; x < pixels->stride_bytes; x++) {
			pixels->data[y * pixels->stride_bytes + x] =
				(uint8_t)next_random(seed);
		}
	}
}

/* Writes red, green and blue of a pixel; returns how many bits each lacks. */
static int read_pixel(const struct pixels *pixels, int x, int y, uint8_t rgb[3])
{
	const uint8_t *at = pixels->data + y * pixels->stride_bytes;
	uint16_t narrow;

	if (pixels->format == PIXELS_RGBA8888) {
		memcpy(rgb, at + 4 * x, 3);
		return 0;
	}
	memcpy(&narrow, at + 2 * x, sizeof(narrow));
	rgb[0] = (uint8_t)(narrow >> 11 << 3);
	rgb[1] = (uint8_t)(narrow >> 5 << 2);
	rgb[2] = (uint8_t)(narrow << 3);
	return 3;
}

static void expect_shown(const struct pixels *pixels)
{
	SDL_Surface *surface = window_surface();

	assert_non_null(surface);
	assert_int_equal(surface->w, pixels->width);
	assert_int_equal(surface->h, pixels->height);
	assert_int_equal(surface->format->BytesPerPixel, 4);
	for (int y = 0; y < pixels->height; y++) {
		for (int x = 0; x < pixels->width; x++) {
			uint8_t wanted[3], seen[3];
			int lost = read_pixel(pixels, x, y, wanted);
			Uint32 value;

			memcpy(&value,
				(uint8_t *)surface->pixels +
					y * surface->pitch + 4 * x,
				sizeof(value));
			SDL_GetRGB(value, surface->format, &seen[0], &seen[1],
				&seen[2]);
			for (int i = 0; i < 3; i++) {
				assert_int_equal(
					seen[i] >> lost, wanted[i] >> lost);
			}
		}
	}
}

/* The fourth byte of a pixel means nothing: it hides no part of the picture. */
static void test_the_window_shows_each_pixel_of_each_frame(void **state)
{
	static const enum pixel_format formats[] = {
		PIXELS_RGBA8888, PIXELS_RGB565};
	uint32_t seed = 1;

	(void)state;
	setenv("SDL_VIDEODRIVER", "dummy", 1);
	for (int i = 0; i < 2; i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);
		const struct display_options options = {.width = WIDTH,
			.height = HEIGHT,
			.format_given = true,
			.format = formats[i],
			.log = &log};
		const struct display_driver *driver = &display_driver_window;
		struct display *display;
		struct pixels pixels;

		assert_int_equal(driver->create(&options, &display), 0);
		for (int frame = 0; frame < 3; frame++) {
			assert_int_equal(
				driver->begin_frame(display, &pixels), 0);
			assert_int_equal(pixels.format, formats[i]);
			fill_at_random(&pixels, &seed);
			assert_int_equal(driver->end_frame(display), 0);
			expect_shown(&pixels);
		}
		driver->destroy(display);
		assert_int_equal(capture.count, 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_window_shows_each_pixel_of_each_frame),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

#else
#include "tests/unit/platform/display/window/no_window.h"

int main(void)
{
	return skip_the_window();
}

#endif
