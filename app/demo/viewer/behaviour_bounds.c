#include "app/demo/viewer/behaviour_bounds.h"

void behaviour_range(const struct character *character, const float *value,
	float *low, float *high)
{
	*low = *high = *value;
	for (int i = 0; i < character->parameter_count; i++) {
		const struct character_parameter *p = &character->parameter[i];

		if (value == &p->value) {
			*low = p->range[0];
			*high = p->range[1];
		}
	}
}

/*
 * Adds a box unless the model would be less than half as large in the picture.
 */
static void add_box(
	struct bounds *all, const struct bounds *box, float model_extent)
{
	struct bounds with = *all;

	bounds_join(&with, box);
	if (bounds_extent(&with) <= 2.0f * model_extent) {
		*all = with;
	}
}

/* Adds all places of the targets' balls. */
static void add_balls(struct bounds *all, const struct character *character,
	float model_extent)
{
	float unit_scale = character->instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float radius = target->radius_m;
		struct bounds ball;

		if (radius <= 0.0f || target->is_camera || target->node >= 0) {
			continue;
		}
		for (int axis = 0; axis < 3; axis++) {
			float low, high;

			behaviour_range(
				character, target->place[axis], &low, &high);
			ball.low[axis] = (low - radius) * unit_scale;
			ball.high[axis] = (high + radius) * unit_scale;
		}
		add_box(all, &ball, model_extent);
	}
}

/* The box of the model with a node shifted along an axis. */
static struct bounds shifted(
	struct instance *instance, int node, int axis, float way_m)
{
	struct bounds bounds;

	instance->pose.local[node].translation[axis] += way_m;
	instance_update(instance);
	bounds = bounds_of_instance(instance);
	pose_rest(&instance->pose, instance->model);
	return bounds;
}

/* Adds where parts go that are shifted, such as a truck on its way. */
static void add_shifts(struct bounds *all, const struct character *character,
	float model_extent)
{
	struct instance *instance = character->instance;

	for (int i = 0; i < character->part_count; i++) {
		const struct character_part *part = &character->part[i];

		for (int axis = 0; axis < 3; axis++) {
			const struct character_freedom *freedom =
				&part->freedom[CHARACTER_X + axis];
			struct bounds low, high;

			if (!freedom->given) {
				continue;
			}
			low = shifted(instance, part->node, axis, freedom->low);
			high = shifted(
				instance, part->node, axis, freedom->high);
			add_box(all, &low, model_extent);
			add_box(all, &high, model_extent);
		}
	}
	instance_update(instance);
}

struct bounds behaviour_bounds(const struct character *character)
{
	struct instance *instance = character->instance;
	struct bounds all = bounds_of_model(instance, -1);
	float extent;

	for (int i = 0; i < character->morph_count; i++) {
		struct bounds shapes =
			bounds_of_targets(instance, character->morph[i].node);

		bounds_join(&all, &shapes);
	}
	extent = bounds_extent(&all);
	add_shifts(&all, character, extent);
	add_balls(&all, character, extent);
	return all;
}
