/* What textured.S knows of the structures. */
#include "platform/gl/soft/fast/tint.h"
#include "platform/gl/soft/raster/raster.h"

#include <assert.h>

static_assert(offsetof(struct textured, depth) == 0, "DEPTH");
static_assert(offsetof(struct textured, perspective) == 20, "PERSPECTIVE");
static_assert(offsetof(struct textured, last_level) == 36, "LAST_LEVEL");
static_assert(offsetof(struct textured, pixels) == 52, "PIXELS");
static_assert(offsetof(struct textured, level) == 64, "LEVELS");
static_assert(sizeof(struct textured_level) == 32, "LEVELS");
static_assert(offsetof(struct textured_level, s_down) == 20, "");
static_assert(offsetof(struct setup, v) == 0, "");
static_assert(offsetof(struct setup, top) == 24, "TOP");
static_assert(offsetof(struct setup, bottom) == 32, "BOTTOM");
static_assert(offsetof(struct setup, area) == 48, "AREA");
static_assert(offsetof(struct vertex, x) == 4, "");
static_assert(offsetof(struct vertex, z) == 12, "Z");
static_assert(offsetof(struct vertex, attribute[RED]) == 16, "RED");
static_assert(offsetof(struct vertex, attribute[TEX_S]) == 36, "TEX_S");
static_assert(offsetof(struct vertex, clip[3]) == 76, "W");
static_assert(offsetof(struct texture_band, down) == 16, "GRAY_DOWN");
static_assert(offsetof(struct texture_band, z_right) == 32, "GRAY_RIGHT");
static_assert(offsetof(struct texture_band, texels) == 40, "GRAY_TEXELS");
static_assert(offsetof(struct texture_band, edge) == 64, "GRAY_EDGE");
static_assert(offsetof(struct texture_band, share_right) == 80, "");
static_assert(offsetof(struct texture_band, rows) == 84, "GRAY_ROWS");
static_assert(offsetof(struct tint_band, down) == 20, "TINT_DOWN");
static_assert(offsetof(struct tint_band, edge) == 40, "TINT_EDGE");
static_assert(offsetof(struct tint_band, rows) == 56, "TINT_ROWS");
static_assert(offsetof(struct tint_band, z_right) == 64, "TINT_RIGHT");
static_assert(offsetof(struct tint_band, texel_mask) == 80, "TINT_LEVEL");
static_assert(offsetof(struct tint_band, red_blue_mask) == 104, "TINT_MASKS");
static_assert(sizeof(struct tint_band) == 120, "LOWER");
