#include "app/character/sketch/sketch_once.h"

#include "app/anim/clip.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "app/anim/pose.h"
#include "app/character/build/gait.h"
#include "app/character/sketch/sketch_names.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	STEPS = 8
};

/* A shorter clip is a pose. */
static const float short_s = 0.1f;
/* A point has moved if it ends this far from its start, in sides of the model. */
static const float moved_part = 0.05f;
/* A morph target has moved if its weight has changed by this. */
static const float moved_weight = 0.1f;
/* The end is the farthest pose if no other one is much farther from the start. */
static const float farthest_part = 0.75f;
/*
 * A wheel of five spokes looks the same after a fifth of a turn: then each
 * point ends this near, as a part of the way, to where some point was.
 */
static const float same_part = 0.3f;

/* The model at a time of a clip. */
struct shape {
	struct pose pose;
	float (*at)[3]; /* [body.count] */
	float mean[3];
};

struct search {
	const struct model *model;
	struct gait_body body;
	mat4 *world;
	struct shape start, now;
	float extent; /* the longest side of the model's box at the start */
};

static int init_shape(
	struct shape *shape, const struct search *search, struct arena *arena)
{
	shape->at = arena_alloc(
		arena, (size_t)search->body.count, sizeof(*shape->at));
	return shape->at ? pose_init(&shape->pose, search->model, arena)
			 : -ENOMEM;
}

static int init(struct search *search, struct arena *arena)
{
	int error;

	gait_body_make(&search->body, search->model);
	search->world =
		ARENA_ARRAY(arena, mat4, (size_t)search->model->node_count);
	error = search->world ? init_shape(&search->start, search, arena)
			      : -ENOMEM;
	return error ? error : init_shape(&search->now, search, arena);
}

static void place(const struct character_sole *sole, mat4 *world, float out[3])
{
	float second[3];

	matrix_apply(world[sole->node[0]], sole->at[0], out);
	if (sole->weight[1] > 0) {
		matrix_apply(world[sole->node[1]], sole->at[1], second);
		vec_mix(out, second, sole->weight[1], out);
	}
}

static void take(struct search *search, const struct model_clip *clip,
	float time_s, struct shape *shape)
{
	struct clip_cursor none = {0};
	int count = search->body.count;

	pose_rest(&shape->pose, search->model);
	clip_sample(clip, time_s, &none, &shape->pose);
	pose_world(&shape->pose, search->model, NULL, search->world);
	memset(shape->mean, 0, sizeof(shape->mean));
	for (int i = 0; i < count; i++) {
		place(&search->body.point[i].sole, search->world, shape->at[i]);
		vec_add_scaled(shape->mean, shape->at[i], 1.0f / (float)count,
			shape->mean);
	}
}

static float extent_of(const struct shape *shape, int count)
{
	float extent = 0;

	for (int axis = 0; axis < 3; axis++) {
		float low = 0, high = 0;

		for (int i = 0; i < count; i++) {
			float at = shape->at[i][axis];

			low = i == 0 || at < low ? at : low;
			high = i == 0 || at > high ? at : high;
		}
		extent = high - low > extent ? high - low : extent;
	}
	return extent;
}

/* How far a point is from its place at the start, whatever drifts. */
static float way_of(const struct search *search, int point)
{
	float way[3], drift[3];

	vec_subtract(search->now.at[point], search->start.at[point], way);
	vec_subtract(search->now.mean, search->start.mean, drift);
	vec_subtract(way, drift, way);
	return scalar_sqrt(vec_dot(way, way));
}

static float longest_way(const struct search *search)
{
	float most = 0;

	for (int i = 0; i < search->body.count; i++) {
		float way = way_of(search, i);

		most = scalar_max(way, most);
	}
	return most;
}

static float largest_change(const struct search *search)
{
	float most = 0;

	for (int i = 0; i < search->model->weight_count; i++) {
		float change = scalar_abs(search->now.pose.weight[i] -
			search->start.pose.weight[i]);

		most = scalar_max(change, most);
	}
	return most;
}

/* Whether a point is near to where some point of its surface was. */
static bool is_near_surface(const struct search *search, int point, float near)
{
	const struct gait_point *points = search->body.point;

	for (int i = 0; i < search->body.count; i++) {
		float way[3];

		vec_subtract(search->now.at[point], search->start.at[i], way);
		if (points[i].primitive == points[point].primitive &&
			vec_dot(way, way) <= near * near) {
			return true;
		}
	}
	return false;
}

/* Whether the model looks at the end as at the start, as a wheel may. */
static bool looks_same(const struct search *search, float longest)
{
	for (int i = 0; i < search->body.count; i++) {
		if (way_of(search, i) > 0.5f * longest &&
			!is_near_surface(search, i, same_part * longest)) {
			return false;
		}
	}
	return true;
}

static bool has_gone_away(const struct search *search)
{
	float x = search->now.mean[0] - search->start.mean[0];
	float z = search->now.mean[2] - search->start.mean[2];

	return x * x + z * z > search->extent * search->extent;
}

/* Whether the last key has another value than the first one. */
static bool ends_elsewhere(const struct model_channel *channel)
{
	size_t last = (size_t)channel->key_count - 1;
	size_t width = (size_t)channel->width;
	/* A cubic key has its value between two tangents. */
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;
	size_t begin = cubic ? width : 0;
	size_t end = begin + last * width * (cubic ? 3 : 1);

	if (channel->packed) {
		return memcmp(channel->packed[0], channel->packed[last],
			       sizeof(channel->packed[0])) != 0;
	}
	return memcmp(channel->value + begin, channel->value + end,
		       width * sizeof(*channel->value)) != 0;
}

/* Whether the last pose may differ from the first: one need not see most loops. */
static bool may_end_elsewhere(const struct model_clip *clip)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (ends_elsewhere(&clip->channel[i])) {
			return true;
		}
	}
	return false;
}

static bool plays_once(struct search *search, const struct model_clip *clip)
{
	float way, change;
	bool moved, morphed;

	if (clip->duration_s < short_s || !may_end_elsewhere(clip)) {
		return false;
	}
	take(search, clip, 0, &search->start);
	take(search, clip, clip->duration_s, &search->now);
	search->extent = extent_of(&search->start, search->body.count);
	way = longest_way(search);
	change = largest_change(search);
	moved = way > moved_part * search->extent;
	morphed = change > moved_weight;
	if ((!moved && !morphed) || has_gone_away(search) ||
		(!morphed && looks_same(search, way))) {
		return false;
	}
	for (int i = 1; i < STEPS; i++) {
		take(search, clip, clip->duration_s * (float)i / (float)STEPS,
			&search->now);
		moved = moved && way >= farthest_part * longest_way(search);
		morphed = morphed &&
			change >= farthest_part * largest_change(search);
	}
	return moved || morphed;
}

/* 0 or -ENOMEM. */
static int find(const struct model *model, int count, struct sketch_once *once)
{
	struct arena arena = arena_empty();
	struct search *search = ARENA_ARRAY(&arena, struct search, 1);
	int error = -ENOMEM;

	if (search) {
		search->model = model;
		error = init(search, &arena);
	}
	for (int i = 0; i < count && !error; i++) {
		once->clip[i] = plays_once(search, &model->clip[i]);
		once->any = once->any || once->clip[i];
	}
	arena_release(&arena);
	return error;
}

int sketch_find_once(const struct model *model,
	const struct character_sketch_play *play, struct sketch_once *once)
{
	int count = model->clip_count < CHARACTER_SKETCH_CLIPS
		? model->clip_count
		: CHARACTER_SKETCH_CLIPS;

	*once = (struct sketch_once){.any = false};
	return play->repeat != CLIP_LOOP || play->all_loop || count == 0
		? 0
		: find(model, count, once);
}

void sketch_write_once(const struct model *model, int clip, FILE *out)
{
	fputs("; It ends in another shape than it begins with.\nrepeat = once\n",
		out);
	if (model->clip_count == 1) {
		fputs("pause = 1\nnext = ", out);
		sketch_write_heading(out, model, clip);
		fputc('\n', out);
	}
}
