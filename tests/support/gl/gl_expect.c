#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const enum pixel_format gl_expect_formats[2] = {PIXELS_RGBA8888, PIXELS_RGB565};

void gl_expect_read(
	const struct gl_canvas *canvas, int x, int y, uint8_t rgba[4])
{
	canvas->gl->ReadPixels(x, GL_CANVAS_HEIGHT - 1 - y, 1, 1, GL_RGBA,
		GL_UNSIGNED_BYTE, rgba);
}

static double clamp(double value)
{
	return value < 0 ? 0 : value > 1 ? 1 : value;
}

static double tolerance_of(enum pixel_format format, int channel)
{
	if (format == PIXELS_RGBA8888) {
		return 2.0;
	}
	return 2.0 * 255 / (channel == 1 ? 63 : 31);
}

static void expect(const struct gl_canvas *canvas, const char *name, int x,
	int y, const double *wanted, int channels)
{
	uint8_t is[4];
	bool near = true;

	gl_expect_read(canvas, x, y, is);
	for (int i = 0; i < channels; i++) {
		near = near &&
			fabs(is[i] - 255 * clamp(wanted[i])) <=
				tolerance_of(canvas->pixels.format, i);
	}
	if (!near) {
		fail_msg("%s%s: pixel (%d, %d) is (%d, %d, %d, %d), not "
			 "(%.1f, %.1f, %.1f, %.1f)",
			name,
			canvas->pixels.format == PIXELS_RGB565 ? " in RGB565"
							       : "",
			x, y, is[0], is[1], is[2], is[3], 255 * wanted[0],
			255 * wanted[1], 255 * wanted[2],
			channels > 3 ? 255 * wanted[3] : 255);
	}
}

void gl_expect_color(const struct gl_canvas *canvas, const char *name, int x,
	int y, const double rgb[3])
{
	expect(canvas, name, x, y, rgb, 3);
}

void gl_expect_color_alpha(const struct gl_canvas *canvas, const char *name,
	int x, int y, const double rgba[4])
{
	bool alpha = canvas->pixels.format == PIXELS_RGBA8888;

	expect(canvas, name, x, y, rgba, alpha ? 4 : 3);
}

GLfixed gl_fixed(double value)
{
	return (GLfixed)lrint(value * 65536);
}

void gl_fixed_all(const double *values, int count, GLfixed *out)
{
	for (int i = 0; i < count; i++) {
		out[i] = gl_fixed(values[i]);
	}
}

void gl_set_color(struct gl *gl, const double rgba[4])
{
	gl->Color4x(gl_fixed(rgba[0]), gl_fixed(rgba[1]), gl_fixed(rgba[2]),
		gl_fixed(rgba[3]));
}

void gl_clear_to(struct gl *gl, const double rgba[4])
{
	gl->ClearColorx(gl_fixed(rgba[0]), gl_fixed(rgba[1]), gl_fixed(rgba[2]),
		gl_fixed(rgba[3]));
	gl->Clear(GL_COLOR_BUFFER_BIT);
}

/*
 * Draws with a driver and returns the picture, which the caller frees. The
 * context is closed before, because OSMesa allows only one at a time.
 */
static uint8_t *draw_with(const char *driver,
	void (*draw)(struct gl *gl, const void *context), const void *context)
{
	struct gl_canvas canvas = gl_canvas_open(driver, PIXELS_RGBA8888);
	uint8_t *picture;

	canvas.gl->Disable(GL_DITHER);
	draw(canvas.gl, context);
	gl_canvas_end_frame(&canvas);
	assert_int_equal(canvas.pixels.stride_bytes, 4 * GL_CANVAS_WIDTH);
	picture = canvas.pixels.data;
	canvas.pixels.data = NULL;
	gl_canvas_close(&canvas);
	return picture;
}

/* Whether other has the colour of own's pixel at, within reach pixels of at. */
static bool is_found(const uint8_t *own, const uint8_t *other, int at,
	int reach, int tolerance)
{
	for (int i = 0; i < (2 * reach + 1) * (2 * reach + 1); i++) {
		int x = at % GL_CANVAS_WIDTH + i % (2 * reach + 1) - reach;
		int y = at / GL_CANVAS_WIDTH + i / (2 * reach + 1) - reach;
		bool near = x >= 0 && x < GL_CANVAS_WIDTH && y >= 0 &&
			y < GL_CANVAS_HEIGHT;

		for (int j = 0; j < 3 && near; j++) {
			near = abs(own[4 * at + j] -
				       other[4 * (y * GL_CANVAS_WIDTH + x) + j]) <=
				tolerance;
		}
		if (near) {
			return true;
		}
	}
	return false;
}

int gl_count_differences(void (*draw)(struct gl *gl, const void *context),
	const void *context, int reach, int tolerance)
{
	uint8_t *reference = draw_with("osmesa", draw, context);
	uint8_t *own = draw_with("soft", draw, context);
	int count = 0;

	for (int i = 0; i < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; i++) {
		count += !is_found(own, reference, i, reach, tolerance) ||
			!is_found(reference, own, i, reach, tolerance);
	}
	free(reference);
	free(own);
	return count;
}
