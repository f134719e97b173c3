/*
 * Draws a figure in another pose as tinted glass, for onion skins: the key
 * frames before and after the pose that is shown.
 *
 * A ghost is one more instance of the model, which takes as much memory as the
 * figure's own. It is posed anew for each onion skin.
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_GHOST_H
#define APP_SCENE_OVERLAY_OVERLAY_GHOST_H

#include "app/scene/draw/draw.h"

struct overlay_ghost {
	const struct instance *figure; /* not owned */
	struct instance *instance;
	struct model glass; /* the model with white materials */
};

/*
 * Makes a ghost of a figure: of glass or, with solid, as the figure is. Returns
 * 0, or -ENOMEM after logging an error; then nothing is left to release.
 * Release it with overlay_ghost_finish().
 */
int overlay_ghost_init(struct overlay_ghost *ghost,
	const struct instance *figure, bool solid, const struct log *log);

/* Releases a ghost; one that is all zero is allowed. */
void overlay_ghost_finish(struct overlay_ghost *ghost);

/*
 * Draws the pose of a ghost of glass (ghost->instance->pose) in this colour,
 * with alpha.
 */
void overlay_ghost_draw(struct overlay_ghost *ghost, const struct gl *gl,
	const struct texture_set *textures, const float color[4]);

/* Draws the pose of a solid ghost. */
void overlay_ghost_draw_solid(struct overlay_ghost *ghost, const struct gl *gl,
	const struct texture_set *textures);

/*
 * Returns the time of the nearest key frame of any channel that is at least
 * gap_s seconds after time_s or, if gap_s is negative, more than -gap_s seconds
 * before it. Returns a negative time if the clip has no such key frame.
 */
float overlay_ghost_key_time(
	const struct model_clip *clip, float time_s, float gap_s);

#endif
