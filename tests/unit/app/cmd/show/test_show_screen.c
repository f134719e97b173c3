/*
 * Who begins and ends a frame on a surface and in pixels, and what the picture
 * of a surface is. A made-up display and a made-up GL note their calls.
 */
#include "app/cmd/show/show_screen.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

enum {
	WIDTH = 5,
	HEIGHT = 4
};

/* The calls carry no context of the test. */
static struct {
	char calls[64]; /* a letter each */
	int display_error, gl_error;
	const struct pixels *target;
	int width, height; /* of the surface */
} noted;

static void note(char call)
{
	noted.calls[strlen(noted.calls)] = call;
}

static void expect_calls(const char *calls)
{
	assert_string_equal(noted.calls, calls);
	memset(noted.calls, 0, sizeof(noted.calls));
}

static void get_surface(
	const struct display *display, struct native_surface *out)
{
	(void)display;
	(void)out;
}

static int begin_pixels(struct display *display, struct pixels *out)
{
	static uint8_t data[HEIGHT][WIDTH][4];

	(void)display;
	note('p');
	*out = (struct pixels){
		&data[0][0][0], WIDTH, HEIGHT, WIDTH * 4, PIXELS_RGBA8888};
	return noted.display_error;
}

static int end_display(struct display *display)
{
	(void)display;
	note('d');
	return noted.display_error;
}

static void destroy_display(struct display *display)
{
	(void)display;
	note('D');
}

static int begin_gl(struct gl_context *context, const struct pixels *target)
{
	(void)context;
	note('b');
	noted.target = target;
	return noted.gl_error;
}

static int end_gl(struct gl_context *context)
{
	(void)context;
	note('e');
	return noted.gl_error;
}

static void destroy_gl(struct gl_context *context)
{
	(void)context;
	note('G');
}

/* A surface's pixel, which has y upwards, as GL does. */
static uint8_t channel_of(int x, int y, int channel)
{
	return (uint8_t)(x * 50 + y * 7 + channel * 3);
}

static void read_pixels(GLint x, GLint y, GLsizei width, GLsizei height,
	GLenum format, GLenum type, void *pixels)
{
	uint8_t *next = pixels;

	assert_int_equal(format, GL_RGBA);
	assert_int_equal(type, GL_UNSIGNED_BYTE);
	assert_int_equal(width, noted.width);
	assert_int_equal(height, noted.height);
	for (int i = 0; i < width * height * 4; i++) {
		int column = i / 4 % width, row = i / 4 / width;

		next[i] = channel_of(x + column, y + row, i % 4);
	}
}

static const struct gl_driver gl_driver = {
	.begin_frame = begin_gl, .end_frame = end_gl, .destroy = destroy_gl};
static const struct display_driver on_surface = {.get_surface = get_surface,
	.end_frame = end_display,
	.destroy = destroy_display};
static const struct display_driver in_pixels = {.begin_frame = begin_pixels,
	.end_frame = end_display,
	.destroy = destroy_display};

static struct show_screen begin(
	struct gl_context *gl, const struct display_driver *display)
{
	memset(&noted, 0, sizeof(noted));
	*gl = (struct gl_context){.driver = &gl_driver};
	gl->gl.ReadPixels = read_pixels;
	return (struct show_screen){.driver = display, .gl = gl};
}

static void expect_picture(struct show_screen *screen, int width, int height)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct pixels picture;

	screen->gl->width = noted.width = width;
	screen->gl->height = noted.height = height;
	assert_int_equal(show_screen_picture(screen, &picture, &log), 0);
	assert_int_equal(picture.width, width);
	assert_int_equal(picture.height, height);
	assert_int_equal(picture.format, PIXELS_RGBA8888);
	for (int i = 0; i < width * height * 4; i++) {
		int x = i / 4 % width, y = i / 4 / width;

		assert_int_equal(
			picture.data[y * picture.stride_bytes + i % (4 * width)],
			channel_of(x, height - 1 - y, i % 4));
	}
}

static void test_the_picture_of_a_surface_is_the_right_way_up(void **state)
{
	static const int sizes[][2] = {
		{5, 4}, {5, 4}, {5, 3}, {3, 5}, {1, 1}, {4, 1}, {1, 2}, {5, 2}};
	struct gl_context gl;
	struct show_screen screen = begin(&gl, &on_surface);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		expect_picture(&screen, sizes[i][0], sizes[i][1]);
	}
	show_screen_close(&screen);
	expect_calls("GD");
}

static void test_gl_shows_the_frames_of_a_surface(void **state)
{
	struct gl_context gl;
	struct show_screen screen = begin(&gl, &on_surface);
	int width = 0, height = 0;

	(void)state;
	gl.width = 31;
	gl.height = 17;
	assert_int_equal(show_screen_begin_frame(&screen, &width, &height), 0);
	assert_int_equal(width, 31);
	assert_int_equal(height, 17);
	assert_null(noted.target);
	expect_calls("b");
	assert_int_equal(show_screen_complete_frame(&screen), 0);
	expect_calls("");
	assert_int_equal(show_screen_end_frame(&screen), 0);
	expect_calls("ed");
	noted.gl_error = -EIO;
	assert_int_equal(
		show_screen_begin_frame(&screen, &width, &height), -EIO);
	assert_int_equal(show_screen_complete_frame(&screen), 0);
	expect_calls("b");
	assert_int_equal(show_screen_end_frame(&screen), -EIO);
	expect_calls("e");
	show_screen_close(&screen);
}

static void test_the_display_shows_the_frames_of_pixels(void **state)
{
	struct gl_context gl;
	struct show_screen screen = begin(&gl, &in_pixels);
	struct log log = log_to_nowhere();
	int width = 0, height = 0;
	struct pixels picture;

	(void)state;
	assert_int_equal(show_screen_begin_frame(&screen, &width, &height), 0);
	assert_int_equal(width, WIDTH);
	assert_int_equal(height, HEIGHT);
	assert_non_null(noted.target);
	expect_calls("pb");
	assert_int_equal(show_screen_complete_frame(&screen), 0);
	expect_calls("e");
	assert_int_equal(show_screen_picture(&screen, &picture, &log), 0);
	assert_ptr_equal(picture.data, screen.pixels.data);
	assert_int_equal(picture.height, HEIGHT);
	assert_int_equal(show_screen_end_frame(&screen), 0);
	expect_calls("d");
	show_screen_close(&screen);
}

static void test_a_frame_of_pixels_that_fails_is_an_error(void **state)
{
	struct gl_context gl;
	struct show_screen screen = begin(&gl, &in_pixels);
	int width = 0, height = 0;

	(void)state;
	noted.gl_error = -EIO;
	assert_int_equal(
		show_screen_begin_frame(&screen, &width, &height), -EIO);
	expect_calls("pb");
	assert_int_equal(show_screen_complete_frame(&screen), -EIO);
	expect_calls("e");
	noted.display_error = -ENODEV;
	assert_int_equal(
		show_screen_begin_frame(&screen, &width, &height), -ENODEV);
	expect_calls("p");
	assert_null(screen.pixels.data);
	assert_int_equal(show_screen_end_frame(&screen), -ENODEV);
	expect_calls("d");
	show_screen_close(&screen);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_picture_of_a_surface_is_the_right_way_up),
		cmocka_unit_test(test_gl_shows_the_frames_of_a_surface),
		cmocka_unit_test(test_the_display_shows_the_frames_of_pixels),
		cmocka_unit_test(test_a_frame_of_pixels_that_fails_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
