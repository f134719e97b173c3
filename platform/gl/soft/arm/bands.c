#include <assert.h>

#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/tile_row.h"
#include "platform/gl/soft/raster/raster.h"

/* texture.S */
void soft_band_texture_arm(struct texture_band *band);

/* fill.S */
void soft_band_fill_arm(uint16_t *at, int count, uint16_t value);

/* tile_row.S */
void soft_tile_row_arm(const struct tile_run *run);
void soft_tile_fine_arm(const struct tile_run *run);

/* narrow.S, narrow_rows.S */
void soft_fill_narrow_arm(struct draw *draw, struct setup *setup);

/* shadow.S */
void soft_fill_shadow_arm(struct draw *draw, struct setup *setup);

/* list.S, with struct setup and its own on the stack */
void soft_list_arm(struct draw *draw, const void *indices, uint32_t count);

static void list(struct draw *draw, const void *indices, uint32_t count)
{
	if (count >= 3) {
		soft_list_arm(draw, indices, count / 3 * 3);
	}
}

/* What the assembly knows. */
static_assert(sizeof(struct vertex) == 96, "VERTEX_BYTES");
static_assert(offsetof(struct vertex, x) == 4, "VERTEX_XY");
static_assert(offsetof(struct vertex, outcode) == 1, "VERTEX_OUTCODE");
static_assert(offsetof(struct vertex, shaded) == 2, "VERTEX_SHADED");
static_assert(offsetof(struct vertex, index) == 56, "VERTEX_INDEX");
static_assert(offsetof(struct vertex, z) == 12, "VERTEX_Z");
static_assert(offsetof(struct vertex, attribute) == 16, "VERTEX_COLOR");
static_assert(offsetof(struct vertex, clip) == 64, "VERTEX_W");
static_assert(offsetof(struct draw, view.reciprocals) == 112, "RECIPROCALS");
static_assert(offsetof(struct draw, fast_setup) == 128, "FAST_SETUP_");
static_assert(offsetof(struct fast_setup, inverse) == 12, "FAST_SETUP_INVERSE");
static_assert(offsetof(struct fast_setup, cull_side) == 16, "FAST_SETUP_CULL");
static_assert(offsetof(struct fast_setup, box_low) == 24, "FAST_SETUP_BOX");
static_assert(
	offsetof(struct fast_setup, attributes) == 44, "FAST_SETUP_ATTRIBUTES");
static_assert(offsetof(struct fast_setup, back_flip) == 52, "FAST_SETUP_BACK");
static_assert(offsetof(struct fast_setup, flat) == 56, "FAST_SETUP_FLAT");
static_assert(offsetof(struct fast_setup, stencil) == 64, "FAST_SETUP_STENCIL");
static_assert(offsetof(struct fast_setup, shadow) == 72, "FAST_SETUP_SHADOW");
static_assert(offsetof(struct flat_band, reference) == 44, "FLAT_REFERENCE");
static_assert(offsetof(struct flat_band, keep) == 48, "FLAT_KEEP");
static_assert(sizeof(struct setup) <= 88, "CULL");
static_assert(offsetof(struct setup, xy) == 12, "SETUP_XY");
static_assert(offsetof(struct setup, extent) == 40, "SETUP_EXTENT");
static_assert(offsetof(struct setup, inside) == 44, "SETUP_FLAGS");
static_assert(offsetof(struct setup, back) == 47, "SETUP_FLAGS");
static_assert(offsetof(struct setup, area) == 48, "SETUP_AREA");

const struct band_functions soft_bands = {
	.list = list,
	.narrow = soft_fill_narrow_arm,
	.shadow = soft_fill_shadow_arm,
	.texture = soft_band_texture_arm,
	.fill = soft_band_fill_arm,
	.tile_row = soft_tile_row_arm,
	.tile_fine = soft_tile_fine_arm,
};
