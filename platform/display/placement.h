/*
 * Where a picture lies on a screen that has a size of its own.
 */
#ifndef PLATFORM_DISPLAY_PLACEMENT_H
#define PLATFORM_DISPLAY_PLACEMENT_H

#include "platform/display/display.h"

struct placement {
	int left, top, width, height;
};

/*
 * All of the screen, or the size somebody asked for in its middle; what does
 * not fit is cut after a warning.
 */
struct placement placement_choose(
	const struct display_options *options, int width, int height);

#endif
