#include "app/anim/procedural/procedural.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "platform/base/scalar.h"

#include <string.h>

struct procedural_preset procedural_preset_default(void)
{
	return (struct procedural_preset){
		.name = "snowboard",
		.speed = 40,
		.amplitude = 0.3f,
		.attenuation = 0.3f,
		.translation = {0, 1, 0},
		.rotation = {0, 0.1f, 0},
		.modifier = 1,
		.unit = 1,
	};
}

int procedural_preset_find(
	const struct procedural_preset *preset, int count, const char *name)
{
	for (int i = 0; i < count; i++) {
		if (strcmp(preset[i].name, name) == 0) {
			return i;
		}
	}
	return -1;
}

struct procedural procedural_begin(
	const struct procedural_preset *preset, int node)
{
	return (struct procedural){
		.preset = *preset,
		.node = node,
		.fade = 1,
		.fade_goal = 1,
	};
}

void procedural_fade(struct procedural *procedural, float goal, float duration_s)
{
	procedural->fade_goal = scalar_clamp(goal, 0, 1);
	if (duration_s > 0) {
		procedural->fade_rate = 1 / duration_s;
	} else {
		procedural->fade = procedural->fade_goal;
	}
}

void procedural_update(struct procedural *procedural, float step_s)
{
	float step = procedural->fade_rate * (step_s > 0 ? step_s : 0);

	procedural->fade = scalar_clamp(procedural->fade_goal,
		procedural->fade - step, procedural->fade + step);
}

float procedural_modifier(const struct procedural_preset *preset, int level)
{
	float modifier = preset->modifier;

	for (int i = 0; i < level && modifier > 0.1f; i++) {
		modifier += preset->attenuation;
	}
	return modifier < 0 ? 0 : modifier;
}

/* Returns the factor at modifier 1 and fade 0, the same for all bones. */
static float swing(const struct procedural *procedural, double time_s)
{
	const double turn = 6.283185307179586;
	double angle = time_s * (double)procedural->preset.speed;
	double turns = angle / turn;

	/* Reduced in double, so that the angle is still exact after hours. */
	if (turns > -2147483647.0 && turns < 2147483647.0) {
		angle -= (double)(int32_t)turns * turn;
	}
	return scalar_cos((float)angle) * procedural->preset.amplitude;
}

/*
 * Returns how many levels a node is below an ancestor, 0 for the ancestor
 * itself, or -1 if it is no descendant.
 */
static int levels_below(const struct model *model, int node, int ancestor)
{
	int level = 0;

	while (node > ancestor) {
		node = model->node[node].parent;
		level++;
	}
	return node == ancestor ? level : -1;
}

static void swing_bone(const struct procedural_preset *preset, float factor,
	struct transform *local)
{
	static const float axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
	struct transform offset = transform_identity();

	for (int i = 0; i < 3; i++) {
		float turn[4];

		offset.translation[i] =
			preset->translation[i] * preset->unit * factor;
		quat_from_axis_angle(
			axis[i], preset->rotation[i] * factor, turn);
		quat_multiply(turn, offset.rotation, offset.rotation);
	}
	transform_compose(local, &offset, local);
	quat_normalize(local->rotation);
}

void procedural_apply(
	const struct procedural *procedural, double time_s, struct pose *pose)
{
	const struct procedural_preset *preset = &procedural->preset;
	float whole = swing(procedural, time_s) * (1 - procedural->fade);

	if (procedural->node < 0 || procedural->fade >= 1) {
		return;
	}
	for (int i = procedural->node; i < pose->node_count; i++) {
		int level = levels_below(pose->model, i, procedural->node);

		if (level >= 0) {
			swing_bone(preset,
				whole * procedural_modifier(preset, level),
				&pose->local[i]);
			pose->animated[i] = true;
		}
	}
}
