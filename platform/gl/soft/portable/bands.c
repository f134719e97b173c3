#include "platform/gl/soft/band.h"
#include "platform/gl/soft/count.h"
#include "platform/gl/soft/glyph.h"
#include "platform/gl/soft/ground.h"
#include "platform/gl/soft/picture.h"
#include "platform/gl/soft/raster.h"
#include "platform/gl/soft/tile_row.h"
#include "platform/gl/soft/tint.h"

const struct band_functions soft_bands = {
	.list = soft_list_c,
	.narrow = fill_narrow_c,
	.shadow = fill_flat,
	.color = band_color_c,
	.texture = band_texture_c,
	.tint_linear = tint_linear_c,
	.tint_nearest = tint_nearest_c,
	.tint_dot = tint_dot_c,
	.tint_multiply = tint_multiply_c,
	.tint_add = tint_add_c,
	.flat = band_flat_c,
	.fill = band_fill_c,
	.picture = picture_copy_c,
	.glyph = glyph_draw_c,
	.mix = glyph_mix_c,
	.tile_row = tile_row_c,
	.tile_fine = tile_fine_c,
	.tile_blend = tile_blend_c,
	.count = count_band_c,
	.shade_ground = ground_shade_c,
	.depth = ground_depth_c,
};
