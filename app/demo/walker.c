/*
 * The walker: skeletal animation, AN4044 section 3. Buttons switch clips.
 */
#include "app/demo/actor.h"
#include "app/demo/demo.h"

#include <errno.h>
#include <stdlib.h>

/* What the walker can do; gaits first, from slow to fast. */
enum move {
	MOVE_IDLE,
	MOVE_WALK,
	MOVE_RUN,
	MOVE_WAVE,
	MOVE_JUMP,
	MOVE_COUNT,
	GAIT_COUNT = MOVE_RUN + 1,
};

struct move_kind {
	const char *clip;
	float ground_m_per_s; /* how fast the floor runs underneath */
	bool once;            /* goes back to the gait when it is over */
};

static const struct move_kind moves[MOVE_COUNT] = {
	[MOVE_IDLE] = {"idle", 0.0f, false},
	[MOVE_WALK] = {"walk", 1.03f, false},
	[MOVE_RUN] = {"run", 2.6f, false},
	[MOVE_WAVE] = {"wave", 0.0f, true},
	[MOVE_JUMP] = {"jump", 0.0f, true},
};

static const float turn_rad_per_s = 1.2f;

static const struct framing framing = {
	.yaw_rad = 0.45f, .pitch_rad = 0.12f, .turn_rad = 0.3f, .margin = 1.05f};

struct demo {
	const struct gl *gl;
	struct actor actor;
	struct stage stage;
	int clip[MOVE_COUNT];
	enum move gait, move;
	double move_s; /* since the move began */
	double now_s;
	float turn;
};

static int find_clips(struct demo *demo, const struct demo_env *env)
{
	for (int i = 0; i < MOVE_COUNT; i++) {
		demo->clip[i] =
			model_find_clip(demo->actor.model, moves[i].clip);
		if (demo->clip[i] < 0) {
			log_error(env->log, "%s: has no clip %s",
				env->model_path, moves[i].clip);
			return -EINVAL;
		}
	}
	return 0;
}

static int walker_create(const struct demo_env *env, struct demo **out)
{
	struct demo *demo = calloc(1, sizeof(*demo));
	int error = -ENOMEM;

	if (!demo) {
		log_error(env->log, "walker: not enough memory");
		return error;
	}
	demo->gl = env->gl;
	demo->gait = demo->move = env->unattended ? MOVE_WALK : MOVE_IDLE;
	error = actor_load(&demo->actor, env);
	if (error) {
		goto fail;
	}
	error = find_clips(demo, env);
	if (!error) {
		error = actor_set_stage(&demo->actor, env,
			demo->clip[MOVE_WALK], framing, &demo->stage);
	}
	if (error) {
		goto fail_actor;
	}
	*out = demo;
	return 0;

fail_actor:
	actor_unload(&demo->actor, env->gl);
fail:
	free(demo);
	return error;
}

static void walker_destroy(struct demo *demo)
{
	if (demo) {
		stage_finish(&demo->stage, demo->gl);
		actor_unload(&demo->actor, demo->gl);
		free(demo);
	}
}

static const struct model_clip *clip_of(const struct demo *demo, enum move move)
{
	return &demo->actor.model->clip[demo->clip[move]];
}

static void begin(struct demo *demo, enum move move)
{
	demo->move = move;
	demo->move_s = 0.0;
}

static void walker_update(struct demo *demo, double time_s)
{
	float step_s = (float)(time_s - demo->now_s);
	const struct model_clip *clip;

	demo->now_s = time_s;
	demo->move_s += step_s;
	if (moves[demo->move].once &&
		demo->move_s >= clip_of(demo, demo->move)->duration_s) {
		begin(demo, demo->gait);
	}
	clip = clip_of(demo, demo->move);
	camera_orbit(&demo->stage.camera, demo->turn * turn_rad_per_s * step_s,
		0.0f);
	floor_run(&demo->stage.floor, 0.0f,
		moves[demo->move].ground_m_per_s * step_s);
	actor_pose(&demo->actor, demo->clip[demo->move],
		clip_time((float)demo->move_s, clip->duration_s, CLIP_LOOP));
	instance_update(demo->actor.instance);
}

static void walker_draw(struct demo *demo, int width, int height)
{
	actor_draw(&demo->actor, &demo->stage, demo->gl, width, height);
}

static double walker_period_s(const struct demo *demo)
{
	return clip_of(demo, demo->move)->duration_s;
}

static void walker_label(const struct demo *demo, struct hud *hud)
{
	const struct model_clip *clip = clip_of(demo, demo->move);
	struct hud_group group = hud_group_begin(hud, HUD_TOP_LEFT, "Skeletal");

	hud_group_time(&group, clip->name,
		clip_time(demo->move_s, clip->duration_s, CLIP_LOOP),
		clip->duration_s, hud_color_blue);
	hud_group_end(&group);
}

static void change_gait(struct demo *demo, int step)
{
	int gait = (int)demo->gait + step;

	if (gait >= 0 && gait < GAIT_COUNT) {
		demo->gait = (enum move)gait;
		begin(demo, demo->gait);
	}
}

static void press_faster(struct demo *demo, bool down)
{
	if (down) {
		change_gait(demo, 1);
	}
}

static void press_slower(struct demo *demo, bool down)
{
	if (down) {
		change_gait(demo, -1);
	}
}

static void press_wave(struct demo *demo, bool down)
{
	if (down) {
		begin(demo, MOVE_WAVE);
	}
}

static void press_jump(struct demo *demo, bool down)
{
	if (down) {
		begin(demo, MOVE_JUMP);
	}
}

static void press_turn(struct demo *demo, bool down)
{
	demo->turn = down ? 1.0f : 0.0f;
}

static const struct demo_action walker_actions[] = {
	{BUTTON_UP, "faster: idle, walk, run", press_faster},
	{BUTTON_DOWN, "slower", press_slower},
	{BUTTON_LEFT, "wave", press_wave},
	{BUTTON_RIGHT, "jump", press_jump},
	{BUTTON_ENTER, "go round (hold)", press_turn},
	{0},
};

const struct demo_driver demo_driver_walker = {
	.name = "walker",
	.summary = "skeletal: a figure that idles, walks, runs, waves, jumps",
	.asset = "walker.glb",
	.action = walker_actions,
	.create = walker_create,
	.update = walker_update,
	.draw = walker_draw,
	.period_s = walker_period_s,
	.label = walker_label,
	.destroy = walker_destroy,
};
