#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const enum pixel_format gl_expect_formats[2] = {PIXELS_RGBA8888, PIXELS_RGB565};

void gl_expect_read(const struct stage *stage, int x, int y, uint8_t rgba[4])
{
	stage->gl->ReadPixels(
		x, STAGE_HEIGHT - 1 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
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

static void expect(const struct stage *stage, const char *name, int x, int y,
	const double *wanted, int channels)
{
	uint8_t is[4];
	bool near = true;

	gl_expect_read(stage, x, y, is);
	for (int i = 0; i < channels; i++) {
		near = near &&
			fabs(is[i] - 255 * clamp(wanted[i])) <=
				tolerance_of(stage->pixels.format, i);
	}
	if (!near) {
		fail_msg("%s%s: pixel (%d, %d) is (%d, %d, %d, %d), not "
			 "(%.1f, %.1f, %.1f, %.1f)",
			name,
			stage->pixels.format == PIXELS_RGB565 ? " in RGB565"
							      : "",
			x, y, is[0], is[1], is[2], is[3], 255 * wanted[0],
			255 * wanted[1], 255 * wanted[2],
			channels > 3 ? 255 * wanted[3] : 255);
	}
}

void gl_expect_color(const struct stage *stage, const char *name, int x, int y,
	const double rgb[3])
{
	expect(stage, name, x, y, rgb, 3);
}

void gl_expect_color_alpha(const struct stage *stage, const char *name, int x,
	int y, const double rgba[4])
{
	bool alpha = stage->pixels.format == PIXELS_RGBA8888;

	expect(stage, name, x, y, rgba, alpha ? 4 : 3);
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

/* OSMesa allows one context at a time: keeps the picture, closes the context. */
static uint8_t *draw_with(const char *driver,
	void (*draw)(struct gl *gl, const void *context), const void *context)
{
	struct stage stage = stage_open(driver, PIXELS_RGBA8888);
	uint8_t *picture;

	stage.gl->Disable(GL_DITHER);
	draw(stage.gl, context);
	stage_end_frame(&stage);
	assert_int_equal(stage.pixels.stride_bytes, 4 * STAGE_WIDTH);
	picture = stage.pixels.data;
	stage.pixels.data = NULL;
	stage_close(&stage);
	return picture;
}

/* Whether the other picture has the colour of this pixel within reach of it. */
static bool is_found(const uint8_t *own, const uint8_t *other, int at,
	int reach, int tolerance)
{
	for (int i = 0; i < (2 * reach + 1) * (2 * reach + 1); i++) {
		int x = at % STAGE_WIDTH + i % (2 * reach + 1) - reach;
		int y = at / STAGE_WIDTH + i / (2 * reach + 1) - reach;
		bool near =
			x >= 0 && x < STAGE_WIDTH && y >= 0 && y < STAGE_HEIGHT;

		for (int j = 0; j < 3 && near; j++) {
			near = abs(own[4 * at + j] -
				       other[4 * (y * STAGE_WIDTH + x) + j]) <=
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

	for (int i = 0; i < STAGE_WIDTH * STAGE_HEIGHT; i++) {
		count += !is_found(own, reference, i, reach, tolerance) ||
			!is_found(reference, own, i, reach, tolerance);
	}
	free(reference);
	free(own);
	return count;
}
