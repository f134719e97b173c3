#include "app/demo/viewer/behaviour_bounds.h"

#include <errno.h>

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

/* Adds a box unless the model would be too small. */
static void add_box(struct behaviour_bounds *bounds, const struct bounds *box,
	float model_extent, struct bounds *to)
{
	struct bounds with = bounds->all;

	bounds_join(&with, box);
	if (bounds_extent(&with) <= 2.0f * model_extent) {
		bounds->all = with;
		bounds_join(to, box);
	}
}

/* Shapes within the rest pose's box do not matter. */
static void add_shapes(
	struct behaviour_bounds *bounds, const struct bounds *shapes)
{
	float least = 0.01f * bounds_extent(&bounds->rest);

	for (int axis = 0; axis < 3; axis++) {
		if (shapes->low[axis] < bounds->rest.low[axis] - least ||
			shapes->high[axis] > bounds->rest.high[axis] + least) {
			bounds_join(&bounds->extra, shapes);
		}
	}
}

/* Adds all places of the targets' balls. */
static void add_balls(struct behaviour_bounds *bounds,
	const struct character *character, float model_extent)
{
	float unit_scale = character->instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float radius = target->radius_m;
		struct bounds ball;

		bounds->ball[i] = bounds_empty();
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
		add_box(bounds, &ball, model_extent, &bounds->ball[i]);
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
static void add_shifts(struct behaviour_bounds *bounds,
	const struct character *character, float model_extent)
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
			add_box(bounds, &low, model_extent, &bounds->extra);
			add_box(bounds, &high, model_extent, &bounds->extra);
		}
	}
	instance_update(instance);
}

int behaviour_bounds_init(
	struct behaviour_bounds *bounds, const struct character *character)
{
	struct instance *instance = character->instance;
	int count = instance->model->clip_count;
	float extent;

	bounds->clip =
		ARENA_ARRAY(&instance->arena, struct bounds, (size_t)count);
	bounds->ball = ARENA_ARRAY(&instance->arena, struct bounds,
		(size_t)character->target_count);
	if (!bounds->clip || !bounds->ball) {
		return -ENOMEM;
	}
	bounds->rest = bounds_of_model(instance, bounds->clip);
	bounds->extra = bounds_empty();
	for (int i = 0; i < character->morph_count; i++) {
		struct bounds shapes =
			bounds_of_targets(instance, character->morph[i].node);

		add_shapes(bounds, &shapes);
	}
	bounds->all = bounds->rest;
	for (int i = 0; i < count; i++) {
		bounds_join(&bounds->all, &bounds->clip[i]);
	}
	bounds_join(&bounds->all, &bounds->extra);
	extent = bounds_extent(&bounds->all);
	pose_rest(&instance->pose, instance->model);
	add_shifts(bounds, character, extent);
	add_balls(bounds, character, extent);
	return 0;
}

static void add_entry(const struct behaviour_bounds *bounds,
	const struct character *character, const struct character_entry *entry,
	struct bounds *all)
{
	const struct model_clip *first = character->instance->model->clip;

	bounds_join(all,
		entry->of->clip ? &bounds->clip[entry->of->clip - first]
				: &bounds->rest);
}

struct bounds behaviour_bounds_now(const struct behaviour_bounds *bounds,
	const struct character *character)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	struct bounds all = bounds->extra;

	for (int i = 0; i < state->entry_count; i++) {
		add_entry(bounds, character, &state->entry[i], &all);
	}
	for (int i = 0; i < character->layer_count; i++) {
		const struct character_layer *layer = &character->layer[i];

		if (layer->once ? layer->playing : layer->is.is_on) {
			add_entry(bounds, character, &layer->entry, &all);
		}
	}
	for (int i = 0; i < character->target_count; i++) {
		if (character->target[i].used) {
			bounds_join(&all, &bounds->ball[i]);
		}
	}
	return all;
}
