#include "app/compare/optimize/optimize_known.h"

#include "app/compare/optimize/optimize_hash.h"

static void add_bytes(uint64_t *stamp, const void *bytes, size_t size)
{
	*stamp = optimize_hash(*stamp, bytes, size);
}

static void add_channel(uint64_t *stamp, const struct model_channel *channel)
{
	const int numbers[] = {channel->node, (int)channel->path,
		(int)channel->interpolation, channel->constant, channel->unit,
		channel->width, channel->key_count, channel->packed != NULL};
	size_t keys = (size_t)channel->key_count;
	size_t values = keys * (size_t)channel->width *
		(channel->interpolation == MODEL_CUBICSPLINE ? 3 : 1);

	add_bytes(stamp, numbers, sizeof(numbers));
	add_bytes(stamp, channel->time_s, keys * sizeof(float));
	if (channel->packed) {
		add_bytes(stamp, channel->packed,
			keys * sizeof(*channel->packed));
	} else {
		add_bytes(stamp, channel->value, values * sizeof(float));
	}
}

uint64_t optimize_known_stamp(const struct model *model, int clip)
{
	uint64_t stamp = optimize_hash_empty;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];

		add_bytes(&stamp, &node->rest, sizeof(node->rest));
		if (node->matrix) {
			add_bytes(&stamp, node->matrix, sizeof(mat4));
		}
	}
	if (clip >= 0) {
		const struct model_clip *played = &model->clip[clip];

		add_bytes(&stamp, &played->duration_s, sizeof(float));
		for (int i = 0; i < played->channel_count; i++) {
			add_channel(&stamp, &played->channel[i]);
		}
	}
	return stamp;
}

bool optimize_known_find(
	const struct optimize_known *known, uint64_t stamp, float *peak_px)
{
	for (int i = 0; i < known->count; i++) {
		if (known->stamp[i] == stamp) {
			*peak_px = known->peak_px[i];
			return true;
		}
	}
	return false;
}

void optimize_known_add(
	struct optimize_known *known, uint64_t stamp, float peak_px)
{
	int at = known->count < OPTIMIZE_KNOWN_MAX ? known->count++
						   : OPTIMIZE_KNOWN_MAX - 1;

	known->stamp[at] = stamp;
	known->peak_px[at] = peak_px;
}
