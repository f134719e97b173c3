/*
 * Stencil shadow volumes: the space that a drawable keeps from the light.
 *
 * Unlike a flattened shadow they fall on ground of any shape. They need
 * positions only. The volume is drawn when the depth buffer holds the ground
 * and not yet the figure, so the figure does not shade itself; its own lighting
 * does that more smoothly.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_VOLUME_H
#define APP_SCENE_SHADOW_SHADOW_VOLUME_H

#include "app/scene/instance/instance.h"
#include "app/scene/shadow/shadow_caster.h"
#include "app/scene/stage/floor.h"
#include "platform/gl/gl.h"

struct shadow_volume {
	bool depth_pass; /* all hulls, of the near plane; and they end in the ground */
	int caster_count;
	struct shadow_caster *caster;
};

/*
 * The light, and the ground it falls on. Hulls lie where that can be alone, so
 * that they cover no more of the picture than they must.
 */
struct shadow_light {
	float towards[3];           /* unit length */
	float max_length;           /* scene units: hulls are no longer */
	const struct floor *ground; /* NULL: hulls go all the way */
	/*
	 * The camera's (camera_near_plane()): where all hulls lie beyond, the
	 * eye is outside of them, and less has to be drawn.
	 */
	float near_plane[4];
};

/*
 * Finds the edges of all drawables; memory comes from the instance's arena.
 * Drawables with more than 32,768 vertices cast no shadow, which is said once.
 * 0, or -ENOMEM after a sentence.
 */
int shadow_volume_init(struct shadow_volume *volume, struct instance *instance,
	const struct log *log);

/*
 * After instance_update(): which triangles see the light, and the hulls that
 * follow. Allocates nothing.
 */
void shadow_volume_update(struct shadow_volume *volume,
	const struct instance *instance, const struct shadow_light *light);

/*
 * Darkens what lies in the volumes, by strength 0..1. Needs a stencil buffer
 * that is clear, the camera's model-view matrix, and a depth buffer with what
 * receives the shadow. Leaves the stencil test off and the stencil dirty.
 */
void shadow_volume_draw(const struct shadow_volume *volume, const struct gl *gl,
	float strength);

#endif
