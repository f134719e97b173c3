#include "platform/gl/soft/band.h"

const struct band_functions soft_bands = {
	.color = band_color_c,
	.flat = band_flat_c,
	.fill = band_fill_c,
};
