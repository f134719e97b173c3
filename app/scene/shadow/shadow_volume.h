/*
 * Stencil shadow volumes: the space that a figure shades.
 *
 * Unlike projected shadows they fall on ground of any shape. They need
 * positions only. The volumes are drawn when the depth buffer holds the ground
 * but not the figure, so the figure casts no shadow on itself.
 */
#ifndef APP_SCENE_SHADOW_SHADOW_VOLUME_H
#define APP_SCENE_SHADOW_SHADOW_VOLUME_H

#include "app/scene/instance/bounds.h"
#include "app/scene/instance/instance.h"
#include "app/scene/shadow/shadow_caster.h"
#include "app/scene/stage/floor.h"
#include "platform/gl/gl.h"

struct shadow_volume {
	/*
	 * The eye is outside all volumes and sees no back cap: depth-pass
	 * counting suffices. Otherwise depth-fail counting is used.
	 */
	bool depth_pass;
	struct bounds box; /* around all volumes */
	bool box_seen;     /* its faces cover all pixels that it covers */
	int caster_count;
	struct shadow_caster *caster;
};

/*
 * The light and the ground. Volumes extend only from a little above the ground
 * to a little below it, so that they cover few pixels.
 */
struct shadow_light {
	float towards[3];           /* unit vector to the light */
	float max_length;           /* of a volume, scene units */
	const struct floor *ground; /* NULL: volumes have their full length */
	float near_plane[4];        /* from camera_near_plane() */
};

/*
 * Finds the edges of all drawables; memory comes from the instance's arena. A
 * drawable of more than 32,768 vertices casts no shadow, which is logged as a
 * warning. Returns 0, or -ENOMEM after logging an error.
 */
int shadow_volume_init(struct shadow_volume *volume, struct instance *instance,
	const struct log *log);

/*
 * Makes the volumes of the instance as it was last updated. Allocates nothing.
 */
void shadow_volume_update(struct shadow_volume *volume,
	const struct instance *instance, const struct shadow_light *light);

/*
 * Darkens pixels in the volumes by strength, 0..1. Expects a cleared stencil
 * buffer, the camera's model-view matrix, and a depth buffer with whatever
 * receives the shadow. Leaves the stencil test off and the stencil buffer
 * changed.
 */
void shadow_volume_draw(const struct shadow_volume *volume, const struct gl *gl,
	float strength);

#endif
