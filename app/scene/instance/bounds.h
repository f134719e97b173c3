/*
 * Axis-aligned boxes around posed vertices.
 *
 * A skinned model's bind pose says little about where its vertices go, so
 * bounds are always computed from posed vertices.
 */
#ifndef APP_SCENE_INSTANCE_BOUNDS_H
#define APP_SCENE_INSTANCE_BOUNDS_H

#include "app/scene/instance/instance.h"

#define BOUNDS_MAX 1e9f

struct bounds {
	float low[3], high[3]; /* low is above high in an empty box */
};

struct bounds bounds_empty(void);
bool bounds_is_empty(const struct bounds *bounds);

/*
 * Extend the box to contain a point or another box. Coordinates are clamped to
 * +-BOUNDS_MAX, so that the box's lengths are finite; a point with a NaN is
 * left out.
 */
void bounds_add(struct bounds *bounds, const float point[3]);
void bounds_join(struct bounds *bounds, const struct bounds *other);

/*
 * Shrinks the box around a figure and its way to a box around the figure in its
 * place. way is how far the figure went along x and z, in scene units; the box
 * gets shorter by that at the end to which the figure went.
 */
void bounds_stay(struct bounds *bounds, const float way[2]);

/* Returns the length of the longest side, 0 for an empty box. */
float bounds_extent(const struct bounds *bounds);

/* Returns the box's centre, the origin for an empty box. */
void bounds_center(const struct bounds *bounds, float out[3]);

/*
 * Returns the height of level ground below the box, 0 below an empty one: that
 * of its lower side, or a thousandth of the extent less below a box so flat
 * that what it contains may lie in the ground's plane.
 */
float bounds_ground(const struct bounds *bounds);

/* Returns the box of the last update's vertices, in scene units. */
struct bounds bounds_of_instance(const struct instance *instance);

/*
 * The longest side along each axis, in scene units, that a model's box has at
 * any sampled moment of a clip.
 */
struct bounds_sides {
	float side[3];
};

/*
 * Finds the box and the sides of each clip, [clip_count], and returns the box
 * of the rest pose, in scene units. way, [clip_count], is how far each clip
 * carries the model along x and z; the model is taken to go evenly, and each
 * sample is moved back by its part of the way. The more clips there are, the
 * more coarsely they are sampled: it poses the whole instance about a hundred
 * times at most, unless there are more clips than that. Leaves the instance
 * posed at the last clip's start.
 */
struct bounds bounds_of_model(struct instance *instance, const float (*way)[2],
	struct bounds *clip, struct bounds_sides *sides);

/*
 * Returns the box of a clip, sampled at 13 evenly spaced times, in scene units;
 * -1 means the rest pose. Leaves the instance posed at the clip's start. It
 * poses the whole instance each time, so it is meant for load time.
 */
struct bounds bounds_of_clip(struct instance *instance, int clip);

/*
 * Returns the model's size in scene units: the longest side of the rest pose's
 * box or, where the model has no size at rest but for rounding, of the largest
 * clip's box, as clips may let it grow. Leaves the instance in the rest pose.
 */
float bounds_extent_of_model(struct instance *instance);

/*
 * Returns the box of the rest pose with each morph target of a node's mesh in
 * turn at its full weight, in scene units; of the first 104 targets when there
 * are more. Leaves the instance posed at rest. It poses the whole instance each
 * time, so it is meant for load time.
 */
struct bounds bounds_of_targets(struct instance *instance, int node);

#endif
