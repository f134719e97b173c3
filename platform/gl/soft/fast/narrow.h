/*
 * Opaque triangles without a texture in a few columns: their rows, with colours
 * that run as one number. fill_narrow.c sets them up.
 */
#ifndef PLATFORM_GL_SOFT_FAST_NARROW_H
#define PLATFORM_GL_SOFT_FAST_NARROW_H

#include "platform/gl/soft/raster/raster.h"

enum {
	/*
	 * The packed colour's steps are off by a 64th of a step of RGB565 at
	 * most, and it is taken afresh after so many rows: it stays within
	 * half a step for up to so many columns (one more by rounding).
	 */
	NARROW_CHUNK = 8,
	NARROW_COLUMNS = 23,
	/* All that moves on with a row is given so many columns further left. */
	NARROW_LEFT = 24,
};

/*
 * What moves on with a row; packed is 6.5 green, 5.6 red, 5.5 blue. Edges are
 * those of struct band_edges.
 */
struct narrow_row {
	uintptr_t depth; /* an address */
	uint32_t z, packed, left, right;
};

/* A colour's channel, times 31/32 or 63/64: in 8.15 and 8.16 bits. */
struct narrow_channel {
	int32_t start, down;
};

/* Offsets on ARM are known to arm/narrow_rows.S. */
struct narrow {
	struct narrow_row row, down; /* 0, 20: the first one, and the steps */
	uint32_t z_right;            /* 40 */
	uint32_t packed_right;       /* 44 */
	uintptr_t pixels;            /* 48: from behind a depth to its pixel */
	int32_t more;                /* 52: rows from the middle corner on */
	int32_t rows;                /* 56: as far as there */
	/* 60: the left edge from there on, or the right one */
	int32_t middle_left;
	struct side lower;
	struct narrow_channel channel[3]; /* 72: where packed is from; RED first */
	int32_t column;                   /* 96: the same, see NARROW_LEFT */
};

/* From the channels. */
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

/* fill_narrow.c: false where the triangle is not one for these rows. */
bool soft_narrow_begin(const struct draw *draw, const struct setup *setup,
	struct narrow *narrow);

/* arm/narrow_rows.S or portable/triangles.c: draws all rows; uses narrow up. */
void soft_narrow_rows(struct narrow *narrow);
/* narrow_rows.c: the same bytes. */
void soft_narrow_rows_c(struct narrow *narrow);

#endif
