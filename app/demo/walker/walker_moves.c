#include "app/demo/walker/walker_moves.h"

#include "app/anim/pose_blend.h"
#include "app/demo/actor.h"
#include "platform/base/scalar.h"

#include <errno.h>

struct move_kind {
	const char *clip;
	float ground_m_per_s; /* at which the floor scrolls */
};

static const struct move_kind kinds[MOVE_COUNT] = {
	[MOVE_IDLE] = {"idle", 0.0f},
	[MOVE_WALK] = {"walk", 1.03f},
	[MOVE_RUN] = {"run", 2.6f},
	[MOVE_JUMP] = {"jump", 0.0f},
	[MOVE_WAVE] = {"wave", 0.0f},
};

static const char waving_arm[] = "shoulder.R";
static const char smiling_head[] = "walker_head"; /* its morph weights */
static const float fade_s = 0.3f;

static int find_clips(struct walker_moves *moves, const struct model *model,
	const struct log *log)
{
	for (int i = 0; i < MOVE_COUNT; i++) {
		moves->clip[i] = model_find_clip(model, kinds[i].clip);
		if (moves->clip[i] < 0) {
			log_error(log, "%s: the model has no clip named %s",
				model->path, kinds[i].clip);
			return -EINVAL;
		}
	}
	return 0;
}

static int take_memory(struct walker_moves *moves, const struct model *model,
	struct arena *arena)
{
	int error = fade_init(&moves->fade, model, arena);

	for (int i = 0; i < 2 && !error; i++) {
		error = clip_cursor_init(&moves->cursor[i], model, arena);
	}
	if (!error) {
		error = pose_init(&moves->before, model, arena);
	}
	if (!error) {
		error = pose_init(&moves->wave, model, arena);
	}
	moves->wave_mask = ARENA_ARRAY(arena, float, (size_t)model->node_count);
	return moves->wave_mask ? error : -ENOMEM;
}

int walker_moves_init(struct walker_moves *moves, struct instance *instance,
	enum walker_move gait, const struct log *log)
{
	const struct model *model = instance->model;
	int head = model_find_node(model, smiling_head);
	int arm, error;

	*moves = (struct walker_moves){
		.gait = gait, .move = gait, .wave_s = -1.0};
	error = find_clips(moves, model, log);
	if (!error) {
		error = actor_find_bone(model, waving_arm, log, &arm);
	}
	if (error) {
		return error;
	}
	error = take_memory(moves, model, &instance->arena);
	if (error) {
		log_error(log,
			"%s: there is not enough memory to play the model",
			model->path);
		return error;
	}
	pose_mask_fill(moves->wave_mask, model->node_count, 0.0f);
	pose_mask_subtree(moves->wave_mask, model, arm, 1.0f);
	if (head >= 0) {
		moves->wave_mask[head] = 1.0f;
	}
	return 0;
}

static void change(struct walker_moves *moves, enum walker_move move)
{
	if (move != moves->move) {
		fade_begin(&moves->fade, &moves->before, fade_s, EASE_CUBIC);
	}
	moves->move = move;
	moves->move_s = 0.0;
}

void walker_moves_begin(struct walker_moves *moves, enum walker_move move)
{
	if (move == MOVE_WAVE) {
		moves->wave_s = 0.0;
		return;
	}
	if (move < GAIT_COUNT) {
		moves->gait = move;
	}
	change(moves, move);
}

void walker_moves_change_gait(struct walker_moves *moves, int step)
{
	int gait = (int)moves->gait + step;

	if (gait >= 0 && gait < GAIT_COUNT) {
		walker_moves_begin(moves, (enum walker_move)gait);
	}
}

/* The wave fades in and out within its clip's duration. */
static void wave(
	struct walker_moves *moves, struct instance *instance, float step_s)
{
	const struct model_clip *clip =
		&instance->model->clip[moves->clip[MOVE_WAVE]];
	float left_s;

	moves->wave_weight = 0.0f;
	if (moves->wave_s < 0.0) {
		return;
	}
	moves->wave_s += (double)step_s;
	left_s = clip->duration_s - (float)moves->wave_s;
	if (left_s <= 0.0f) {
		moves->wave_s = -1.0;
		return;
	}
	moves->wave_weight = ease_at(EASE_CUBIC, (float)moves->wave_s / fade_s) *
		ease_at(EASE_CUBIC, left_s / fade_s);
	clip_pose(clip, (float)moves->wave_s, CLIP_AUTO, &moves->cursor[1],
		&moves->wave);
	pose_mix(&instance->pose, &moves->wave, moves->wave_weight,
		moves->wave_mask, &instance->pose);
}

void walker_moves_update(
	struct walker_moves *moves, struct instance *instance, float step_s)
{
	const struct model_clip *clip =
		&instance->model->clip[moves->clip[moves->move]];
	float fraction = scalar_clamp(2.0f * step_s / fade_s, 0.0f, 1.0f);

	moves->move_s += (double)step_s;
	if (moves->move == MOVE_JUMP &&
		moves->move_s >= (double)clip->duration_s) {
		change(moves, moves->gait);
		clip = &instance->model->clip[moves->clip[moves->move]];
	}
	moves->ground_m_per_s +=
		(kinds[moves->move].ground_m_per_s - moves->ground_m_per_s) *
		fraction;
	clip_pose(clip, clip_time(moves->move_s, clip->duration_s, CLIP_LOOP),
		CLIP_AUTO, &moves->cursor[0], &instance->pose);
	fade_update(&moves->fade, step_s, &instance->pose);
	pose_copy(&moves->before, &instance->pose);
	wave(moves, instance, step_s);
}

const struct model_clip *walker_moves_clip(const struct walker_moves *moves,
	const struct model *model, float *time_s)
{
	const struct model_clip *clip = &model->clip[moves->clip[moves->move]];

	*time_s = clip_time(moves->move_s, clip->duration_s, CLIP_LOOP);
	return clip;
}
