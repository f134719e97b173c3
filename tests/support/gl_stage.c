#include "tests/support/gl_checks.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"

#ifdef __arm__
static const bool library_may_lack = true;
#else
static const bool library_may_lack = false;
#endif

static void fail_or_skip(const char *driver, int error)
{
	static char reason[64];

	if (library_may_lack && (error == -ENOENT || error == -ENODEV)) {
		snprintf(reason, sizeof(reason), "--gl %s does not open here",
			driver);
		skip_because(reason);
	}
	fail_msg("--gl %s: does not open: %s", driver, strerror(-error));
}

struct stage stage_open(const char *driver, enum pixel_format format)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct stage stage;
	int error;

	error = gl_open(driver, format, &log, &stage.context);
	if (error) {
		fail_or_skip(driver, error);
	}
	stage.gl = &stage.context->gl;
	assert_int_equal(pixels_alloc(&stage.pixels, STAGE_WIDTH, STAGE_HEIGHT,
				 format, &log),
		0);
	assert_int_equal(
		stage.context->driver->begin_frame(stage.context, &stage.pixels),
		0);
	stage.gl->ClearColorx(0, 0, 0, FX16_ONE);
	stage.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT);
	return stage;
}

void stage_end_frame(struct stage *stage)
{
	assert_int_equal(stage->gl->GetError(), GL_NO_ERROR);
	assert_int_equal(stage->context->driver->end_frame(stage->context), 0);
	assert_int_equal(stage->gl->GetError(), GL_NO_ERROR);
}

void stage_close(struct stage *stage)
{
	stage->context->driver->destroy(stage->context);
	free(stage->pixels.data);
}

static void read_pixel(const struct pixels *pixels, int x, int y, int rgb[3])
{
	const uint8_t *data = pixels->data + y * pixels->stride_bytes +
		x * pixel_bytes(pixels->format);
	uint16_t packed;

	if (pixels->format == PIXELS_RGBA8888) {
		for (int i = 0; i < 3; i++) {
			rgb[i] = data[i];
		}
		return;
	}
	memcpy(&packed, data, sizeof(packed));
	rgb[0] = (packed >> 11) * 255 / 31;
	rgb[1] = (packed >> 5 & 63) * 255 / 63;
	rgb[2] = (packed & 31) * 255 / 31;
}

void stage_expect(const struct stage *stage, int x, int y, int red, int green,
	int blue, int tolerance)
{
	int rgb[3];

	read_pixel(&stage->pixels, x, y, rgb);
	if (abs(rgb[0] - red) > tolerance || abs(rgb[1] - green) > tolerance ||
		abs(rgb[2] - blue) > tolerance) {
		fail_msg("pixel (%d, %d) is (%d, %d, %d), not (%d, %d, %d) "
			 "within %d",
			x, y, rgb[0], rgb[1], rgb[2], red, green, blue,
			tolerance);
	}
}
