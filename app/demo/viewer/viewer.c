/*
 * The viewer shows any model, which behaves as its character file says or as
 * `limber character` would write it (app/character).
 */
#include "app/character/character_open.h"
#include "app/character/run/feet.h"
#include "app/character/run/outputs.h"
#include "app/character/show/character_draw.h"
#include "app/character/show/character_label.h"
#include "app/character/show/character_overlay.h"
#include "app/character/state/entry.h"
#include "app/character/state/machine.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/demo_overlay.h"
#include "platform/base/file.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>

static const double check_s = 1.0;    /* between checks of the file */
static const float ease_per_s = 5.0f; /* of the camera's easing */

/* Watches the model's file for changes, once a second. */
struct file_watch {
	struct demo_env env; /* for reloading the model */
	uint64_t shown;      /* the stamp of the file last loaded or tried */
	uint64_t last;       /* the stamp at the last check */
	double next_s;
	bool broken; /* the current file cannot be loaded */
};

/* A loaded model's behaviour. */
struct figure {
	struct character *character;
	struct character_drawing drawing;
	struct character_outputs outputs;
	const struct floor *floor; /* the stage's, from the first update on */
	bool framed; /* the camera has been set by the first update */
};

struct demo {
	struct demo_base base;
	struct figure *figure;
	double now_s;
	struct file_watch watch;
};

/* The height of the ground under a character, in metres; user is the figure. */
static float ground_height(void *user, float x, float z)
{
	const struct figure *figure = user;
	const struct floor *floor = figure->floor;
	float scale = figure->character->instance->unit_scale;

	return floor
		? (floor_height(floor, x * scale, z * scale) - floor->y) / scale
		: 0.0f;
}

static void destroy_figure(struct figure *figure)
{
	if (figure) {
		character_outputs_close(&figure->outputs);
		character_destroy(figure->character);
		free(figure);
	}
}

static int create_figure(
	const struct demo_env *env, struct actor *actor, struct figure **out)
{
	const struct character_request request = demo_env_request(env);
	struct figure *figure = calloc(1, sizeof(*figure));
	struct character *character;
	int error;

	if (!figure) {
		log_error(env->log, "%s: there is not enough memory",
			env->model_path);
		return -ENOMEM;
	}
	error = character_open(&request, actor->instance, env->log, &character);
	figure->character = character;
	if (!error) {
		error = character_draw_init(
			&figure->drawing, character, &actor->ground, env->log);
	}
	if (error) {
		destroy_figure(figure);
		return error;
	}
	character_outputs_open(&figure->outputs, character, env->log);
	character->ground_height = ground_height;
	character->ground_user = figure;
	character->interpolation = env->interpolation;
	character->touring = env->unattended;
	character->tour_next = character->scene.tour;
	*out = figure;
	return 0;
}

/* How the character file wants the figure and its labels in the picture. */
static struct framing framing_of(const struct figure *figure)
{
	const struct character_scene *scene = &figure->character->scene;
	const struct bounds *rest = &figure->drawing.bounds.rest;
	float pitch = scene->pitch_rad < 0 ? camera_pitch_for(rest)
					   : scene->pitch_rad;
	struct framing framing = {.camera = {.yaw_rad = scene->yaw_rad,
					  .pitch_rad = pitch,
					  .margin = scene->margin,
					  .follow = true},
		.labels_right = scene->labels == CHARACTER_LABELS_RIGHT};

	framing.label_rows =
		character_label_count(figure->character, &framing.label_bars);
	return framing;
}

static float ground_of(const struct figure *figure)
{
	return character_bounds_ground(&figure->drawing.bounds,
		figure->character->instance->model->clip_count);
}

/* Makes the stage that the character file describes. */
static int init_stage(const struct figure *figure, struct demo_base *base,
	const struct demo_env *env, struct stage *stage)
{
	struct framing framing = framing_of(figure);
	struct bounds box = figure->drawing.bounds.all;
	int error;

	box.low[1] = ground_of(figure);
	error = actor_init_stage(base, env, &box,
		base->actor.instance->unit_scale, &framing, stage);
	if (!error) {
		camera_zoom(&stage->camera, figure->character->scene.zoom);
	}
	return error;
}

/* One stamp of the model's file and the character's files; 0: no model file. */
static uint64_t stamp_files(const struct demo *demo)
{
	const struct character_request request =
		demo_env_request(&demo->watch.env);
	uint64_t model = file_stamp(request.model_path);

	return model == 0 ? 0
			  : model ^
			character_open_stamp(&request, demo->figure->character);
}

static int viewer_prepare(struct demo *demo, const struct demo_env *env)
{
	int error = create_figure(env, &demo->base.actor, &demo->figure);

	if (error) {
		return error;
	}
	demo->watch.env = *env;
	demo->watch.shown = demo->watch.last = stamp_files(demo);
	return init_stage(demo->figure, &demo->base, env, &demo->base.stage);
}

static void viewer_finish(struct demo *demo)
{
	destroy_figure(demo->figure);
}

/*
 * Returns true if the stage of one figure suits another: it asks for the same
 * picture, is about as large, and stands at about the same height.
 */
static bool suits(const struct figure *a, float extent, const struct figure *b,
	float other_extent)
{
	const struct framing one = framing_of(a), other = framing_of(b);
	float ratio = other_extent / extent;

	return ratio > 0.8f && ratio < 1.25f &&
		scalar_abs(ground_of(a) - ground_of(b)) < 0.005f * extent &&
		one.camera.yaw_rad == other.camera.yaw_rad &&
		one.camera.pitch_rad == other.camera.pitch_rad &&
		one.camera.margin == other.camera.margin &&
		a->character->scene.zoom == b->character->scene.zoom &&
		one.label_rows == other.label_rows &&
		one.label_bars == other.label_bars &&
		one.labels_right == other.labels_right;
}

/* Makes a new stage where the old figure's does not suit the new one. */
static void reframe(
	struct demo *demo, const struct figure *before, float old_extent)
{
	struct stage *stage = &demo->base.stage;
	struct stage fresh;

	if (!suits(before, old_extent, demo->figure, demo->base.actor.extent) &&
		init_stage(demo->figure, &demo->base, &demo->watch.env,
			&fresh) == 0) {
		stage_finish(stage, demo->base.gl);
		*stage = fresh;
	}
}

/*
 * Loads the model again and goes on in the same state. Returns 0; or -errno,
 * and the old model stays.
 */
static int reload(struct demo *demo)
{
	struct demo_env env = demo->watch.env;
	struct actor old = demo->base.actor, fresh;
	struct figure *before = demo->figure, *after;
	int error = actor_load(&fresh, &env);

	if (error) {
		return error;
	}
	if (env.clip && model_find_clip(fresh.model, env.clip) < 0) {
		env.clip = fresh.model->clip_count > 0 ? "0" : NULL;
	}
	/* The new character may drive the same output lines. */
	character_outputs_close(&before->outputs);
	error = create_figure(&env, &fresh, &after);
	if (error) {
		character_outputs_open(
			&before->outputs, before->character, env.log);
		actor_unload(&fresh, env.gl);
		return error;
	}
	character_go_on(after->character, before->character);
	demo->base.actor = fresh;
	actor_reduce(&demo->base);
	demo->figure = after;
	reframe(demo, before, old.extent);
	demo_overlay_release(&demo->base);
	destroy_figure(before);
	actor_unload(&old, env.gl);
	return 0;
}

/*
 * Reloads a changed file once its stamp is the same in two checks: a file that
 * is still being written changes in between.
 */
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

/* Moves camera and ground as the character asks. */
static void move_scene(
	struct figure *figure, struct stage *stage, float scale, float step_s)
{
	struct character *character = figure->character;
	float moved[3];
	struct bounds now;

	camera_orbit(
		&stage->camera, character->camera_turn, character->camera_tilt);
	/* A frame of seconds must not bring the camera to the target. */
	camera_zoom(&stage->camera,
		1.0f + scalar_clamp(character->camera_zoom, -0.5f, 1.0f));
	now = character_bounds_now(&figure->drawing.bounds, character, moved);
	stage_follow(stage, moved, figure->drawing.bounds.way);
	camera_ease_to(&stage->camera, &now,
		figure->framed ? 1.0f - scalar_exp(-ease_per_s * step_s) : 1.0f);
	figure->framed = true;
	floor_scroll(&stage->floor, character->motion.scroll[0] * scale,
		character->motion.scroll[1] * scale);
}

static void viewer_update(struct demo *demo, double time_s)
{
	struct demo_base *base = &demo->base;
	struct character_frame frame = {.time_s = time_s};
	struct character *character;
	float scale;

	demo->now_s = time_s;
	check_file(demo);
	character_outputs_check(&demo->figure->outputs, time_s);
	character = demo->figure->character;
	scale = character->instance->unit_scale;
	demo->figure->floor = &base->stage.floor;
	character->ground_m = base->stage.floor.y / scale;
	floor_set_wave_height(&base->stage.floor,
		*character->scene.wave_m * scale *
			(character->feet ? character_feet_level(character)
					 : 1.0f));
	frame.motion_level = live_controls_motion(&base->live)
		? base->live.smooth_level
		: 0.0f;
	camera_eye(&base->stage.camera, frame.eye);
	for (int i = 0; i < 3; i++) {
		frame.eye[i] /= scale;
	}
	character_update(character, &frame);
	move_scene(demo->figure, &base->stage, scale, character->real_s);
	base->below = character_label_below(character);
	base->below.switches += live_label_rows(&base->live);
	character->instance->normal_mapping = *character->scene.relief > 0.0f;
	actor_update(&base->actor, &base->stage.camera, base->height);
	character_bend(character);
	character_draw_update(&demo->figure->drawing, &base->stage);
}

static void viewer_draw(struct demo *demo, int width, int height)
{
	struct demo_base *base = &demo->base;

	base->stage.content =
		character_draw_content(&demo->figure->drawing, &base->stage);
	/* Overlays may be outside of the figure's bounds. */
	if (base->overlay && base->overlay->kinds) {
		base->stage.content.bounded = false;
	}
	stage_begin(&base->stage, base->gl, width, height);
	character_draw(&demo->figure->drawing, &base->stage,
		&base->actor.textures, base->gl);
}

/* How long the present clip takes, there and back if it plays to and fro. */
static double clip_period_s(const struct character *character)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	double duration_s = (double)character_entry_duration_s(
		character_machine_entry(character));
	double rate = (double)scalar_abs(*state->rate);
	double ways = state->repeat == CLIP_PING_PONG ? 2.0 : 1.0;

	return duration_s > 0.0 && rate > 0.0 ? ways * duration_s / rate : 1.0;
}

/* The period of the tour, or of the current clip. */
static double viewer_period_s(const struct demo *demo)
{
	const struct character *character = demo->figure->character;

	return character->scene.tour_s > 0.0 ? character->scene.tour_s
					     : clip_period_s(character);
}

/*
 * The first round of a clip holds the pose of a first key that comes late;
 * later rounds begin there (clip_round_time()).
 */
static double viewer_settled_s(const struct demo *demo)
{
	const struct character *character = demo->figure->character;
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	const struct model_clip *clip =
		character_machine_entry(character)->of->clip;
	bool changes = character->scene.tour_s <= 0.0 &&
		state->repeat == CLIP_LOOP && clip && clip->lead_s > 0.0f;

	return changes ? clip_period_s(character) : 0.0;
}

static void viewer_label(const struct demo *demo, struct hud *hud)
{
	struct hud_group group;

	character_label_all(demo->figure->character,
		instance_technique(demo->base.actor.instance), hud);
	if (demo->watch.broken) {
		group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
		hud_group_mark(&group, "new file is broken", "", hud_color_rose);
		hud_group_end(&group);
	}
}

static void viewer_get_motion(
	const struct demo *demo, struct overlay_motion *out)
{
	character_overlay_describe(demo->figure->character, out);
}

static void viewer_press(struct demo *demo, const struct button_event *event)
{
	character_press(demo->figure->character, event);
}

static void viewer_print_buttons(const struct demo *demo, FILE *out)
{
	character_print_buttons(demo->figure->character, out);
}

/* The members that the viewer shares with demos that are character files. */
#define VIEWER_FUNCTIONS                                                \
	.size = sizeof(struct demo), .prepare = viewer_prepare,         \
	.finish = viewer_finish, .press = viewer_press,                 \
	.print_buttons = viewer_print_buttons, .update = viewer_update, \
	.draw = viewer_draw, .period_s = viewer_period_s,               \
	.settled_s = viewer_settled_s, .label = viewer_label,           \
	.get_motion = viewer_get_motion

const struct demo_driver demo_driver_viewer = {
	.name = "viewer",
	.summary = "any model and its clips",
	VIEWER_FUNCTIONS,
};

/* assets/walker.character describes this demo. */
const struct demo_driver demo_driver_walker = {
	.name = "walker",
	.summary = "skeletal: a figure that idles, walks, runs, waves, jumps",
	.asset = "walker.glb",
	VIEWER_FUNCTIONS,
};

/* assets/face.character describes this demo. */
const struct demo_driver demo_driver_face = {
	.name = "face",
	.summary = "morphing: a head that changes its expression",
	.asset = "face.glb",
	VIEWER_FUNCTIONS,
};

/* assets/arm.character describes this demo. */
const struct demo_driver demo_driver_arm = {
	.name = "arm",
	.summary = "hierarchical: a robot arm on pivots that loads a truck",
	.asset = "arm.glb",
	VIEWER_FUNCTIONS,
};
