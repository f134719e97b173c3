/*
 * The overlays of a demo (app/scene/overlay): which figures they belong to, and
 * what moves these.
 */
#ifndef APP_DEMO_DEMO_OVERLAY_H
#define APP_DEMO_DEMO_OVERLAY_H

#include "app/demo/actor.h"
#include "app/demo/demo.h"

/*
 * Makes the demo's overlay anew for its first figure. Returns 0, or -errno
 * after logging an error; then the demo has no overlay.
 */
int demo_overlay_make(const struct demo_driver *driver, struct demo *demo,
	const struct overlay_choice *choice);

/*
 * Releases the overlays; call it before their model is released. The next frame
 * shows them for the new model.
 */
void demo_overlay_release(struct demo_base *base);

/*
 * Adds labels of the overlays where no figure is. Returns false if other labels
 * leave them no room.
 */
bool demo_overlay_label(const struct demo_driver *driver,
	const struct demo *demo, struct overlay *overlay, struct hud *hud);

#endif
