/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/fast/tint.h"

void soft_band_tint(struct tint_band *band)
{
	soft_band_tint_c(band);
}
