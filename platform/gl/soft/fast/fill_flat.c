/*
 * Triangles of any size in one colour for all of a call, without a depth test,
 * where a stencil lets each pixel through once.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/mix.h"

enum {
	WIDE_ROW = 16, /* pixels from which on four are looked at at once */
};

static uint8_t next_stencil(const struct stencil *stencil)
{
	return stencil->pass == GL_INCR    ? (uint8_t)(stencil->reference + 1)
		: stencil->pass == GL_ZERO ? 0
					   : stencil->reference;
}

void soft_fill_flat_begin(struct draw *draw)
{
	const struct stencil *stencil = &draw->soft->fragment.stencil;
	/* Where all of a call has one colour, no vertex is shaded. */
	const GLfixed *color = draw->soft->arrays.current_color;
	uint32_t own = widen(pack_565(
		soft_byte(color[0]), soft_byte(color[1]), soft_byte(color[2])));
	uint32_t alpha =
		draw->blended ? (uint32_t)(soft_byte(color[3]) + 4) >> 3 : 32;

	draw->flat = (struct flat_color){
		.reference = stencil->reference,
		.next = next_stencil(stencil),
		.keep = 32 - alpha,
		.own = own * alpha + WIDE_ROUND,
	};
}

static ALWAYS_INLINE void draw_pixel(
	uint8_t *stencil, uint16_t *pixel, const struct flat_color *color)
{
	if (*stencil == color->reference) {
		*stencil = color->next;
		*pixel = narrow((widen(*pixel) * color->keep + color->own) >> 5 &
			WIDE_MASK);
	}
}

/* Pixels as long as there are four, whose stencils are looked at at once. */
static NEVER_INLINE int draw_fours(uint8_t *stencil, uint16_t *pixel, int count,
	const struct flat_color *color)
{
	const uint32_t all = color->reference * 0x01010101u;
	const uint32_t next = color->next * 0x01010101u;
	int x = 0;

	for (; count - x >= 4; x += 4) {
		uint32_t four = load_32(stencil + x);

		if (four == all) {
			memcpy(stencil + x, &next, sizeof(next));
			for (int i = x; i < x + 4; i += 2) {
				soft_store_two(pixel + i,
					soft_keep_two(soft_load_two(pixel + i),
						color->keep, color->own,
						color->own));
			}
		} else if (four != next) {
			for (int i = x; i < x + 4; i++) {
				draw_pixel(stencil + i, pixel + i, color);
			}
		}
	}
	return x;
}

/* Rows between two edges, and the row under way. */
struct part {
	const struct draw *draw;
	uint8_t *pixels, *stencil; /* of column 0 */
	ptrdiff_t stride_bytes, stencil_stride;
	struct band_edges edges;
};

static ALWAYS_INLINE void draw_rows(struct part *part, bool inside)
{
	const struct draw *draw = part->draw;
	const struct clip_box *box = &draw->box;
	const struct flat_color color = draw->flat;
	uint32_t left = part->edges.at[BAND_LEFT];
	uint32_t right = part->edges.at[BAND_RIGHT];
	uint8_t *stencil = part->stencil, *pixels = part->pixels;

	for (int rows = part->edges.rows; rows > 0; rows--) {
		int x = (int32_t)left >> 16, end = (int32_t)right >> 16;
		uint16_t *pixel = (uint16_t *)(void *)pixels;

		if (!inside) {
			x = x > box->left ? x : box->left;
			end = end < box->right ? end : box->right;
		}
		if (end - x >= WIDE_ROW) {
			x += draw_fours(
				stencil + x, pixel + x, end - x, &draw->flat);
		}
		for (; x < end; x++) {
			draw_pixel(stencil + x, pixel + x, &color);
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

static void draw_inside(void *part)
{
	draw_rows(part, true);
}

static void draw_clipped(void *part)
{
	draw_rows(part, false);
}

static ALWAYS_INLINE void begin(
	const struct draw *draw, int top, struct part *part)
{
	const struct buffers *buffers = &draw->soft->buffers;

	part->draw = draw;
	part->stride_bytes = buffers->target.stride_bytes;
	part->stencil_stride = buffers->width;
	part->pixels = buffers->target.data + top * part->stride_bytes;
	part->stencil = buffers->stencil + top * part->stencil_stride;
}

static NEVER_INLINE void fill_clipped(
	const struct draw *draw, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	struct part part;
	/* The long edge is left of the middle vertex or right of it. */
	const bool middle_left =
		(int64_t)(v[1]->x - v[0]->x) * (v[2]->y - v[0]->y) <
		(int64_t)(v[2]->x - v[0]->x) * (v[1]->y - v[0]->y);

	begin(draw, raster_first_row(draw, setup), &part);
	raster_draw_bands(
		draw, setup, middle_left, &part.edges, draw_clipped, &part);
}

void soft_fill_flat(struct draw *draw, struct setup *setup)
{
	struct part part;

	if (!setup->inside || setup->wide) {
		fill_clipped(draw, setup);
		return;
	}
	begin(draw, setup->top, &part);
	frame_draw_bands(draw, setup, frame_is_middle_left(setup), &part.edges,
		draw_inside, &part);
}
