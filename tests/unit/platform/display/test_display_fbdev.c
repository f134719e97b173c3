#include "platform/display/console.h"
#include "platform/display/fbdev/fbdev.h"
#include "platform/process/stop.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/gl/paint.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/kd.h>
#include <signal.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
	WIDTH = 20,
	HEIGHT = 12
};

static const struct pixel_layout rgb565 = {
	.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};
static const struct pixel_layout xrgb8888 = {
	.bits = 32, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}};

struct scene {
	const struct display_driver *driver;
	struct display *display;
	struct display_options options;
	struct log_capture capture;
	struct log log;
};

static int scene_open(struct scene *scene)
{
	scene->driver = display_find("fbdev");
	assert_non_null(scene->driver);
	scene->log = log_capture_begin(&scene->capture);
	scene->options.log = &scene->log;
	scene->display = NULL;
	return fbdev_create_on(&fake_fb_calls, &scene->options, &scene->display);
}

static void expect_all_closed(void)
{
	assert_int_equal(fake_fb.open_count, 0);
	assert_int_equal(fake_fb.map_count, 0);
	assert_int_equal(fake_fb.console_mode, KD_TEXT);
}

static void scene_close(struct scene *scene)
{
	scene->driver->destroy(scene->display);
	expect_all_closed();
}

/* Red, green and blue in the corners, white in the fourth, gray between. */
static struct pixels draw(struct scene *scene)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	paint_all(&pixels, 132, 132, 132);
	paint_pixel(&pixels, 0, 0, 255, 0, 0);
	paint_pixel(&pixels, pixels.width - 1, 0, 0, 255, 0);
	paint_pixel(&pixels, 0, pixels.height - 1, 0, 0, 255);
	paint_pixel(&pixels, pixels.width - 1, pixels.height - 1, 255, 255, 255);
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
	return pixels;
}

static void expect_corners(
	uint32_t red, uint32_t green, uint32_t blue, uint32_t white)
{
	assert_int_equal(fake_fb_seen(0, 0), red);
	assert_int_equal(fake_fb_seen(WIDTH - 1, 0), green);
	assert_int_equal(fake_fb_seen(0, HEIGHT - 1), blue);
	assert_int_equal(fake_fb_seen(WIDTH - 1, HEIGHT - 1), white);
}

static void test_every_layout_shows_its_colours(void **state)
{
	static const struct {
		struct pixel_layout layout;
		int stride_bytes;
		uint32_t red, green, blue, white, gray;
	} cases[] = {
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
			WIDTH * 3 + 5, 0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF,
			0x848484},
		{{.bits = 24, .red = {0, 8}, .green = {8, 8}, .blue = {16, 8}},
			WIDTH * 3, 0x0000FF, 0x00FF00, 0xFF0000, 0xFFFFFF,
			0x848484},
		{{.bits = 32,
			 .red = {16, 8},
			 .green = {8, 8},
			 .blue = {0, 8},
			 .alpha = {24, 8}},
			WIDTH * 4 + 7, 0xFFFF0000, 0xFF00FF00, 0xFF0000FF,
			0xFFFFFFFF, 0xFF848484},
		{{.bits = 32, .red = {0, 8}, .green = {8, 8}, .blue = {16, 8}},
			WIDTH * 4 + 4, 0x000000FF, 0x0000FF00, 0x00FF0000,
			0x00FFFFFF, 0x00848484},
		{{.bits = 32,
			 .red = {20, 10},
			 .green = {10, 10},
			 .blue = {0, 10},
			 .alpha = {30, 2}},
			WIDTH * 4, 0xFFF00000, 0xC00FFC00, 0xC00003FF,
			0xFFFFFFFF, 0xE1284A12},
		{{.bits = 8, .red = {5, 3}, .green = {2, 3}, .blue = {0, 2}},
			WIDTH, 0xE0, 0x1C, 0x03, 0xFF, 0x92},
		{{.bits = 8,
			 .red = {0, 8},
			 .green = {0, 8},
			 .blue = {0, 8},
			 .gray = true},
			WIDTH + 1, 0x4C, 0x96, 0x1C, 0xFF, 0x82},
	};
	struct scene scene = {0};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		bool wide = cases[i].layout.bits > 16;
		struct pixels pixels;
		uint32_t pixel;

		fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT,
			cases[i].stride_bytes, cases[i].layout);
		/* Each by the format that is the finer one. */
		scene.options.format_given = cases[i].layout.bits == 8;
		scene.options.format = PIXELS_RGBA8888;
		assert_int_equal(scene_open(&scene), 0);
		pixels = draw(&scene);
		if (!scene.options.format_given) {
			assert_int_equal(pixels.format,
				wide ? PIXELS_RGBA8888 : PIXELS_RGB565);
		}
		assert_int_equal(pixels.width, WIDTH);
		assert_int_equal(pixels.height, HEIGHT);
		pixel = fake_fb_seen(WIDTH / 2, HEIGHT / 2);
		if (cases[i].layout.gray) {
			/* Green takes what rounding took from white. */
			assert_in_range(fake_fb_seen(WIDTH - 1, 0),
				cases[i].green - 1, cases[i].green + 1);
			assert_int_equal(fake_fb_seen(0, 0), cases[i].red);
			assert_int_equal(
				fake_fb_seen(WIDTH - 1, HEIGHT - 1), 0xFF);
			assert_in_range(pixel, 0x81, 0x84);
		} else {
			expect_corners(cases[i].red, cases[i].green,
				cases[i].blue, cases[i].white);
			assert_int_equal(pixel, cases[i].gray);
		}
		scene_close(&scene);
	}
}

/* What a screen with tables shows, 0 to 255 a channel. */
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

static void test_a_palette_is_filled_and_put_back(void **state)
{
	static const struct pixel_layout palette = {
		.bits = 8, .red = {0, 8}, .green = {0, 8}, .blue = {0, 8}};
	struct scene scene = {0};
	int seen;

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH, palette);
	fake_fb.fix.visual = FB_VISUAL_PSEUDOCOLOR;
	for (int i = 0; i < 256; i++) {
		fake_fb.colors[0][i] = (uint16_t)(7 * i);
	}
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene);
	seen = (int)fake_fb_seen(0, 0);
	expect_color((const int[]){seen, seen, seen}, 255, 0, 0, 0);
	seen = (int)fake_fb_seen(WIDTH - 1, 0);
	expect_color((const int[]){seen, seen, seen}, 0, 255, 0, 0);
	seen = (int)fake_fb_seen(0, HEIGHT - 1);
	expect_color((const int[]){seen, seen, seen}, 0, 0, 255, 0);
	seen = (int)fake_fb_seen(WIDTH / 2, HEIGHT / 2);
	expect_color((const int[]){seen, seen, seen}, 132, 132, 132, 43);
	scene_close(&scene);
	for (int i = 0; i < 256; i++) {
		assert_int_equal(fake_fb.colors[0][i], 7 * i);
	}
	fake_fb.fail_request = FBIOPUTCMAP;
	assert_int_equal(scene_open(&scene), -ENOTSUP);
	expect_all_closed();
}

static void test_tables_of_channels_become_straight(void **state)
{
	static const struct pixel_layout layouts[] = {
		{.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}},
		{.bits = 32, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}}};
	struct scene scene = {0};

	(void)state;
	for (int i = 0; i < 2; i++) {
		uint32_t seen;

		fake_fb_begin(
			WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 4, layouts[i]);
		fake_fb.fix.visual = FB_VISUAL_DIRECTCOLOR;
		assert_int_equal(scene_open(&scene), 0);
		draw(&scene);
		seen = fake_fb_seen(WIDTH / 2, HEIGHT / 2);
		expect_color(
			i ? (const int[]){seen >> 16 & 255, seen >> 8 & 255,
				    seen & 255}
			  : (const int[]){seen >> 11, seen >> 5 & 63, seen & 31},
			132, 132, 132, 4);
		scene_close(&scene);
		assert_int_equal(fake_fb.colors[1][63], 0);
	}
}

static void test_nothing_beside_the_picture_is_written(void **state)
{
	enum {
		STRIDE = WIDTH * 3 + 5
	};
	static const struct pixel_layout layout = {
		.bits = 24, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}};
	struct scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT + 3, HEIGHT, STRIDE, layout);
	fake_fb.fix.ypanstep = 0;
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene);
	scene_close(&scene);
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

static void test_two_pages_are_drawn_into_in_turn(void **state)
{
	enum {
		STRIDE = WIDTH * 2 + 4
	};
	struct scene scene = {0};
	uint8_t *pages[2];

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, STRIDE, rgb565);
	fake_fb.has_wait = true;
	assert_int_equal(scene_open(&scene), 0);
	pages[0] = fake_fb.memory;
	pages[1] = fake_fb.memory + HEIGHT * STRIDE;
	for (int i = 0; i < 5; i++) {
		int back = !(i & 1);
		int waits = fake_fb.wait_count;
		struct pixels pixels;

		assert_int_equal(
			scene.driver->begin_frame(scene.display, &pixels), 0);
		/* Straight into the page that is not seen. */
		assert_ptr_equal(pixels.data, pages[back]);
		assert_int_equal(pixels.stride_bytes, STRIDE);
		assert_int_not_equal(fake_fb.var.yoffset, back * HEIGHT);
		pixels = draw(&scene);
		assert_int_equal(fake_fb.var.yoffset, back * HEIGHT);
		assert_int_equal(fake_fb.wait_count, waits + 1);
		expect_corners(0xF800, 0x07E0, 0x001F, 0xFFFF);
	}
	scene_close(&scene);
	assert_int_equal(fake_fb.var.yoffset, 0);
}

static void test_a_second_page_is_asked_for_and_given_back(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH * 4, xrgb8888);
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT * 2);
	for (int i = 0; i < 3; i++) {
		draw(&scene);
		expect_corners(0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	}
	assert_true(fake_fb.pan_count >= 3);
	scene_close(&scene);
	assert_int_equal(fake_fb.var.yres_virtual, HEIGHT);
	assert_int_equal(fake_fb.var.yoffset, 0);
}

static void test_a_driver_that_rounds_the_mode_is_set_back(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH * 4, xrgb8888);
	fake_fb.rounds_width = true;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_fb.var.xres, WIDTH);
	draw(&scene);
	expect_corners(0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	assert_int_equal(fake_fb.var.yoffset, 0);
	scene_close(&scene);
}

static void test_what_is_seen_before_is_where_one_page_goes(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_fb_begin(
		WIDTH, HEIGHT, HEIGHT + 4, HEIGHT + 4, WIDTH * 2 + 8, rgb565);
	fake_fb.var.xres_virtual = WIDTH + 4;
	fake_fb.var.xoffset = 2;
	fake_fb.var.yoffset = 3;
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene);
	expect_corners(0xF800, 0x07E0, 0x001F, 0xFFFF);
	assert_int_equal(fake_fb.memory[0], 0xEE);
	scene_close(&scene);
}

static void test_a_smaller_picture_lies_in_the_middle_on_black(void **state)
{
	struct scene scene = {
		.options = {.width = 10, .height = 6, .size_given = true}};
	struct pixels pixels;

	(void)state;
	for (int pages = 1; pages <= 2; pages++) {
		fake_fb_begin(WIDTH, HEIGHT, HEIGHT * pages, HEIGHT * pages,
			WIDTH * 2, rgb565);
		assert_int_equal(scene_open(&scene), 0);
		for (int i = 0; i < 3; i++) {
			pixels = draw(&scene);
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
		scene_close(&scene);
	}
}

static void test_a_larger_picture_is_cut_to_the_screen(void **state)
{
	struct scene scene = {
		.options = {.width = 480, .height = 6, .size_given = true}};
	struct pixels pixels;

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
	assert_int_equal(scene_open(&scene), 0);
	pixels = draw(&scene);
	assert_int_equal(pixels.width, WIDTH);
	assert_int_equal(pixels.height, 6);
	assert_true(
		log_capture_has(&scene.capture, LOG_WARNING, "--size 480x6"));
	scene_close(&scene);
}

static void test_the_format_asked_for_is_converted(void **state)
{
	struct scene scene = {
		.options = {.format_given = true, .format = PIXELS_RGB565}};

	(void)state;
	fake_fb_begin(
		WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, WIDTH * 4, xrgb8888);
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(draw(&scene).format, PIXELS_RGB565);
	expect_corners(0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF);
	scene_close(&scene);
}

static void test_the_rate_is_told_where_the_device_waits(void **state)
{
	struct scene scene = {0};
	struct display_info info;

	(void)state;
	for (int i = 0; i < 3; i++) {
		fake_fb_begin(480, 640, 640, 640, 960, rgb565);
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
		assert_int_equal(scene_open(&scene), 0);
		scene.driver->get_info(scene.display, &info);
		assert_near(info.rate_hz,
			i == 0           ? 0.0
				: i == 1 ? 60.0
					 : 1e12 / (41701.0 * 561 * 665),
			1e-6);
		scene_close(&scene);
	}
}

static void test_what_fails_is_said_and_everything_closed(void **state)
{
	static const unsigned long requests[] = {
		FBIOGET_FSCREENINFO, FBIOGET_VSCREENINFO};
	struct scene scene = {0};

	(void)state;
	for (int i = 0; i < 3; i++) {
		fake_fb_begin(
			WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH * 2, rgb565);
		fake_fb.has_console = true;
		fake_fb.fail_request = i < 2 ? requests[i] : 0;
		fake_fb.fail_map = i == 2;
		assert_true(scene_open(&scene) < 0);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 1);
		assert_contains(scene.capture.sentence[0], "/dev/fb0");
		expect_all_closed();
		assert_int_equal(fake_fb.var.yres_virtual, HEIGHT);
	}
}

static void test_what_is_not_needed_may_fail(void **state)
{
	static const unsigned long requests[] = {FBIOPUT_VSCREENINFO,
		FBIOPAN_DISPLAY, FBIO_WAITFORVSYNC, FBIOBLANK, KDGETMODE,
		KDSETMODE};
	struct scene scene = {0};

	(void)state;
	for (size_t i = 0; i < sizeof(requests) / sizeof(requests[0]); i++) {
		fake_fb_begin(
			WIDTH, HEIGHT, HEIGHT * 2, HEIGHT, WIDTH * 2, rgb565);
		fake_fb.has_console = true;
		fake_fb.has_wait = true;
		fake_fb.fail_request = requests[i];
		assert_int_equal(scene_open(&scene), 0);
		draw(&scene);
		expect_corners(0xF800, 0x07E0, 0x001F, 0xFFFF);
		scene_close(&scene);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 0);
	}
}

static void test_a_failing_flip_is_told(void **state)
{
	struct scene scene = {0};
	struct pixels pixels;

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT * 2, HEIGHT * 2, WIDTH * 2, rgb565);
	assert_int_equal(scene_open(&scene), 0);
	fake_fb.fail_request = FBIOPAN_DISPLAY;
	assert_int_equal(scene.driver->begin_frame(scene.display, &pixels), 0);
	assert_int_equal(scene.driver->end_frame(scene.display), -EIO);
	assert_int_equal(log_capture_count(&scene.capture, LOG_ERROR), 1);
	scene_close(&scene);
}

static void test_a_missing_device_says_what_to_do(void **state)
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
	struct scene scene = {.options = {.device = "/dev/fb7"}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
		fake_fb.open_error = cases[i].error;
		assert_true(scene_open(&scene) < 0);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], "/dev/fb7");
		assert_contains(scene.capture.sentence[0], cases[i].advice);
		expect_all_closed();
	}
}

static void spoil(int how)
{
	struct fb_var_screeninfo *var = &fake_fb.var;
	struct fb_fix_screeninfo *fix = &fake_fb.fix;

	switch (how) {
	case 0:
		var->bits_per_pixel = 0;
		break;
	case 1:
		var->bits_per_pixel = 64;
		break;
	case 2:
		var->bits_per_pixel = 4;
		break;
	case 3:
		var->red.offset = 12;
		break;
	case 4:
		var->red.offset = 4000000000u;
		break;
	case 5:
		var->green.length = 0;
		break;
	case 6:
		var->green.length = 4000000000u;
		break;
	case 7:
		var->blue.offset = 5;
		break; /* over green */
	case 8:
		var->red.msb_right = 1;
		break;
	case 9:
		var->nonstd = 1;
		break;
	case 10:
		var->grayscale = 0x56595559;
		break;
	case 11:
		var->xres = 0;
		break;
	case 12:
		var->yres = 4000000000u;
		break;
	case 13:
		var->xres = 100000;
		break;
	case 14:
		var->xoffset = 4000000000u;
		break;
	case 15:
		var->yoffset = 4000000000u;
		break;
	case 16:
		fix->line_length = WIDTH;
		break;
	case 17:
		fix->line_length = 4000000000u;
		break;
	case 18:
		fix->smem_len = WIDTH * 2 * HEIGHT - 1;
		break;
	case 19:
		fix->type = FB_TYPE_PLANES;
		break;
	case 20:
		fix->visual = FB_VISUAL_MONO01;
		break;
	default:
		fail();
	}
}

static void test_modes_without_sense_are_refused(void **state)
{
	struct scene scene = {0};

	(void)state;
	for (int i = 0; i <= 20; i++) {
		fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
		spoil(i);
		if (scene_open(&scene) != -ENOTSUP) {
			fail_msg("case %d is taken", i);
		}
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], "/dev/fb0");
		expect_all_closed();
	}
}

static void test_the_console_is_dark_meanwhile(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
	fake_fb.has_console = true;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	draw(&scene);
	scene_close(&scene);

	/* Left so by a program that was killed. */
	fake_fb.console_mode = KD_GRAPHICS;
	assert_false(console_is_in_use(&fake_fb_calls));
	assert_int_equal(scene_open(&scene), 0);
	scene_close(&scene);
	assert_int_equal(log_capture_count(&scene.capture, LOG_WARNING), 0);
}

static void test_another_programs_console_is_left_alone(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
	assert_false(console_is_in_use(&fake_fb_calls));
	fake_fb.has_console = true;
	fake_fb.console_watched = true;
	assert_false(console_is_in_use(&fake_fb_calls));
	fake_fb.console_mode = KD_GRAPHICS;
	assert_true(console_is_in_use(&fake_fb_calls));
	assert_int_equal(scene_open(&scene), 0);
	assert_true(log_capture_has(&scene.capture, LOG_WARNING, "another"));
	draw(&scene);
	scene.driver->destroy(scene.display);
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	assert_int_equal(fake_fb.open_count, 0);
}

/* Ends itself by that signal, with the console taken; never returns. */
static void end_by(int number, int report_fd)
{
	const struct rlimit none = {0, 0};
	struct scene scene = {0};

	setrlimit(RLIMIT_CORE, &none);
	signal(number, SIG_DFL);
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
	fake_fb.has_console = true;
	fake_fb.report_fd = report_fd;
	if (scene_open(&scene) == 0) {
		raise(number);
	}
	_exit(99);
}

static void test_a_signal_that_ends_brings_the_console_back(void **state)
{
	static const int signals[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT,
		SIGQUIT, SIGTERM, SIGINT, SIGHUP, SIGPIPE};

	(void)state;
	for (size_t i = 0; i < sizeof(signals) / sizeof(signals[0]); i++) {
		char modes[4] = {0};
		int ends[2];
		int status;
		pid_t child;

		assert_int_equal(pipe(ends), 0);
		child = fork();
		assert_true(child >= 0);
		if (child == 0) {
			end_by(signals[i], ends[1]);
		}
		close(ends[1]);
		assert_int_equal(waitpid(child, &status, 0), child);
		assert_true(WIFSIGNALED(status));
		assert_int_equal(WTERMSIG(status), signals[i]);
		assert_int_equal(read(ends[0], modes, sizeof(modes)), 2);
		assert_int_equal(modes[0], KD_GRAPHICS);
		assert_int_equal(modes[1], KD_TEXT);
		close(ends[0]);
	}
}

static void test_a_wish_to_stop_is_left_to_the_frame_loop(void **state)
{
	struct scene scene = {0};

	(void)state;
	signal(SIGTERM, SIG_DFL);
	stop_catch();
	fake_fb_begin(WIDTH, HEIGHT, HEIGHT, HEIGHT, WIDTH * 2, rgb565);
	fake_fb.has_console = true;
	assert_int_equal(scene_open(&scene), 0);
	assert_false(stop_requested());
	raise(SIGTERM);
	assert_true(stop_requested());
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	scene_close(&scene);
	stop_release();
}

static void test_the_real_system_is_asked_politely(void **state)
{
	struct scene scene = {.options = {.device = "/dev/null"}};

	(void)state;
	scene.driver = display_find("fbdev");
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
		cmocka_unit_test(test_a_palette_is_filled_and_put_back),
		cmocka_unit_test(test_tables_of_channels_become_straight),
		cmocka_unit_test(test_nothing_beside_the_picture_is_written),
		cmocka_unit_test(test_two_pages_are_drawn_into_in_turn),
		cmocka_unit_test(test_a_second_page_is_asked_for_and_given_back),
		cmocka_unit_test(test_a_driver_that_rounds_the_mode_is_set_back),
		cmocka_unit_test(test_what_is_seen_before_is_where_one_page_goes),
		cmocka_unit_test(
			test_a_smaller_picture_lies_in_the_middle_on_black),
		cmocka_unit_test(test_a_larger_picture_is_cut_to_the_screen),
		cmocka_unit_test(test_the_format_asked_for_is_converted),
		cmocka_unit_test(test_the_rate_is_told_where_the_device_waits),
		cmocka_unit_test(test_what_fails_is_said_and_everything_closed),
		cmocka_unit_test(test_what_is_not_needed_may_fail),
		cmocka_unit_test(test_a_failing_flip_is_told),
		cmocka_unit_test(test_a_missing_device_says_what_to_do),
		cmocka_unit_test(test_modes_without_sense_are_refused),
		cmocka_unit_test(test_the_console_is_dark_meanwhile),
		cmocka_unit_test(test_another_programs_console_is_left_alone),
		cmocka_unit_test(test_a_signal_that_ends_brings_the_console_back),
		cmocka_unit_test(test_a_wish_to_stop_is_left_to_the_frame_loop),
		cmocka_unit_test(test_the_real_system_is_asked_politely),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
