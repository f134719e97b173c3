/*
 * The rectangle that pictures fill on a screen of fixed size.
 */
#ifndef PLATFORM_DISPLAY_PLACEMENT_H
#define PLATFORM_DISPLAY_PLACEMENT_H

#include "platform/display/display.h"

struct placement {
	int left, top, width, height;
};

/*
 * Returns all of the screen or, if the user gave a size, a centred rectangle of
 * that size. A size larger than the screen is reduced after logging a warning.
 */
struct placement placement_choose(
	const struct display_options *options, int width, int height);

#endif
