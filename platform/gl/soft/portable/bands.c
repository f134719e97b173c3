#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/count.h"
#include "platform/gl/soft/fast/glyph.h"
#include "platform/gl/soft/fast/ground.h"
#include "platform/gl/soft/fast/picture.h"
#include "platform/gl/soft/fast/tile_row.h"
#include "platform/gl/soft/raster/raster.h"

const struct band_functions soft_bands = {
	.list = soft_list_c,
	.narrow = soft_fill_narrow_c,
	.shadow = soft_fill_flat,
	.color = soft_band_color_c,
	.texture = soft_band_texture_c,
	.flat = soft_band_flat_c,
	.fill = soft_band_fill_c,
	.picture = soft_picture_copy_c,
	.glyph = soft_glyph_draw_c,
	.mix = soft_glyph_mix_c,
	.tile_row = soft_tile_row_c,
	.tile_fine = soft_tile_fine_c,
	.tile_blend = soft_tile_blend_c,
	.count = soft_count_band_c,
	.shade_ground = soft_ground_shade_c,
	.depth = soft_ground_depth_c,
};
