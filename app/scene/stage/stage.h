/*
 * What is around a model: background, floor, light, shadow.
 *
 * A frame is stage_begin(), the shadows, the models. Flat shadows go between
 * stage_shadow_begin() and stage_shadow_end() as shapes; shadow volumes are
 * drawn right after stage_begin().
 */
#ifndef APP_SCENE_STAGE_STAGE_H
#define APP_SCENE_STAGE_STAGE_H

#include "app/scene/stage/backdrop.h"
#include "app/scene/stage/camera.h"
#include "app/scene/stage/floor.h"
#include "app/scene/stage/monitor.h"

struct stage {
	struct camera camera;
	struct floor floor;
	bool has_stencil;
	/* In place of the background and the level floor; or NULL. */
	const struct live_texture *backdrop;
	/* Stands on the stage, dark without its picture; or NULL. */
	const struct monitor *monitor;
	const struct live_texture *monitor_picture;
};

/*
 * A stage whose floor lies under the box and whose camera frames it, see
 * camera_frame(). 0, or -ENOMEM after a sentence. Release with stage_finish().
 */
int stage_init(struct stage *stage, const struct gl *gl,
	const struct bounds *bounds, const struct camera_framing *framing,
	enum pixel_format target, const struct log *log);

void stage_finish(struct stage *stage, const struct gl *gl);

/* Clears, draws background and floor, loads camera and lights. */
void stage_begin(
	const struct stage *stage, const struct gl *gl, int width, int height);

/*
 * Until stage_shadow_end(), shapes are drawn flattened onto the level of the
 * floor along the main light, in a dark see-through colour.
 */
void stage_shadow_begin(const struct stage *stage, const struct gl *gl);
void stage_shadow_end(const struct stage *stage, const struct gl *gl);

/*
 * What stands on level ground, over flat shadows: stage_shadow_end() draws it,
 * and this where there are none.
 */
void stage_draw_monitor(const struct stage *stage, const struct gl *gl);

#endif
