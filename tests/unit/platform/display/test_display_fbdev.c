#include "platform/base/compiler.h"
#include "tests/support/fake/fbdev_scene.h"
#include "tests/support/test.h"

#include <errno.h>

enum {
	WIDTH = FBDEV_SCENE_WIDTH,
	HEIGHT = FBDEV_SCENE_HEIGHT
};

extern const struct display_driver display_driver_fbdev;

/* The pixels of a layout in the corners and the middle of the screen. */
static const struct {
	struct pixel_layout layout;
	int stride_bytes;
	uint32_t red, green, blue, white, gray;
} layout_cases[] = {
	{{.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}},
		WIDTH * 2 + 6, 0xF800, 0x07E0, 0x001F, 0xFFFF, 0x8430},
	{{.bits = 16, .red = {0, 5}, .green = {5, 6}, .blue = {11, 5}},
		WIDTH * 2, 0x001F, 0x07E0, 0xF800, 0xFFFF, 0x8430},
	{{.bits = 16,
		 .red = {10, 5},
		 .green = {5, 5},
		 .blue = {0, 5},
		 .alpha = {15, 1}},
		WIDTH * 2 + 3, 0xFC00, 0x83E0, 0x801F, 0xFFFF, 0xC210},
	{{.bits = 15, .red = {10, 5}, .green = {5, 5}, .blue = {0, 5}},
		WIDTH * 2, 0x7C00, 0x03E0, 0x001F, 0x7FFF, 0x4210},
	{{.bits = 24, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}},
		WIDTH * 3 + 5, 0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF, 0x848484},
	{{.bits = 24, .red = {0, 8}, .green = {8, 8}, .blue = {16, 8}},
		WIDTH * 3, 0x0000FF, 0x00FF00, 0xFF0000, 0xFFFFFF, 0x848484},
	{{.bits = 32,
		 .red = {16, 8},
		 .green = {8, 8},
		 .blue = {0, 8},
		 .alpha = {24, 8}},
		WIDTH * 4 + 7, 0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0xFFFFFFFF,
		0xFF848484},
	{{.bits = 32, .red = {0, 8}, .green = {8, 8}, .blue = {16, 8}},
		WIDTH * 4 + 4, 0x000000FF, 0x0000FF00, 0x00FF0000, 0x00FFFFFF,
		0x00848484},
	{{.bits = 32,
		 .red = {20, 10},
		 .green = {10, 10},
		 .blue = {0, 10},
		 .alpha = {30, 2}},
		WIDTH * 4, 0xFFF00000, 0xC00FFC00, 0xC00003FF, 0xFFFFFFFF,
		0xE1284A12},
	{{.bits = 8, .red = {5, 3}, .green = {2, 3}, .blue = {0, 2}}, WIDTH,
		0xE0, 0x1C, 0x03, 0xFF, 0x92},
	{{.bits = 8, .red = {0, 8}, .green = {0, 8}, .blue = {0, 8}, .gray = true},
		WIDTH + 1, 0x4C, 0x96, 0x1C, 0xFF, 0x82},
};

static void test_every_layout_shows_its_colours(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(layout_cases); i++) {
		bool wide = layout_cases[i].layout.bits > 16;
		struct pixels pixels;
		uint32_t pixel;

		fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT,
			layout_cases[i].stride_bytes, layout_cases[i].layout);
		/* From the wider of the two picture formats. */
		scene.options.format_given = layout_cases[i].layout.bits == 8;
		scene.options.format = PIXELS_RGBA8888;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		pixels = fbdev_scene_draw(&scene);
		if (!scene.options.format_given) {
			assert_int_equal(pixels.format,
				wide ? PIXELS_RGBA8888 : PIXELS_RGB565);
		}
		assert_int_equal(pixels.width, WIDTH);
		assert_int_equal(pixels.height, HEIGHT);
		pixel = fake_fb_seen(WIDTH / 2, HEIGHT / 2);
		if (layout_cases[i].layout.gray) {
			/* Green gets the rounding error of white. */
			assert_in_range(fake_fb_seen(WIDTH - 1, 0),
				layout_cases[i].green - 1,
				layout_cases[i].green + 1);
			assert_int_equal(
				fake_fb_seen(0, 0), layout_cases[i].red);
			assert_int_equal(
				fake_fb_seen(WIDTH - 1, HEIGHT - 1), 0xFF);
			assert_in_range(pixel, 0x81, 0x84);
		} else {
			fbdev_scene_expect_corners(layout_cases[i].red,
				layout_cases[i].green, layout_cases[i].blue,
				layout_cases[i].white);
			assert_int_equal(pixel, layout_cases[i].gray);
		}
		fbdev_scene_close(&scene);
	}
}

/* Checks the colour that a screen with a colour map shows. */
static void expect_color(
	const int index[3], int red, int green, int blue, int tolerance)
{
	const int wanted[3] = {red, green, blue};

	for (int channel = 0; channel < 3; channel++) {
		int shown = fake_fb.colors[channel][index[channel]] >> 8;

		assert_in_range(shown + tolerance, wanted[channel],
			wanted[channel] + 2 * tolerance);
	}
}

static void test_a_palette_is_set_and_restored(void **state)
{
	static const struct pixel_layout palette = {
		.bits = 8, .red = {0, 8}, .green = {0, 8}, .blue = {0, 8}};
	struct fbdev_scene scene = {0};
	int seen;

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH, palette);
	fake_fb.fix.visual = FB_VISUAL_PSEUDOCOLOR;
	for (int i = 0; i < 256; i++) {
		fake_fb.colors[0][i] = (uint16_t)(7 * i);
	}
	assert_int_equal(fbdev_scene_open(&scene), 0);
	fbdev_scene_draw(&scene);
	seen = (int)fake_fb_seen(0, 0);
	expect_color((const int[]){seen, seen, seen}, 255, 0, 0, 0);
	seen = (int)fake_fb_seen(WIDTH - 1, 0);
	expect_color((const int[]){seen, seen, seen}, 0, 255, 0, 0);
	seen = (int)fake_fb_seen(0, HEIGHT - 1);
	expect_color((const int[]){seen, seen, seen}, 0, 0, 255, 0);
	seen = (int)fake_fb_seen(WIDTH / 2, HEIGHT / 2);
	expect_color((const int[]){seen, seen, seen}, 132, 132, 132, 43);
	fbdev_scene_close(&scene);
	for (int i = 0; i < 256; i++) {
		assert_int_equal(fake_fb.colors[0][i], 7 * i);
	}
	fake_fb.fail_request = FBIOPUTCMAP;
	assert_int_equal(fbdev_scene_open(&scene), -ENOTSUP);
	fbdev_scene_expect_closed();
}

static void test_the_tables_of_channels_become_linear(void **state)
{
	static const struct pixel_layout layouts[] = {
		{.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}},
		{.bits = 32, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}}};
	struct fbdev_scene scene = {0};

	(void)state;
	for (int i = 0; i < 2; i++) {
		uint32_t seen;

		fake_fb_begin(
			WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 4, layouts[i]);
		fake_fb.fix.visual = FB_VISUAL_DIRECTCOLOR;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		fbdev_scene_draw(&scene);
		seen = fake_fb_seen(WIDTH / 2, HEIGHT / 2);
		expect_color(
			i ? (const int[]){(int)(seen >> 16 & 255),
				    (int)(seen >> 8 & 255), (int)(seen & 255)}
			  : (const int[]){(int)(seen >> 11),
				    (int)(seen >> 5 & 63), (int)(seen & 31)},
			132, 132, 132, 4);
		fbdev_scene_close(&scene);
		assert_int_equal(fake_fb.colors[1][63], 0);
	}
}

static void test_only_the_picture_is_written(void **state)
{
	enum {
		STRIDE = WIDTH * 3 + 5
	};
	static const struct pixel_layout layout = {
		.bits = 24, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}};
	struct fbdev_scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT + 3, HEIGHT, STRIDE, layout);
	fake_fb.fix.ypanstep = 0;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	fbdev_scene_draw(&scene);
	fbdev_scene_close(&scene);
	for (int i = 0; i < FAKE_FB_LEAD; i++) {
		assert_int_equal(fake_fb.map[i], 0xEE);
	}
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = WIDTH * 3; x < STRIDE; x++) {
			assert_int_equal(fake_fb.memory[y * STRIDE + x], 0xEE);
		}
	}
	for (int i = HEIGHT * STRIDE; i < (HEIGHT + 3) * STRIDE; i++) {
		assert_int_equal(fake_fb.memory[i], 0xEE);
	}
}

static void test_a_smaller_picture_is_centred_on_black(void **state)
{
	struct fbdev_scene scene = {
		.options = {.width = 10, .height = 6, .size_given = true}};
	struct pixels pixels;

	(void)state;
	for (int pages = 1; pages <= 2; pages++) {
		fake_fb_begin(WIDTH, HEIGHT, HEIGHT * pages, HEIGHT * pages,
			WIDTH * 2, fbdev_scene_layout_565);
		assert_int_equal(fbdev_scene_open(&scene), 0);
		for (int i = 0; i < 3; i++) {
			pixels = fbdev_scene_draw(&scene);
			assert_int_equal(pixels.width, 10);
			assert_int_equal(pixels.height, 6);
			assert_int_equal(fake_fb_seen(5, 3), 0xF800);
			assert_int_equal(fake_fb_seen(14, 3), 0x07E0);
			assert_int_equal(fake_fb_seen(5, 8), 0x001F);
			assert_int_equal(fake_fb_seen(14, 8), 0xFFFF);
			assert_int_equal(fake_fb_seen(4, 3), 0);
			assert_int_equal(fake_fb_seen(15, 8), 0);
			assert_int_equal(fake_fb_seen(0, 0), 0);
			assert_int_equal(fake_fb_seen(WIDTH - 1, HEIGHT - 1), 0);
		}
		fbdev_scene_close(&scene);
	}
}

/* Else what is behind the screen would show around the picture. */
static void test_the_black_around_a_picture_is_opaque(void **state)
{
	static const struct {
		struct pixel_layout layout;
		uint32_t black;
	} cases[] = {
		{{32, {16, 8}, {8, 8}, {0, 8}, {24, 8}, false}, 0xFF000000},
		{{32, {0, 8}, {8, 8}, {16, 8}, {24, 8}, false}, 0xFF000000},
		{{16, {10, 5}, {5, 5}, {0, 5}, {15, 1}, false}, 0x8000},
		{{32, {16, 8}, {8, 8}, {0, 8}, {0, 0}, false}, 0},
	};
	struct fbdev_scene scene = {
		.options = {.width = 10, .height = 6, .size_given = true}};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(cases); i++) {
		int pages = 1 + (int)i % 2;

		fake_fb_begin(WIDTH, HEIGHT, HEIGHT * pages, HEIGHT * pages,
			WIDTH * 4, cases[i / 2].layout);
		fake_fb.has_wait = true;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		for (int frame = 0; frame < 3; frame++) {
			fbdev_scene_draw(&scene);
			for (int x = 0; x < WIDTH; x++) {
				assert_int_equal(
					fake_fb_seen(x, 0), cases[i / 2].black);
				assert_int_equal(fake_fb_seen(x, HEIGHT - 1),
					cases[i / 2].black);
			}
		}
		fbdev_scene_close(&scene);
	}
}

static void test_a_larger_size_is_reduced_to_the_screen(void **state)
{
	struct fbdev_scene scene = {
		.options = {.width = 480, .height = 6, .size_given = true}};
	struct pixels pixels;

	(void)state;
	fbdev_scene_begin_565(1);
	assert_int_equal(fbdev_scene_open(&scene), 0);
	pixels = fbdev_scene_draw(&scene);
	assert_int_equal(pixels.width, WIDTH);
	assert_int_equal(pixels.height, 6);
	assert_true(
		log_capture_has(&scene.capture, LOG_WARNING, "--size 480x6"));
	fbdev_scene_close(&scene);
}

static void test_a_requested_format_is_converted(void **state)
{
	struct fbdev_scene scene = {
		.options = {.format_given = true, .format = PIXELS_RGB565}};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, WIDTH * 4,
		fbdev_scene_layout_8888);
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(fbdev_scene_draw(&scene).format, PIXELS_RGB565);
	fbdev_scene_expect_corners(0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	fbdev_scene_close(&scene);
}

static void test_the_rate_is_known_where_the_device_waits(void **state)
{
	struct fbdev_scene scene = {0};
	struct display_info info;

	(void)state;
	for (int i = 0; i < 3; i++) {
		fake_fb_begin(480, 640, 640, 640, 960, fbdev_scene_layout_565);
		fake_fb.has_wait = i > 0;
		if (i == 2) {
			/* The i.MX31 PDK's panel. */
			fake_fb.var.pixclock = 41701;
			fake_fb.var.left_margin = 20;
			fake_fb.var.right_margin = 41;
			fake_fb.var.upper_margin = 10;
			fake_fb.var.lower_margin = 5;
			fake_fb.var.hsync_len = 20;
			fake_fb.var.vsync_len = 10;
		}
		assert_int_equal(fbdev_scene_open(&scene), 0);
		scene.driver->get_info(scene.display, &info);
		assert_near(info.rate_hz,
			i == 0           ? 0.0
				: i == 1 ? 60.0
					 : 1e12 / (41701.0 * 561 * 665),
			1e-6);
		fbdev_scene_close(&scene);
	}
}

/* From 20 to 250 Hz; other timings are those of a panel that has none. */
static void test_a_rate_that_no_screen_has_is_60_hz(void **state)
{
	static const struct {
		unsigned pixclock;
		double rate_hz;
	} cases[] = {{250000, 20.0}, {250001, 60.0}, {20000, 250.0},
		{19999, 60.0}, {0, 60.0}};
	struct fbdev_scene scene = {0};
	struct display_info info;

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		fake_fb_begin(500, 400, 400, 400, 1000, fbdev_scene_layout_565);
		fake_fb.has_wait = true;
		fake_fb.var.pixclock = cases[i].pixclock;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		scene.driver->get_info(scene.display, &info);
		assert_near(info.rate_hz, cases[i].rate_hz, 0.0);
		fbdev_scene_close(&scene);
	}
}

static void test_the_real_system_refuses_another_device(void **state)
{
	struct fbdev_scene scene = {.options = {.device = "/dev/null"}};

	(void)state;
	scene.driver = &display_driver_fbdev;
	scene.log = log_capture_begin(&scene.capture);
	scene.options.log = &scene.log;
	assert_true(scene.driver->create(&scene.options, &scene.display) < 0);
	assert_int_equal(scene.capture.count, 1);
	assert_contains(scene.capture.sentence[0], "/dev/null");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_layout_shows_its_colours),
		cmocka_unit_test(test_a_palette_is_set_and_restored),
		cmocka_unit_test(test_the_tables_of_channels_become_linear),
		cmocka_unit_test(test_only_the_picture_is_written),
		cmocka_unit_test(test_a_smaller_picture_is_centred_on_black),
		cmocka_unit_test(test_the_black_around_a_picture_is_opaque),
		cmocka_unit_test(test_a_larger_size_is_reduced_to_the_screen),
		cmocka_unit_test(test_a_requested_format_is_converted),
		cmocka_unit_test(test_the_rate_is_known_where_the_device_waits),
		cmocka_unit_test(test_a_rate_that_no_screen_has_is_60_hz),
		cmocka_unit_test(test_the_real_system_refuses_another_device),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
