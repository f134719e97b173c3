/*
 * Triangles of any size in one colour for all of a call, without a depth test:
 * a stencil may let each pixel through once.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"

static uint8_t next_stencil(const struct stencil *stencil)
{
	return stencil->pass == GL_INCR    ? (uint8_t)(stencil->reference + 1)
		: stencil->pass == GL_ZERO ? 0
					   : stencil->reference;
}

void soft_fill_flat_color(struct draw *draw, uint16_t color, uint32_t alpha)
{
	struct flat_band *band = &draw->flat;

	band->opaque = color;
	band->alpha = alpha;
	band->keep = 32 - alpha;
	band->own = widen(color) * alpha + WIDE_ROUND;
}

void soft_fill_flat_begin(struct draw *draw)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct stencil *stencil = &draw->soft->fragment.stencil;
	const GLfixed *color = draw->soft->arrays.current_color;

	draw->flat = (struct flat_band){
		.stride_bytes = buffers->target.stride_bytes,
		.stencil_stride = buffers->width,
		.from = draw->box.left,
		.to = draw->box.right,
		.reference = stencil->reference,
		.next = next_stencil(stencil),
	};
	/* Where all of a call has one colour, no vertex is shaded. */
	soft_fill_flat_color(draw,
		pack_565(soft_byte(color[0]), soft_byte(color[1]),
			soft_byte(color[2])),
		draw->blended ? (uint32_t)(soft_byte(color[3]) + 4) >> 3 : 32);
}

static void draw_band(void *band)
{
	soft_band_flat(band);
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
	if (draw->soft->fragment.stencil.enabled) {
		band->stencil = buffers->stencil + top * buffers->width;
	}
	raster_draw_bands(draw, setup, middle_left,
		&(struct band_ends){band->edge, band->edge_step, &band->rows},
		draw_band, band);
}
