/*
 * The face: morphing between key frames, AN4044 section 1.
 *
 * Each morph target of the model is a key frame: the base plus that target at
 * weight 1. Buttons change Destiny to another key frame, also during a morph.
 */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/face_keys.h"
#include "app/scene/instance/bend.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char mesh_node[] = "Face";
static const char motion_target[] = "surprise";
static const float default_ms = 600.0f;
static const float turn_rad = 0.2f, turn_rad_per_s = 0.8f; /* of the head */

/* The face's neck, in metres. */
static const struct bend_neck neck = {.low = 0.098f, .high = 0.15f};

/* What F8 chooses: no wave, or one that runs through the face. */
static const struct {
	const char *name;
	struct morph_wave wave;
} curves[] = {
	{"linear", {.amplitude = 0.0f}},
	{"sine across",
		{.direction = {0.0f, 0.0f, 1.0f},
			.axis = {1.0f, 0.0f, 0.0f},
			.amplitude = 0.026f,
			.delay = 1.5f}},
	{"sine up",
		{.direction = {1.0f, 0.0f, 0.0f},
			.axis = {0.0f, 1.0f, 0.0f},
			.amplitude = 0.02f,
			.delay = 1.5f}},
};
static const float graph_wave = 0.35f; /* its height in the graph */
static const double dwell_s = 1.5;     /* autoplay: time for an expression */

static const struct actor_framing framing = {.camera = {.yaw_rad = 0.3f,
						     .pitch_rad = 0.04f,
						     .margin = 1.04f,
						     .follow = true},
	.label_rows = 3,
	.label_bars = 1};

struct demo {
	struct demo_base base;
	int head; /* the head's node */
	struct face_keys keys;
	int current;  /* the key frame that Destiny is */
	int previous; /* the key frame before it */
	struct morph_motion motion;
	size_t curve; /* of curves */
	struct bend bend;
	double now_s;
	bool autoplay;
	double next_s;
	int motion_key;         /* the key frame that camera motion blends to */
	bool motion_controlled; /* camera motion controls the face now */
};

static int init_keys(struct demo *demo, const struct demo_env *env)
{
	const struct model *model = demo->base.actor.model;
	int error;

	demo->head = model_find_node(model, mesh_node);
	if (demo->head < 0 || model->node[demo->head].mesh < 0) {
		log_error(env->log,
			"%s: the model has no node named %s with a mesh",
			env->model_path, mesh_node);
		return -EINVAL;
	}
	error = face_keys_init(
		&demo->keys, demo->base.actor.instance, demo->head);
	if (!error) {
		error = bend_init(&demo->bend, demo->base.actor.instance,
			demo->head, &neck);
	}
	if (error) {
		log_error(env->log,
			"%s: there is not enough memory for the key frames",
			env->model_path);
	}
	return error;
}

/* The key frame of that target, else the last key frame. */
static int find_key(const struct demo *demo, const char *target)
{
	int key = 1;

	while (key + 1 < demo->keys.key_count &&
		strcmp(demo->keys.target_name[key - 1], target) != 0) {
		key++;
	}
	return key < demo->keys.key_count ? key : 0;
}

static int face_prepare(struct demo *demo, const struct demo_env *env)
{
	struct bounds bounds;
	int error = init_keys(demo, env);

	if (error) {
		return error;
	}
	demo->autoplay = env->unattended;
	demo->motion_key = find_key(demo, motion_target);
	demo->motion = morph_motion_default();
	demo->motion.duration_ms = default_ms;
	bend_update(&demo->bend, 0.0f, 0.0f);
	bounds = bounds_of_clip(demo->base.actor.instance, -1);
	bend_update(&demo->bend, 0.0f, 0.0f);
	return actor_init_stage(env, &bounds, &framing, &demo->base.stage);
}

static void go_to_key(struct demo *demo, int key)
{
	demo->previous = demo->current;
	demo->current = (key + demo->keys.key_count) % demo->keys.key_count;
	face_keys_go(&demo->keys, demo->current, &demo->motion,
		demo->now_s * 1000.0);
}

/* The head turns on the bust, and the wave runs through the face. */
static void bend_face(struct demo *demo)
{
	bend_update(&demo->bend,
		turn_rad * scalar_sin((float)demo->now_s * turn_rad_per_s),
		face_keys_omega(&demo->keys, demo->now_s * 1000.0));
}

/* When camera motion ceases to control the face, it morphs to its key. */
static void release_face(struct demo *demo)
{
	bool motion_controlled = live_controls_motion(&demo->base.live);

	if (demo->motion_controlled && !motion_controlled) {
		go_to_key(demo, demo->current);
		demo->next_s = demo->now_s + dwell_s;
	}
	demo->motion_controlled = motion_controlled;
}

static void face_update(struct demo *demo, double time_s)
{
	const struct live *live = &demo->base.live;

	demo->now_s = time_s;
	release_face(demo);
	if (demo->autoplay && !demo->motion_controlled &&
		time_s >= demo->next_s) {
		go_to_key(demo, demo->current + 1);
		demo->next_s += dwell_s;
	}
	if (live_controls_motion(live)) {
		face_keys_hold(&demo->keys, demo->current, demo->motion_key,
			live->smooth_level);
	} else {
		face_keys_update(&demo->keys, time_s * 1000.0);
	}
	pose_rest(&demo->base.actor.instance->pose, demo->base.actor.model);
	face_keys_apply(&demo->keys);
	instance_update(demo->base.actor.instance);
	bend_face(demo);
}

static void face_draw(struct demo *demo, int width, int height)
{
	actor_choose_lod(&demo->base.actor, &demo->base.stage.camera, height);
	actor_draw(&demo->base.actor, &demo->base.stage, demo->base.gl, width,
		height);
}

static double face_period_s(const struct demo *demo)
{
	return dwell_s * demo->keys.key_count;
}

static const char *key_name(const struct demo *demo, int key)
{
	return key ? demo->keys.target_name[key - 1] : "neutral";
}

static void face_label(const struct demo *demo, struct hud *hud)
{
	const struct morph_motion *motion = &demo->motion;
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, "Morphing");
	char pace[32];

	hud_group_text(&group, "from", key_name(demo, demo->previous));
	hud_group_weight(&group, key_name(demo, demo->current),
		face_keys_omega(&demo->keys, demo->now_s * 1000.0),
		hud_color_rose);
	if (motion->timing == MORPH_OVER_TIME) {
		snprintf(pace, sizeof(pace), "%.0f ms",
			(double)motion->duration_ms);
	} else {
		snprintf(pace, sizeof(pace), "%d frames", motion->frame_count);
	}
	hud_group_text(&group, curves[demo->curve].name, pace);
	hud_group_end(&group);
}

static void face_get_motion(const struct demo *demo, struct overlay_motion *out)
{
	out->morphing = true;
	out->node = demo->head;
	out->from = demo->previous - 1;
	out->to = demo->current - 1;
	out->omega = face_keys_omega(&demo->keys, demo->now_s * 1000.0);
	out->wave = demo->curve > 0 ? graph_wave : 0.0f;
}

static void press_next(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		go_to_key(demo, demo->current + 1);
	}
}

static void press_previous(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		go_to_key(demo, demo->current - 1);
	}
}

static void press_neutral(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = false;
		go_to_key(demo, 0);
	}
}

static void scale_duration(struct demo *demo, float factor)
{
	demo->motion.duration_ms = scalar_clamp(
		demo->motion.duration_ms * factor, 100.0f, 4800.0f);
	demo->motion.frame_count =
		(int)(demo->motion.duration_ms * 30.0f / 1000.0f);
}

static void press_faster(struct demo *demo, bool down)
{
	if (down) {
		scale_duration(demo, 0.5f);
	}
}

static void press_slower(struct demo *demo, bool down)
{
	if (down) {
		scale_duration(demo, 2.0f);
	}
}

static void press_timing(struct demo *demo, bool down)
{
	if (down) {
		demo->motion.timing = demo->motion.timing == MORPH_OVER_TIME
			? MORPH_BY_FRAMES
			: MORPH_OVER_TIME;
	}
}

static void press_curve(struct demo *demo, bool down)
{
	if (down) {
		demo->curve = (demo->curve + 1) % ARRAY_COUNT(curves);
		bend_set_wave(&demo->bend, &curves[demo->curve].wave);
	}
}

static void press_autoplay(struct demo *demo, bool down)
{
	if (down) {
		demo->autoplay = !demo->autoplay;
		demo->next_s = demo->now_s;
	}
}

static const struct demo_action face_actions[] = {
	{BUTTON_RIGHT, "show the next expression", press_next},
	{BUTTON_LEFT, "show the previous expression", press_previous},
	{BUTTON_ENTER, "show the neutral face", press_neutral},
	{BUTTON_UP, "morph twice as fast", press_faster},
	{BUTTON_DOWN, "morph half as fast", press_slower},
	{BUTTON_F6, "interpolate over time or by frames", press_timing},
	{BUTTON_F8, "interpolate linearly, with a wave across, or upwards",
		press_curve},
	{BUTTON_F9, "show all expressions in turn, or stop", press_autoplay},
	{0},
};

const struct demo_driver demo_driver_face = {
	.name = "face",
	.summary = "morphing: a head that changes its expression",
	.asset = "face.glb",
	.action = face_actions,
	.size = sizeof(struct demo),
	.prepare = face_prepare,
	.update = face_update,
	.draw = face_draw,
	.period_s = face_period_s,
	.label = face_label,
	.get_motion = face_get_motion,
};
