/*
 * The face: morphing between key frames, AN4044 section 1.
 *
 * Each shape key of the model is a key frame: the base plus that target at
 * weight 1. Buttons point Destiny at another one, also in mid-flight.
 */
#include "app/anim/morph.h"
#include "app/anim/transform.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	PARTS_MAX = 8
};

static const char mesh_node[] = "Face";
static const char startled_target[] = "surprise";
static const float unhurried_ms = 600.0f;
static const float forward[3] = {0.0f, 0.0f, 1.0f};
static const float bulge_m = 0.03f; /* of sinusoidal motion */
static const double dwell_s = 1.5;  /* from one expression to the next */

/* One primitive of the face and its key frames; key 0 is the base. */
struct part {
	struct drawable *drawable;
	struct morph morph;
	struct morph_key *key;
};

static const struct framing framing = {
	.yaw_rad = 0.3f, .pitch_rad = 0.04f, .turn_rad = 0.0f, .margin = 1.06f};

struct demo {
	struct act act;
	int head; /* node */
	int part_count;
	struct part part[PARTS_MAX];
	int key_count;
	const char **target_name;
	int current;  /* the key frame that Destiny is */
	int previous; /* the one before it */
	struct morph_motion motion;
	double now_s;
	bool touring;
	double next_s;
	int startled; /* the key frame that motion leads to */
	bool stirred; /* motion holds the face now */
};

/* Source and destiny of the morph: the base with one target at weight 1. */
static int bake_key(struct demo *demo, const struct part *part, int target,
	struct morph_key *out)
{
	const struct drawable *drawable = part->drawable;
	const struct model_primitive *primitive = drawable->primitive;
	const struct kernel *kernel = demo->act.actor.instance->kernel;
	struct arena *arena = &demo->act.actor.instance->arena;
	int count = primitive->vertex_count;
	struct morph_term term = {
		.weight = drawable->vertex_scale,
		.position =
			(const float(*)[3])primitive->target[target].position,
		.normal = (const float(*)[3])primitive->target[target].normal,
	};
	float(*position)[3] =
		arena_alloc(arena, (size_t)count, sizeof(*position));
	float(*normal)[3] = arena_alloc(arena, (size_t)count, sizeof(*normal));

	if (!position || !normal) {
		return -ENOMEM;
	}
	kernel->morph_targets(
		count, drawable->base_position, &term, 1, false, position);
	out->position = (const float(*)[3])position;
	if (!drawable->base_normal) {
		return 0;
	}
	term.weight = 1.0f;
	kernel->morph_targets(
		count, drawable->base_normal, &term, 1, true, normal);
	kernel->normalize(count, normal);
	out->normal = (const float(*)[3])normal;
	return 0;
}

static int init_part(
	struct demo *demo, struct part *part, struct drawable *drawable)
{
	struct arena *arena = &demo->act.actor.instance->arena;
	int error;

	part->drawable = drawable;
	part->key =
		ARENA_ARRAY(arena, struct morph_key, (size_t)demo->key_count);
	if (!part->key) {
		return -ENOMEM;
	}
	part->key[0] = (struct morph_key){
		.position = drawable->base_position,
		.normal = drawable->base_normal,
	};
	for (int k = 1; k < demo->key_count; k++) {
		error = bake_key(demo, part, k - 1, &part->key[k]);
		if (error) {
			return error;
		}
	}
	error = morph_init(&part->morph, drawable->primitive->vertex_count,
		part->key[0], arena);
	if (!error) {
		drawable_set_shape(drawable, part->morph.temporal,
			part->morph.temporal_normal);
	}
	return error;
}

static int init_parts(struct demo *demo, const struct demo_env *env)
{
	const struct model *model = demo->act.actor.model;
	struct instance *instance = demo->act.actor.instance;
	const struct model_mesh *mesh;

	demo->head = model_find_node(model, mesh_node);
	if (demo->head < 0 || model->node[demo->head].mesh < 0) {
		log_error(env->log, "%s: has no mesh node %s", env->model_path,
			mesh_node);
		return -EINVAL;
	}
	mesh = &model->mesh[model->node[demo->head].mesh];
	demo->key_count = mesh->target_count + 1;
	demo->target_name = mesh->target_name;
	for (int i = 0; i < instance->drawable_count; i++) {
		int error;

		if (instance->drawable[i].node != demo->head ||
			demo->part_count == PARTS_MAX) {
			continue;
		}
		error = init_part(demo, &demo->part[demo->part_count++],
			&instance->drawable[i]);
		if (error) {
			log_error(env->log,
				"%s: not enough memory for its key "
				"frames",
				env->model_path);
			return error;
		}
	}
	return 0;
}

/* The key frame of that target, or the last one there is. */
static int find_key(const struct demo *demo, const char *target)
{
	int key = 1;

	while (key + 1 < demo->key_count &&
		strcmp(demo->target_name[key - 1], target) != 0) {
		key++;
	}
	return key < demo->key_count ? key : 0;
}

static int face_prepare(struct demo *demo, const struct demo_env *env)
{
	struct bounds bounds;
	int error = init_parts(demo, env);

	if (error) {
		return error;
	}
	demo->touring = env->unattended;
	demo->startled = find_key(demo, startled_target);
	demo->motion = morph_motion_default();
	demo->motion.duration_ms = unhurried_ms;
	memcpy(demo->motion.direction, forward, sizeof(forward));
	demo->motion.amplitude = bulge_m;
	bounds = bounds_of_clip(demo->act.actor.instance, -1);
	return set_stage(env, &bounds, framing, &demo->act.stage);
}

static void go_to_key(struct demo *demo, int key)
{
	demo->previous = demo->current;
	demo->current = (key + demo->key_count) % demo->key_count;
	for (int i = 0; i < demo->part_count; i++) {
		morph_trigger(&demo->part[i].morph,
			demo->part[i].key[demo->current], &demo->motion,
			demo->now_s * 1000.0);
	}
}

/* The head is never quite still. */
static void sway(struct demo *demo)
{
	static const float up[3] = {0.0f, 1.0f, 0.0f};
	struct transform *local =
		&demo->act.actor.instance->pose.local[demo->head];
	float turn[4];

	pose_rest(&demo->act.actor.instance->pose, demo->act.actor.model);
	quat_from_axis_angle(
		up, 0.10f * scalar_sin((float)demo->now_s * 0.8f), turn);
	quat_multiply(turn, local->rotation, local->rotation);
}

/* Once, when the camera lets go of the face: from where it is to its key. */
static void let_go(struct demo *demo)
{
	bool stirred = live_moves(&demo->act.live);

	if (demo->stirred && !stirred) {
		go_to_key(demo, demo->current);
		demo->next_s = demo->now_s + dwell_s;
	}
	demo->stirred = stirred;
}

static void face_update(struct demo *demo, double time_s)
{
	const struct live *live = &demo->act.live;

	demo->now_s = time_s;
	let_go(demo);
	if (demo->touring && !demo->stirred && time_s >= demo->next_s) {
		go_to_key(demo, demo->current + 1);
		demo->next_s += dwell_s;
	}
	for (int i = 0; i < demo->part_count; i++) {
		struct part *part = &demo->part[i];

		if (live_moves(live)) {
			morph_hold(&part->morph, part->key[demo->current],
				part->key[demo->startled], live->motion);
		} else {
			morph_update(&part->morph, time_s * 1000.0);
		}
	}
	sway(demo);
	instance_update(demo->act.actor.instance);
}

static void face_draw(struct demo *demo, int width, int height)
{
	actor_draw(&demo->act.actor, &demo->act.stage, demo->act.gl, width,
		height);
}

static double face_period_s(const struct demo *demo)
{
	return dwell_s * demo->key_count;
}

static const char *key_name(const struct demo *demo, int key)
{
	return key ? demo->target_name[key - 1] : "neutral";
}

static void face_label(const struct demo *demo, struct hud *hud)
{
	const struct morph_motion *motion = &demo->motion;
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, "Morphing");
	char pace[32];

	hud_group_text(&group, "from", key_name(demo, demo->previous));
	hud_group_weight(&group, key_name(demo, demo->current),
		morph_omega(&demo->part[0].morph, demo->now_s * 1000.0),
		hud_color_rose);
	if (motion->timing == MORPH_OVER_TIME) {
		snprintf(pace, sizeof(pace), "%.0f ms",
			(double)motion->duration_ms);
	} else {
		snprintf(pace, sizeof(pace), "%d frames", motion->frame_count);
	}
	hud_group_text(&group,
		motion->curve == MORPH_LINEAR ? "linear" : "sinusoidal", pace);
	hud_group_end(&group);
}

static void press_next(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
		go_to_key(demo, demo->current + 1);
	}
}

static void press_previous(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
		go_to_key(demo, demo->current - 1);
	}
}

static void press_neutral(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = false;
		go_to_key(demo, 0);
	}
}

static void set_pace(struct demo *demo, float factor)
{
	demo->motion.duration_ms = scalar_clamp(
		demo->motion.duration_ms * factor, 100.0f, 4800.0f);
	demo->motion.frame_count =
		(int)(demo->motion.duration_ms * 30.0f / 1000.0f);
}

static void press_faster(struct demo *demo, bool down)
{
	if (down) {
		set_pace(demo, 0.5f);
	}
}

static void press_slower(struct demo *demo, bool down)
{
	if (down) {
		set_pace(demo, 2.0f);
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
		demo->motion.curve = demo->motion.curve == MORPH_LINEAR
			? MORPH_SINUSOIDAL
			: MORPH_LINEAR;
	}
}

static void press_tour(struct demo *demo, bool down)
{
	if (down) {
		demo->touring = !demo->touring;
		demo->next_s = demo->now_s;
	}
}

static const struct demo_action face_actions[] = {
	{BUTTON_RIGHT, "the next expression", press_next},
	{BUTTON_LEFT, "the one before", press_previous},
	{BUTTON_ENTER, "back to neutral", press_neutral},
	{BUTTON_UP, "twice as fast", press_faster},
	{BUTTON_DOWN, "half as fast", press_slower},
	{BUTTON_F6, "interpolate over time or by frames", press_timing},
	{BUTTON_F8, "linear or sinusoidal", press_curve},
	{BUTTON_F9, "run through all of them", press_tour},
	{0},
};

const struct demo_driver demo_driver_face = {
	.name = "face",
	.summary = "morphing: a head that goes from expression to expression",
	.asset = "face.glb",
	.action = face_actions,
	.size = sizeof(struct demo),
	.prepare = face_prepare,
	.update = face_update,
	.draw = face_draw,
	.period_s = face_period_s,
	.label = face_label,
};
