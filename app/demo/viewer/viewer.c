/*
 * The viewer shows any model. A model with a character file behaves as the file
 * says (behaviour.h). For others UP and DOWN choose a clip, and other buttons
 * move the camera.
 */
#include "app/anim/playback.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/demo_overlay.h"
#include "app/demo/viewer/behaviour.h"
#include "app/demo/viewer/viewer_join.h"
#include "platform/base/file.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

static const float orbit_rad_per_s = 1.4f;
static const float zoom_per_s = 1.2f;
static const float fade_s = 0.25f;
static const double check_s = 1.0; /* between checks of the file */

static const struct actor_framing framing = {.camera = {.yaw_rad = 0.45f,
						     .pitch_rad = 0.16f,
						     .margin = 1.1f,
						     .follow = true},
	.label_rows = 2,
	.label_bars = 1};

/* Watches the model's file for changes, once a second. */
struct file_watch {
	struct demo_env env; /* to reload the model with */
	uint64_t shown;      /* the stamp of the file last loaded or tried */
	uint64_t last;       /* the stamp at the last check */
	double next_s;
	bool broken; /* the file as it is now cannot be loaded */
};

struct demo {
	struct demo_base base;
	struct behaviour *behaviour; /* NULL: what follows moves the model */
	int height;                  /* of the picture */
	int clip;                    /* or -1: at rest */
	struct playback playback;
	enum clip_repeat repeat;
	float speed;

	struct viewer_join join;
	double now_s;
	bool paused;
	struct file_watch watch;
	const char *title;      /* the model's technique */
	bool tilting;           /* UP and DOWN move the camera */
	float turn, tilt, zoom; /* while a button is held: -1, 0 or 1 */
};

static float viewer_duration_s(const struct demo *demo)
{
	return demo->clip < 0
		? 0.0f
		: demo->base.actor.model->clip[demo->clip].duration_s;
}

static void begin_clip(struct demo *demo)
{
	demo->playback = playback_begin(
		viewer_duration_s(demo), demo->repeat, demo->speed);
}

/* The stamps of all files that are shown. */
static uint64_t stamp_files(const struct demo *demo)
{
	uint64_t model = file_stamp(demo->watch.env.model_path);

	return model == 0
		? 0
		: model ^ behaviour_stamp(&demo->watch.env, demo->behaviour);
}

static int init_stage(struct demo *demo, struct stage *stage)
{
	struct actor *actor = &demo->base.actor;
	struct bounds bounds;

	if (demo->behaviour) {
		return behaviour_init_stage(
			demo->behaviour, &demo->watch.env, stage);
	}
	bounds = bounds_of_model(actor->instance, demo->clip);
	return actor_init_stage(&demo->watch.env, &bounds, &framing, stage);
}

static int viewer_prepare(struct demo *demo, const struct demo_env *env)
{
	struct actor *actor = &demo->base.actor;
	int error = model_choose_clip(actor->model, env->clip,
		actor->model->clip_count > 0 ? 0 : -1, env->log, &demo->clip);

	if (!error) {
		error = viewer_join_init(
			&demo->join, &demo->base.actor, env->log);
	}
	if (!error) {
		error = behaviour_create(env, actor, &demo->behaviour);
	}
	if (error) {
		return error;
	}
	demo->height = env->height;
	demo->watch.env = *env;
	demo->watch.shown = demo->watch.last = stamp_files(demo);
	demo->repeat = env->repeat;
	demo->speed = env->speed;
	demo->tilting = actor->model->clip_count < 2;
	demo->title = actor_technique(actor->instance);
	begin_clip(demo);
	return init_stage(demo, &demo->base.stage);
}

static void viewer_finish(struct demo *demo)
{
	behaviour_destroy(demo->behaviour);
}

/* The clip with the old clip's name, else with its index, else the first. */
static int same_clip(const struct model *old, const struct model *new, int clip)
{
	int found = clip < 0 ? -1 : model_find_clip(new, old->clip[clip].name);

	if (found >= 0 || new->clip_count == 0) {
		return found;
	}
	return clip >= 0 && clip < new->clip_count ? clip : 0;
}

/* The camera stays unless the model's size has changed by a quarter. */
static void reframe(struct demo *demo, float old_extent)
{
	struct stage *stage = &demo->base.stage;
	float ratio = demo->base.actor.extent / old_extent;
	struct stage fresh;

	if (ratio > 0.8f && ratio < 1.25f) {
		return;
	}
	if (init_stage(demo, &fresh) == 0) {
		stage_finish(stage, demo->base.gl);
		*stage = fresh;
	}
}

/* Replaces the model; if the new one cannot be loaded, the old one stays. */
static int reload(struct demo *demo)
{
	const struct demo_env *env = &demo->watch.env;
	struct actor old = demo->base.actor, fresh;
	const struct demo before = *demo;
	int error = actor_load(&fresh, env);

	if (error) {
		return error;
	}
	demo->base.actor = fresh;
	error = viewer_join_init(&demo->join, &demo->base.actor, env->log);
	if (!error) {
		behaviour_suspend(before.behaviour);
		error = behaviour_create(
			env, &demo->base.actor, &demo->behaviour);
	}
	if (error) {
		behaviour_resume(before.behaviour, env->log);
		actor_unload(&fresh, env->gl);
		*demo = before;
		return error;
	}
	demo->clip = same_clip(old.model, fresh.model, demo->clip);
	demo->title = actor_technique(fresh.instance);
	demo->tilting = demo->tilting || fresh.model->clip_count < 2;
	demo->join.running = false;
	begin_clip(demo);
	playback_seek(&demo->playback, before.playback.time_s);
	reframe(demo, old.extent);
	demo_overlay_release(&demo->base);
	behaviour_destroy(before.behaviour);
	actor_unload(&old, env->gl);
	return 0;
}

/* The stamp of a file that is still being written changes until the next check. */
static void check_file(struct demo *demo)
{
	struct file_watch *watch = &demo->watch;
	uint64_t stamp;
	bool settled;

	if (!watch->env.follow_file || demo->now_s < watch->next_s) {
		return;
	}
	watch->next_s = demo->now_s + check_s;
	stamp = stamp_files(demo);
	settled = stamp == watch->last;
	watch->last = stamp;
	if (stamp != 0 && settled && stamp != watch->shown) {
		watch->shown = stamp;
		watch->broken = reload(demo) != 0;
	}
}

static void viewer_update(struct demo *demo, double time_s)
{
	double exact_s = time_s - demo->now_s;
	float step_s = (float)exact_s;

	demo->now_s = time_s;
	check_file(demo);
	if (demo->behaviour) {
		behaviour_update(
			demo->behaviour, &demo->base, time_s, demo->height);
		return;
	}
	if (!demo->paused) {
		playback_advance(&demo->playback, exact_s, NULL, 0, NULL, 0);
	}
	camera_orbit(&demo->base.stage.camera,
		demo->turn * orbit_rad_per_s * step_s,
		demo->tilt * orbit_rad_per_s * step_s);
	camera_zoom(&demo->base.stage.camera,
		1.0f + demo->zoom * zoom_per_s * step_s);
	if (demo->join.running) {
		viewer_join_run(&demo->join, &demo->base.actor, &demo->clip,
			demo->paused ? 0.0f : step_s);
	} else {
		actor_pose(&demo->base.actor, demo->clip,
			(float)demo->playback.time_s);
		fade_update(&demo->base.actor.fade, step_s,
			&demo->base.actor.instance->pose);
	}
	actor_update(&demo->base.actor, &demo->base.stage.camera, demo->height);
}

static void viewer_draw(struct demo *demo, int width, int height)
{
	demo->height = height;
	if (demo->behaviour) {
		behaviour_draw(demo->behaviour, &demo->base, width, height);
		return;
	}
	actor_draw(&demo->base.actor, &demo->base.stage, demo->base.gl, width,
		height);
}

static double viewer_period_s(const struct demo *demo)
{
	float duration_s = viewer_duration_s(demo);

	if (demo->behaviour) {
		return behaviour_period_s(demo->behaviour);
	}
	return duration_s > 0.0f ? duration_s : 1.0;
}

static void label_broken(const struct demo *demo, struct hud *hud)
{
	struct hud_group group;

	if (demo->watch.broken) {
		group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
		hud_group_mark(&group, "new file is broken", "", hud_color_rose);
		hud_group_end(&group);
	}
}

static void viewer_label(const struct demo *demo, struct hud *hud)
{
	const struct model *model = demo->base.actor.model;
	float duration_s = viewer_duration_s(demo);
	struct hud_group group;

	if (demo->behaviour) {
		behaviour_label(demo->behaviour, &demo->base, hud);
		label_broken(demo, hud);
		return;
	}
	group = hud_group_begin(hud, HUD_TOP_LEFT, demo->title);
	if (demo->clip < 0) {
		hud_group_text(&group, "at rest", "");
	} else {
		const char *name = model->clip[demo->clip].name;
		char number[32];

		snprintf(number, sizeof(number), "clip %d", demo->clip);
		hud_group_time(&group, name[0] ? name : number,
			(float)(demo->join.running ? demo->join.time_s
						   : demo->playback.time_s),
			duration_s, hud_color_blue);
	}
	if (demo->join.running) {
		hud_group_text(&group, "joined to", demo->join.clips.to->name);
	}
	actor_label_lod(&demo->base.actor, &group);
	if (demo->paused) {
		hud_group_text(&group, "paused", "");
	}
	if (demo->watch.broken) {
		hud_group_mark(&group, "new file is broken", "", hud_color_rose);
	}
	hud_group_end(&group);
}

static void viewer_get_motion(
	const struct demo *demo, struct overlay_motion *out)
{
	if (demo->behaviour) {
		behaviour_get_motion(
			demo->behaviour, demo->base.actor.model, out);
		return;
	}
	out->clip = demo->clip;
	out->time_s = (float)(demo->join.running ? demo->join.time_s
						 : demo->playback.time_s);
	if (demo->base.actor.fade.running) {
		out->layer[0].name = "fade";
		out->layer[0].weight = demo->base.actor.fade.elapsed_s /
			demo->base.actor.fade.duration_s;
		out->layer_count = 1;
	}
}

static void step_clip(struct demo *demo, int step)
{
	int count = demo->base.actor.model->clip_count;

	if (count > 0) {
		fade_begin(&demo->base.actor.fade,
			&demo->base.actor.instance->pose, fade_s, EASE_CUBIC);
		demo->clip = (demo->clip + step + count) % count;
		demo->join.running = false;
		begin_clip(demo);
	}
}

static void press_up(struct demo *demo, bool down)
{
	if (demo->tilting) {
		demo->tilt = down ? 1.0f : 0.0f;
	} else if (down) {
		step_clip(demo, -1);
	}
}

static void press_down(struct demo *demo, bool down)
{
	if (demo->tilting) {
		demo->tilt = down ? -1.0f : 0.0f;
	} else if (down) {
		step_clip(demo, 1);
	}
}

static void press_left(struct demo *demo, bool down)
{
	demo->turn = down ? -1.0f : 0.0f;
}

static void press_right(struct demo *demo, bool down)
{
	demo->turn = down ? 1.0f : 0.0f;
}

static void press_pause(struct demo *demo, bool down)
{
	if (down) {
		demo->paused = !demo->paused;
	}
}

static void press_closer(struct demo *demo, bool down)
{
	demo->zoom = down ? -1.0f : 0.0f;
}

static void press_farther(struct demo *demo, bool down)
{
	demo->zoom = down ? 1.0f : 0.0f;
}

static void press_tilting(struct demo *demo, bool down)
{
	if (down) {
		demo->tilting = !demo->tilting;
		demo->tilt = 0.0f;
	}
}

static void press_join(struct demo *demo, bool down)
{
	if (down && demo->base.actor.model->clip_count > 1) {
		demo->join.running = !demo->join.running;
		begin_clip(demo);
		viewer_join_begin(
			&demo->join, &demo->base.actor, demo->clip, 0.0);
	}
}

static bool viewer_press(struct demo *demo, const struct button_event *event)
{
	if (demo->behaviour) {
		behaviour_press(demo->behaviour, event);
	}
	return demo->behaviour;
}

static bool viewer_print_buttons(const struct demo *demo, FILE *out)
{
	if (demo->behaviour) {
		behaviour_print_buttons(demo->behaviour, out);
	}
	return demo->behaviour;
}

static const struct demo_action viewer_actions[] = {
	{BUTTON_UP, "play the previous clip (or tilt up)", press_up},
	{BUTTON_DOWN, "play the next clip (or tilt down)", press_down},
	{BUTTON_LEFT, "turn the camera left", press_left},
	{BUTTON_RIGHT, "turn the camera right", press_right},
	{BUTTON_ENTER, "pause or continue", press_pause},
	{BUTTON_F6, "move the camera closer", press_closer},
	{BUTTON_F8, "move the camera away", press_farther},
	{BUTTON_F9, "let UP and DOWN choose clips or tilt", press_tilting},
	{BUTTON_F10, "play all clips in a row, or stop", press_join},
	{0},
};

/* The members that are the same for a model and for demos that are data. */
#define VIEWER_FUNCTIONS                                              \
	.action = viewer_actions, .size = sizeof(struct demo),        \
	.prepare = viewer_prepare, .finish = viewer_finish,           \
	.press = viewer_press, .print_buttons = viewer_print_buttons, \
	.update = viewer_update, .draw = viewer_draw,                 \
	.period_s = viewer_period_s, .label = viewer_label,           \
	.get_motion = viewer_get_motion

const struct demo_driver demo_driver_viewer = {
	.name = "viewer",
	.summary = "any model and its clips",
	VIEWER_FUNCTIONS,
};

/* assets/walker.character says what it does. */
const struct demo_driver demo_driver_walker = {
	.name = "walker",
	.summary = "skeletal: a figure that idles, walks, runs, waves, jumps",
	.asset = "walker.glb",
	VIEWER_FUNCTIONS,
};

/* assets/face.character says what it does. */
const struct demo_driver demo_driver_face = {
	.name = "face",
	.summary = "morphing: a head that changes its expression",
	.asset = "face.glb",
	VIEWER_FUNCTIONS,
};

/* assets/arm.character says what it does. */
const struct demo_driver demo_driver_arm = {
	.name = "arm",
	.summary = "hierarchical: a robot arm on pivots that loads a truck",
	.asset = "arm.glb",
	VIEWER_FUNCTIONS,
};
