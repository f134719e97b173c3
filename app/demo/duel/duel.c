/*
 * The duel plays the same clip with AN4044's three techniques side by side.
 *
 * The techniques are the model's skin, morph key frames baked from the clip,
 * and rigid parts cut from the model. Below each figure are its time a frame,
 * its memory and its error. As in `limber compare`, the error is the distance
 * of a vertex in pixels, where `limber play` shows one figure in a picture of
 * the same size.
 */
#include "app/character/motions/motions.h"
#include "app/character/show/character_follow.h"
#include "app/character/show/character_in_place.h"
#include "app/compare/measure/winding.h"
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/demo/duel/contender.h"
#include "app/demo/duel/duel_board.h"
#include "platform/base/scalar.h"

#include <errno.h>

static const float bound_px = 0.5f;   /* the largest error of the morph */
static const float spacing = 1.2f;    /* times a figure's width */
static const float slant = 0.25f;     /* tan(framing.camera.yaw_rad) */
static const float longest_s = 30.0f; /* that key frames are fitted to */
static const float turn_rad_per_s = 1.2f;
static const float full_px[] = {1.0f, 2.0f, 4.0f, 8.0f, 16.0f};
static const double heat_s = 3.3; /* autoplay: time of each display */

static const struct framing framing = {.camera = {.yaw_rad = 0.25f,
					       .pitch_rad = 0.14f,
					       .margin = 1.04f,
					       .follow = true},
	.lines_below = 6};

struct demo {
	struct demo_base base;
	struct motion motion;
	struct model in_place; /* the model, with walks on the spot */
	struct arena arena;    /* of the clips of in_place */
	float spacing;         /* between figures, scene units */
	struct bounds box;     /* of a figure, or of its start if it goes far */
	struct character_follow follow; /* what the camera follows in the clip */
	float way[3];                   /* how far that went */
	struct reference *reference;
	struct time_grid grid; /* of the clip */
	struct screen_view screen;
	struct contender contender[CONTENDER_KINDS];
	double clip_s, now_s;
	unsigned frame;
	int speed_halvings; /* the speed is divided by 2 to this power */
	bool heat_shown, paused, autoplay;
	int scale; /* index in full_px */
	float turn;
};

/* All take their memory before one is converted, which may take seconds. */
static int init_contenders(struct demo *demo, const struct demo_env *env)
{
	int error = 0;

	for (int i = 0; i < CONTENDER_KINDS && !error; i++) {
		error = contender_init(&demo->contender[i],
			(enum contender_kind)i, demo->reference, &demo->screen,
			&demo->grid, env);
	}
	if (!error) {
		error = contender_try_export(demo->reference, env->log);
	}
	for (int i = 0; i < CONTENDER_KINDS && !error; i++) {
		error = contender_bake(&demo->contender[i], &demo->screen,
			&demo->grid, bound_px, env);
	}
	return error;
}

/* Finds the box of the clip by any technique, unless the camera follows it. */
static void find_box(struct demo *demo)
{
	struct bounds *box = &demo->box;

	for (int i = 0; demo->follow.node < 0 && i < CONTENDER_KINDS; i++) {
		const struct contender *one = &demo->contender[i];
		int clip = (int)(one->clip - one->shown->model->clip);
		struct bounds more = bounds_of_clip(one->shown, clip);

		bounds_join(box, &more);
	}
	if (scalar_abs(box->low[1]) < 0.05f * (box->high[1] - box->low[1])) {
		box->low[1] = 0.0f;
	}
}

/* Long figures are seen at an angle, so they need more room. */
static void find_spacing(struct demo *demo)
{
	const struct bounds *box = &demo->box;
	float width = box->high[0] - box->low[0];
	float slanted = width + slant * (box->high[2] - box->low[2]);

	demo->spacing = spacing * width > slanted ? spacing * width : slanted;
}

/* Returns the box of three figures in a row, each in this box. */
static struct bounds bounds_of_row(const struct demo *demo, struct bounds box)
{
	box.low[0] -= demo->spacing;
	box.high[0] += demo->spacing;
	return box;
}

/* Chooses the clip in which the figure walks, or the next best motion. */
static int choose_clip(struct demo *demo, const struct demo_env *env)
{
	struct motions motions;
	const struct character_request request = demo_env_request(env);
	int error = motions_find(
		&request, demo->base.actor.instance, env->log, &motions);

	if (error) {
		return error;
	}
	demo->motion = motions.role[MOTION_WALK];
	if (demo->motion.clip < 0 ||
		!model_has_triangles(demo->base.actor.model)) {
		log_error(env->log,
			"%s: the duel plays a clip by three techniques, and this model has no %s: give one with both meshes and clips",
			env->model_path,
			demo->motion.clip < 0 ? "clip" : "triangles");
		return -EINVAL;
	}
	return 0;
}

/* Finds what the camera follows, as in the viewer, and the box around it. */
static int find_followed(struct demo *demo, const struct character *character)
{
	struct instance *instance = character->instance;
	int count = instance->model->clip_count;
	struct bounds rest;
	const struct character_boxes boxes = {.rest = &rest,
		.clip = ARENA_ARRAY(&demo->arena, struct bounds, count),
		.follow = ARENA_ARRAY(
			&demo->arena, struct character_follow, count)};
	int error = !boxes.clip || !boxes.follow
		? -ENOMEM
		: character_follow_find(character, &boxes);

	if (!error) {
		demo->follow = boxes.follow[demo->motion.clip];
		demo->box = demo->follow.node >= 0
			? boxes.clip[demo->motion.clip]
			: bounds_empty();
	}
	pose_rest(&instance->pose, instance->model);
	instance_update(instance);
	return error;
}

/* Makes clips walk on the spot, as limber play and limber compare do. */
static int stay_in_place(struct demo *demo, const struct demo_env *env)
{
	const struct model *model = demo->base.actor.model;
	const struct character_request request = demo_env_request(env);
	/* choose_clip() has logged the warnings already. */
	const struct log errors = {env->log->write, env->log->user, LOG_ERROR};
	struct character *character;
	float *way_m = ARENA_ARRAY(&demo->arena, float, model->clip_count);
	int error = character_open(
		&request, demo->base.actor.instance, &errors, &character);

	if (error) {
		return error;
	}
	error = !way_m ? -ENOMEM
		       : character_in_place(character, model, &demo->arena,
				 &demo->in_place, way_m);
	if (!error) {
		error = find_followed(demo, character);
	}
	if (error) {
		error = memory_budget_fail(
			demo->arena.budget, model->path, env->log);
	} else if (way_m[demo->motion.clip] > 0.0f) {
		demo->motion.drift[0] = demo->motion.drift[1] = 0.0f;
	}
	character_destroy(character);
	return error;
}

/*
 * Shortens a long clip, whose key frames would take minutes to fit and more
 * memory than there is. The clips of in_place are copies.
 */
static void shorten(struct demo *demo, const struct log *log)
{
	struct model_clip *clip = &demo->in_place.clip[demo->motion.clip];

	if (clip->duration_s > longest_s) {
		log_warning(log,
			"%s: clip %d lasts %.0f s: the duel plays its first %.0f s",
			demo->in_place.path, demo->motion.clip,
			(double)clip->duration_s, (double)longest_s);
		clip->duration_s = longest_s;
	}
}

/* Finds the clip's moments, and warns if no morph is right at all of them. */
static int make_grid(struct demo *demo, const struct demo_env *env)
{
	const char *path = demo->base.actor.model->path;
	bool turns = false;
	int error = time_grid_make(demo->reference->clip, &demo->grid);

	if (!error) {
		error = winding_find_turns(demo->reference, &demo->grid, &turns);
	}
	if (error) {
		log_error(env->log,
			"%s: there is not enough memory for the clip's moments",
			path);
	} else if (turns) {
		log_warning(env->log,
			"%s: clip %d turns a surface inside out, as the sign of a scale changes: the morph shows it from inside for a part of the time",
			path, demo->motion.clip);
	}
	return error;
}

static int duel_prepare(struct demo *demo, const struct demo_env *env)
{
	struct bounds bounds;
	int error = choose_clip(demo, env);

	if (!error) {
		error = stay_in_place(demo, env);
	}
	if (!error) {
		shorten(demo, env->log);
		error = reference_create(&demo->in_place, demo->motion.clip,
			env->log, &demo->reference);
	}
	if (!error) {
		error = make_grid(demo, env);
	}
	if (error) {
		return error;
	}
	demo->screen = screen_view_create(
		demo->reference, &demo->grid, env->width, env->height);
	demo->scale = 2;
	demo->autoplay = env->unattended;
	error = init_contenders(demo, env);
	if (error) {
		return error;
	}
	find_box(demo);
	find_spacing(demo);
	bounds = bounds_of_row(demo, demo->box);
	return actor_init_stage(&demo->base, env, &bounds,
		demo->base.actor.instance->unit_scale, &framing,
		&demo->base.stage);
}

static void duel_finish(struct demo *demo)
{
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		contender_finish(&demo->contender[i]);
	}
	time_grid_release(&demo->grid);
	reference_destroy(demo->reference);
	arena_release(&demo->arena);
}

static void show_heat(struct demo *demo, bool on)
{
	demo->heat_shown = on;
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		overlay_heat_switch(&demo->contender[i].heat, on);
	}
}

/* Measures one contender a frame to save time, and all in the first frame. */
static void measure_errors(struct demo *demo)
{
	for (unsigned i = 0; i < CONTENDER_KINDS; i++) {
		if (demo->frame == 0 || demo->frame % CONTENDER_KINDS == i) {
			contender_measure_error(&demo->contender[i],
				&demo->screen, full_px[demo->scale]);
		}
	}
}

/* Moves the ground backwards under a figure that walks on the spot. */
static void move_ground(struct demo *demo, float step_s)
{
	const struct motion *motion = &demo->motion;
	float way = motion->speed * step_s;

	if (motion->drift[0] == 0.0f && motion->drift[1] == 0.0f) {
		floor_scroll(&demo->base.stage.floor,
			way * scalar_sin(motion->facing_rad),
			way * scalar_cos(motion->facing_rad));
	}
}

/* Keeps figures that go far in the picture, as the reference is posed now. */
static void follow_figures(struct demo *demo)
{
	struct stage *stage = &demo->base.stage;
	struct bounds box = demo->box;
	float way[3], moved[3];

	if (demo->follow.node < 0) {
		return;
	}
	character_follow_way(&demo->follow, demo->reference->instance, way);
	for (int axis = 0; axis < 3; axis++) {
		moved[axis] = way[axis] - demo->way[axis];
		demo->way[axis] = way[axis];
	}
	character_follow_box(&demo->follow, way, &box);
	box = bounds_of_row(demo, box);
	stage_follow(stage, moved, way);
	camera_ease_to(&stage->camera, &box, 1.0f);
}

/* All contenders get the level of detail of the middle one's distance. */
static void choose_lod(struct demo *demo)
{
	const struct actor *actor = &demo->base.actor;
	/* A figure that stays in its place is taken as it stood at first. */
	const struct instance *figure = demo->follow.node >= 0
		? demo->contender[CONTENDER_SKIN].shown
		: actor->instance;
	struct lod lod = lod_relax(&actor->lod, actor->min_error_px);
	float px = lod_px_per_unit(figure, &demo->base.stage.camera,
		actor->extent, demo->base.height);

	for (int i = 0; i < CONTENDER_KINDS; i++) {
		lod_choose(demo->contender[i].shown, &lod, px);
	}
}

static float clip_time_of(const struct demo *demo)
{
	return clip_round_time(demo->reference->clip, demo->clip_s, CLIP_LOOP);
}

static void duel_update(struct demo *demo, double time_s)
{
	float step_s = (float)(time_s - demo->now_s);
	float clip_step_s = demo->paused
		? 0.0f
		: step_s / (float)(1 << demo->speed_halvings);
	float at_s;

	demo->now_s = time_s;
	demo->clip_s += (double)clip_step_s;
	if (demo->autoplay) {
		show_heat(demo, (long)(time_s / heat_s) % 2 == 1);
	}
	camera_orbit(&demo->base.stage.camera,
		demo->turn * turn_rad_per_s * step_s, 0.0f);
	move_ground(demo, clip_step_s);
	at_s = clip_time_of(demo);
	for (int i = 0; i < CONTENDER_KINDS; i++) {
		contender_pose(&demo->contender[i], at_s);
	}
	reference_pose(demo->reference, at_s, false);
	measure_errors(demo);
	follow_figures(demo);
	choose_lod(demo);
	demo->frame++;
}

static bool duel_get_figure(
	const struct demo *demo, int number, struct overlay_figure *out)
{
	if (number >= CONTENDER_KINDS) {
		return false;
	}
	out->instance = demo->contender[number].shown;
	out->shadow = demo->contender[number].shadow;
	out->unposed_nodes = number == CONTENDER_MORPH;
	out->place[3][0] = (float)(number - 1) * demo->spacing;
	return true;
}

static void duel_get_motion(const struct demo *demo, struct overlay_motion *out)
{
	out->clip = demo->reference->clip_index;
	out->time_s = clip_time_of(demo);
}

static double duel_period_s(const struct demo *demo)
{
	(void)demo;
	return 2.0 * heat_s;
}

static void duel_label(const struct demo *demo, struct hud *hud)
{
	duel_board_show(demo->contender,
		demo->heat_shown ? full_px[demo->scale] : 0.0f, hud);
}

static void toggle_heat(struct demo *demo, int amount)
{
	(void)amount;
	demo->autoplay = false;
	show_heat(demo, !demo->heat_shown);
}

static void change_scale(struct demo *demo, int step)
{
	int scale = demo->scale + step;

	if (scale >= 0 && scale < (int)ARRAY_COUNT(full_px)) {
		demo->scale = scale;
	}
}

static void turn(struct demo *demo, int direction)
{
	demo->turn = (float)direction;
}

static void slow_down(struct demo *demo, int times)
{
	demo->speed_halvings = (demo->speed_halvings + times) % 4;
}

static const struct demo_action duel_actions[] = {
	DEMO_PRESS(UP, "paint errors red from more pixels on", change_scale, 1),
	DEMO_PRESS(DOWN, "paint errors red from fewer pixels on", change_scale,
		-1),
	DEMO_HOLD(LEFT, "turn the camera left", turn, -1),
	DEMO_HOLD(RIGHT, "turn the camera right", turn, 1),
	DEMO_INVERT(ENTER, "pause or continue", paused),
	DEMO_PRESS(F6, "play at half the speed, down to an eighth", slow_down, 1),
	DEMO_PRESS(F8, "paint the errors, or not", toggle_heat, 1),
	DEMO_INVERT(F9, "paint the errors from time to time, or not", autoplay),
	{0},
};

const struct demo_driver demo_driver_duel = {
	.name = "duel",
	.summary = "all three techniques side by side, with what they cost",
	.asset = "walker.glb",
	.any_model = true,
	.action = duel_actions,
	.size = sizeof(struct demo),
	.prepare = duel_prepare,
	.finish = duel_finish,
	.update = duel_update,
	.period_s = duel_period_s,
	.label = duel_label,
	.technique = "All three",
	.get_figure = duel_get_figure,
	.get_motion = duel_get_motion,
};
