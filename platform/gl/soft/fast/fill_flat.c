/*
 * Triangles of any size in one colour for all of a call, without a depth test,
 * where a stencil lets each pixel through once.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/raster.h"

static uint8_t next_stencil(const struct stencil *stencil)
{
	return stencil->pass == GL_INCR    ? (uint8_t)(stencil->reference + 1)
		: stencil->pass == GL_ZERO ? 0
					   : stencil->reference;
}

void soft_fill_flat_begin(struct draw *draw)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct stencil *stencil = &draw->soft->fragment.stencil;
	/* Where all of a call has one colour, no vertex is shaded. */
	const GLfixed *color = draw->soft->arrays.current_color;
	uint32_t own = widen(pack_565(
		soft_byte(color[0]), soft_byte(color[1]), soft_byte(color[2])));
	uint32_t alpha =
		draw->blended ? (uint32_t)(soft_byte(color[3]) + 4) >> 3 : 32;

	draw->flat = (struct flat_band){
		.stride_bytes = buffers->target.stride_bytes,
		.stencil_stride = buffers->width,
		.from = draw->box.left,
		.to = draw->box.right,
		.reference = stencil->reference,
		.next = next_stencil(stencil),
		.keep = 32 - alpha,
		.own = own * alpha + WIDE_ROUND,
	};
}

static ALWAYS_INLINE void draw_pixel(const struct flat_band *band, int x)
{
	uint16_t *pixel = (uint16_t *)(void *)band->pixels + x;

	if (band->stencil[x] == band->reference) {
		band->stencil[x] = band->next;
		*pixel = narrow((widen(*pixel) * band->keep + band->own) >> 5 &
			WIDE_MASK);
	}
}

static ALWAYS_INLINE void draw_four(const struct flat_band *band, int x)
{
	uint16_t *pixel = (uint16_t *)(void *)band->pixels + x;

	for (int i = 0; i < 4; i += 2) {
		soft_store_two(pixel + i,
			soft_keep_two(soft_load_two(pixel + i), band->keep,
				band->own, band->own));
	}
}

static void draw_row(const struct flat_band *band, int left, int right)
{
	/* A copy: what is written may be bytes of any object. */
	const struct flat_band row = *band;
	const uint32_t all = row.reference * 0x01010101u;
	const uint32_t next = row.next * 0x01010101u;
	int x = left;

	while (right - x >= 4) {
		uint32_t four = load_32(row.stencil + x);

		if (four == all) {
			memcpy(row.stencil + x, &next, sizeof(next));
			draw_four(&row, x);
		} else if (four != next) {
			for (int i = 0; i < 4; i++) {
				draw_pixel(&row, x + i);
			}
		}
		x += 4;
	}
	for (; x < right; x++) {
		draw_pixel(&row, x);
	}
}

static void draw_band(void *flat_band)
{
	struct flat_band *band = flat_band;

	for (; band->edges.rows > 0; band_next_row(&band->edges)) {
		int left = band_column(&band->edges, BAND_LEFT);
		int right = band_column(&band->edges, BAND_RIGHT);

		draw_row(band, left > band->from ? left : band->from,
			right < band->to ? right : band->to);
		band->pixels += band->stride_bytes;
		band->stencil += band->stencil_stride;
	}
}

void soft_fill_flat(struct draw *draw, struct setup *setup)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct vertex *const *v = setup->v;
	struct flat_band *band = &draw->flat;
	int top = raster_first_row(draw, setup);
	/* The long edge is left of the middle vertex or right of it. */
	bool middle_left = (int64_t)(v[1]->x - v[0]->x) * (v[2]->y - v[0]->y) <
		(int64_t)(v[2]->x - v[0]->x) * (v[1]->y - v[0]->y);

	band->pixels = buffers->target.data +
		(ptrdiff_t)top * buffers->target.stride_bytes;
	band->stencil = buffers->stencil + top * buffers->width;
	raster_draw_bands(
		draw, setup, middle_left, &band->edges, draw_band, band);
}
