#include "platform/display/packing_rows.h"

#include <string.h>

#include "platform/base/compiler.h"

static bool is_big_endian(void)
{
	return pixel_layout_of(PIXELS_RGBA8888).red.offset != 0;
}

/* GCC would load four bytes one by one for a pixel that it sees stored again. */
static ALWAYS_INLINE uint32_t load(const uint8_t *in)
{
	uint32_t pixel;

	memcpy(&pixel, in, sizeof(pixel));
	OPAQUE(pixel);
	return pixel;
}

static ALWAYS_INLINE void store(uint8_t *out, uint32_t pixel)
{
	memcpy(out, &pixel, sizeof(pixel));
}

static void copy_same(const struct packing *packing, const uint8_t *in,
	uint8_t *out, int width)
{
	memcpy(out, in, (size_t)width * (size_t)packing->bytes);
}

/* Pixels of RGBA8888 for a screen that has the same bytes, the last opaque. */
static void copy_opaque(const struct packing *packing, const uint8_t *in,
	uint8_t *out, int width)
{
	uint32_t opaque = packing->opaque;

	for (; width >= 4; width -= 4, in += 16, out += 16) {
		uint32_t a = load(in), b = load(in + 4), c = load(in + 8);
		uint32_t d = load(in + 12);

		store(out, a | opaque);
		store(out + 4, b | opaque);
		store(out + 8, c | opaque);
		store(out + 12, d | opaque);
	}
	for (; width > 0; width--, in += 4, out += 4) {
		store(out, load(in) | opaque);
	}
}

/*
 * Pixels of RGBA8888 for a screen with the bytes B G R and any fourth, on a
 * little-endian machine. Compilers reverse four bytes by one instruction of ARMv6.
 */
static ALWAYS_INLINE uint32_t swap(uint32_t pixel, uint32_t opaque)
{
	uint32_t reversed = (pixel & 0xff) << 24 | (pixel & 0xff00) << 8 |
		(pixel >> 8 & 0xff00) | pixel >> 24;

	return reversed >> 8 | opaque;
}

static void copy_swapped(const struct packing *packing, const uint8_t *in,
	uint8_t *out, int width)
{
	uint32_t opaque = packing->opaque;

	for (; width >= 4; width -= 4, in += 16, out += 16) {
		uint32_t a = load(in), b = load(in + 4), c = load(in + 8);
		uint32_t d = load(in + 12);

		store(out, swap(a, opaque));
		store(out + 4, swap(b, opaque));
		store(out + 8, swap(c, opaque));
		store(out + 12, swap(d, opaque));
	}
	for (; width > 0; width--, in += 4, out += 4) {
		store(out, swap(load(in), opaque));
	}
}

static ALWAYS_INLINE uint32_t pack(
	const struct packing *packing, const uint8_t *in, bool narrow)
{
	uint16_t pixel;

	if (!narrow) {
		return packing->red[in[0]] + packing->green[in[1]] +
			packing->blue[in[2]];
	}
	memcpy(&pixel, in, sizeof(pixel));
	return packing->red[pixel >> 11] + packing->green[pixel >> 5 & 63] +
		packing->blue[pixel & 31];
}

/* The lower bytes of a pixel, in the machine's order. */
static ALWAYS_INLINE void store_bytes(
	uint8_t *out, uint32_t pixel, int bytes, bool big)
{
	for (int i = 0; i < bytes; i++) {
		out[i] = (uint8_t)(pixel >> 8 * (big ? bytes - 1 - i : i));
	}
}

/* Any layout, through the tables. */
static ALWAYS_INLINE void copy_any(const struct packing *packing,
	const uint8_t *in, uint8_t *out, int width, bool narrow, int bytes)
{
	int step = narrow ? 2 : 4;
	bool big = is_big_endian();

	for (int x = 0; x < width; x++, in += step, out += bytes) {
		uint32_t pixel = pack(packing, in, narrow);
		uint16_t half = (uint16_t)pixel;

		switch (bytes) {
		case 2:
			memcpy(out, &half, 2);
			break;
		case 4:
			store(out, pixel);
			break;
		default:
			store_bytes(out, pixel, bytes, big);
			break;
		}
	}
}

#define COPY_FROM(format, narrow, bytes)                                   \
	static void copy_##format##_##bytes(const struct packing *packing, \
		const uint8_t *in, uint8_t *out, int width)                \
	{                                                                  \
		copy_any(packing, in, out, width, narrow, bytes);          \
	}
COPY_FROM(wide, false, 1)
COPY_FROM(wide, false, 2)
COPY_FROM(wide, false, 3)
COPY_FROM(wide, false, 4)
COPY_FROM(narrow, true, 1)
COPY_FROM(narrow, true, 2)
COPY_FROM(narrow, true, 3)
COPY_FROM(narrow, true, 4)
#undef COPY_FROM

/* Whether a layout has red, green and blue where RGBA8888 has those fields. */
static bool has_fields(const struct pixel_layout *layout,
	struct pixel_field red, struct pixel_field blue)
{
	struct pixel_layout own = pixel_layout_of(PIXELS_RGBA8888);

	return layout->bits == 32 && !layout->gray &&
		pixel_layout_mask(layout->red) == pixel_layout_mask(red) &&
		pixel_layout_mask(layout->green) ==
		pixel_layout_mask(own.green) &&
		pixel_layout_mask(layout->blue) == pixel_layout_mask(blue);
}

packing_row packing_choose_row(
	const struct packing *packing, const struct pixel_layout *layout)
{
	static const packing_row any[2][4] = {
		{copy_wide_1, copy_wide_2, copy_wide_3, copy_wide_4},
		{copy_narrow_1, copy_narrow_2, copy_narrow_3, copy_narrow_4},
	};
	struct pixel_layout own = pixel_layout_of(PIXELS_RGBA8888);
	bool narrow = packing->from == PIXELS_RGB565;

	if (packing->same) {
		return copy_same;
	}
	if (!narrow && has_fields(layout, own.red, own.blue) &&
		packing->opaque == pixel_layout_mask(own.alpha)) {
		return copy_opaque;
	}
	if (!narrow && !is_big_endian() &&
		has_fields(layout, own.blue, own.red)) {
		return copy_swapped;
	}
	return any[narrow][packing->bytes - 1];
}
