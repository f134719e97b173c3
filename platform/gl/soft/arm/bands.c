#include <assert.h>

#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/raster.h"

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
static_assert(offsetof(struct fast_setup, masked) == 72, "FAST_SETUP_MASKED");
static_assert(offsetof(struct flat_band, reference) == 44, "FLAT_REFERENCE");
static_assert(offsetof(struct flat_band, keep) == 48, "FLAT_KEEP");
static_assert(sizeof(struct setup) <= 88, "CULL");
static_assert(offsetof(struct setup, xy) == 12, "SETUP_XY");
static_assert(offsetof(struct setup, extent) == 40, "SETUP_EXTENT");
static_assert(offsetof(struct setup, inside) == 44, "SETUP_FLAGS");
static_assert(offsetof(struct setup, back) == 47, "SETUP_FLAGS");
static_assert(offsetof(struct setup, area) == 48, "SETUP_AREA");
