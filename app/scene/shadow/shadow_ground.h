/*
 * Ground that a model brings along: level surfaces at its bottom, below all the
 * rest, such as a floor, a lawn or the plate that a machine stands on, or
 * uneven surfaces that face upwards, such as hills.
 *
 * Such ground would hide the shadows that lie on the stage's floor. The ground
 * is therefore drawn first; then the shadows of all else are drawn on it, where
 * the stencil says that the ground is seen; then all else. The stage's floor
 * lies a little below ground, and below any other bottom that is seen
 * (stage_lower_floor()), because two surfaces in one plane would fight.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_GROUND_H
#define APP_SCENE_SHADOW_SHADOW_GROUND_H

#include "app/scene/draw/texture.h"
#include "app/scene/instance/bounds.h"
#include "app/scene/shadow/shadow_relief.h"
#include "app/scene/stage/stage.h"

struct shadow_ground {
	int count;     /* 0: the model has no ground */
	int *drawable; /* [count], in the instance's arena */
	/* In scene units, at rest: the height of its surface, */
	float y;
	float level; /* by how little heights may differ, */
	struct shadow_ground_span {
		float low, high;
	} * span; /* and what each drawable's box spans, [count] */
	struct shadow_relief relief; /* if the ground is uneven */
	/*
	 * The model has level ground, or other triangles at its bottom that
	 * face upwards: the stage's floor has to be lowered.
	 */
	bool in_plane;
};

/*
 * Finds opaque drawables that no clip, skin or target moves, whose vertices lie
 * at one height or at two heights, and which together are about as wide as the
 * model and far lower. If there are none, finds such drawables of any heights,
 * nearly all of whose surface faces upwards. Leaves the instance in the rest
 * pose. Returns 0 or -ENOMEM.
 */
int shadow_ground_find(struct shadow_ground *ground, struct instance *instance);

/*
 * Draws the ground and begins its shadows: until stage_top_end(), whatever is
 * drawn with DRAW_SHADOW is projected on it. Call it after the shadows on the
 * stage's floor and before all else is drawn. The ground is hidden from
 * draw_instance() until shadow_ground_hide() with false. Ground that was lifted
 * since it was found keeps its shadows. Does nothing and returns false without
 * a stencil buffer, and without ground or when its drawables lie in no level
 * plane now. light is towards the light, as the instance stands.
 *
 * Ground with a relief is only drawn, and the stencil buffer marked with
 * STAGE_GROUND_MARK where it is seen. Draw the shadows with shadow_drape_draw()
 * then, and do not call stage_top_end().
 */
bool shadow_ground_begin(const struct shadow_ground *ground,
	const struct stage *stage, const struct gl *gl, const float light[3],
	struct instance *instance, const struct texture_set *textures);

/*
 * Hides the ground from draw_instance() and from shadow_drape_update(), or
 * shows it again, as has to be done after the whole instance was drawn.
 */
void shadow_ground_hide(const struct shadow_ground *ground,
	struct instance *instance, bool hidden);

#endif
