#include "app/anim/clip.h"

#include "app/anim/clip_channel.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>

enum clip_moving_kind {
	CLIP_MOVES,         /* translation, scale or rotation */
	CLIP_TURNS,         /* rotation between unit keys by slerp */
	CLIP_MOVES_WEIGHTS, /* morph weights */
};

struct clip_moving {
	const struct model_channel *channel;
	enum clip_moving_kind kind;
	int key;       /* of the last sample */
	size_t offset; /* of the value, in bytes, in the pose's transforms or
			  weights */
};

static const char *const INTERPOLATION_NAME[] = {
	[CLIP_AUTO] = "auto",
	[CLIP_NEAREST] = "nearest",
	[CLIP_STEP] = "step",
	[CLIP_LINEAR] = "linear",
	[CLIP_CUBIC] = "cubic",
};

int clip_interpolation_find(const char *name)
{
	for (size_t i = 0; i < ARRAY_COUNT(INTERPOLATION_NAME); i++) {
		if (strcmp(INTERPOLATION_NAME[i], name) == 0) {
			return (int)i;
		}
	}
	return -1;
}

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
	cursor->moving = ARENA_ARRAY(arena, struct clip_moving, (size_t)most);
	return cursor->key && cursor->moving
		? pose_init(&cursor->still, model, arena)
		: -ENOMEM;
}

/* Of a node's channel: its value's offset in the pose's transforms. */
static ALWAYS_INLINE size_t transform_offset(const struct model_channel *channel)
{
	static const uint8_t part[] = {
		[MODEL_TRANSLATION] = offsetof(struct transform, translation),
		[MODEL_ROTATION] = offsetof(struct transform, rotation),
		[MODEL_SCALE] = offsetof(struct transform, scale),
	};

	return (size_t)channel->node * sizeof(struct transform) +
		part[channel->path];
}

/* Where the channel's value is written; the loader has checked the bounds. */
static float *channel_target(
	const struct model_channel *channel, struct pose *pose)
{
	if (channel->path == MODEL_WEIGHTS) {
		return pose->weight +
			pose->model->node[channel->node].weight_offset;
	}
	pose->animated[channel->node] = true;
	return (float *)((char *)pose->local + transform_offset(channel));
}

void clip_sample(const struct model_clip *clip, float time_s,
	struct clip_cursor *cursor, struct pose *pose)
{
	clip_sample_as(clip, time_s, CLIP_AUTO, cursor, pose);
}

void clip_sample_as(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose)
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		int start = 0;
		int *key = i < cursor->channel_count ? &cursor->key[i] : &start;

		clip_sample_channel(channel, time_s, interpolation, key,
			channel_target(channel, pose));
	}
}

static struct clip_moving describe_moving(
	const struct model_channel *channel, const struct model *model)
{
	if (channel->path == MODEL_WEIGHTS) {
		int first = model->node[channel->node].weight_offset;

		return (struct clip_moving){
			.channel = channel,
			.kind = CLIP_MOVES_WEIGHTS,
			.offset = (size_t)first * sizeof(float),
		};
	}
	return (struct clip_moving){
		.channel = channel,
		.kind = clip_channel_is_slerp(channel) ? CLIP_TURNS : CLIP_MOVES,
		.offset = transform_offset(channel),
	};
}

/* Separates the clip's constant channels from those that change. */
static void begin_clip(struct clip_cursor *cursor,
	const struct model_clip *clip, const struct model *model)
{
	struct pose *still = &cursor->still;

	cursor->clip = clip;
	cursor->moving_count = 0;
	pose_rest(still, model);
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		float *out = channel_target(channel, still);
		int key = 0;

		if (channel->constant ||
			(cursor->only && cursor->only[channel->node] == 0)) {
			clip_sample_channel(channel, channel->time_s[0],
				CLIP_AUTO, &key, out);
		} else {
			cursor->moving[cursor->moving_count++] =
				describe_moving(channel, model);
		}
	}
}

static ALWAYS_INLINE float *moving_target(
	const struct clip_moving *moving, const struct pose *pose)
{
	char *base = moving->kind == CLIP_MOVES_WEIGHTS ? (char *)pose->weight
							: (char *)pose->local;

	return (float *)(base + moving->offset);
}

static bool is_prepared(
	const struct clip_cursor *cursor, const struct model_clip *clip)
{
	return cursor->moving && clip->channel_count <= cursor->channel_count;
}

void clip_pose(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose)
{
	struct clip_moment moment = {NULL, 0, 0, CLIP_AT_KEY};
	const struct clip_moving *end;

	/* A cubic between equal keys may still differ from them by rounding. */
	if (interpolation == CLIP_CUBIC || !is_prepared(cursor, clip)) {
		pose_rest(pose, pose->model);
		clip_sample_as(clip, time_s, interpolation, cursor, pose);
		return;
	}
	if (cursor->clip != clip) {
		begin_clip(cursor, clip, pose->model);
	}
	pose_copy(pose, &cursor->still);
	end = cursor->moving + cursor->moving_count;
	for (struct clip_moving *moving = cursor->moving; moving < end;
		moving++) {
		const struct model_channel *channel = moving->channel;
		float *out = moving_target(moving, pose);

		if (!clip_moment_fits(&moment, channel)) {
			moment = clip_moment_find(channel, time_s, moving->key);
			moving->key = moment.key;
		}
		if (moving->kind == CLIP_TURNS && interpolation == CLIP_AUTO) {
			clip_channel_slerp(channel, moment.key, moment.u, out);
		} else {
			clip_channel_sample(channel, interpolation, moment.key,
				moment.u, out);
		}
	}
}

/* time_s modulo period_s: at least 0 and below period_s. */
static double wrap(double time_s, double period_s)
{
	double turns = time_s / period_s;
	double rest_s;

	/* Beyond 2^31 periods the phase is noise. */
	if (!(turns > -2147483647.0 && turns < 2147483647.0)) {
		return 0;
	}
	rest_s = time_s - (double)(int32_t)turns * period_s;
	rest_s = rest_s < 0 ? rest_s + period_s : rest_s;
	return rest_s < period_s ? rest_s : 0;
}

float clip_time(double time_s, float duration_s, enum clip_repeat repeat)
{
	if (!(duration_s > 0)) {
		return 0;
	}
	if (repeat == CLIP_LOOP) {
		float wrapped = (float)wrap(time_s, duration_s);

		return wrapped < duration_s ? wrapped : 0;
	}
	if (repeat == CLIP_PING_PONG) {
		double there_and_back_s = 2.0 * duration_s;
		double phase_s = wrap(time_s, there_and_back_s);

		return (float)(phase_s <= duration_s
				? phase_s
				: there_and_back_s - phase_s);
	}
	if (time_s > (double)duration_s) {
		return duration_s;
	}
	return time_s > 0 ? (float)time_s : 0;
}
