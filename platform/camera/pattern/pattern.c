/*
 * A test picture instead of a camera: colour bars, a grey ramp, a mark in the
 * top left corner and a bouncing ball. The picture depends on the time only.
 */
#include "platform/camera/camera.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	RATE_HZ = 25,
	BARS = 8,
	LEAST_SIDE = 16
};

struct ycc {
	uint8_t y, cb, cr;
};

struct camera_source {
	enum camera_format format;
	int width, height;
	struct camera_layout layout;
	uint8_t *card;    /* the picture without the ball */
	uint8_t *picture; /* the picture with the ball */
	int64_t shown;    /* number of the picture, -1 before the first */
};

/* BT.601, limited range; rgb 0..255. */
static struct ycc to_ycc(const uint8_t rgb[3])
{
	int r = rgb[0], g = rgb[1], b = rgb[2];

	return (struct ycc){
		.y = (uint8_t)((66 * r + 129 * g + 25 * b + 128 + 16 * 256) /
			256),
		.cb = (uint8_t)((-38 * r - 74 * g + 112 * b + 128 + 128 * 256) /
			256),
		.cr = (uint8_t)((112 * r - 94 * g - 18 * b + 128 + 128 * 256) /
			256),
	};
}

static void put_ycc(const struct camera_source *source, uint8_t *data, int x,
	int y, struct ycc ycc)
{
	const struct camera_layout *layout = &source->layout;
	uint8_t *row[CAMERA_PLANES];

	for (int i = 0; i < CAMERA_PLANES; i++) {
		row[i] = data + layout->offset[i] +
			layout->stride_bytes[i] * (i ? y / 2 : y);
	}
	switch (source->format) {
	case CAMERA_UYVY:
		row[0] += x / 2 * 4;
		row[0][x % 2 * 2 + 1] = ycc.y;
		row[0][0] = ycc.cb;
		row[0][2] = ycc.cr;
		break;
	case CAMERA_YUYV:
		row[0] += x / 2 * 4;
		row[0][x % 2 * 2] = ycc.y;
		row[0][1] = ycc.cb;
		row[0][3] = ycc.cr;
		break;
	case CAMERA_NV12:
		row[0][x] = ycc.y;
		row[1][x / 2 * 2] = ycc.cb;
		row[1][x / 2 * 2 + 1] = ycc.cr;
		break;
	default:
		row[0][x] = ycc.y;
		row[1][x / 2] = ycc.cb;
		row[2][x / 2] = ycc.cr;
		break;
	}
}

static void put_rgb(const struct camera_source *source, uint8_t *data, int x,
	int y, const uint8_t rgb[3])
{
	uint8_t *row = data + source->layout.stride_bytes[0] * y;
	unsigned packed;

	switch (source->format) {
	case CAMERA_RGB565:
		packed = (unsigned)(rgb[0] >> 3 << 11 | rgb[1] >> 2 << 5 |
			rgb[2] >> 3);
		row[x * 2] = (uint8_t)packed;
		row[x * 2 + 1] = (uint8_t)(packed >> 8);
		break;
	case CAMERA_RGB24:
		memcpy(row + x * 3, rgb, 3);
		break;
	case CAMERA_BGR24:
		for (int i = 0; i < 3; i++) {
			row[x * 3 + i] = rgb[2 - i];
		}
		break;
	default:
		put_ycc(source, data, x, y, to_ycc(rgb));
		break;
	}
}

static void card_color(int x, int y, int width, int height, uint8_t rgb[3])
{
	static const uint8_t bar[BARS][3] = {{235, 235, 235}, {228, 196, 40},
		{44, 188, 200}, {56, 184, 76}, {196, 64, 180}, {208, 56, 48},
		{44, 72, 196}, {24, 24, 28}};
	int mark = height / 6;

	if (x + y < mark) {
		memset(rgb, 255, 3);
		rgb[2] = 0;
	} else if (y < height * 3 / 4) {
		memcpy(rgb, bar[x * BARS / width], 3);
	} else {
		memset(rgb, 255 * x / width, 3);
	}
}

static void draw_card(struct camera_source *source)
{
	for (int y = 0; y < source->height; y++) {
		for (int x = 0; x < source->width; x++) {
			uint8_t rgb[3];

			card_color(x, y, source->width, source->height, rgb);
			put_rgb(source, source->card, x, y, rgb);
		}
	}
}

/* Folds a distance into a position that moves back and forth in 0..span. */
static int bounce(int64_t distance, int span)
{
	int at;

	if (span == 0) {
		return 0;
	}
	at = (int)(distance % (2 * span));
	return at < span ? at : 2 * span - at;
}

/* The ball fits into the picture, which may be narrow. */
static int ball_radius(const struct camera_source *source)
{
	int wanted = source->height / 7, most = (source->width - 1) / 2;

	return wanted < most ? wanted : most;
}

static void draw_ball(struct camera_source *source, int64_t number)
{
	static const uint8_t rim[3] = {20, 20, 24}, middle[3] = {250, 120, 30};
	int radius = ball_radius(source);
	int left = bounce(
		number * source->width / 60, source->width - 2 * radius - 1);
	int top = bounce(
		number * source->height / 44, source->height - 2 * radius - 1);
	int outer = radius * radius, inner = radius * radius * 3 / 4;

	for (int y = -radius; y <= radius; y++) {
		for (int x = -radius; x <= radius; x++) {
			int squared = x * x + y * y;

			if (squared <= outer) {
				put_rgb(source, source->picture,
					left + radius + x, top + radius + y,
					squared <= inner ? middle : rim);
			}
		}
	}
}

static int check(const struct camera_options *options)
{
	const struct log *log = options->log;

	if (options->argument) {
		log_error(log, "--camera pattern:%s: pattern takes no argument",
			options->argument);
		return -EINVAL;
	}
	if (options->width < LEAST_SIDE || options->height < LEAST_SIDE) {
		log_error(log,
			"--camera pattern: give a size of at least %dx%d pixels",
			LEAST_SIDE, LEAST_SIDE);
		return -EINVAL;
	}
	if (options->format &&
		camera_format_find(options->format) == CAMERA_FORMATS) {
		log_error(log,
			"--camera pattern: no such format: %s: choose rgb565, uyvy, yuyv, nv12, yuv420, rgb24 or bgr24",
			options->format);
		return -EINVAL;
	}
	return 0;
}

static void pattern_destroy(struct camera_source *source)
{
	if (source) {
		free(source->picture);
		free(source->card);
		free(source);
	}
}

static int pattern_create(
	const struct camera_options *options, struct camera_source **out)
{
	struct camera_source *source;
	int error = check(options);

	if (error) {
		return error;
	}
	source = calloc(1, sizeof(*source));
	if (!source) {
		goto fail;
	}
	source->format = options->format ? camera_format_find(options->format)
					 : CAMERA_UYVY;
	source->width = options->width;
	source->height = options->height;
	source->layout = camera_layout_of(
		source->format, source->width, source->height, 0);
	source->shown = -1;
	source->card = calloc(1, (size_t)source->layout.size);
	source->picture = calloc(1, (size_t)source->layout.size);
	if (!source->card || !source->picture) {
		goto fail;
	}
	draw_card(source);
	*out = source;
	return 0;
fail:
	log_error(options->log, "--camera pattern: out of memory");
	pattern_destroy(source);
	return -ENOMEM;
}

static enum camera_status pattern_take(
	struct camera_source *source, int64_t now_ms, struct camera_image *out)
{
	int64_t number = (now_ms < 0 ? 0 : now_ms) * RATE_HZ / 1000;

	if (number == source->shown) {
		return CAMERA_SAME;
	}
	source->shown = number;
	memcpy(source->picture, source->card, (size_t)source->layout.size);
	draw_ball(source, number);
	*out = camera_image_at(source->format, source->width, source->height,
		&source->layout, source->picture);
	return CAMERA_NEW;
}

static void pattern_give_back(struct camera_source *source)
{
	(void)source;
}

const struct camera_driver camera_driver_pattern = {
	.name = "pattern",
	.summary = "colour bars and a ball that bounces",
	.create = pattern_create,
	.take = pattern_take,
	.give_back = pattern_give_back,
	.destroy = pattern_destroy,
};
