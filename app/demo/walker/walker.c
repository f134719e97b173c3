/*
 * The walker: skeletal animation, AN4044 section 3. Buttons switch clips, each
 * fading into the next, and what is put on top of them.
 */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/walker/walker_moves.h"
#include "app/demo/walker/walker_rig.h"
#include "app/scene/draw/draw.h"
#include "app/scene/shadow/shadow_volume.h"
#include "app/scene/stage/ball.h"
#include "app/scene/stage/light.h"

#include <errno.h>
#include <stdlib.h>

static const float turn_rad_per_s = 1.2f;
static const float shadow_strength = 0.375f;
static const float ball_radius_m = 0.05f;
static const float ball_color[3] = {0.95f, 0.35f, 0.2f};

/* What happens by itself when nobody presses buttons. */
struct tour_stop {
	float time_s;
	enum move move;
	unsigned features; /* bits of enum rig_feature */
};

#define ALIVE \
	(1 << RIG_HAIR | 1 << RIG_BREATH | 1 << RIG_SHADOW | 1 << RIG_BUMPS)

static const struct tour_stop tour[] = {
	{0.0f, MOVE_WALK, ALIVE},
	{2.2f, MOVE_WALK, ALIVE | 1 << RIG_LOOK},
	{4.2f, MOVE_WAVE, ALIVE | 1 << RIG_FACE},
	{6.8f, MOVE_RUN, ALIVE | 1 << RIG_CAPE},
	{9.6f, MOVE_JUMP, ALIVE | 1 << RIG_CAPE},
	{11.1f, MOVE_WALK,
		ALIVE | 1 << RIG_GROUND | 1 << RIG_LOOK | 1 << RIG_REACH},
	{15.5f, MOVE_IDLE, ALIVE | 1 << RIG_SHAKE},
};

static const float tour_s = 17.6f;

static const struct framing framing = {.yaw_rad = 0.45f,
	.pitch_rad = 0.12f,
	.turn_rad = 0.3f,
	.margin = 1.02f,
	.aside = 0.16f};

struct demo {
	struct act act;
	int height; /* of the picture */
	struct ball ball;
	struct shadow_volume shadow;
	struct walker_rig rig;
	struct walker_moves moves;
	double now_s;
	float turn;
	int chosen; /* the feature that F8 switches */
	bool touring;
	size_t stop;
	double tour_start_s;
};

/* Room for everything that it does. */
static struct bounds bounds_of_moves(struct demo *demo)
{
	struct bounds all = bounds_empty();

	for (int i = 0; i < MOVE_COUNT; i++) {
		struct bounds bounds = bounds_of_clip(
			demo->act.actor.instance, demo->moves.clip[i]);

		bounds_join(&all, &bounds);
	}
	/* A jump goes below the floor's level for a few millimetres. */
	all.low[1] = 0.0f;
	return all;
}

static int walker_prepare(struct demo *demo, const struct demo_env *env)
{
	struct instance *instance = demo->act.actor.instance;
	enum move gait = env->unattended ? MOVE_WALK : MOVE_IDLE;
	int error = walker_moves_init(&demo->moves, instance, gait, env->log);

	demo->touring = env->unattended;
	demo->height = env->height;
	ball_init(&demo->ball);
	if (!error) {
		error = walker_rig_init(&demo->rig, instance, env->log);
	}
	if (!error) {
		error = shadow_volume_init(&demo->shadow, instance, env->log);
	}
	if (!error) {
		struct bounds bounds = bounds_of_moves(demo);

		error = set_stage(env, &bounds, framing, &demo->act.stage);
	}
	return error;
}

static void go_on_tour(struct demo *demo)
{
	double tour_time_s = demo->now_s - demo->tour_start_s;

	if (tour_time_s >= (double)tour_s) {
		demo->tour_start_s += (double)tour_s;
		demo->stop = 0;
		tour_time_s -= (double)tour_s;
	}
	while (demo->stop < ARRAY_COUNT(tour) &&
		tour_time_s >= (double)tour[demo->stop].time_s) {
		const struct tour_stop *stop = &tour[demo->stop++];

		if (stop->move != demo->moves.move) {
			walker_moves_begin(&demo->moves, stop->move);
		}
		for (int i = 0; i < RIG_FEATURE_COUNT; i++) {
			demo->rig.on[i] = stop->features >> i & 1;
		}
	}
}

static void walker_update(struct demo *demo, double time_s)
{
	struct instance *instance = demo->act.actor.instance;
	float step_s = (float)(time_s - demo->now_s);
	const struct floor *floor = &demo->act.stage.floor;
	struct shadow_light light;

	demo->now_s = time_s;
	if (demo->touring) {
		go_on_tour(demo);
	}
	camera_orbit(&demo->act.stage.camera,
		demo->turn * turn_rad_per_s * step_s, 0.0f);
	walker_moves_update(&demo->moves, instance, step_s);
	floor_run(&demo->act.stage.floor, 0.0f,
		demo->moves.ground_m_per_s * step_s);
	walker_rig_apply(&demo->rig, instance,
		&(struct rig_frame){.time_s = time_s,
			.step_s = step_s,
			.speed_m_per_s = demo->moves.ground_m_per_s,
			.floor = &demo->act.stage.floor});
	instance->relief = demo->rig.on[RIG_BUMPS];
	actor_update(&demo->act.actor, &demo->act.stage.camera, demo->height);
	if (floor->relief == 0.0f) {
		return;
	}
	light.reach = 2.0f * demo->act.stage.camera.reach;
	light.ground = floor;
	light_direction(light.towards);
	camera_near_plane(&demo->act.stage.camera, light.near_plane);
	shadow_volume_update(&demo->shadow, instance, &light);
}

static void draw_shadow(const struct demo *demo)
{
	const struct gl *gl = demo->act.gl;
	const struct actor *actor = &demo->act.actor;

	if (!demo->rig.on[RIG_SHADOW]) {
		stage_stand(&demo->act.stage, gl);
		return;
	}
	if (demo->act.stage.floor.relief != 0.0f && demo->act.stage.has_stencil) {
		shadow_volume_draw(&demo->shadow, gl, shadow_strength);
		return;
	}
	stage_shadow_begin(&demo->act.stage, gl);
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHAPE);
	if (demo->rig.on[RIG_CAPE]) {
		walker_trail_draw_cape(&demo->rig.trail, gl, DRAW_SHAPE);
	}
	stage_shadow_end(&demo->act.stage, gl);
}

static void walker_draw(struct demo *demo, int width, int height)
{
	const struct gl *gl = demo->act.gl;
	const struct actor *actor = &demo->act.actor;

	demo->height = height;
	stage_begin(&demo->act.stage, gl, width, height);
	draw_shadow(demo);
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADED);
	if (demo->rig.on[RIG_CAPE]) {
		walker_trail_draw_cape(&demo->rig.trail, gl, DRAW_SHADED);
	}
	if (demo->rig.on[RIG_LOOK] || demo->rig.on[RIG_REACH]) {
		ball_draw(&demo->ball, gl, demo->rig.ball, ball_radius_m,
			ball_color);
	}
}

static double walker_period_s(const struct demo *demo)
{
	(void)demo;
	return tour_s;
}

static const char *expression_name(const struct demo *demo)
{
	const struct model *model = demo->act.actor.model;
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
				rig_feature_name((enum rig_feature)i),
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
		walker_moves_clip(moves, demo->act.actor.model, &time_s);
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
	actor_label_lod(&demo->act.actor, &group);
	label_features(demo, &group);
	hud_group_end(&group);
	if (!demo->touring) {
		group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
		hud_group_switch(&group, "F8",
			rig_feature_name((enum rig_feature)demo->chosen),
			demo->rig.on[demo->chosen], hud_color_green);
		hud_group_end(&group);
	}
}

static void press_faster(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
		walker_moves_change_gait(&demo->moves, 1);
	}
}

static void press_slower(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
		walker_moves_change_gait(&demo->moves, -1);
	}
}

static void press_wave(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
		walker_moves_begin(&demo->moves, MOVE_WAVE);
	}
}

static void press_jump(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
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
		demo->touring = false;
		demo->rig.on[demo->chosen] = !demo->rig.on[demo->chosen];
	}
}

static void press_preset(struct demo *demo, bool down)
{
	if (down) {
		walker_rig_next_preset(&demo->rig);
	}
}

static void press_tour(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = true;
		demo->stop = 0;
		demo->tour_start_s = demo->now_s;
	}
}

static const struct demo_action walker_actions[] = {
	{BUTTON_UP, "faster: idle, walk, run", press_faster},
	{BUTTON_DOWN, "slower", press_slower},
	{BUTTON_LEFT, "wave", press_wave},
	{BUTTON_RIGHT, "jump", press_jump},
	{BUTTON_ENTER, "go round (hold)", press_turn},
	{BUTTON_F6, "choose the next feature of the list", press_choose},
	{BUTTON_F8, "switch the chosen feature", press_switch},
	{BUTTON_F9, "show all of it in turn", press_tour},
	{BUTTON_F10, "shake by the next preset", press_preset},
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
};
