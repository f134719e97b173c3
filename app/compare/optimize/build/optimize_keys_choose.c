#include "app/compare/optimize/build/optimize_keys.h"

#include "app/compare/optimize/optimize_hash.h"

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

/* Whether the channel moves a node on which nothing depends. */
static bool is_idle(const struct optimize_channel *channel)
{
	return channel->track.path != MODEL_WEIGHTS && channel->track.reach &&
		channel->track.reach->idle;
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

/* Finds channels with equal times by a hash of these. Arrays are [count]. */
struct groups {
	int *bucket; /* the last group whose times have this hash, or -1 */
	int *before; /* by group: the one before it in its bucket, or -1 */
	int *next;   /* by channel: the next one of its group, or -1 */
	int *last;   /* by group: its last channel */
	const struct optimize_track **track; /* room for those of a group */
};

static int begin_groups(struct groups *groups, int count)
{
	size_t size = (size_t)count + 1;

	*groups = (struct groups){
		.bucket = malloc(size * sizeof(int)),
		.before = malloc(size * sizeof(int)),
		.next = malloc(size * sizeof(int)),
		.last = malloc(size * sizeof(int)),
		.track = malloc(size * sizeof(*groups->track)),
	};
	if (!groups->bucket || !groups->before || !groups->next ||
		!groups->last || !groups->track) {
		return -ENOMEM;
	}
	memset(groups->bucket, 0xFF, size * sizeof(int));
	return 0;
}

static void end_groups(struct groups *groups)
{
	free(groups->bucket);
	free(groups->before);
	free(groups->next);
	free(groups->last);
	free(groups->track);
}

/* Sets the channel's group: the first reducible channel with the same times. */
static void find_group(
	struct optimize_keys *keys, struct groups *groups, int index)
{
	struct optimize_channel *channel = &keys->channel[index];
	uint64_t hash;
	int *bucket;
	int group;

	channel->group = -1;
	if (channel->constant || channel->dropped || !can_reduce(channel)) {
		return;
	}
	hash = optimize_hash(optimize_hash_empty, channel->time_s,
		(size_t)channel->track.key_count * sizeof(float));
	bucket = &groups->bucket[hash % (uint64_t)keys->count];
	group = *bucket;
	while (group >= 0 && !has_same_times(&keys->channel[group], channel)) {
		group = groups->before[group];
	}
	if (group < 0) {
		group = index;
		groups->before[group] = *bucket;
		*bucket = group;
	} else {
		groups->next[groups->last[group]] = index;
	}
	groups->next[index] = -1;
	groups->last[group] = index;
	channel->group = group;
}

/*
 * Makes channels of a group use the shared keys, unless their own keys and
 * times, which are fewer, take fewer bytes.
 */
static void share_keys(struct optimize_keys *keys, const struct groups *groups,
	int group, const int *kept, int count)
{
	for (int i = group; i >= 0; i = groups->next[i]) {
		struct optimize_channel *channel = &keys->channel[i];
		size_t value = channel->track.path == MODEL_ROTATION
			? 8
			: (size_t)channel->track.width * 4;
		size_t own = (size_t)channel->kept_count * (value + 4) +
			TIMES_JSON_BYTES;

		if (own >= (size_t)count * value) {
			memcpy(channel->kept, kept,
				(size_t)count * sizeof(*kept));
			channel->kept_count = count;
		}
	}
}

static int reduce_group(
	struct optimize_keys *keys, const struct groups *groups, int group)
{
	int *kept = malloc(
		(size_t)keys->channel[group].track.key_count * sizeof(*kept));
	int count = 0;

	if (!kept) {
		return -ENOMEM;
	}
	for (int i = group; i >= 0; i = groups->next[i]) {
		groups->track[count++] = &keys->channel[i].track;
	}
	share_keys(keys, groups, group, kept,
		optimize_track_reduce(groups->track, count, kept));
	free(kept);
	return 0;
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
	struct groups groups;
	int error = begin_groups(&groups, keys->count);

	for (int i = 0; i < keys->count && !error; i++) {
		struct optimize_channel *channel = &keys->channel[i];

		channel->dropped = !*moved_at((bool *)moved, channel);
		channel->constant = is_idle(channel) ||
			(channel->track.reach &&
				optimize_track_is_constant(&channel->track));
		error = reduce_alone(channel);
		if (channel->constant) {
			channel->kept_count = 1;
		}
		find_group(keys, &groups, i);
	}
	for (int i = 0; i < keys->count && !error; i++) {
		if (keys->channel[i].group == i) {
			error = reduce_group(keys, &groups, i);
		}
	}
	end_groups(&groups);
	keep_end(keys);
	return error;
}

void optimize_keys_find_moved(const struct optimize_keys *keys, bool *moved)
{
	for (int c = 0; c < keys->count; c++) {
		const struct optimize_channel *channel = &keys->channel[c];

		if (!is_idle(channel) && !rests(keys, channel)) {
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
