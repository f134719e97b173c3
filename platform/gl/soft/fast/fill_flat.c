/*
 * Triangles of any size, all of a call in one colour, without a depth test,
 * where the stencil test is EQUAL: shadows, which darken each pixel once.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/mix.h"

void soft_prepare_flat(struct soft *soft, struct draw *draw)
{
	const struct stencil *stencil = &soft->fragment.stencil;
	/* no vertex is shaded: the call's colour is the current one */
	const GLfixed *color = soft->arrays.current_color;
	uint32_t own, alpha;

	if (draw->fill != soft_fill_flat) {
		return;
	}
	own = widen(pack_565(
		soft_byte(color[0]), soft_byte(color[1]), soft_byte(color[2])));
	alpha = draw->blended ? (uint32_t)(soft_byte(color[3]) + 4) >> 3 : 32;
	draw->flat = (struct flat_color){
		.reference = stencil->reference,
		.next = (uint8_t)(stencil->pass == GL_ZERO ? 0
							   : stencil->reference +
					(stencil->pass == GL_INCR)),
		.keep = 32 - alpha,
		.own = own * alpha + WIDE_ROUND,
	};
}

/* A band, and the addresses of its next row. */
struct part {
	const struct draw *draw;
	uint8_t *pixels, *stencil; /* the row's column 0 */
	ptrdiff_t stride_bytes, stencil_stride;
	struct band_edges edges;
};

static void draw_rows(void *given)
{
	struct part *part = given;
	const struct draw *draw = part->draw;
	const int from = draw->box.left, to = draw->box.right;
	const struct flat_color color = draw->flat;
	uint32_t left = part->edges.at[BAND_LEFT];
	uint32_t right = part->edges.at[BAND_RIGHT];
	uint8_t *stencil = part->stencil, *pixels = part->pixels;

	for (int rows = part->edges.rows; rows > 0; rows--) {
		int x = (int32_t)left >> 16, end = (int32_t)right >> 16;
		uint16_t *pixel = (uint16_t *)(void *)pixels;

		x = x > from ? x : from;
		end = end < to ? end : to;
		for (; x < end; x++) {
			if (stencil[x] == color.reference) {
				uint32_t wide = widen(pixel[x]);

				wide = (wide * color.keep + color.own) >> 5;
				stencil[x] = color.next;
				pixel[x] = narrow(wide & WIDE_MASK);
			}
		}
		left += part->edges.step[BAND_LEFT];
		right += part->edges.step[BAND_RIGHT];
		stencil += part->stencil_stride;
		pixels += part->stride_bytes;
	}
	part->edges.at[BAND_LEFT] = left;
	part->edges.at[BAND_RIGHT] = right;
	part->stencil = stencil;
	part->pixels = pixels;
}

void soft_fill_flat(struct draw *draw, struct setup *setup)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct vertex *const *v = setup->v;
	const int top = raster_first_row(draw, setup);
	struct part part;

	part.draw = draw;
	part.stride_bytes = buffers->target.stride_bytes;
	part.stencil_stride = buffers->width;
	part.pixels = buffers->target.data + top * part.stride_bytes;
	part.stencil = buffers->stencil + top * part.stencil_stride;
	if (setup->inside) {
		frame_draw_bands(draw, setup, true, frame_is_middle_left(setup),
			&part.edges, draw_rows, &part);
		return;
	}
	frame_draw_bands(draw, setup, false,
		raster_find_area(v[0], v[1], v[2]) < 0, &part.edges, draw_rows,
		&part);
}
