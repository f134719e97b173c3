#include "app/character/show/character_bounds.h"

#include "app/character/run/effects.h"
#include "platform/base/scalar.h"

#include <errno.h>

/* Parts of the model's extent. */
/* heights of clips that differ by less count as equal */
static const float near_part = 0.03f;

void character_range(const struct character *character, const float *value,
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

/* Adds a box unless the model would then be too small in the picture. */
static void add_box(struct character_bounds *bounds, const struct bounds *box,
	struct bounds *to)
{
	struct bounds with = bounds->all;

	bounds_join(&with, box);
	if (bounds_extent(&with) <= 2.0f * bounds->extent) {
		bounds->all = with;
		bounds_join(to, box);
	}
}

/* Shapes within the rest pose's box do not matter. */
static void add_shapes(
	struct character_bounds *bounds, const struct bounds *shapes)
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
static void add_balls(
	struct character_bounds *bounds, const struct character *character)
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

			character_range(
				character, target->place[axis], &low, &high);
			ball.low[axis] = (low - radius) * unit_scale;
			ball.high[axis] = (high + radius) * unit_scale;
		}
		add_box(bounds, &ball, &bounds->ball[i]);
	}
}

/* Returns the box of the model with a node shifted along an axis. */
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
static void add_shifts(
	struct character_bounds *bounds, const struct character *character)
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
			low = shifted(instance, part->node, axis,
				freedom->low * part->metre[axis]);
			high = shifted(instance, part->node, axis,
				freedom->high * part->metre[axis]);
			add_box(bounds, &low, &bounds->extra);
			add_box(bounds, &high, &bounds->extra);
		}
	}
	instance_update(instance);
}

/*
 * Returns a point's coordinate along a direction: 0 to 5 are the axes both
 * ways, 6 to 13 the diagonals.
 */
static float along(const float point[3], int direction)
{
	float sum = 0.0f;

	if (direction < 6) {
		return direction & 1 ? point[direction / 2]
				     : -point[direction / 2];
	}
	for (int axis = 0; axis < 3; axis++) {
		sum += (direction - 6) >> axis & 1 ? point[axis] : -point[axis];
	}
	return sum;
}

/* Whether each update poses the vertex, whatever the level of detail is. */
static bool is_always_posed(const struct drawable *drawable, int vertex)
{
	const struct drawable_fixed *fixed = drawable->fixed;

	return !fixed || drawable->skin < 0 ||
		fixed->inverse_order[vertex] <
		(uint32_t)fixed->skin.vertex_count_to[0];
}

static int find_outermost(
	struct character_bounds *bounds, struct instance *instance)
{
	bounds->outermost = arena_alloc(&instance->arena,
		(size_t)instance->drawable_count, sizeof(*bounds->outermost));
	if (!bounds->outermost) {
		return -ENOMEM;
	}
	for (int i = 0; i < instance->drawable_count * CHARACTER_DIRECTIONS;
		i++) {
		int direction = i % CHARACTER_DIRECTIONS, best = -1;
		const struct drawable *drawable =
			&instance->drawable[i / CHARACTER_DIRECTIONS];
		float(*position)[3] = drawable->primitive->position;

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			if (is_always_posed(drawable, v) &&
				(best < 0 ||
					along(position[v], direction) >
						along(position[best],
							direction))) {
				best = v;
			}
		}
		bounds->outermost[i / CHARACTER_DIRECTIONS][direction] =
			best > 0 ? best : 0;
	}
	return 0;
}

void character_bounds_add(const struct character_bounds *bounds,
	const struct instance *instance, int drawable, float y,
	const float slope[2], struct bounds *out)
{
	const struct drawable *shown = &instance->drawable[drawable];

	for (int i = 0; i < CHARACTER_DIRECTIONS; i++) {
		float point[3];

		if (shown->primitive->vertex_count == 0) {
			return;
		}
		instance_world_vertex(
			instance, shown, bounds->outermost[drawable][i], point);
		for (int axis = 0; axis < 3; axis++) {
			point[axis] *= instance->unit_scale;
		}
		point[0] += slope[0] * (point[1] - y);
		point[2] += slope[1] * (point[1] - y);
		bounds_add(out, point);
	}
}

/* Adds where the outermost vertices are now. */
static void add_reached(
	struct character_bounds *bounds, const struct instance *instance)
{
	static const float straight[2] = {0.0f, 0.0f};
	struct bounds now = bounds_empty();

	for (int i = 0; i < instance->drawable_count; i++) {
		character_bounds_add(bounds, instance, i, 0.0f, straight, &now);
	}
	add_box(bounds, &now, &bounds->extra);
}

/* Marks the clips that states and layers play. */
static void mark_played(bool *is_played, const struct model *model,
	const struct character_entry *entry, int count)
{
	for (int i = 0; i < count; i++) {
		const struct model_clip *clip = entry[i].of->clip;

		if (clip) {
			is_played[clip - model->clip] = true;
		}
	}
}

static void find_played(bool *is_played, const struct character *character)
{
	const struct character_machine *machine = &character->machine;
	const struct model *model = character->instance->model;

	for (int i = 0; i < machine->state_count; i++) {
		const struct character_state *state = &machine->state[i];

		mark_played(is_played, model, state->entry, state->entry_count);
	}
	for (int i = 0; i < character->layer_count; i++) {
		mark_played(is_played, model, &character->layer[i].entry, 1);
	}
}

/* A walk that stays in its place, because the ground moves, is not followed. */
int character_bounds_init(
	struct character_bounds *bounds, const struct character *character)
{
	struct instance *instance = character->instance;
	int count = instance->model->clip_count;
	int error;

	bounds->clip =
		ARENA_ARRAY(&instance->arena, struct bounds, (size_t)count);
	bounds->ball = ARENA_ARRAY(&instance->arena, struct bounds,
		(size_t)character->target_count);
	bounds->is_played = ARENA_ARRAY(&instance->arena, bool, (size_t)count);
	bounds->height = ARENA_ARRAY(&instance->arena, float, (size_t)count);
	bounds->follow = ARENA_ARRAY(
		&instance->arena, struct character_follow, (size_t)count);
	if (!bounds->clip || !bounds->ball || !bounds->is_played ||
		!bounds->height || !bounds->follow) {
		return -ENOMEM;
	}
	bounds->followed = -1;
	error = character_follow_find(character,
		&(struct character_boxes){
			&bounds->rest, bounds->clip, bounds->follow});
	if (error) {
		return error;
	}
	bounds->extra = bounds->swung = bounds_empty();
	for (int i = 0; i < character->morph_count; i++) {
		struct bounds shapes =
			bounds_of_targets(instance, character->morph[i].node);

		add_shapes(bounds, &shapes);
	}
	find_played(bounds->is_played, character);
	bounds->all = bounds->rest;
	for (int i = 0; i < count; i++) {
		bounds_join(&bounds->all, &bounds->clip[i]);
	}
	bounds_join(&bounds->all, &bounds->extra);
	bounds->extent = bounds_extent(&bounds->all);
	pose_rest(&instance->pose, instance->model);
	add_shifts(bounds, character);
	add_balls(bounds, character);
	return character->part_count > 0 ? find_outermost(bounds, instance) : 0;
}

static void add_points(
	const float (*point)[3], int count, float scale, struct bounds *out)
{
	for (int i = 0; i < count; i++) {
		bounds_add(out,
			(float[3]){point[i][0] * scale, point[i][1] * scale,
				point[i][2] * scale});
	}
}

/*
 * Returns the box of the springs' ends and of the capes; empty if none is on.
 */
static struct bounds swinging_now(const struct character *character)
{
	float scale = character->instance->unit_scale;
	struct bounds now = bounds_empty();

	for (int i = 0; i < character->op_count; i++) {
		const struct character_spring *effect = character->op[i].what;

		if (character->op[i].run == character_spring_run &&
			effect->is.now > 0.0f && effect->spring.begun) {
			add_points((const float(*)[3])effect->spring.position,
				effect->spring.count, scale, &now);
		}
	}
	for (int i = 0; i < character->cape_count; i++) {
		const struct character_cape *cape = &character->cape[i];

		if (cape->worn) {
			add_points((const float(*)[3])cape->cloth.position,
				cape->cloth.count, scale, &now);
		}
	}
	return now;
}

/* Adds where springs and capes are now, if they are well outside of a box. */
static void add_swings(struct character_bounds *bounds,
	const struct character *character, const struct bounds *box)
{
	struct bounds now = swinging_now(character), with = bounds->all;
	float near = near_part * bounds->extent;

	if (bounds_is_empty(&now)) {
		bounds->swung = now;
		return;
	}
	bounds_join(&with, &now);
	if (bounds_extent(&with) > 2.0f * bounds->extent) {
		return;
	}
	for (int axis = 0; axis < 3; axis++) {
		if (now.low[axis] < box->low[axis] - near ||
			now.high[axis] > box->high[axis] + near) {
			bounds_join(&bounds->swung, &now);
		}
	}
}

static void add_entry(const struct character_bounds *bounds,
	const struct character *character, const struct character_entry *entry,
	struct bounds *all)
{
	const struct model_clip *first = character->instance->model->clip;

	bounds_join(all,
		entry->of->clip ? &bounds->clip[entry->of->clip - first]
				: &bounds->rest);
}

/* Returns the clip of the current state that goes far, or -1. */
static int find_far_clip(const struct character_bounds *bounds,
	const struct character *character)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	const struct model_clip *first = character->instance->model->clip;

	for (int i = 0; i < state->entry_count; i++) {
		const struct model_clip *clip = state->entry[i].of->clip;

		if (clip && bounds->follow[clip - first].node >= 0) {
			return (int)(clip - first);
		}
	}
	return -1;
}

/* Returns the box of the far clip where its model is now. */
static struct bounds follow(struct character_bounds *bounds,
	const struct instance *instance, int clip, float moved[3])
{
	struct bounds box = bounds->clip[clip];
	float way[3];

	character_follow_way(&bounds->follow[clip], instance, way);
	for (int axis = 0; axis < 3; axis++) {
		moved[axis] = clip == bounds->followed
			? way[axis] - bounds->way[axis]
			: 0.0f;
		bounds->way[axis] = way[axis];
	}
	character_follow_box(&bounds->follow[clip], way, &box);
	return box;
}

struct bounds character_bounds_now(struct character_bounds *bounds,
	const struct character *character, float moved[3])
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	int far = find_far_clip(bounds, character);
	struct bounds all;

	if (far >= 0) {
		all = follow(bounds, character->instance, far, moved);
		bounds->followed = far;
		return all;
	}
	for (int axis = 0; axis < 3; axis++) {
		moved[axis] = bounds->way[axis] = 0.0f;
	}
	bounds->followed = -1;
	if (bounds->outermost) {
		add_reached(bounds, character->instance);
	}
	all = bounds->extra;
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
	add_swings(bounds, character, &all);
	bounds_join(&all, &bounds->swung);
	return all;
}
