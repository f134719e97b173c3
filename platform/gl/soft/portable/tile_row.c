/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/fast/tile_row.h"

void soft_tile_row(const struct tile_run *run, int by_fine)
{
	soft_tile_row_c(run, by_fine);
}
