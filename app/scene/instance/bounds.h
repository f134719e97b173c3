/*
 * Boxes around posed vertices.
 *
 * A skinned model's bind pose says little about where it goes, so bounds are
 * always taken from vertices that have been posed.
 */
#ifndef APP_SCENE_INSTANCE_BOUNDS_H
#define APP_SCENE_INSTANCE_BOUNDS_H

#include "app/scene/instance/instance.h"

struct bounds {
	float low[3], high[3]; /* low above high: empty */
};

struct bounds bounds_empty(void);
bool bounds_is_empty(const struct bounds *bounds);
void bounds_add(struct bounds *bounds, const float point[3]);
void bounds_join(struct bounds *bounds, const struct bounds *other);

/* The longest side; 0 when empty. */
float bounds_extent(const struct bounds *bounds);
void bounds_center(const struct bounds *bounds, float out[3]);

/* The instance as it was last updated, in scene units. */
struct bounds bounds_of_instance(const struct instance *instance);

/*
 * The instance over all of a clip (-1: at rest), at a few evenly spread times.
 * Leaves the instance at the clip's start. For load time, not for a frame.
 */
struct bounds bounds_of_clip(struct instance *instance, int clip);

#endif
