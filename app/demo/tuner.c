/*
 * The tuner changes the parameters of shaken bones while they shake.
 *
 * It implements "Physic-based Implementation" of the document on offline and
 * physics-based animation. The bones below each shoulder are painted by the
 * strength of their swing: red for the strongest one, blue where the
 * attenuation leaves none.
 */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/preset_file.h"
#include "app/demo/vertex_tint.h"
#include "app/scene/overlay/overlay_heat.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum {
	SIDES = 2,
	LEVELS_MAX = 16,
	OFF_CHAIN = -1
};

static const char clip_name[] = "idle";
static const char *const bones[SIDES] = {"shoulder.L", "shoulder.R"};
static const float fade_s = 0.3f;
static const double repeat_after_s = 0.4, repeat_s = 0.06; /* while held */
static const double message_s = 2.0;
static const double autoplay_s = 6.0;
static const int attenuation = 2; /* of preset_fields */
static const uint8_t off_chain_rgb[3] = {206, 210, 216};

static const struct actor_framing framing = {.camera = {.yaw_rad = 0.3f,
						     .pitch_rad = 0.1f,
						     .margin = 1.04f,
						     .follow = true},
	.label_rows = 11,
	.label_bars = 0};

struct demo {
	struct demo_base base;
	const struct log *log;
	int height; /* of the picture */
	struct preset_file file;
	int chosen; /* the preset's index */
	int field;
	struct procedural swing[SIDES];
	struct vertex_tint tint;
	int8_t **level; /* [drawable_count][vertex_count], see level_of() */
	bool painted, autoplay, shaking;
	int clip;
	double now_s;
	int changing; /* while LEFT or RIGHT is held: -1 or 1, else 0 */
	double next_change_s;
	const char *message;
	double message_end_s;
};

static struct procedural_preset *preset_of(struct demo *demo)
{
	return &demo->file.preset[demo->chosen];
}

/* The node's depth below either shaken bone, or OFF_CHAIN. */
static int8_t level_of(const struct demo *demo, int node)
{
	const struct model *model = demo->base.actor.model;
	int8_t level = 0;

	while (node >= 0 && level < LEVELS_MAX) {
		if (node == demo->swing[0].node || node == demo->swing[1].node) {
			return level;
		}
		node = model->node[node].parent;
		level++;
	}
	return OFF_CHAIN;
}

/* The joint with the greatest weight, or a rigid drawable's node. */
static int main_joint(
	const struct model *model, const struct drawable *drawable, int vertex)
{
	struct skin_influence influence[SKIN_INFLUENCES_MAX];

	if (drawable->skin < 0) {
		return drawable->node;
	}
	skin_gather_influences(drawable->primitive, (uint32_t)vertex, influence);
	return model->skin[drawable->skin].joint[influence[0].joint];
}

static int find_levels(struct demo *demo)
{
	struct instance *instance = demo->base.actor.instance;
	struct arena *arena = &instance->arena;

	demo->level = arena_alloc(
		arena, (size_t)instance->drawable_count, sizeof(*demo->level));
	for (int d = 0; demo->level && d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		int count = drawable->primitive->vertex_count;

		demo->level[d] = arena_alloc(arena, (size_t)count, 1);
		if (!demo->level[d]) {
			return -ENOMEM;
		}
		for (int v = 0; v < count; v++) {
			demo->level[d][v] = level_of(
				demo, main_joint(instance->model, drawable, v));
		}
	}
	return demo->level ? 0 : -ENOMEM;
}

static void paint(struct demo *demo)
{
	const struct instance *instance = demo->base.actor.instance;
	const struct procedural_preset *preset = preset_of(demo);
	uint8_t rgb[LEVELS_MAX + 1][3];
	float max = 0.001f;

	for (int level = 0; level <= LEVELS_MAX; level++) {
		float modifier = procedural_modifier(preset, level);

		/* The chain is no longer than six bones. */
		max = level < 6 && modifier > max ? modifier : max;
	}
	for (int level = 0; level <= LEVELS_MAX; level++) {
		overlay_heat_ramp(
			procedural_modifier(preset, level) / max, rgb[level]);
	}
	for (int d = 0; d < instance->drawable_count; d++) {
		int count = instance->drawable[d].primitive->vertex_count;

		for (int v = 0; v < count; v++) {
			int level = demo->level[d][v];

			vertex_tint_set(&demo->tint, d, v,
				level == OFF_CHAIN ? off_chain_rgb : rgb[level]);
		}
	}
}

/* Call this after any change of the preset. */
static void use_preset(struct demo *demo)
{
	for (int side = 0; side < SIDES; side++) {
		demo->swing[side].preset = *preset_of(demo);
	}
	paint(demo);
}

static void show_message(struct demo *demo, const char *message)
{
	demo->message = message;
	demo->message_end_s = demo->now_s + message_s;
}

static int begin_swings(struct demo *demo, const struct log *log)
{
	const struct model *model = demo->base.actor.model;

	for (int side = 0; side < SIDES; side++) {
		int node;
		int error = actor_find_bone(model, bones[side], log, &node);

		if (error) {
			return error;
		}
		demo->swing[side] = procedural_begin(preset_of(demo), node);
		procedural_fade(&demo->swing[side], 0.0f, fade_s);
	}
	return 0;
}

static int tuner_prepare(struct demo *demo, const struct demo_env *env)
{
	struct instance *instance = demo->base.actor.instance;
	struct bounds bounds;
	int error = preset_file_read(&demo->file, env->log);

	demo->log = env->log;
	demo->height = env->height;
	demo->autoplay = env->unattended;
	demo->painted = demo->shaking = true;
	demo->field = attenuation;
	demo->clip = model_find_clip(instance->model, clip_name);
	instance->normal_mapping = false;
	if (!error) {
		error = begin_swings(demo, env->log);
	}
	if (error) {
		return error;
	}
	error = vertex_tint_init(&demo->tint, instance);
	if (!error) {
		error = find_levels(demo);
	}
	if (error) {
		log_error(env->log,
			"%s: there is not enough memory to tune the model",
			env->model_path);
		return error;
	}
	use_preset(demo);
	bounds = bounds_of_clip(instance, demo->clip);
	vertex_tint_switch(&demo->tint, demo->painted);
	return actor_init_stage(env, &bounds, &framing, &demo->base.stage);
}

static void change(struct demo *demo, int steps)
{
	const struct preset_field *field = &preset_fields[demo->field];
	float *value = preset_value(preset_of(demo), field);
	float count = *value / field->step + (float)steps;
	/* Values are multiples of the step, so that a change can be undone. */
	float whole = (float)(int)(count + (count < 0.0f ? -0.5f : 0.5f));

	*value = scalar_clamp(whole * field->step, field->low, field->high);
	use_preset(demo);
}

static void repeat_change(struct demo *demo)
{
	while (demo->changing && demo->now_s >= demo->next_change_s) {
		change(demo, demo->changing);
		demo->next_change_s += repeat_s;
	}
}

static void run_autoplay(struct demo *demo)
{
	float angle = (float)(demo->now_s / autoplay_s -
			      (double)(long)(demo->now_s / autoplay_s)) *
		2.0f * SCALAR_PI;

	*preset_value(preset_of(demo), &preset_fields[attenuation]) =
		-0.35f * scalar_cos(angle);
	use_preset(demo);
}

static void tuner_update(struct demo *demo, double time_s)
{
	struct actor *actor = &demo->base.actor;
	float step_s = (float)(time_s - demo->now_s);

	demo->now_s = time_s;
	if (demo->autoplay) {
		run_autoplay(demo);
	}
	repeat_change(demo);
	actor_pose(actor, demo->clip,
		demo->clip < 0
			? 0.0f
			: clip_time(time_s,
				  actor->model->clip[demo->clip].duration_s,
				  CLIP_LOOP));
	for (int side = 0; side < SIDES; side++) {
		procedural_update(&demo->swing[side], step_s);
		procedural_apply(
			&demo->swing[side], time_s, &actor->instance->pose);
	}
	actor_update(actor, &demo->base.stage.camera, demo->height);
}

static void tuner_draw(struct demo *demo, int width, int height)
{
	demo->height = height;
	actor_draw(&demo->base.actor, &demo->base.stage, demo->base.gl, width,
		height);
}

static double tuner_period_s(const struct demo *demo)
{
	(void)demo;
	return autoplay_s;
}

/* Where not all fields are shown, the chosen one is the second. */
static int first_field(const struct demo *demo, const struct hud *hud)
{
	int rows = hud_group_rows_max(hud->width, hud->height);

	return rows >= PRESET_FIELDS || demo->field == 0 ? 0 : demo->field - 1;
}

static void tuner_label(const struct demo *demo, struct hud *hud)
{
	struct procedural_preset preset = demo->file.preset[demo->chosen];
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, preset.name);

	for (int i = first_field(demo, hud); i < PRESET_FIELDS; i++) {
		const struct preset_field *field = &preset_fields[i];
		char value[32];

		snprintf(value, sizeof(value), "%.2f",
			(double)*preset_value(&preset, field));
		if (i == demo->field) {
			hud_group_mark(
				&group, field->name, value, hud_color_amber);
		} else {
			hud_group_text(&group, field->name, value);
		}
	}
	hud_group_end(&group);
	if (demo->message && demo->now_s < demo->message_end_s) {
		group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
		hud_group_text(&group, demo->message, "");
		hud_group_end(&group);
	}
}

static void tuner_get_motion(const struct demo *demo, struct overlay_motion *out)
{
	static const char *const name[SIDES] = {"left shake", "right shake"};
	const struct model *model = demo->base.actor.model;

	out->clip = demo->clip;
	if (demo->clip >= 0) {
		out->time_s = clip_time(demo->now_s,
			model->clip[demo->clip].duration_s, CLIP_LOOP);
	}
	for (int side = 0; side < SIDES; side++) {
		out->layer[side] = (struct overlay_layer){
			name[side], 1.0f - demo->swing[side].fade, NULL};
	}
	out->layer_count = SIDES;
}

static void step_field(struct demo *demo, int step)
{
	demo->field = (demo->field + step + PRESET_FIELDS) % PRESET_FIELDS;
}

static void press_up(struct demo *demo, bool down)
{
	step_field(demo, down ? -1 : 0);
}

static void press_down(struct demo *demo, bool down)
{
	step_field(demo, down ? 1 : 0);
}

static void change_value(struct demo *demo, int direction, bool down)
{
	demo->changing = down ? direction : 0;
	if (down) {
		demo->autoplay = false;
		change(demo, direction);
		demo->next_change_s = demo->now_s + repeat_after_s;
	}
}

static void press_left(struct demo *demo, bool down)
{
	change_value(demo, -1, down);
}

static void press_right(struct demo *demo, bool down)
{
	change_value(demo, 1, down);
}

static void press_save(struct demo *demo, bool down)
{
	if (!down) {
		return;
	}
	if (!demo->file.path[0]) {
		show_message(demo, "no file to save to");
		return;
	}
	show_message(demo,
		preset_file_save(demo->file.path, preset_of(demo), demo->log)
			? "could not be saved"
			: "saved");
}

static void press_next(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		demo->chosen = (demo->chosen + 1) % demo->file.count;
		use_preset(demo);
	}
}

static void press_paint(struct demo *demo, bool down)
{
	if (down) {
		demo->painted = !demo->painted;
		vertex_tint_switch(&demo->tint, demo->painted);
	}
}

static void press_reload(struct demo *demo, bool down)
{
	struct preset_file file;

	if (down && preset_file_read(&file, demo->log) == 0 &&
		demo->chosen < file.count) {
		demo->autoplay = false;
		*preset_of(demo) = file.preset[demo->chosen];
		use_preset(demo);
		show_message(demo, "as in the file");
	}
}

static void press_shake(struct demo *demo, bool down)
{
	if (down) {
		demo->shaking = !demo->shaking;
		for (int side = 0; side < SIDES; side++) {
			procedural_fade(&demo->swing[side],
				demo->shaking ? 0.0f : 1.0f, fade_s);
		}
	}
}

static const struct demo_action tuner_actions[] = {
	{BUTTON_UP, "choose the previous parameter", press_up},
	{BUTTON_DOWN, "choose the next parameter", press_down},
	{BUTTON_LEFT, "decrease the parameter (hold to repeat)", press_left},
	{BUTTON_RIGHT, "increase the parameter (hold to repeat)", press_right},
	{BUTTON_ENTER, "save the preset to its file", press_save},
	{BUTTON_F6, "choose the next preset", press_next},
	{BUTTON_F8, "paint the shaken bones, or not", press_paint},
	{BUTTON_F9, "reload the preset from its file", press_reload},
	{BUTTON_F10, "shake the arms, or hold them still", press_shake},
	{0},
};

const struct demo_driver demo_driver_tuner = {
	.name = "tuner",
	.summary = "procedural: shaking arms whose parameters you change",
	.asset = "walker.glb",
	.action = tuner_actions,
	.size = sizeof(struct demo),
	.prepare = tuner_prepare,
	.update = tuner_update,
	.draw = tuner_draw,
	.period_s = tuner_period_s,
	.label = tuner_label,
	.get_motion = tuner_get_motion,
};
