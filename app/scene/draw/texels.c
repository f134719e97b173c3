#include "app/scene/draw/texels.h"

#include "app/model/image/image.h"
#include "app/model/image/image_halve.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	SIDE_MAX = IMAGE_SIDE_USED,
	SMALL_MAX = 128 /* a side of few texels is enlarged to this at most */
};

/* Every second byte of a word: sums and products of 16 bits have room. */
static const uint32_t even_bytes = 0x00ff00ff;

/*
 * A side of few texels, such as a row of colours, becomes several times as
 * long: each of its texels then keeps its colour in its middle.
 */
static int power_of_two_near(int side)
{
	int power = 1;

	while (power < side && power < SIDE_MAX) {
		power *= 2;
	}
	if (power > side && power <= SMALL_MAX / 2) {
		return 4 * power < SMALL_MAX ? 4 * power : SMALL_MAX;
	}
	/* The nearer one: 300 becomes 256, 400 becomes 512. */
	return power > 1 && power - side > side - power / 2 ? power / 2 : power;
}

int texels_side(int side, enum model_wrap wrap)
{
	int power = power_of_two_near(side);

	return wrap == MODEL_MIRROR && power < SIDE_MAX ? 2 * power : power;
}

/* Where a texel's centre lies along one axis of the image. */
struct place {
	int first, second; /* columns or rows between which it lies */
	uint32_t part;     /* of the second one, in 1/256 */
};

/*
 * If the model asks for the nearest texel, places are whole columns or rows, so
 * that texels are not interpolated.
 */
static struct place place_at(int texel, int side, int source_side,
	enum model_wrap wrap, bool nearest)
{
	int once = wrap == MODEL_MIRROR ? side / 2 : side;
	int last = (source_side - 1) * 256;
	struct place place;
	int64_t at;

	if (texel >= once) {
		texel = side - 1 - texel;
	}
	at = ((int64_t)texel * 2 + 1) * source_side * 128 / once - 128;
	at = nearest ? (at + 128) & ~255 : at;
	at = at < 0 ? 0 : at > last ? last : at;
	place.first = (int)(at >> 8);
	place.second = at < last ? place.first + 1 : place.first;
	place.part = (uint32_t)at & 255;
	return place;
}

/* The places of all texels along an axis; the caller frees them. */
static struct place *find_places(
	int side, int source_side, enum model_wrap wrap, bool nearest)
{
	struct place *place = malloc((size_t)side * sizeof(*place));

	for (int i = 0; place && i < side; i++) {
		place[i] = place_at(i, side, source_side, wrap, nearest);
	}
	return place;
}

static uint32_t load(const uint8_t rgba[4])
{
	uint32_t word;

	memcpy(&word, rgba, sizeof(word));
	return word;
}

/* Mixes every second byte of two texels along x, each to 16 bits. */
static uint32_t mix_x(uint32_t first, uint32_t second, uint32_t part)
{
	return (first & even_bytes) * (256 - part) +
		(second & even_bytes) * part;
}

/* Mixes two results of mix_x() along y, to every second byte of a texel. */
static uint32_t mix_y(uint32_t first, uint32_t second, uint32_t part)
{
	uint32_t low = (first & 0xffff) * (256 - part) +
		(second & 0xffff) * part + 32768;
	uint32_t high =
		(first >> 16) * (256 - part) + (second >> 16) * part + 32768;

	return (high & 0xff0000) | low >> 16;
}

static void resample_row(const struct model_image *image,
	const struct place *column, const struct place *row, int width,
	uint8_t (*out)[4])
{
	size_t stride = (size_t)image->width * 4;
	const uint8_t *above = image->rgba + (size_t)row->first * stride;
	const uint8_t *below = image->rgba + (size_t)row->second * stride;

	for (int x = 0; x < width; x++) {
		size_t left = (size_t)column[x].first * 4;
		size_t right = (size_t)column[x].second * 4;
		uint32_t a = load(above + left), b = load(above + right);
		uint32_t c = load(below + left), d = load(below + right);
		uint32_t part = column[x].part;
		uint32_t even =
			mix_y(mix_x(a, b, part), mix_x(c, d, part), row->part);
		uint32_t odd = mix_y(mix_x(a >> 8, b >> 8, part),
			mix_x(c >> 8, d >> 8, part), row->part);
		uint32_t word = even | odd << 8;

		memcpy(out[x], &word, sizeof(word));
	}
}

static int resample(const struct model_image *image,
	const struct model_texture *sampling, struct texels *out)
{
	struct place *column = find_places(
		out->width, image->width, sampling->wrap_s, sampling->nearest);

	if (!column) {
		return -ENOMEM;
	}
	for (int y = 0; y < out->height; y++) {
		struct place row = place_at(y, out->height, image->height,
			sampling->wrap_t, sampling->nearest);

		resample_row(image, column, &row, out->width,
			out->rgba + (size_t)y * (size_t)out->width);
	}
	free(column);
	return 0;
}

int texels_resample(const struct model_image *image,
	const struct model_texture *sampling, struct texels *out)
{
	int error = 0;
	size_t count;

	out->width = texels_side(image->width, sampling->wrap_s);
	out->height = texels_side(image->height, sampling->wrap_t);
	count = (size_t)out->width * (size_t)out->height;
	out->rgba = malloc(count * 4);
	if (!out->rgba) {
		return -ENOMEM;
	}
	if (out->width == image->width && out->height == image->height) {
		memcpy(out->rgba, image->rgba, count * 4);
		return 0;
	}
	error = resample(image, sampling, out);
	if (error) {
		free(out->rgba);
		out->rgba = NULL;
	}
	return error;
}

void texels_halve(struct texels *texels)
{
	int width = texels->width, height = texels->height;
	const uint8_t(*row)[4] = (const uint8_t(*)[4])texels->rgba;
	uint8_t(*out)[4] = texels->rgba;

	texels->width = (width + 1) / 2;
	texels->height = (height + 1) / 2;
	for (int y = 0; y < texels->height; y++) {
		image_halve_rows(
			row, height > 1 ? row + width : row, width, out);
		row += 2 * width;
		out += texels->width;
	}
}

bool texels_are_gray(const struct texels *texels)
{
	for (int i = 0; i < texels->width * texels->height; i++) {
		const uint8_t *t = texels->rgba[i];

		if (t[0] != t[1] || t[0] != t[2]) {
			return false;
		}
	}
	return true;
}

void texels_pack_gray(const struct texels *texels, uint8_t *out)
{
	for (int i = 0; i < texels->width * texels->height; i++) {
		out[i] = texels->rgba[i][0];
	}
}

void texels_pack_565(const struct texels *texels, uint16_t *out)
{
	for (int i = 0; i < texels->width * texels->height; i++) {
		const uint8_t *t = texels->rgba[i];

		out[i] = (uint16_t)((t[0] >> 3) << 11 | (t[1] >> 2) << 5 |
			t[2] >> 3);
	}
}

void texels_pack_4444(const struct texels *texels, uint16_t *out)
{
	for (int i = 0; i < texels->width * texels->height; i++) {
		const uint8_t *t = texels->rgba[i];

		out[i] = (uint16_t)((t[0] >> 4) << 12 | (t[1] >> 4) << 8 |
			(t[2] >> 4) << 4 | t[3] >> 4);
	}
}
