/*
 * Finds the figures of a demo, and draws them with their shadows.
 */
#ifndef APP_DEMO_DEMO_FIGURES_H
#define APP_DEMO_DEMO_FIGURES_H

#include "app/demo/demo.h"

/*
 * Draws stage and figures, without overlays, in a picture of this many pixels.
 */
void demo_draw_stage(const struct demo_driver *driver, struct demo *demo,
	int width, int height);

/* Describes figure number, counted from 0. Returns false if there is none. */
bool demo_find_figure(const struct demo_driver *driver, const struct demo *demo,
	int number, struct overlay_figure *out);

#endif
