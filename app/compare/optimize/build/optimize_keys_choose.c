#include "app/compare/optimize/build/optimize_keys.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	/* About the JSON text of one more accessor of times. */
	TIMES_JSON_BYTES = 110
};

/* Reads the node's rest value of the path. False if the node has a matrix. */
static bool read_rest(const struct optimize_keys *keys,
	const struct optimize_channel *channel, float rest[4])
{
	const json_t *node =
		json_array_get(json_object_get(keys->build->root, "nodes"),
			(size_t)json_integer_value(
				json_object_get(channel->target, "node")));
	const json_t *value =
		json_object_get(node, optimize_path_name[channel->track.path]);

	for (int i = 0; i < 4; i++) {
		rest[i] = value ? (float)json_number_value(
					  json_array_get(value, (size_t)i))
			: channel->track.path == MODEL_SCALE || i == 3 ? 1.0f
								       : 0.0f;
	}
	if (channel->track.path == MODEL_TRANSLATION) {
		rest[3] = 0.0f;
	}
	return node && !json_object_get(node, "matrix");
}

/* Whether the channel stays at the rest value, so that it can be left out. */
static bool rests(const struct optimize_keys *keys,
	const struct optimize_channel *channel)
{
	float rest[4];

	return channel->track.path != MODEL_WEIGHTS && channel->track.reach &&
		optimize_track_is_constant(&channel->track) &&
		read_rest(keys, channel, rest) &&
		optimize_track_is_near(&channel->track,
			optimize_track_value(&channel->track, 0), rest);
}

static bool *moved_at(bool *moved, const struct optimize_channel *channel)
{
	return &moved[4 *
			(size_t)json_integer_value(
				json_object_get(channel->target, "node")) +
		(size_t)channel->track.path];
}

static int keep_all(struct optimize_channel *channel)
{
	channel->kept_count = channel->track.key_count;
	channel->kept =
		malloc((size_t)channel->kept_count * sizeof(*channel->kept));
	for (int k = 0; channel->kept && k < channel->kept_count; k++) {
		channel->kept[k] = k;
	}
	return channel->kept ? 0 : -ENOMEM;
}

static bool can_reduce(const struct optimize_channel *channel)
{
	return channel->track.interpolation != MODEL_CUBICSPLINE &&
		channel->track.reach && channel->track.key_count > 1;
}

static int reduce_alone(struct optimize_channel *channel)
{
	const struct optimize_track *track = &channel->track;
	int error = keep_all(channel);

	if (!error && can_reduce(channel) && !channel->constant) {
		channel->kept_count =
			optimize_track_reduce(&track, 1, channel->kept);
	}
	return error;
}

static bool has_same_times(
	const struct optimize_channel *a, const struct optimize_channel *b)
{
	return a->track.key_count == b->track.key_count &&
		a->track.interpolation == b->track.interpolation &&
		memcmp(a->time_s, b->time_s,
			(size_t)a->track.key_count * sizeof(float)) == 0;
}

/* Sets the channel's group: the first reducible channel with the same times. */
static void find_group(struct optimize_keys *keys, int index)
{
	struct optimize_channel *channel = &keys->channel[index];

	channel->group = -1;
	if (channel->constant || channel->dropped || !can_reduce(channel)) {
		return;
	}
	channel->group = index;
	for (int i = 0; i < index; i++) {
		if (keys->channel[i].group == i &&
			has_same_times(&keys->channel[i], channel)) {
			channel->group = i;
			return;
		}
	}
}

/*
 * Makes channels of a group use the shared keys, unless their own keys and
 * times, which are fewer, take fewer bytes.
 */
static void share_keys(
	struct optimize_keys *keys, int group, const int *kept, int count)
{
	for (int i = group; i < keys->count; i++) {
		struct optimize_channel *channel = &keys->channel[i];
		size_t value = channel->track.path == MODEL_ROTATION
			? 8
			: (size_t)channel->track.width * 4;
		size_t own = (size_t)channel->kept_count * (value + 4) +
			TIMES_JSON_BYTES;

		if (channel->group == group && own >= (size_t)count * value) {
			memcpy(channel->kept, kept,
				(size_t)count * sizeof(*kept));
			channel->kept_count = count;
		}
	}
}

static int reduce_group(struct optimize_keys *keys, int group)
{
	const struct optimize_track **track =
		malloc((size_t)keys->count * sizeof(*track));
	int *kept = malloc(
		(size_t)keys->channel[group].track.key_count * sizeof(*kept));
	int count = 0, error = -ENOMEM;

	if (track && kept) {
		for (int i = group; i < keys->count; i++) {
			if (keys->channel[i].group == group) {
				track[count++] = &keys->channel[i].track;
			}
		}
		share_keys(keys, group, kept,
			optimize_track_reduce(track, count, kept));
		error = 0;
	}
	free(track);
	free(kept);
	return error;
}

/*
 * A clip lasts to its last key, so one channel must keep a key there: one that
 * moves until then or, if there is none, a constant channel. If possible, that
 * is one which stays anyway and ends there already: then another run chooses it
 * again.
 */
static void keep_end(struct optimize_keys *keys)
{
	struct optimize_channel *pin = NULL;
	int best = 0;

	for (int i = 0; i < keys->count; i++) {
		struct optimize_channel *channel = &keys->channel[i];
		bool at_end = channel->time_s[channel->track.key_count - 1] ==
			keys->end_s;
		int rank = 1 + 2 * !channel->dropped + at_end;

		if (!channel->constant && !channel->dropped && at_end) {
			return;
		}
		if (channel->constant && rank > best) {
			pin = channel;
			best = rank;
		}
	}
	if (!pin) {
		return;
	}
	pin->dropped = false;
	pin->ends = true;
	if (keys->end_s > 0.0f && pin->track.key_count > 1) {
		pin->kept_count = 2;
	}
}

int optimize_keys_choose(struct optimize_keys *keys, const bool *moved)
{
	int error = 0;

	for (int i = 0; i < keys->count && !error; i++) {
		struct optimize_channel *channel = &keys->channel[i];

		channel->dropped = !*moved_at((bool *)moved, channel);
		channel->constant = channel->track.reach &&
			optimize_track_is_constant(&channel->track);
		error = reduce_alone(channel);
		if (channel->constant) {
			channel->kept_count = 1;
		}
		find_group(keys, i);
	}
	for (int i = 0; i < keys->count && !error; i++) {
		if (keys->channel[i].group == i) {
			error = reduce_group(keys, i);
		}
	}
	keep_end(keys);
	return error;
}

void optimize_keys_find_moved(const struct optimize_keys *keys, bool *moved)
{
	for (int c = 0; c < keys->count; c++) {
		const struct optimize_channel *channel = &keys->channel[c];

		if (!rests(keys, channel)) {
			*moved_at(moved, channel) = true;
		}
	}
}

int optimize_keys_keep_all(struct optimize_keys *keys)
{
	int error = 0;

	for (int c = 0; c < keys->count && !error; c++) {
		error = keep_all(&keys->channel[c]);
	}
	return error;
}
