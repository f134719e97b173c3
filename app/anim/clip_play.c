#include "app/anim/clip.h"

#include "app/anim/clip_channel.h"
#include "app/anim/math/transform_inline.h"
#include "app/anim/math/vec.h"
#include "app/anim/turns.h"

#include <errno.h>
#include <stdlib.h>

struct clip_moving {
	const struct model_channel *channel;
	int key;       /* of the last sample */
	size_t offset; /* of the value, in bytes from pose.weight for
			  MODEL_WEIGHTS, else from pose.local */
};

struct clip_part {
	int node;
	uint8_t paths;
	bool animated;
	float weight;
};

int clip_cursor_init(struct clip_cursor *cursor, const struct model *model,
	struct arena *arena)
{
	int most = 0;

	for (int i = 0; i < model->clip_count; i++) {
		int count = model->clip[i].channel_count;

		most = count > most ? count : most;
	}
	*cursor = (struct clip_cursor){.channel_count = most};
	cursor->key = ARENA_ARRAY(arena, int, (size_t)most);
	cursor->turn = ARENA_ARRAY(arena, struct turn, (size_t)most);
	cursor->moving = ARENA_ARRAY(arena, struct clip_moving, (size_t)most);
	cursor->part =
		ARENA_ARRAY(arena, struct clip_part, (size_t)model->node_count);
	return cursor->key && cursor->turn && cursor->moving && cursor->part
		? pose_init(&cursor->still, model, arena)
		: -ENOMEM;
}

/* Whether the functions of turns.h can sample the channel. */
static bool is_turn(const struct model_channel *channel)
{
	return channel->unit && channel->interpolation == MODEL_LINEAR &&
		!signbit(channel->time_s[0]);
}

static void add_turn(
	struct clip_cursor *cursor, const struct model_channel *channel)
{
	const float *only = cursor->only;

	struct turn *turn = &cursor->turn[cursor->turn_count++];

	*turn = (struct turn){
		.time_s = channel->time_s,
		.offset = (int)clip_channel_offset(channel),
		.weight = only ? only[channel->node] : 1,
		.last = channel->key_count - 1,
	};
	if (channel->packed) {
		turn->packed = channel->packed;
	} else {
		turn->value = channel->value;
	}
}

static void add_moving(struct clip_cursor *cursor,
	const struct model_channel *channel, const struct model *model)
{
	size_t first = (size_t)model->node[channel->node].weight_offset;

	cursor->moving[cursor->moving_count++] = (struct clip_moving){
		.channel = channel,
		.offset = channel->path == MODEL_WEIGHTS
			? first * sizeof(float)
			: clip_channel_offset(channel),
	};
}

static bool is_still(
	const struct clip_cursor *cursor, const struct model_channel *channel)
{
	return channel->constant ||
		(cursor->only && cursor->only[channel->node] == 0);
}

/*
 * Writes the constant channels into cursor->still and lists those that change
 * and are no turns in moving[].
 */
static void divide_channels(struct clip_cursor *cursor,
	const struct model_clip *clip, const struct model *model)
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		float *out = clip_channel_target(channel, &cursor->still);
		int key = 0;

		if (is_still(cursor, channel)) {
			clip_sample_channel(channel, channel->time_s[0],
				CLIP_AUTO, &key, out);
		} else if (!is_turn(channel)) {
			add_moving(cursor, channel, model);
		}
	}
}

/*
 * Sorts turns by key times, since neighbours with equal times share a search.
 */
static int compare_turns(const void *a, const void *b)
{
	const struct turn *left = a, *right = b;

	return (left->time_s > right->time_s) - (left->time_s < right->time_s);
}

static void add_turns(
	struct clip_cursor *cursor, const struct model_clip *clip, bool packed)
{
	int first = cursor->turn_count;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (!is_still(cursor, channel) && is_turn(channel) &&
			!channel->packed == !packed) {
			add_turn(cursor, channel);
		}
	}
	qsort(cursor->turn + first, (size_t)(cursor->turn_count - first),
		sizeof(*cursor->turn), compare_turns);
}

/*
 * Marks the nodes of the turns in part[node].animated. list_parts() fills
 * part[] from its start and has no more parts than nodes done, so that it reads
 * each mark before it writes there.
 */
static void mark_turned(struct clip_cursor *cursor, int node_count)
{
	for (int n = 0; n < node_count; n++) {
		cursor->part[n].animated = false;
	}
	for (int i = 0; i < cursor->turn_count; i++) {
		size_t node = (size_t)cursor->turn[i].offset /
			sizeof(*cursor->still.local);

		cursor->part[node].animated = true;
	}
}

/* Fills in part[]: what clip_mix() mixes besides the turns. */
static void list_parts(struct clip_cursor *cursor, const struct model *model)
{
	mark_turned(cursor, model->node_count);
	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];
		float weight = cursor->only ? cursor->only[n] : 1;
		unsigned paths = cursor->paths ? cursor->paths[n] : 0xf;

		if (cursor->part[n].animated) {
			paths &= ~(1u << MODEL_ROTATION);
		}
		if (node->mesh < 0 || model->mesh[node->mesh].target_count == 0) {
			paths &= ~(1u << MODEL_WEIGHTS);
		}
		if (weight > 0 && paths != 0) {
			cursor->part[cursor->part_count++] = (struct clip_part){
				.node = n,
				.paths = (uint8_t)paths,
				.animated = cursor->still.animated[n],
				.weight = weight,
			};
		}
	}
}

static void begin_clip(struct clip_cursor *cursor,
	const struct model_clip *clip, const struct model *model)
{
	cursor->begun = true;
	cursor->clip = clip;
	cursor->turn_count = cursor->float_turn_count = 0;
	cursor->moving_count = cursor->part_count = 0;
	pose_rest(&cursor->still, model);
	if (clip) {
		divide_channels(cursor, clip, model);
		add_turns(cursor, clip, false);
		cursor->float_turn_count = cursor->turn_count;
		add_turns(cursor, clip, true);
	}
	list_parts(cursor, model);
}

/* Writes the channels of moving[]. */
static void sample_moving(
	struct clip_cursor *cursor, float time_s, struct pose *pose)
{
	struct clip_moment moment = {NULL, 0, 0, CLIP_AT_KEY};
	struct clip_moving *end = cursor->moving + cursor->moving_count;

	for (struct clip_moving *moving = cursor->moving; moving < end;
		moving++) {
		const struct model_channel *channel = moving->channel;
		char *base = channel->path == MODEL_WEIGHTS
			? (char *)pose->weight
			: (char *)pose->local;

		if (!clip_moment_fits(&moment, channel)) {
			moment = clip_moment_find(channel, time_s, moving->key);
			moving->key = moment.key;
		}
		clip_channel_sample(channel, CLIP_AUTO, moment.key, moment.u,
			(float *)(base + moving->offset));
	}
}

/* The functions of turns.h take times from 0 on; NaN becomes 0. */
static float turn_time_s(float time_s)
{
	return time_s > 0 ? time_s : 0;
}

void clip_pose(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose)
{
	int floats;

	/*
	 * The fast way is only for CLIP_AUTO: by another interpolation,
	 * constant channels may be rounded differently.
	 */
	if (interpolation != CLIP_AUTO || !cursor->moving ||
		clip->channel_count > cursor->channel_count) {
		pose_rest(pose, pose->model);
		clip_sample_as(clip, time_s, interpolation, cursor, pose);
		return;
	}
	if (!cursor->begun || cursor->clip != clip) {
		begin_clip(cursor, clip, pose->model);
	}
	floats = cursor->float_turn_count;
	pose_copy(pose, &cursor->still);
	if (floats > 0) {
		turns_set(
			cursor->turn, floats, turn_time_s(time_s), pose->local);
	}
	if (cursor->turn_count > floats) {
		turns_set_packed(cursor->turn + floats,
			cursor->turn_count - floats, turn_time_s(time_s),
			pose->local);
	}
	sample_moving(cursor, time_s, pose);
}

static void mix_weights(
	struct pose *pose, const struct pose *other, int node, float t)
{
	const struct model_node *of = &pose->model->node[node];
	int last = of->weight_offset + pose->model->mesh[of->mesh].target_count;

	for (int i = of->weight_offset; i < last; i++) {
		pose->weight[i] =
			pose->weight[i] * (1 - t) + other->weight[i] * t;
	}
}

static void mix_part(struct pose *pose, const struct pose *other,
	const struct clip_part *part, float amount)
{
	struct transform *local = &pose->local[part->node];
	const struct transform *to = &other->local[part->node];
	float t = amount * part->weight;

	if (part->paths & 1 << MODEL_ROTATION) {
		inline_quat_mix(local->rotation, to->rotation, t);
	}
	if (part->paths & 1 << MODEL_TRANSLATION) {
		vec_mix(local->translation, to->translation, t,
			local->translation);
	}
	if (part->paths & 1 << MODEL_SCALE) {
		vec_mix(local->scale, to->scale, t, local->scale);
	}
	if (part->paths & 1 << MODEL_WEIGHTS) {
		mix_weights(pose, other, part->node, t);
	}
	pose->animated[part->node] |= part->animated;
}

static void mix_turns(const struct clip_cursor *cursor, float time_s,
	float amount, struct pose *pose)
{
	int floats = cursor->float_turn_count;

	if (floats > 0) {
		turns_mix(cursor->turn, floats, turn_time_s(time_s),
			pose->local, amount);
	}
	if (cursor->turn_count > floats) {
		turns_mix_packed(cursor->turn + floats,
			cursor->turn_count - floats, turn_time_s(time_s),
			pose->local, amount);
	}
}

/* The same with the rotations that cursor->still has already. */
static void mix_turned(
	const struct clip_cursor *cursor, float amount, struct pose *pose)
{
	for (int i = 0; i < cursor->turn_count; i++) {
		const struct turn *turn = &cursor->turn[i];
		const char *from = (const char *)cursor->still.local;

		inline_quat_mix((float *)((char *)pose->local + turn->offset),
			(const float *)(from + turn->offset),
			turn->weight * amount);
	}
}

void clip_mix(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, float amount,
	struct clip_cursor *cursor, struct pose *pose)
{
	const struct clip_part *end;

	if (!cursor->begun || cursor->clip != clip) {
		begin_clip(cursor, clip, pose->model);
	}
	/* All other channels are sampled into still and mixed from there. */
	if (clip && interpolation != CLIP_AUTO) {
		clip_sample_as(
			clip, time_s, interpolation, cursor, &cursor->still);
		mix_turned(cursor, amount, pose);
	} else {
		sample_moving(cursor, time_s, &cursor->still);
		mix_turns(cursor, time_s, amount, pose);
	}
	end = cursor->part + cursor->part_count;
	for (const struct clip_part *part = cursor->part; part < end; part++) {
		mix_part(pose, &cursor->still, part, amount);
	}
}

/* Whether the channel never changes and has the value of the node at rest. */
static bool is_at_rest(
	const struct model_channel *channel, const struct model *model)
{
	const struct transform *rest = &model->node[channel->node].rest;
	const float *value = channel->path == MODEL_TRANSLATION
		? rest->translation
		: channel->path == MODEL_ROTATION ? rest->rotation
						  : rest->scale;

	if (!channel->constant || channel->path == MODEL_WEIGHTS) {
		return false;
	}
	for (int i = 0; i < channel->width; i++) {
		if (channel->value[i] != value[i]) {
			return false;
		}
	}
	return true;
}

void clip_add_paths(const struct model_clip *clip, const struct model *model,
	uint8_t *paths)
{
	for (int i = 0; clip && i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (!is_at_rest(channel, model)) {
			paths[channel->node] |= (uint8_t)(1 << channel->path);
		}
	}
}
