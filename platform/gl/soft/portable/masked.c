/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/raster/raster.h"

void soft_fill_masked(struct draw *draw, struct setup *setup)
{
	soft_fill_flat(draw, setup);
}
