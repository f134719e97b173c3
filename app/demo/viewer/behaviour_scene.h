/*
 * Draws a character on its stage, with its shadows, its cape and the balls of
 * targets.
 */
#ifndef APP_DEMO_VIEWER_BEHAVIOUR_SCENE_H
#define APP_DEMO_VIEWER_BEHAVIOUR_SCENE_H

#include "app/character/character.h"
#include "app/demo/actor.h"
#include "app/demo/viewer/behaviour_bounds.h"
#include "app/scene/shadow/shadow_drape.h"
#include "app/scene/stage/ball.h"

struct behaviour_scene {
	struct ball ball;
	struct shadow_drape drape; /* if the ground may be uneven */
};

/*
 * Memory comes from the instance's arena. Returns 0, or -ENOMEM after logging
 * an error.
 */
int behaviour_scene_init(struct behaviour_scene *scene,
	struct instance *instance, bool has_waves, const struct log *log);

/* Makes the shadow on uneven ground of the updated instance. */
void behaviour_scene_update(
	struct behaviour_scene *scene, const struct demo_base *base);

void behaviour_scene_draw(const struct behaviour_scene *scene,
	const struct character *character,
	const struct behaviour_bounds *bounds, const struct demo_base *base,
	int width, int height);

#endif
