/*
 * The surroundings of a model: camera, lights, floor and background.
 *
 * A frame calls stage_begin(), then draws the shadows, then the models. Flat
 * shadows are drawn with DRAW_SHADOW between stage_shadow_begin() and
 * stage_shadow_end(); shadows on uneven ground are drawn right after stage_begin().
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
	struct floor_sight sight; /* of the floor; set by stage_begin() */
	/*
	 * What this frame draws after the ground. Set it before stage_begin()
	 * if it is known; all zero means anything anywhere.
	 */
	struct floor_content content;
	bool has_stencil;
	/* Replaces the background and the level floor; may be NULL. */
	const struct live_texture *backdrop;
	/* Stands on the floor; dark without a picture; may be NULL. */
	const struct monitor *monitor;
	const struct live_texture *monitor_picture;
};

/*
 * Makes a stage whose floor lies under the box and whose camera frames the box,
 * see camera_frame(). unit is that of floor_init(). Returns 0, or -ENOMEM after
 * logging an error. Release it with stage_finish().
 */
int stage_init(struct stage *stage, const struct gl *gl,
	const struct bounds *bounds, float unit,
	const struct camera_framing *framing, enum pixel_format target,
	const struct log *log);

void stage_finish(struct stage *stage, const struct gl *gl);

/*
 * Moves the camera by moved, how far a figure went since the last call, and the
 * ground's middle to way, how far the figure went in all; both in scene units.
 * Below a figure that rises, more ground is shown.
 */
void stage_follow(struct stage *stage, const float moved[3], const float way[3]);

/*
 * Sets the viewport, clears the buffers, draws background and floor, and loads
 * the camera's matrices and the lights.
 */
void stage_begin(
	struct stage *stage, const struct gl *gl, int width, int height);

/*
 * Returns true if something that stage_begin() has drawn may hide a part of
 * what lies on uneven ground in a box. If not, the latter needs no depth test.
 */
bool stage_may_hide(const struct stage *stage, const struct bounds *box);

/*
 * Until stage_shadow_end(), whatever is drawn is projected along the key light
 * onto the floor's plane and blended in a dark colour.
 */
void stage_shadow_begin(const struct stage *stage, const struct gl *gl);
void stage_shadow_end(const struct stage *stage, const struct gl *gl);

/*
 * Does the same as stage_shadow_begin() for shadows on a level rectangle above
 * the ground, given by its corners in order. Call it after all that may hide
 * the rectangle was drawn. It needs a stencil buffer. End it with
 * stage_top_end().
 */
void stage_top_begin(
	const struct stage *stage, const struct gl *gl, float corner[4][3]);
void stage_top_end(const struct gl *gl);

enum {
	STAGE_GROUND_MARK = 64 /* in the stencil: ground of the model's own */
};

/*
 * Do the same as stage_top_begin() for level ground of the model's own, at
 * height y. The caller draws the ground between these two calls, and then,
 * until stage_top_end(), the shadows that lie on it. They need a stencil
 * buffer. light is towards the light, and it and y are in the space of the
 * current model-view matrix, in which a model may stand turned.
 */
void stage_ground_begin(const struct gl *gl);
void stage_ground_end(const struct gl *gl, const float light[3], float y);

/*
 * Lowers the floor by a small part of the box's extent, below ground of the
 * model's own that would lie in the same plane.
 */
void stage_lower_floor(struct stage *stage, const struct bounds *box);

/*
 * Draws the monitor on level ground, where it has to follow the flat shadows.
 * stage_shadow_end() calls this; a frame without flat shadows calls it itself.
 */
void stage_draw_monitor(const struct stage *stage, const struct gl *gl);

#endif
