/*
 * The loops that convert a row of pixels, one for each kind of layout.
 */
#ifndef PLATFORM_DISPLAY_PACKING_ROWS_H
#define PLATFORM_DISPLAY_PACKING_ROWS_H

#include "platform/display/packing.h"

/*
 * The loop for a layout. The other members of *packing must be set. The loops
 * write each byte once and in order, and read none.
 */
packing_row packing_choose_row(
	const struct packing *packing, const struct pixel_layout *layout);

#endif
