/*
 * Rows of opaque triangles without a texture, up to 23 columns wide, whose
 * colour is stepped as one packed word. fill_narrow.c sets them up.
 */
#ifndef PLATFORM_GL_SOFT_FAST_NARROW_H
#define PLATFORM_GL_SOFT_FAST_NARROW_H

#include "platform/gl/soft/raster/frame.h"

enum {
	/*
	 * The packed colour's steps are off by at most 1/64 of a step of RGB565,
	 * and it is computed anew every NARROW_CHUNK rows, so that it is off by
	 * at most half a step in NARROW_COLUMNS columns, or one more by rounding.
	 */
	NARROW_CHUNK = 8,
	NARROW_COLUMNS = 23,
	/* z and packed of a row are those of so many columns left of column 0. */
	NARROW_LEFT = 24,
};

/*
 * A row's values, or their steps a row. packed is 6.5 of green, 5.6 of red and
 * 5.5 of blue, from the top. left and right are as in struct band_edges.
 */
struct narrow_row {
	uintptr_t depth; /* address of column 0 */
	uint32_t z, packed, left, right;
};

/* A colour's channel times 31/32 or 63/64: start is 8.15, its step down 8.16. */
struct narrow_channel {
	int32_t start, down;
};

/* Offsets on ARM are known to arm/narrow_rows.S. */
struct narrow {
	struct narrow_row row, down; /* 0, 20: the first row, and steps a row */
	uint32_t z_right;            /* 40 */
	uint32_t packed_right;       /* 44 */
	uintptr_t pixels;            /* 48: from a depth + 2 to its pixel */
	int32_t more;                /* 52: rows below the middle vertex */
	int32_t rows;                /* 56: rows above the middle vertex */
	/* 60: below the middle vertex, lower is the left edge, else the right */
	int32_t middle_left;
	struct side lower;
	struct narrow_channel channel[3]; /* 72: RED first; packed's source */
	int32_t column;                   /* 96: of channel, from NARROW_LEFT */
};

/* Packs the channels' colour, moved left to where rows have their values. */
static ALWAYS_INLINE uint32_t narrow_pack(const struct narrow *narrow)
{
	const struct narrow_channel *channel = narrow->channel;

	return ((uint32_t)(channel[GREEN].start >> 12) << 21) +
		((uint32_t)(channel[RED].start >> 12) << 10) +
		(uint32_t)(channel[BLUE].start >> 13) -
		narrow->packed_right * (uint32_t)narrow->column;
}

static ALWAYS_INLINE void narrow_set_edge(
	struct narrow *narrow, bool left, struct side side)
{
	if (left) {
		narrow->row.left = (uint32_t)side.x;
		narrow->down.left = (uint32_t)side.step;
	} else {
		narrow->row.right = (uint32_t)side.x;
		narrow->down.right = (uint32_t)side.step;
	}
}

/* all: sets the edges of bands without rows, too. */
static ALWAYS_INLINE void narrow_set_edges(const struct draw *draw,
	const struct setup *setup, bool middle_left, bool all,
	struct narrow *narrow)
{
	const struct vertex *const *v = setup->v;
	const int32_t *inverse = draw->inverse_q31;

	OPAQUE(inverse); /* else compilers find it from draw for each edge */
	narrow->rows = setup->middle - setup->top;
	narrow->more = setup->bottom - setup->middle;
	narrow->middle_left = middle_left;
	narrow_set_edge(
		narrow, !middle_left, frame_find_side(inverse, v[0], v[2]));
	if (all || narrow->rows > 0) {
		narrow_set_edge(narrow, middle_left,
			frame_find_side(inverse, v[0], v[1]));
	}
	if (all || narrow->more > 0) {
		narrow->lower = frame_find_side(inverse, v[1], v[2]);
	}
}

/* Sets depths of column 0, or so many columns left of it. */
static ALWAYS_INLINE void narrow_set_depth(const struct draw *draw,
	const struct setup *setup, const struct frame *frame, int left,
	bool offset, struct narrow *narrow)
{
	const struct vertex *const *v = setup->v;
	struct plane z = frame_find_near(
		frame, v[0]->z, v[1]->z - v[0]->z, v[2]->z - v[0]->z);

	if (offset) {
		z.start += (uint32_t)soft_find_offset(draw, setup, z.dx, z.dy);
	}
	narrow->column = frame->column + left;
	narrow->z_right = (uint32_t)z.dx << 6;
	narrow->down.z = (uint32_t)z.dy << 6;
	narrow->row.z =
		(z.start << 6) - narrow->z_right * (uint32_t)narrow->column;
	narrow->down.depth = draw->fast_setup.stride_bytes;
	narrow->row.depth = draw->fast_setup.depth +
		(uintptr_t)setup->top * narrow->down.depth;
	narrow->pixels = draw->fast_setup.pixels;
}

/*
 * arm/narrow_rows.S or portable/triangles.c: draws all rows of a struct narrow, and
 * changes it. Depths are tested LESS, or LEQUAL by soft_narrow_rows_equal().
 */
void soft_narrow_rows(void *narrow);
void soft_narrow_rows_equal(void *narrow);
/* narrow_rows.c: the same in C, with the same results. */
void soft_narrow_rows_c(struct narrow *narrow, bool equal);

#endif
