#include "app/model/xfile/xfile_build.h"

#include "app/model/clip/key_times.h"
#include "app/model/xfile/xfile_convert.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* If all animations are shorter, their keys may count frames. */
static const float short_s = 0.1f;

/* A key's time and its number in the file, where keys may be out of order. */
struct key_time {
	float time_s;
	uint32_t index;
};

static int compare_key_times(const void *a, const void *b)
{
	const struct key_time *left = a;
	const struct key_time *right = b;

	if (left->time_s != right->time_s) {
		return left->time_s < right->time_s ? -1 : 1;
	}
	return (left->index > right->index) - (left->index < right->index);
}

/* Sorts the keys by time; those of one time stay as in the file. */
static int sort_keys(struct xfile_build *build, const struct xfile_keys *keys,
	struct key_time **out)
{
	struct key_time *key_time =
		ARENA_ARRAY(build->scratch, struct key_time, keys->count);

	if (!key_time) {
		return xfile_no_memory(build->context);
	}
	for (uint32_t i = 0; i < keys->count; i++) {
		key_time[i].time_s =
			(float)(keys->tick[i] / build->scene->ticks_per_second);
		key_time[i].index = i;
		if (!(key_time[i].time_s <= MODEL_NUMBER_MAX)) {
			log_error(build->log,
				"%s: the time of an animation key is beyond 1e9 s",
				build->context->path);
			return -EINVAL;
		}
	}
	qsort(key_time, keys->count, sizeof(*key_time), compare_key_times);
	*out = key_time;
	return 0;
}

/*
 * Returns the clip's channel of a node and path, or a new one. build->channel
 * may hold numbers of other clips' channels, so the channel itself decides.
 */
static struct model_channel *take_channel(struct xfile_build *build,
	struct model_clip *clip, int node, enum model_path path)
{
	int *known = &build->channel[node][path];
	struct model_channel *channel = &clip->channel[*known];

	if (*known < clip->channel_count && channel->node == node &&
		channel->path == path) {
		return channel;
	}
	*known = clip->channel_count++;
	return &clip->channel[*known];
}

/*
 * Sets a channel and returns its array of values, which the caller fills in;
 * NULL if there is not enough memory.
 */
static float *set_channel(struct xfile_build *build, struct model_clip *clip,
	int node, enum model_path path, const float *time_s, int count)
{
	int width = path == MODEL_ROTATION ? 4 : 3;
	float *value = ARENA_ARRAY(
		&build->model->arena, float, (size_t)count *(size_t)width);

	if (value) {
		*take_channel(build, clip, node, path) = (struct model_channel){
			.node = node,
			.path = path,
			.interpolation = MODEL_LINEAR,
			.width = width,
			.key_count = count,
			.time_s = time_s,
			.value = value,
		};
	}
	return value;
}

static int add_matrices(struct xfile_build *build, struct model_clip *clip,
	int node, const struct xfile_keys *keys,
	const struct key_time *key_time, const float *time_s, int count)
{
	float *translation = set_channel(
		build, clip, node, MODEL_TRANSLATION, time_s, count);
	float *rotation =
		set_channel(build, clip, node, MODEL_ROTATION, time_s, count);
	float *scale =
		set_channel(build, clip, node, MODEL_SCALE, time_s, count);

	if (!translation || !rotation || !scale) {
		return xfile_no_memory(build->context);
	}
	for (int i = 0; i < count; i++) {
		struct transform transform;
		mat4 matrix;

		xfile_convert_matrix(
			keys->value + (size_t)key_time[i].index * 16, matrix);
		xfile_decompose(matrix, &transform);
		memcpy(translation + 3 * i, transform.translation,
			sizeof(transform.translation));
		memcpy(rotation + 4 * i, transform.rotation,
			sizeof(transform.rotation));
		memcpy(scale + 3 * i, transform.scale, sizeof(transform.scale));
	}
	return 0;
}

static int add_values(struct xfile_build *build, struct model_clip *clip,
	int node, const struct xfile_keys *keys,
	const struct key_time *key_time, const float *time_s, int count)
{
	static const enum model_path paths[] = {
		[XFILE_KEY_ROTATION] = MODEL_ROTATION,
		[XFILE_KEY_SCALE] = MODEL_SCALE,
		[XFILE_KEY_POSITION] = MODEL_TRANSLATION,
	};
	float *value = set_channel(
		build, clip, node, paths[keys->type], time_s, count);

	if (!value) {
		return xfile_no_memory(build->context);
	}
	for (int i = 0; i < count; i++) {
		const float *from = keys->value +
			(size_t)key_time[i].index * (size_t)keys->width;

		if (keys->type == XFILE_KEY_ROTATION) {
			xfile_convert_rotation(from, value + 4 * i);
		} else if (keys->type == XFILE_KEY_POSITION) {
			xfile_convert_vector(from, value + 3 * i);
		} else {
			memcpy(value + 3 * i, from, 3 * sizeof(*value));
		}
	}
	return 0;
}

static int add_keys(struct xfile_build *build, struct model_clip *clip,
	int node, const struct xfile_keys *keys)
{
	struct key_time *key_time = NULL;
	int count = (int)keys->count;
	int first, error = sort_keys(build, keys, &key_time);
	float *time_s;

	if (error) {
		return error;
	}
	time_s = ARENA_ARRAY(&build->model->arena, float, (size_t)count);
	if (!time_s) {
		return xfile_no_memory(build->context);
	}
	for (int i = 0; i < count; i++) {
		time_s[i] = key_time[i].time_s;
	}
	first = key_times_separate(time_s, count).first;
	key_time += first;
	time_s += first;
	count -= first;
	build->moved[node] = true;
	return keys->type == XFILE_KEY_MATRIX
		? add_matrices(build, clip, node, keys, key_time, time_s, count)
		: add_values(build, clip, node, keys, key_time, time_s, count);
}

/* Returns the model's node that an animation moves, or -1 after a warning. */
static int find_node(
	struct xfile_build *build, const struct xfile_animation *animation)
{
	int frame;

	if (!animation->frame) {
		xfile_warn_at(build->context, animation->location,
			"this animation does not name a frame; limber ignores it");
		return -1;
	}
	frame = xfile_names_find(&build->frame_names, animation->frame);
	if (frame < 0) {
		xfile_warn_at(build->context, animation->location,
			"this animation moves the frame \"%.200s\", which does not exist",
			animation->frame);
		return -1;
	}
	return build->node_index[frame];
}

/* Matrix keys become three channels. */
static int channels_of(const struct xfile_keys *keys)
{
	return keys->type == XFILE_KEY_MATRIX ? 3 : 1;
}

/* Returns a bound of a clip's channels. */
static size_t count_channels(const struct xfile_set *set)
{
	const struct xfile_animation *animation = set->animations;
	size_t count = 0;

	for (; animation; animation = animation->next) {
		const struct xfile_keys *keys = animation->keys;

		for (; keys; keys = keys->next) {
			count += (size_t)channels_of(keys);
		}
	}
	return count;
}

/*
 * Adds the channels of an animation. Several keys may move a frame in the same
 * way, as a matrix and a position do; then the last ones count.
 */
static int add_animation(struct xfile_build *build, struct model_clip *clip,
	const struct xfile_animation *animation)
{
	const struct xfile_keys *keys = animation->keys;
	int node = keys ? find_node(build, animation) : -1;
	int end = clip->channel_count;

	for (; node >= 0 && keys; keys = keys->next) {
		int error = add_keys(build, clip, node, keys);

		if (error) {
			return error;
		}
		end += channels_of(keys);
	}
	if (node >= 0 && clip->channel_count < end) {
		xfile_warn_at(build->context, animation->location,
			"several keys move the frame \"%.200s\" in the same way; limber takes the last ones",
			animation->frame);
	}
	return 0;
}

static float find_end(const struct model_clip *clip)
{
	float end_s = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		end_s = fmaxf(end_s, channel->time_s[channel->key_count - 1]);
	}
	return end_s;
}

static int add_clip(struct xfile_build *build, const struct xfile_set *set)
{
	struct model *model = build->model;
	struct model_clip *clip = &model->clip[model->clip_count];
	const struct xfile_animation *animation = set->animations;

	clip->name = arena_strdup(&model->arena, set->name);
	clip->channel = ARENA_ARRAY(
		&model->arena, struct model_channel, count_channels(set));
	if (!clip->name || !clip->channel) {
		return xfile_no_memory(build->context);
	}
	for (; animation; animation = animation->next) {
		int error = add_animation(build, clip, animation);

		if (error) {
			return error;
		}
	}
	clip->duration_s = find_end(clip);
	if (clip->channel_count) {
		model->clip_count++;
	} else {
		xfile_warn_at(build->context, set->location,
			"the animation set \"%.200s\" moves no frame; limber ignores it",
			set->name);
	}
	return 0;
}

/*
 * Some programs count frames and leave the unit to whoever plays the file. As
 * ticks, a walk of 30 frames would be over before it was seen.
 */
static void warn_of_frames(const struct xfile_build *build)
{
	const struct model *model = build->model;
	float longest_s = 0;

	for (int i = 0; i < model->clip_count; i++) {
		longest_s = fmaxf(longest_s, model->clip[i].duration_s);
	}
	if (!build->scene->has_ticks && longest_s > 0 && longest_s < short_s) {
		xfile_warn_at(build->context, build->scene->sets->location,
			"the longest animation takes %.3g s, as a second has 4800 ticks in a file without AnimTicksPerSecond; if its keys count frames, write AnimTicksPerSecond { 30; } below the header",
			(double)longest_s);
	}
}

int xfile_build_clips(struct xfile_build *build)
{
	const struct xfile_set *set = build->scene->sets;
	struct model *model = build->model;
	int error = 0;

	model->clip = ARENA_ARRAY(
		&model->arena, struct model_clip, build->scene->set_count);
	build->channel = arena_alloc(build->scratch, (size_t)model->node_count,
		sizeof(*build->channel));
	if (!model->clip || !build->channel) {
		return xfile_no_memory(build->context);
	}
	for (; !error && set; set = set->next) {
		error = add_clip(build, set);
	}
	if (!error) {
		warn_of_frames(build);
	}
	return error;
}
