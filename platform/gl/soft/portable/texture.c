/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/fast/band.h"

void soft_band_texture(struct texture_band *band)
{
	soft_band_texture_c(band);
}
