/* The box of one drawable's posed vertices. */
#ifndef APP_SCENE_INSTANCE_BOUNDS_DRAWABLE_H
#define APP_SCENE_INSTANCE_BOUNDS_DRAWABLE_H

#include "app/scene/instance/bounds.h"

/*
 * Returns the box of the last update's vertices, in scene units: that of
 * instance_world_vertex(), to the bit, in a part of the time.
 */
struct bounds bounds_of_drawable(
	const struct instance *instance, const struct drawable *drawable);

#endif
