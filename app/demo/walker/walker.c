/*
 * The walker: skeletal animation, AN4044 section 3. Buttons change clips, which
 * fade into each other, and switch the procedural layers above them.
 */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/walker/walker_moves.h"
#include "app/demo/walker/walker_rig.h"
#include "app/scene/draw/draw.h"
#include "app/scene/shadow/shadow_drape.h"
#include "app/scene/stage/ball.h"
#include "app/scene/stage/light.h"

#include <errno.h>
#include <stdlib.h>

static const float turn_rad_per_s = 1.2f;
static const float shadow_strength = 0.375f;
static const float ball_radius_m = 0.05f;
static const float ball_color[3] = {0.95f, 0.35f, 0.2f};

/* What the walker does while nobody presses buttons. */
struct autoplay_step {
	float time_s;
	enum walker_move move;
	unsigned features; /* bits of enum walker_rig_feature */
};

#define ALIVE \
	(1 << RIG_HAIR | 1 << RIG_BREATH | 1 << RIG_SHADOW | 1 << RIG_BUMPS)

static const struct autoplay_step autoplay_steps[] = {
	{0.0f, MOVE_WALK, ALIVE},
	{2.2f, MOVE_WALK, ALIVE | 1 << RIG_LOOK},
	{4.2f, MOVE_WAVE, ALIVE | 1 << RIG_FACE},
	{6.8f, MOVE_RUN, ALIVE | 1 << RIG_CAPE},
	{9.6f, MOVE_JUMP, ALIVE | 1 << RIG_CAPE},
	{11.1f, MOVE_WALK,
		ALIVE | 1 << RIG_GROUND | 1 << RIG_LOOK | 1 << RIG_REACH},
	{15.5f, MOVE_IDLE, ALIVE | 1 << RIG_SHAKE},
};

static const float autoplay_s = 17.6f;

static const struct actor_framing framing = {.camera = {.yaw_rad = 0.45f,
						     .pitch_rad = 0.12f,
						     .margin = 1.08f,
						     .follow = true},
	.label_rows = 9,
	.label_bars = 8};

struct demo {
	struct demo_base base;
	int height; /* of the picture */
	struct ball ball;
	struct shadow_drape shadow;
	struct walker_rig rig;
	struct walker_moves moves;
	double now_s;
	float turn;
	int chosen; /* the feature that F8 switches */
	bool autoplay;
	size_t next_step;
	double autoplay_start_s;
};

/* The box of all clips. */
static struct bounds bounds_of_moves(struct demo *demo)
{
	struct bounds all = bounds_empty();

	for (int i = 0; i < MOVE_COUNT; i++) {
		struct bounds bounds = bounds_of_clip(
			demo->base.actor.instance, demo->moves.clip[i]);

		bounds_join(&all, &bounds);
	}
	/* A jump goes a few millimetres below the floor. */
	all.low[1] = 0.0f;
	return all;
}

static int walker_prepare(struct demo *demo, const struct demo_env *env)
{
	struct instance *instance = demo->base.actor.instance;
	enum walker_move gait = env->unattended ? MOVE_WALK : MOVE_IDLE;
	int error = walker_moves_init(&demo->moves, instance, gait, env->log);

	demo->autoplay = env->unattended;
	demo->height = env->height;
	ball_init(&demo->ball);
	if (!error) {
		error = walker_rig_init(&demo->rig, instance, env->log);
	}
	if (!error) {
		error = shadow_drape_init(&demo->shadow, instance, env->log);
	}
	if (!error) {
		struct bounds bounds = bounds_of_moves(demo);

		error = actor_init_stage(
			env, &bounds, &framing, &demo->base.stage);
	}
	return error;
}

static void run_autoplay(struct demo *demo)
{
	double elapsed_s = demo->now_s - demo->autoplay_start_s;

	if (elapsed_s >= (double)autoplay_s) {
		demo->autoplay_start_s += (double)autoplay_s;
		demo->next_step = 0;
		elapsed_s -= (double)autoplay_s;
	}
	while (demo->next_step < ARRAY_COUNT(autoplay_steps) &&
		elapsed_s >= (double)autoplay_steps[demo->next_step].time_s) {
		const struct autoplay_step *step =
			&autoplay_steps[demo->next_step++];

		if (step->move != demo->moves.move) {
			walker_moves_begin(&demo->moves, step->move);
		}
		for (int i = 0; i < RIG_FEATURE_COUNT; i++) {
			demo->rig.on[i] = step->features >> i & 1;
		}
	}
}

static void walker_update(struct demo *demo, double time_s)
{
	struct instance *instance = demo->base.actor.instance;
	float step_s = (float)(time_s - demo->now_s);
	const struct floor *floor = &demo->base.stage.floor;
	struct shadow_light light;

	demo->now_s = time_s;
	if (demo->autoplay) {
		run_autoplay(demo);
	}
	camera_orbit(&demo->base.stage.camera,
		demo->turn * turn_rad_per_s * step_s, 0.0f);
	walker_moves_update(&demo->moves, instance, step_s);
	floor_scroll(&demo->base.stage.floor, 0.0f,
		demo->moves.ground_m_per_s * step_s);
	walker_rig_apply(&demo->rig, instance,
		&(struct walker_rig_frame){.time_s = time_s,
			.step_s = step_s,
			.speed_m_per_s = demo->moves.ground_m_per_s,
			.floor = &demo->base.stage.floor});
	instance->normal_mapping = demo->rig.on[RIG_BUMPS];
	actor_update(&demo->base.actor, &demo->base.stage.camera, demo->height);
	if (floor->wave_height == 0.0f) {
		return;
	}
	light.ground = floor;
	light_direction(light.towards);
	camera_eye(&demo->base.stage.camera, light.eye);
	camera_near_plane(&demo->base.stage.camera, light.near_plane);
	shadow_drape_update(&demo->shadow, instance, &light);
}

static void draw_shadow(const struct demo *demo)
{
	const struct gl *gl = demo->base.gl;
	const struct actor *actor = &demo->base.actor;

	if (!demo->rig.on[RIG_SHADOW]) {
		stage_draw_monitor(&demo->base.stage, gl);
		return;
	}
	if (demo->base.stage.floor.wave_height != 0.0f &&
		demo->base.stage.has_stencil) {
		shadow_drape_draw(&demo->shadow, gl, shadow_strength);
		return;
	}
	stage_shadow_begin(&demo->base.stage, gl);
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADOW);
	if (demo->rig.weight[RIG_CAPE] > 0.5f) {
		walker_secondary_draw_cape(
			&demo->rig.secondary, gl, DRAW_SHADOW, 1.0f);
	}
	stage_shadow_end(&demo->base.stage, gl);
}

static bool shows_ball(const struct demo *demo)
{
	return demo->rig.on[RIG_LOOK] || demo->rig.on[RIG_REACH];
}

static void walker_draw(struct demo *demo, int width, int height)
{
	const struct gl *gl = demo->base.gl;
	const struct actor *actor = &demo->base.actor;

	demo->height = height;
	stage_begin(&demo->base.stage, gl, width, height);
	draw_shadow(demo);
	if (shows_ball(demo) && demo->rig.on[RIG_SHADOW]) {
		ball_draw_shadow(gl, demo->rig.ball, ball_radius_m,
			&demo->base.stage);
	}
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADED);
	if (demo->rig.weight[RIG_CAPE] > 0.0f) {
		walker_secondary_draw_cape(&demo->rig.secondary, gl,
			DRAW_SHADED, demo->rig.weight[RIG_CAPE]);
	}
	if (shows_ball(demo)) {
		ball_draw(&demo->ball, gl, demo->rig.ball, ball_radius_m,
			ball_color);
	}
}

static double walker_period_s(const struct demo *demo)
{
	(void)demo;
	return autoplay_s;
}

static const char *expression_name(const struct demo *demo)
{
	const struct model *model = demo->base.actor.model;
	const struct model_node *head = &model->node[demo->rig.face];

	return model->mesh[head->mesh].target_name[demo->rig.expression];
}

static void label_features(const struct demo *demo, struct hud_group *group)
{
	static const struct hud_color *const colors[] = {
		&hud_color_green,
		&hud_color_amber,
		&hud_color_violet,
		&hud_color_rose,
	};

	if (demo->rig.on[RIG_FACE] && demo->rig.face >= 0) {
		hud_group_text(group, "expression", expression_name(demo));
	}
	if (demo->rig.on[RIG_SHAKE]) {
		hud_group_text(group, "preset",
			demo->rig.presets.preset[demo->rig.preset_chosen].name);
	}
	for (int i = 0; i < RIG_FEATURE_COUNT; i++) {
		if (demo->rig.weight[i] > 0.0f && i < RIG_SHADOW) {
			hud_group_weight(group,
				walker_rig_feature_name(
					(enum walker_rig_feature)i),
				demo->rig.weight[i],
				*colors[(size_t)i % ARRAY_COUNT(colors)]);
		}
	}
}

static void walker_label(const struct demo *demo, struct hud *hud)
{
	const struct walker_moves *moves = &demo->moves;
	float time_s;
	const struct model_clip *clip =
		walker_moves_clip(moves, demo->base.actor.model, &time_s);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, "Skeletal");

	hud_group_time(
		&group, clip->name, time_s, clip->duration_s, hud_color_blue);
	if (moves->fade.running) {
		hud_group_weight(&group, "fade",
			moves->fade.elapsed_s / moves->fade.duration_s,
			hud_color_blue);
	}
	if (moves->wave_weight > 0.0f) {
		hud_group_weight(
			&group, "wave", moves->wave_weight, hud_color_blue);
	}
	actor_label_lod(&demo->base.actor, &group);
	label_features(demo, &group);
	hud_group_end(&group);
	if (!demo->autoplay) {
		group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
		hud_group_switch(&group, "F8",
			walker_rig_feature_name(
				(enum walker_rig_feature)demo->chosen),
			demo->rig.on[demo->chosen], hud_color_green);
		hud_group_end(&group);
	}
}

static void add_layer(struct overlay_motion *motion, const char *name,
	float weight, const float *mask)
{
	if (motion->layer_count < OVERLAY_LAYERS_MAX) {
		motion->layer[motion->layer_count++] =
			(struct overlay_layer){name, weight, mask};
	}
}

static void walker_get_motion(
	const struct demo *demo, struct overlay_motion *out)
{
	const struct walker_moves *moves = &demo->moves;
	const struct model_clip *clip =
		walker_moves_clip(moves, demo->base.actor.model, &out->time_s);

	out->clip = moves->clip[moves->move];
	add_layer(out, clip->name,
		moves->fade.running
			? moves->fade.elapsed_s / moves->fade.duration_s
			: 1.0f,
		NULL);
	add_layer(out, "wave (arm)", moves->wave_weight, moves->wave_mask);
	for (int i = 0; i < RIG_SHADOW; i++) {
		if (demo->rig.weight[i] > 0.0f) {
			add_layer(out,
				walker_rig_feature_name(
					(enum walker_rig_feature)i),
				demo->rig.weight[i], NULL);
		}
	}
}

static void press_faster(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		walker_moves_change_gait(&demo->moves, 1);
	}
}

static void press_slower(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		walker_moves_change_gait(&demo->moves, -1);
	}
}

static void press_wave(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		walker_moves_begin(&demo->moves, MOVE_WAVE);
	}
}

static void press_jump(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		walker_moves_begin(&demo->moves, MOVE_JUMP);
	}
}

static void press_turn(struct demo *demo, bool down)
{
	demo->turn = down ? 1.0f : 0.0f;
}

static void press_choose(struct demo *demo, bool down)
{
	if (down) {
		demo->chosen = (demo->chosen + 1) % RIG_FEATURE_COUNT;
	}
}

static void press_switch(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		demo->rig.on[demo->chosen] = !demo->rig.on[demo->chosen];
	}
}

static void press_preset(struct demo *demo, bool down)
{
	if (down) {
		walker_rig_next_preset(&demo->rig);
	}
}

static void press_autoplay(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = true;
		demo->next_step = 0;
		demo->autoplay_start_s = demo->now_s;
	}
}

static const struct demo_action walker_actions[] = {
	{BUTTON_UP, "go faster: idle, walk, run", press_faster},
	{BUTTON_DOWN, "go slower", press_slower},
	{BUTTON_LEFT, "wave", press_wave},
	{BUTTON_RIGHT, "jump", press_jump},
	{BUTTON_ENTER, "turn the camera (hold)", press_turn},
	{BUTTON_F6, "choose the next feature of the list", press_choose},
	{BUTTON_F8, "switch the chosen feature on or off", press_switch},
	{BUTTON_F9, "show all features in turn", press_autoplay},
	{BUTTON_F10, "choose the next shake preset", press_preset},
	{0},
};

const struct demo_driver demo_driver_walker = {
	.name = "walker",
	.summary = "skeletal: a figure that idles, walks, runs, waves, jumps",
	.asset = "walker.glb",
	.action = walker_actions,
	.size = sizeof(struct demo),
	.prepare = walker_prepare,
	.update = walker_update,
	.draw = walker_draw,
	.period_s = walker_period_s,
	.label = walker_label,
	.get_motion = walker_get_motion,
};
