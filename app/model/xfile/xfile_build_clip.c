#include "app/model/xfile/xfile_build.h"
#include "app/model/xfile/xfile_convert.h"

#include <stdlib.h>
#include <string.h>

/* A key by its time, which may be out of order in the file. */
struct moment {
	float time_s;
	uint32_t index;
};

static int compare_moments(const void *a, const void *b)
{
	const struct moment *left = a;
	const struct moment *right = b;

	if (left->time_s != right->time_s) {
		return left->time_s < right->time_s ? -1 : 1;
	}
	return (left->index > right->index) - (left->index < right->index);
}

/* Of keys at the same time the last one stays. */
static int sort_keys(struct xfile_build *build, const struct xfile_keys *keys,
	struct moment **out, int *count)
{
	struct moment *moment =
		ARENA_ARRAY(build->scratch, struct moment, keys->count);

	if (!moment) {
		return xfile_no_memory(build->where);
	}
	for (uint32_t i = 0; i < keys->count; i++) {
		moment[i].time_s =
			(float)(keys->tick[i] / build->scene->ticks_per_second);
		moment[i].index = i;
	}
	qsort(moment, keys->count, sizeof(*moment), compare_moments);
	*out = moment;
	*count = 0;
	for (uint32_t i = 0; i < keys->count; i++) {
		if (*count && moment[*count - 1].time_s == moment[i].time_s) {
			moment[*count - 1] = moment[i];
		} else {
			moment[(*count)++] = moment[i];
		}
	}
	return 0;
}

/* Room for a channel; its times are the same for all of a key's paths. */
static float *add_channel(struct xfile_build *build, struct model_clip *clip,
	int node, enum model_path path, const float *time_s, int count)
{
	int width = path == MODEL_ROTATION ? 4 : 3;
	float *value = ARENA_ARRAY(
		&build->model->arena, float, (size_t)count *(size_t)width);

	if (value) {
		clip->channel[clip->channel_count++] = (struct model_channel){
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
	int node, const struct xfile_keys *keys, const struct moment *moment,
	const float *time_s, int count)
{
	float *translation = add_channel(
		build, clip, node, MODEL_TRANSLATION, time_s, count);
	float *rotation =
		add_channel(build, clip, node, MODEL_ROTATION, time_s, count);
	float *scale =
		add_channel(build, clip, node, MODEL_SCALE, time_s, count);

	if (!translation || !rotation || !scale) {
		return xfile_no_memory(build->where);
	}
	for (int i = 0; i < count; i++) {
		struct transform transform;
		mat4 matrix;

		xfile_convert_matrix(
			keys->value + (size_t)moment[i].index * 16, matrix);
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
	int node, const struct xfile_keys *keys, const struct moment *moment,
	const float *time_s, int count)
{
	static const enum model_path paths[] = {
		[XFILE_KEY_ROTATION] = MODEL_ROTATION,
		[XFILE_KEY_SCALE] = MODEL_SCALE,
		[XFILE_KEY_POSITION] = MODEL_TRANSLATION,
	};
	float *value = add_channel(
		build, clip, node, paths[keys->type], time_s, count);

	if (!value) {
		return xfile_no_memory(build->where);
	}
	for (int i = 0; i < count; i++) {
		const float *from = keys->value +
			(size_t)moment[i].index * (size_t)keys->width;

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
	struct moment *moment = NULL;
	float *time_s;
	int count = 0;
	int error = sort_keys(build, keys, &moment, &count);

	if (error) {
		return error;
	}
	time_s = ARENA_ARRAY(&build->model->arena, float, (size_t)count);
	if (!time_s) {
		return xfile_no_memory(build->where);
	}
	for (int i = 0; i < count; i++) {
		time_s[i] = moment[i].time_s;
	}
	if (time_s[count - 1] > clip->duration_s) {
		clip->duration_s = time_s[count - 1];
	}
	build->moved[node] = true;
	return keys->type == XFILE_KEY_MATRIX
		? add_matrices(build, clip, node, keys, moment, time_s, count)
		: add_values(build, clip, node, keys, moment, time_s, count);
}

/* The frame that an animation moves as a node, or -1 after a warning. */
static int find_node(
	struct xfile_build *build, const struct xfile_animation *animation)
{
	int frame;

	if (!animation->frame) {
		xfile_warn_at(build->where, animation->place,
			"this animation does not say what it moves");
		return -1;
	}
	frame = xfile_names_find(&build->frame_names, animation->frame);
	if (frame < 0) {
		xfile_warn_at(build->where, animation->place,
			"there is no frame \"%.200s\" to move",
			animation->frame);
		return -1;
	}
	return build->place[frame];
}

/* A matrix becomes three channels. */
static size_t count_channels(const struct xfile_set *set)
{
	const struct xfile_animation *animation = set->animations;
	size_t count = 0;

	for (; animation; animation = animation->next) {
		const struct xfile_keys *keys = animation->keys;

		for (; keys; keys = keys->next) {
			count += keys->type == XFILE_KEY_MATRIX ? 3 : 1;
		}
	}
	return count;
}

/* A set that moves nothing makes no clip. */
static int add_clip(struct xfile_build *build, const struct xfile_set *set)
{
	struct model *model = build->model;
	struct model_clip *clip = &model->clip[model->clip_count];
	const struct xfile_animation *animation = set->animations;

	clip->name = arena_strdup(&model->arena, set->name);
	clip->channel = ARENA_ARRAY(
		&model->arena, struct model_channel, count_channels(set));
	if (!clip->name || !clip->channel) {
		return xfile_no_memory(build->where);
	}
	for (; animation; animation = animation->next) {
		const struct xfile_keys *keys = animation->keys;
		int node = keys ? find_node(build, animation) : -1;

		for (; node >= 0 && keys; keys = keys->next) {
			int error = add_keys(build, clip, node, keys);

			if (error) {
				return error;
			}
		}
	}
	if (clip->channel_count) {
		model->clip_count++;
	} else {
		xfile_warn_at(build->where, set->place,
			"the animation set \"%.200s\" moves nothing", set->name);
	}
	return 0;
}

int xfile_build_clips(struct xfile_build *build)
{
	const struct xfile_set *set = build->scene->sets;
	struct model *model = build->model;
	int error = 0;

	model->clip = ARENA_ARRAY(
		&model->arena, struct model_clip, build->scene->set_count);
	if (!model->clip) {
		return xfile_no_memory(build->where);
	}
	for (; !error && set; set = set->next) {
		error = add_clip(build, set);
	}
	return error;
}
