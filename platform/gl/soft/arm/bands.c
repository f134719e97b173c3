#include "platform/gl/soft/band.h"
#include "platform/gl/soft/count.h"
#include "platform/gl/soft/shade.h"

/* band.S */
void band_color_arm(struct band *band);

/* texture.S */
void band_texture_arm(struct texture_band *band);

/* fill.S */
void band_fill_arm(uint16_t *at, int count, uint16_t value);

/* shade.S */
void shade_four_arm(const struct shade_run *run);
void shade_two_arm(const struct shade_run *run);

/* count.S: of one row or more */
void count_band_arm(struct count_band *band);

static void count_arm(struct count_band *band)
{
	if (band->rows > 0) {
		count_band_arm(band);
	}
}

/* flat.S: blended ones of one row or more */
void band_flat_arm(struct flat_band *band);

static void flat_arm(struct flat_band *band)
{
	if (band->rows > 0 && (band->stencil || band->keep)) {
		band_flat_arm(band);
	} else {
		band_flat_c(band);
	}
}

const struct band_functions soft_bands = {
	.color = band_color_arm,
	.texture = band_texture_arm,
	.flat = flat_arm,
	.fill = band_fill_arm,
	.shade_four = shade_four_arm,
	.shade_two = shade_two_arm,
	.count = count_arm,
};
