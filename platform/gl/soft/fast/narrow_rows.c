/* Rows of narrow triangles in C; arm/narrow_rows.S has the same in assembly. */
#include "platform/gl/soft/fast/narrow.h"
#include "platform/gl/soft/raster/pixel.h"

/* Green is in 31..21, red in 20..10, blue in 9..0. */
static uint16_t unpack(uint32_t packed)
{
	return narrow((packed >> 5 | packed << 27) & WIDE_MASK);
}

static void draw_row(const struct narrow *narrow, bool equal)
{
	const struct narrow_row *row = &narrow->row;
	const int left = ((int32_t)row->left >> 16) + NARROW_LEFT;
	const int right = ((int32_t)row->right >> 16) + NARROW_LEFT;
	uint16_t *depth =
		(uint16_t *)(row->depth + 2 * (uintptr_t)(left - NARROW_LEFT));
	uint32_t z = row->z + narrow->z_right * (uint32_t)left;
	uint32_t packed = row->packed + narrow->packed_right * (uint32_t)left;

	for (int i = left; i < right; i++, depth++) {
		if (z >> 16 < (uint32_t)*depth + equal) {
			*depth = (uint16_t)(z >> 16);
			*(uint16_t *)((uintptr_t)(depth + 1) + narrow->pixels) =
				unpack(packed);
		}
		z += narrow->z_right;
		packed += narrow->packed_right;
	}
}

/* Steps the channels' colour by NARROW_CHUNK rows to this one and packs it. */
static void pack_again(struct narrow *narrow)
{
	for (int i = 0; i < 3; i++) {
		struct narrow_channel *channel = &narrow->channel[i];

		channel->start = (int32_t)((uint32_t)channel->start +
			(uint32_t)channel->down * (NARROW_CHUNK / 2));
	}
	narrow->row.packed = narrow_pack(narrow);
}

void soft_narrow_rows_c(struct narrow *narrow, bool equal)
{
	struct narrow_row *row = &narrow->row, *down = &narrow->down;
	const int rows = narrow->rows + narrow->more;

	for (int y = 0; y < rows; y++) {
		if (y == narrow->rows) {
			narrow_set_edge(
				narrow, narrow->middle_left, narrow->lower);
		}
		if (y > 0 && y % NARROW_CHUNK == 0) {
			pack_again(narrow);
		}
		draw_row(narrow, equal);
		row->depth += down->depth;
		row->z += down->z;
		row->packed += down->packed;
		row->left += down->left;
		row->right += down->right;
	}
}
