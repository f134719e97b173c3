/*
 * The tuner changes the parameters of shaken bones while they shake.
 *
 * The bones shake as in app/anim/procedural/procedural.h. The first row of the
 * panel chooses the bone to shake. This bone and those below it are painted by
 * the strength of their swing: red for the strongest one, blue where the
 * attenuation leaves none.
 */
#include "app/anim/math/matrix.h"
#include "app/character/presets/preset_file.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/tuner/tuner_bones.h"
#include "app/scene/hud/hud_name.h"
#include "app/scene/overlay/overlay_heat.h"
#include "platform/base/scalar.h"

#include <stdio.h>
#include <string.h>

enum {
	ROW_BONE,
	ROW_FIELDS, /* the first field of the preset */
	ROWS = ROW_FIELDS + PRESET_FIELDS
};

static const float person_m = 1.72f;
static const float fade_s = 0.3f;
static const double repeat_after_s = 0.4,
		    repeat_s = 0.06; /* while a button is held */
static const double longest_frame_s = 1.0;
static const double message_s = 2.0;
static const double autoplay_s = 6.0;
static const int attenuation = 2; /* index in preset_fields */
static const uint8_t off_chain_rgb[3] = {206, 210, 216};

static const struct framing framing = {.camera = {.yaw_rad = 0.3f,
					       .pitch_rad = 0.1f,
					       .margin = 1.04f,
					       .follow = true},
	.label_rows = 12,
	.label_bars = 0};

struct demo {
	struct demo_base base;
	const struct log *log;
	struct preset_file file;
	int chosen; /* the preset's index */
	int row;
	struct tuner_bones bones;
	struct procedural swing[MOTION_BONES_MAX]; /* [bones.count] are used */
	float unit_factor;                         /* for lengths of presets */
	struct overlay_heat heat;
	bool painted, autoplay, shaking, may_save;
	int clip;
	double now_s;
	int changing; /* while LEFT or RIGHT is held: -1 or 1, else 0 */
	double next_change_s;
	const char *message; /* shown until message_end_s */
	double message_end_s;
};

static struct procedural_preset *preset_of(struct demo *demo)
{
	return &demo->file.preset[demo->chosen];
}

/* The colour of each level of bones. */
struct palette {
	const struct tuner_bones *bones;
	uint8_t rgb[TUNER_LEVELS_MAX + 1][3];
};

static void color_vertex(void *user, int drawable, int vertex, uint8_t rgb[3])
{
	const struct palette *palette = user;
	const struct tuner_bones *bones = palette->bones;
	int level = bones->level[tuner_bones_mover(bones, drawable, vertex)];

	memcpy(rgb,
		level == TUNER_OFF_CHAIN ? off_chain_rgb : palette->rgb[level],
		3);
}

static void paint(struct demo *demo)
{
	const struct procedural_preset *preset = preset_of(demo);
	struct palette palette = {.bones = &demo->bones};
	float max = 0.001f;

	for (int level = 0; level <= demo->bones.deepest; level++) {
		float modifier = procedural_modifier(preset, level);

		max = scalar_max(modifier, max);
	}
	for (int level = 0; level <= TUNER_LEVELS_MAX; level++) {
		overlay_heat_ramp(procedural_modifier(preset, level) / max,
			palette.rgb[level]);
	}
	overlay_heat_paint(&demo->heat, color_vertex, &palette);
}

/*
 * Fits the lengths of a swing's preset to the model. Bones are shifted in their
 * own units, which differ below a scaled node.
 */
static void fit_lengths(const struct demo *demo, struct procedural *swing)
{
	const struct instance *instance = demo->base.actor.instance;
	float scale = matrix_scale((const mat4 *)&instance->world[swing->node]);

	swing->preset.unit *= demo->unit_factor;
	if (scale > 0.0f) {
		swing->preset.unit /= scale;
	}
}

/* Applies the preset to the swings and colours, after any change of it. */
static void use_preset(struct demo *demo)
{
	for (int i = 0; i < demo->bones.count; i++) {
		demo->swing[i].preset = *preset_of(demo);
		fit_lengths(demo, &demo->swing[i]);
	}
	paint(demo);
}

static void show_message(struct demo *demo, const char *message)
{
	demo->message = message;
	demo->message_end_s = demo->now_s + message_s;
}

/* Shakes the chosen bones; bones that were shaken before stop at once. */
static void begin_swings(struct demo *demo)
{
	for (int i = 0; i < demo->bones.count; i++) {
		demo->swing[i] =
			procedural_begin(preset_of(demo), demo->bones.node[i]);
		fit_lengths(demo, &demo->swing[i]);
		procedural_fade(
			&demo->swing[i], demo->shaking ? 0.0f : 1.0f, fade_s);
	}
}

/* The factor for the lengths of presets, which suit a figure of human size. */
static float unit_factor(const struct actor *actor)
{
	float extent = actor->extent / actor->instance->unit_scale;

	return extent <= 0.0f || (extent > 0.5f && extent < 4.0f)
		? 1.0f
		: extent / person_m;
}

static int tuner_prepare(struct demo *demo, const struct demo_env *env)
{
	struct instance *instance = demo->base.actor.instance;
	const struct character_request request = demo_env_request(env);
	struct motions motions;
	struct bounds bounds;
	int error = preset_file_find(&demo->file, env->log);

	demo->log = env->log;
	demo->autoplay = env->unattended;
	demo->painted = demo->shaking = true;
	demo->may_save = env->may_save;
	demo->row = ROW_FIELDS + attenuation;
	instance->normal_mapping = false;
	if (!error) {
		error = motions_find(&request, instance, env->log, &motions);
	}
	if (error) {
		return error;
	}
	demo->clip = motions.role[MOTION_STAND].clip;
	demo->unit_factor = unit_factor(&demo->base.actor);
	error = overlay_heat_init(&demo->heat, instance, &instance->arena);
	if (!error) {
		error = tuner_bones_init(&demo->bones, instance, &motions);
	}
	if (error) {
		return memory_budget_fail(
			instance->arena.budget, env->model_path, env->log);
	}
	error = shadow_figure_create(instance, &demo->base.actor.ground,
		env->log, &demo->base.actor.shadow);
	if (error) {
		return error;
	}
	begin_swings(demo);
	use_preset(demo);
	bounds = bounds_of_clip(instance, demo->clip);
	overlay_heat_switch(&demo->heat, demo->painted);
	return actor_init_stage(&demo->base, env, &bounds, instance->unit_scale,
		&framing, &demo->base.stage);
}

static void change(struct demo *demo, int steps)
{
	const struct preset_field *field;
	float *value, count, whole;

	if (demo->row == ROW_BONE) {
		tuner_bones_step(&demo->bones, steps);
		begin_swings(demo);
		paint(demo);
		return;
	}
	field = &preset_fields[demo->row - ROW_FIELDS];
	value = preset_value(preset_of(demo), field);
	count = *value / field->step + (float)steps;
	/* Values are multiples of the step, so that a change can be undone. */
	whole = (float)(int)(count + (count < 0.0f ? -0.5f : 0.5f));
	*value = scalar_clamp(whole * field->step, field->low, field->high);
	use_preset(demo);
}

static void repeat_change(struct demo *demo)
{
	/* The machine was suspended: nobody held the button for that long. */
	if (demo->now_s - demo->next_change_s > longest_frame_s) {
		demo->next_change_s = demo->now_s;
	}
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
	if (demo->clip >= 0) {
		const struct model_clip *clip = &actor->model->clip[demo->clip];

		clip_pose(clip, clip_round_time(clip, time_s, CLIP_LOOP),
			actor->interpolation, &actor->cursor,
			&actor->instance->pose);
	} else {
		pose_rest(&actor->instance->pose, actor->model);
	}
	for (int i = 0; i < demo->bones.count; i++) {
		procedural_update(&demo->swing[i], step_s);
		procedural_apply(
			&demo->swing[i], time_s, &actor->instance->pose);
	}
	actor_update(actor, &demo->base.stage.camera, demo->base.height);
}

static double tuner_period_s(const struct demo *demo)
{
	(void)demo;
	return autoplay_s;
}

/*
 * The first row to show. If not all rows have room, the chosen row is the
 * second, or the only one.
 */
static int first_row(const struct demo *demo, const struct hud *hud)
{
	int rows = hud_group_rows_max(hud->width, hud->height);

	return rows >= ROWS || demo->row == 0 ? 0 : demo->row - (rows > 1);
}

static const char *write_row(
	const struct demo *demo, int row, char *value, size_t size)
{
	struct procedural_preset preset = demo->file.preset[demo->chosen];

	if (row == ROW_BONE) {
		tuner_bones_name(&demo->bones, value, size);
		return "bone";
	}
	snprintf(value, size, "%.2f",
		(double)*preset_value(&preset, &preset_fields[row - ROW_FIELDS]));
	return preset_fields[row - ROW_FIELDS].name;
}

static void tuner_label(const struct demo *demo, struct hud *hud)
{
	char number[HUD_NAME_BYTES];
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT,
		demo->now_s < demo->message_end_s
			? demo->message
			: hud_name(demo->file.preset[demo->chosen].name,
				  "preset", demo->chosen + 1, number));

	for (int i = first_row(demo, hud); i < ROWS; i++) {
		char value[64];
		const char *name = write_row(demo, i, value, sizeof(value));

		if (i == demo->row) {
			hud_group_mark(&group, name, value, hud_color_amber);
		} else {
			hud_group_text(&group, name, value);
		}
	}
	hud_group_end(&group);
}

static void tuner_get_motion(const struct demo *demo, struct overlay_motion *out)
{
	const struct model *model = demo->base.actor.model;

	out->clip = demo->clip;
	out->interpolation = demo->base.actor.interpolation;
	if (demo->clip >= 0) {
		out->time_s = clip_round_time(
			&model->clip[demo->clip], demo->now_s, CLIP_LOOP);
	}
	for (int i = 0;
		i < demo->bones.count && i < (int)ARRAY_COUNT(out->layer); i++) {
		out->layer[i] = (struct overlay_layer){
			model->node[demo->bones.node[i]].name, "node",
			demo->bones.node[i], 1.0f - demo->swing[i].fade, NULL};
		out->layer_count = i + 1;
	}
}

static void step_row(struct demo *demo, int step)
{
	demo->row = (demo->row + step + ROWS) % ROWS;
}

static void change_value(struct demo *demo, int direction)
{
	demo->changing = direction;
	if (direction != 0) {
		change(demo, direction);
		demo->next_change_s = demo->now_s + repeat_after_s;
	}
}

static void save(struct demo *demo, int amount)
{
	(void)amount;
	if (!demo->may_save) {
		show_message(demo, "render cannot save");
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

static void step_preset(struct demo *demo, int step)
{
	demo->chosen = (demo->chosen + step) % demo->file.count;
	use_preset(demo);
}

static void toggle_paint(struct demo *demo, int amount)
{
	(void)amount;
	demo->painted = !demo->painted;
	overlay_heat_switch(&demo->heat, demo->painted);
}

static void read_again(struct demo *demo, int amount)
{
	struct preset_file file;
	int at;

	(void)amount;
	if (preset_file_find(&file, demo->log) != 0) {
		return;
	}
	at = procedural_preset_find(
		file.preset, file.count, preset_of(demo)->name);
	if (at >= 0) {
		*preset_of(demo) = file.preset[at];
		use_preset(demo);
	}
	show_message(demo, at >= 0 ? "as in the file" : "not in the file");
}

static void toggle_shake(struct demo *demo, int amount)
{
	(void)amount;
	demo->shaking = !demo->shaking;
	for (int i = 0; i < demo->bones.count; i++) {
		procedural_fade(
			&demo->swing[i], demo->shaking ? 0.0f : 1.0f, fade_s);
	}
}

static const struct demo_action tuner_actions[] = {
	DEMO_PRESS(UP, "choose the previous row: the bone or a parameter",
		step_row, -1),
	DEMO_PRESS(DOWN, "choose the next row", step_row, 1),
	DEMO_HOLD(LEFT,
		"decrease the parameter, or take the previous bone (hold)",
		change_value, -1),
	DEMO_HOLD(RIGHT, "increase the parameter, or take the next bone (hold)",
		change_value, 1),
	DEMO_PRESS(ENTER, "save the preset to its file", save, 1),
	DEMO_PRESS(F6, "choose the next preset", step_preset, 1),
	DEMO_PRESS(F8, "paint the shaken bones, or not", toggle_paint, 1),
	DEMO_PRESS(F9, "reload the preset from its file", read_again, 1),
	DEMO_PRESS(F10, "shake the bones, or hold them still", toggle_shake, 1),
	{0},
};

const struct demo_driver demo_driver_tuner = {
	.name = "tuner",
	.summary = "procedural: shaking bones whose parameters you change",
	.asset = "walker.glb",
	.any_model = true,
	.action = tuner_actions,
	.size = sizeof(struct demo),
	.prepare = tuner_prepare,
	.update = tuner_update,
	.period_s = tuner_period_s,
	.label = tuner_label,
	.get_motion = tuner_get_motion,
};
