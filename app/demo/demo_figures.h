/*
 * The figures of a demo: where they are, and drawing them with their shadows.
 */
#ifndef APP_DEMO_DEMO_FIGURES_H
#define APP_DEMO_DEMO_FIGURES_H

#include "app/demo/demo.h"

/* Draws a frame of this size without overlays. */
void demo_draw_stage(const struct demo_driver *driver, struct demo *demo,
	int width, int height);

/* Finds the figure of this number; false where there is none. */
bool demo_find_figure(const struct demo_driver *driver, const struct demo *demo,
	int number, struct overlay_figure *out);

#endif
