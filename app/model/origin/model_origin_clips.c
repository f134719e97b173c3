#include "app/model/origin/model_origin.h"

#include <errno.h>
#include <string.h>

/* Says what the clips do to the nodes, for model_origin_find(). */
static void scan_clip(const struct model *model, const struct model_clip *clip,
	bool *turned, bool *started, float (*start)[3])
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		int n = channel->node;

		if (channel->path != MODEL_TRANSLATION) {
			turned[n] = true;
		} else if (model->node[n].parent < 0 && !started[n]) {
			started[n] = true;
			memcpy(start[n], channel->value, sizeof(start[n]));
		}
	}
}

static int shift_clip(struct model *model, const struct model_clip *clip,
	const double (*shift)[3])
{
	for (int i = 0; i < clip->channel_count; i++) {
		struct model_channel *channel = &clip->channel[i];
		size_t count = 3 * (size_t)channel->key_count;
		float *value;

		if (channel->path != MODEL_TRANSLATION) {
			continue;
		}
		value = ARENA_ARRAY(&model->arena, float, count);
		if (!value) {
			return -ENOMEM;
		}
		memcpy(value, channel->value, count * sizeof(*value));
		model_origin_shift_keys(shift[channel->node], channel, value);
		channel->value = value;
	}
	return 0;
}

int model_origin_move(struct model *model, struct arena *arena)
{
	size_t count = (size_t)model->node_count;
	bool *turned = ARENA_ARRAY(arena, bool, count);
	bool *started = ARENA_ARRAY(arena, bool, count);
	float(*start)[3] = arena_alloc(arena, count, sizeof(*start));
	double(*shift)[3];
	int error;

	if (!turned || !started || !start) {
		return -ENOMEM;
	}
	for (size_t n = 0; n < count; n++) {
		memcpy(start[n], model->node[n].rest.translation,
			sizeof(start[n]));
	}
	for (int i = 0; i < model->clip_count; i++) {
		scan_clip(model, &model->clip[i], turned, started, start);
	}
	error = model_origin_find(
		model, turned, (const float(*)[3])start, arena, &shift);
	for (int i = 0; i < model->clip_count && shift && !error; i++) {
		error = shift_clip(
			model, &model->clip[i], (const double(*)[3])shift);
	}
	return error;
}
