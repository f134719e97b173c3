#include "platform/display/packing.h"

#include "platform/display/packing_rows.h"

/* Scales a value of 0..max to the field, rounded to nearest. */
static uint32_t scale(uint32_t value, uint32_t max, struct pixel_field field)
{
	uint64_t full = UINT32_MAX >> (32 - field.length);

	return (uint32_t)((full * value + max / 2) / max) << field.offset;
}

/*
 * Scales a value likewise to the part of brightness that the channel
 * contributes in BT.601 luma; weight is in 256ths.
 */
static uint32_t scale_gray(
	uint32_t value, uint32_t max, uint32_t weight, struct pixel_field field)
{
	uint64_t full = UINT32_MAX >> (32 - field.length);
	uint64_t part = full * value * weight / max;

	return (uint32_t)(part / 256) << field.offset;
}

static void fill(uint32_t *table, uint32_t max, struct pixel_field field,
	uint32_t gray_weight)
{
	for (uint32_t i = 0; i <= max; i++) {
		table[i] = gray_weight ? scale_gray(i, max, gray_weight, field)
				       : scale(i, max, field);
	}
}

/*
 * Layouts with alpha never are the same: blending leaves any alpha in pictures,
 * which such a screen could show as holes.
 */
static bool is_same(
	const struct pixel_layout *layout, const struct pixel_layout *own)
{
	return layout->bits == own->bits && !layout->gray &&
		layout->alpha.length == 0 &&
		pixel_layout_mask(layout->red) == pixel_layout_mask(own->red) &&
		pixel_layout_mask(layout->green) ==
		pixel_layout_mask(own->green) &&
		pixel_layout_mask(layout->blue) == pixel_layout_mask(own->blue);
}

void packing_init(struct packing *packing, enum pixel_format from,
	const struct pixel_layout *layout)
{
	bool narrow = from == PIXELS_RGB565;
	bool gray = layout->gray;
	struct pixel_layout own = pixel_layout_of(from);
	uint32_t opaque = pixel_layout_mask(layout->alpha);

	*packing = (struct packing){
		.from = from,
		.same = is_same(layout, &own),
		.bytes = pixel_layout_bytes(layout),
		.opaque = opaque,
	};
	packing->copy_row = packing_choose_row(packing, layout);
	fill(packing->red, narrow ? 31 : 255, layout->red, gray ? 77 : 0);
	fill(packing->green, narrow ? 63 : 255, layout->green, gray ? 150 : 0);
	fill(packing->blue, narrow ? 31 : 255, layout->blue, gray ? 29 : 0);
	for (int i = 0; i < 256; i++) {
		packing->red[i] += opaque;
	}
	if (gray) {
		/* White must be full brightness, so green, the channel with the
		 * largest weight, gets what rounding has lost. */
		uint32_t white = pixel_layout_mask(layout->red) + opaque;
		int max = narrow ? 31 : 255;
		int green_max = narrow ? 63 : 255;

		packing->green[green_max] =
			white - packing->red[max] - packing->blue[max];
	}
}

void packing_blacken(const struct packing *packing, uint8_t *data, int width)
{
	static const uint8_t black[64 * 4];

	for (int x = 0; x < width; x += 64) {
		packing->copy_row(packing, black, data + x * packing->bytes,
			width - x < 64 ? width - x : 64);
	}
}

void packing_copy(const struct packing *packing, const struct pixels *picture,
	uint8_t *data, int stride_bytes)
{
	for (int y = 0; y < picture->height; y++) {
		packing->copy_row(packing,
			picture->data + y * picture->stride_bytes,
			data + y * stride_bytes, picture->width);
	}
}
