/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/raster/raster.h"

void soft_fill_narrow(struct draw *draw, struct setup *setup)
{
	soft_fill_narrow_c(draw, setup);
}
