#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/tile_row.h"
#include "platform/gl/soft/raster/raster.h"

const struct band_functions soft_bands = {
	.list = soft_list_c,
	.narrow = soft_fill_narrow_c,
	.shadow = soft_fill_flat,
	.texture = soft_band_texture_c,
	.fill = soft_band_fill_c,
	.tile_row = soft_tile_row_c,
	.tile_fine = soft_tile_fine_c,
};
