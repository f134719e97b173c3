#include "platform/gl/soft/band.h"

/* band.S */
void band_color_arm(struct band *band);

const struct band_functions soft_bands = {
	.color = band_color_arm,
	.flat = band_flat_c,
	.fill = band_fill_c,
};
