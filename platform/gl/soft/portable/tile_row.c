/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/fast/tile_row.h"

void soft_tile_row(const struct tile_run *run)
{
	soft_tile_row_c(run);
}

void soft_tile_places(const struct tile_run *run)
{
	soft_tile_places_c(run);
}

void soft_tile_fine(const struct tile_run *run)
{
	soft_tile_fine_c(run);
}
