#include "platform/display/placement.h"

static int smaller(int a, int b)
{
	return a < b ? a : b;
}

struct placement placement_choose(
	const struct display_options *options, int width, int height)
{
	struct placement place = {.width = width, .height = height};

	if (options->size_given) {
		if (options->width > width || options->height > height) {
			log_warning(options->log,
				"--size %dx%d: the screen has only %dx%d pixels, which limber uses instead",
				options->width, options->height, width, height);
		}
		place.width = smaller(options->width, width);
		place.height = smaller(options->height, height);
	}
	place.left = (width - place.width) / 2;
	place.top = (height - place.height) / 2;
	return place;
}
