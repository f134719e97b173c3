/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/fast/band.h"

void soft_band_gray(struct band *band)
{
	soft_band_gray_c(band);
}

void soft_band_tint(struct band *band)
{
	soft_band_tint_c(band);
}
