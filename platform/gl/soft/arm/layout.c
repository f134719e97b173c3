/*
 * Asserts what the assembly assumes besides the offsets of offsets.inc: which
 * members lie side by side, and the offsets that vertex.S counts by itself.
 */
#include <assert.h>

#include "platform/gl/soft/fast/narrow.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/cache.h"

/* narrow_rows.S */
static_assert(offsetof(struct narrow, down) == 20, "DOWN");
static_assert(offsetof(struct narrow, middle_left) == 60, "MIDDLE_LEFT");
static_assert(offsetof(struct narrow, channel) == 72, "RED");
static_assert(offsetof(struct narrow, column) == 96, "COLUMN");
static_assert(NARROW_LEFT == 24 && NARROW_CHUNK == 8, "");

/* vertex.S */
static_assert(offsetof(struct draw, view) == 0, "r0 is the view");
static_assert(offsetof(struct view, row_x) == 8, "");
static_assert(offsetof(struct view, row_z) == 32, "");
static_assert(offsetof(struct view, moved_z) == 56, "MATRIX_SIZE less 8");
static_assert(offsetof(struct view, stride_bytes) ==
		offsetof(struct view, positions) + 4,
	"a pair of registers");
static_assert(
	offsetof(struct view, depth) == offsetof(struct view, center_x_q8) + 20,
	"six registers");
static_assert(POSITION_SHORTS == 0 && POSITION_FLOATS == 1, "by KIND");
static_assert(offsetof(struct vertex, x) == 4, "");

/* list.S */
static_assert(VERTEX_CACHE == 512, "CACHE_SLOTS");
static_assert(sizeof(struct cache_tag) == 8, "a pair of registers");
static_assert(offsetof(struct cache_tag, xy) == 4, "the second one");
static_assert(sizeof(struct vertex) == 96, "twelve times the tag");
static_assert(offsetof(struct vertex, y) == 8, "");
static_assert(offsetof(struct source, indices) == 0, "");
static_assert(TAG_OUTSIDE == (uint32_t)-2, "");
static_assert(SMALL_EXTENT == 2047, "");
static_assert(offsetof(struct setup, back) == offsetof(struct setup, inside) + 2,
	"the flags are bytes of one word");
static_assert(offsetof(struct fast_setup, cull_mask) ==
		offsetof(struct fast_setup, cull_side) + 4,
	"");

/* texture.S and tint.S */
static_assert(sizeof(struct band_row) == 20, "five registers");
static_assert(offsetof(struct band, down) == 20, "behind the first row");
static_assert(sizeof(struct band_edges) == 20, "five registers");
static_assert(offsetof(struct band, z_right) % 8 == 0, "a pair of registers");
static_assert(offsetof(struct band, green_right) ==
		offsetof(struct band, z_right) + 12,
	"four registers");
static_assert(offsetof(struct band, texel_mask) % 8 == 0, "a pair of registers");
static_assert(offsetof(struct band, texels) % 8 == 0, "a pair of registers");
static_assert(offsetof(struct band, pixels) % 8 == 0, "a pair of registers");
static_assert(offsetof(struct band, more.red) % 8 == 0, "a pair of registers");
static_assert(offsetof(struct band, more.green) ==
		offsetof(struct band, texel_mask) + 20,
	"six registers");
static_assert(TINT_NEXT == 0x1000100, "in two additions");
