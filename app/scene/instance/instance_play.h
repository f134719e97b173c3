/*
 * Creates instances as the player does.
 */
#ifndef APP_SCENE_INSTANCE_INSTANCE_PLAY_H
#define APP_SCENE_INSTANCE_INSTANCE_PLAY_H

#include "app/scene/instance/instance.h"

/*
 * Whether joints move so many vertices of a part that it pays to pose only
 * those of the level of detail: sorted for this, all of them take 5% longer.
 */
bool instance_is_dense(const struct model *model);

/* instance_create_for_drawing() if the model is dense, or instance_create(). */
int instance_create_to_play(const struct model *model,
	const struct kernel *kernel, const struct log *log,
	struct instance **out);

#endif
