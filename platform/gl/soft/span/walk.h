/*
 * The walk over a triangle's rows between its edges, which span/walk.c and
 * span/walk_general.c fill in what a row is for.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_WALK_H
#define PLATFORM_GL_SOFT_SPAN_WALK_H

#include "platform/gl/soft/raster/raster.h"

/* A row under way. */
struct soft_line {
	uint16_t *depth; /* of column 0, as all that follows */
	uint8_t *pixel;
	int pixel_log2; /* bytes */
	uint32_t z;     /* 16.16 */
	int y;
};

/* By fragment.c, for states that no span function takes. */
void soft_walk_general(struct draw *draw, const struct setup *setup);

static ALWAYS_INLINE struct soft_line soft_find_line(
	const struct draw *draw, int y)
{
	const struct buffers *buffers = &draw->soft->buffers;

	return (struct soft_line){
		.depth = buffers->depth + (ptrdiff_t)y * buffers->width,
		.pixel = buffers->target.data +
			(ptrdiff_t)y * buffers->target.stride_bytes,
		.pixel_log2 = raster_pixel_log2(draw),
		.y = y,
	};
}

/* Defines walk_NAME(), which calls draw_row() for each row. */
#define SOFT_WALK(name, ...)                                                   \
	static NEVER_INLINE void walk_##name(                                  \
		struct draw *draw, const struct setup *setup)                  \
	{                                                                      \
		const struct walk_kind kind = {__VA_ARGS__};                   \
		const struct buffers *buffers = &draw->soft->buffers;          \
		const struct clip_box box = draw->box;                         \
		int y = raster_first_row(draw, setup), turn = setup->middle;   \
		int bottom = setup->bottom < box.bottom ? setup->bottom        \
							: box.bottom;          \
		struct soft_line line = soft_find_line(draw, y);               \
		struct side whole, part = {0};                                 \
                                                                               \
		soft_raster_skip_rows(draw, y - setup->top);                   \
		turn = turn > y ? turn : y;                                    \
		whole = raster_side(draw, setup->v[0], setup->v[2], y);        \
		if (y < turn) {                                                \
			part = raster_side(draw, setup->v[0], setup->v[1], y); \
		}                                                              \
		for (; line.y < bottom; line.y++) {                            \
			int left, right;                                       \
                                                                               \
			if (line.y == turn) {                                  \
				part = raster_side(                            \
					draw, setup->v[1], setup->v[2], turn); \
			}                                                      \
			left = raster_column(                                  \
				setup->middle_left ? part.x : whole.x);        \
			right = raster_column(                                 \
				setup->middle_left ? whole.x : part.x);        \
			left = left > box.left ? left : box.left;              \
			right = right < box.right ? right : box.right;         \
			draw_row(draw, kind, &line, left, right);              \
			raster_next_side(&whole);                              \
			raster_next_side(&part);                               \
			line.depth += buffers->width;                          \
			line.pixel += buffers->target.stride_bytes;            \
		}                                                              \
	}

#endif
