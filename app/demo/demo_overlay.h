/*
 * Draws overlays (app/scene/overlay) over the figures of a demo, and adds their
 * labels.
 */
#ifndef APP_DEMO_DEMO_OVERLAY_H
#define APP_DEMO_DEMO_OVERLAY_H

#include "app/demo/actor.h"
#include "app/demo/demo.h"

/*
 * Replaces the demo's overlay by a new one for its first figure. Returns 0, or
 * -errno after logging an error; then the demo has no overlay.
 */
int demo_overlay_make(const struct demo_driver *driver, struct demo *demo,
	const struct overlay_choice *choice);

/*
 * Releases the overlay; call it before its model is released. The next frame
 * makes the same kinds of overlays for the new model.
 */
void demo_overlay_release(struct demo_base *base);

/*
 * Finds room for labels beside the figures: the column at their left, which
 * other labels share, the column at their right, or the room above or below.
 */
struct hud_place demo_overlay_place(
	const struct demo *demo, const struct hud *hud);

/*
 * Finds room for the graph of frame times: the same, but if labels fill the
 * left column, the room below the figures at their right. In a narrow picture
 * that was framed for the graph but has no room, it is that of the least graph.
 */
struct hud_place demo_times_place(
	const struct demo *demo, const struct hud *hud);

/*
 * Adds the overlays' labels where they cover no figure. Returns false if other
 * labels leave no room for them.
 */
bool demo_overlay_label(const struct demo_driver *driver,
	const struct demo *demo, struct overlay *overlay, struct hud *hud);

#endif
