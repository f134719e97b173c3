/*
 * Predicts the cost of a whole clip from the loops that run in each frame.
 */
#include "app/compare/cost/board_cost.h"

#include "platform/base/scalar.h"

#include <string.h>

enum {
	FRAMES_MAX = 10000 /* which are enough for an average */
};

struct playback {
	const struct model_clip *clip;
	double rate_hz;
	int frame_count;
	struct instance *instance;
	struct clip_cursor *cursor;
};

static bool is_zero(const float delta[3])
{
	return delta[0] == 0.0f && delta[1] == 0.0f && delta[2] == 0.0f;
}

static bool moves(const struct model_target *target, int vertex)
{
	return (target->position && !is_zero(target->position[vertex])) ||
		(target->normal && !is_zero(target->normal[vertex]));
}

/* Counts the vertices that target t, or t + 1 if it exists, moves. */
static int count_moved(const struct model_primitive *primitive, int t, int count)
{
	int moved = 0;

	for (int v = 0; v < primitive->vertex_count; v++) {
		moved += moves(&primitive->target[t], v) ||
			(t + 1 < count && moves(&primitive->target[t + 1], v));
	}
	return moved;
}

/* Counts the frames in which the loop for targets t and t + 1 runs. */
static int count_frames(
	const struct playback *playback, const struct drawable *drawable, int t)
{
	struct instance *instance = playback->instance;
	const struct model_node *node = &instance->model->node[drawable->node];
	const float *weight = instance->pose.weight + node->weight_offset + t;
	size_t size = t + 1 < drawable_target_count(instance, drawable)
		? sizeof(float[2])
		: sizeof(float);
	static const float none[2] = {0.0f, 0.0f};
	float before[2] = {0.0f, 0.0f};
	int frames = 0;

	for (int i = 0; i < playback->frame_count; i++) {
		clip_pose(playback->clip, (float)((double)i / playback->rate_hz),
			CLIP_AUTO, playback->cursor, &instance->pose);
		/* A skin's base vectors change only when weights do. */
		frames += drawable->skin >= 0 ? memcmp(weight, before, size) != 0
					      : memcmp(weight, none, size) != 0;
		memcpy(before, weight, size);
	}
	return frames;
}

/* Returns how many vertices the targets move in an average frame. */
static double average_moves(
	const struct playback *playback, const struct drawable *drawable)
{
	int count = drawable_target_count(playback->instance, drawable);
	double sum = 0.0;

	for (int t = 0; t < count; t += 2) {
		sum += (double)count_moved(drawable->primitive, t, count) *
			count_frames(playback, drawable, t);
	}
	return sum / playback->frame_count;
}

static void add_drawable(struct board_cost *sum, const struct playback *playback,
	const struct drawable *drawable, int max_influences)
{
	const struct model_primitive *primitive = drawable->primitive;
	bool normals = primitive->normal != NULL;
	double moved = 0.0;
	struct board_cost cost;

	if (drawable->fixed && drawable->fixed->keys) {
		cost = board_cost_keys(primitive->vertex_count, normals);
		board_cost_add(sum, &cost);
		return;
	}
	if (drawable->morphed) {
		moved = average_moves(playback, drawable);
	}
	if (drawable->skin >= 0) {
		cost = board_cost_skin(primitive, max_influences);
		board_cost_add(sum, &cost);
		/* The skin's base vectors are updated from them. */
		cost = board_cost_keys((int)moved, normals);
		board_cost_add(sum, &cost);
	} else if (drawable->morphed && moved < primitive->vertex_count) {
		/* The loop copies the vertices that do not move. */
		moved = primitive->vertex_count;
	}
	cost = board_cost_targets(moved, normals);
	board_cost_add(sum, &cost);
}

struct board_cost board_cost_clip(const struct model_clip *clip,
	struct instance *instance, struct clip_cursor *cursor,
	int max_influences, double rate_hz)
{
	const struct playback playback = {
		.clip = clip,
		.rate_hz = rate_hz,
		.frame_count = scalar_to_int(
			(double)clip->duration_s * rate_hz, 1, FRAMES_MAX),
		.instance = instance,
		.cursor = cursor,
	};
	struct board_cost sum = board_cost_pose(instance->model);

	for (int i = 0; i < instance->drawable_count; i++) {
		add_drawable(&sum, &playback, &instance->drawable[i],
			max_influences);
	}
	return sum;
}
