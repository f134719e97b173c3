#include "app/scene/overlay/overlay_bones.h"

#include "app/anim/math/vec.h"

static const uint8_t bone_color[4] = {244, 236, 212, 255};
static const uint8_t joint_color[4] = {92, 172, 255, 255};
static const uint8_t chosen_color[4] = {250, 170, 60, 255};
static const uint8_t link_color[4] = {255, 255, 255, 200};

/*
 * Fractions of the figure's extent, except bone_radius: of the bone's length.
 */
static const float bone_max_radius = 0.017f, bone_radius = 0.13f;
static const float joint_radius = 0.009f;
static const float axis_length = 0.065f, axis_radius = 0.006f;

static int bone_parent(const struct overlay_bones *bones, int node)
{
	const struct model *model = bones->instance->model;
	int parent = model->node[node].parent;

	while (parent >= 0 && !bones->is_bone[parent]) {
		parent = model->node[parent].parent;
	}
	return parent;
}

static void add_bone(const struct overlay_bones *bones, int parent, int node,
	struct overlay_sketch *sketch)
{
	float from[3], to[3], along[3], radius;

	instance_node_position(bones->instance, parent, from);
	instance_node_position(bones->instance, node, to);
	vec_subtract(to, from, along);
	radius = vec_length(along) * bone_radius;
	if (radius > bones->extent * bone_max_radius) {
		radius = bones->extent * bone_max_radius;
	}
	overlay_sketch_spindle(sketch, from, to, 0.16f, radius,
		parent == bones->chosen ? chosen_color : bone_color);
}

void overlay_bones_skeleton(
	const struct overlay_bones *bones, struct overlay_sketch *sketch)
{
	for (int node = 0; node < bones->instance->model->node_count; node++) {
		int parent =
			bones->is_bone[node] ? bone_parent(bones, node) : -1;
		float at[3];

		if (!bones->is_bone[node]) {
			continue;
		}
		if (parent >= 0) {
			add_bone(bones, parent, node, sketch);
		}
		instance_node_position(bones->instance, node, at);
		overlay_sketch_octahedron(sketch, at,
			bones->extent * joint_radius,
			node == bones->chosen ? chosen_color : joint_color);
	}
}

void overlay_bones_axes(
	const struct overlay_bones *bones, struct overlay_sketch *sketch)
{
	static const uint8_t color[3][4] = {
		{236, 66, 60, 255}, {84, 200, 84, 255}, {74, 128, 255, 255}};
	const struct instance *instance = bones->instance;

	for (int node = 0; node < instance->model->node_count; node++) {
		float at[3];

		if (!bones->is_bone[node]) {
			continue;
		}
		instance_node_position(instance, node, at);
		for (int axis = 0; axis < 3; axis++) {
			const float *along = instance->world[node][axis];
			float length = vec_length(along), end[3];

			if (!(length > 0.0f)) {
				continue;
			}
			vec_add_scaled(at, along,
				bones->extent * axis_length / length, end);
			overlay_sketch_spindle(sketch, at, end, 0.75f,
				bones->extent * axis_radius, color[axis]);
		}
	}
}

void overlay_bones_links(
	const struct overlay_bones *bones, struct overlay_sketch *sketch)
{
	for (int node = 0; node < bones->instance->model->node_count; node++) {
		int parent =
			bones->is_bone[node] ? bone_parent(bones, node) : -1;
		float from[3], to[3];

		if (parent >= 0) {
			instance_node_position(bones->instance, parent, from);
			instance_node_position(bones->instance, node, to);
			overlay_sketch_line(sketch, from, to, link_color);
		}
	}
}
