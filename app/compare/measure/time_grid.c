#include "app/compare/measure/time_grid.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const float gap_most_s = 1.0f / 60.0f;
static const float gap_least_s = 1.0f / 80.0f;
static const float longest_s = 18000.0f;

struct moment {
	float time_s;
	bool jump; /* a value changes at once here */
};

/* Compares times, or moments, which begin with theirs. */
static int compare_times(const void *a, const void *b)
{
	float x = *(const float *)a, y = *(const float *)b;

	return (x > y) - (x < y);
}

static size_t count_keys(const struct model_clip *clip)
{
	size_t count = 2;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (!channel->constant) {
			count += (size_t)channel->key_count *
				(channel->interpolation == MODEL_STEP ? 2 : 1);
		}
	}
	return count;
}

/*
 * Collects a channel's key times. A key at which the value jumps gives two
 * moments: its time and the last float below that.
 */
static size_t collect_channel(const struct model_channel *channel,
	float duration_s, struct moment *moment)
{
	bool jump = channel->interpolation == MODEL_STEP;
	size_t count = 0;

	for (int k = 0; k < channel->key_count; k++) {
		float at = channel->time_s[k];

		if (at > 0.0f &&
			(at < duration_s || (jump && at == duration_s))) {
			moment[count++] = (struct moment){at, jump};
			if (jump) {
				moment[count++] = (struct moment){
					nextafterf(at, 0.0f), true};
			}
		}
	}
	return count;
}

/*
 * Collects and sorts the moments: keys within the clip, and its two ends.
 * Returns their number.
 */
static size_t collect(const struct model_clip *clip, struct moment *moment)
{
	size_t count = 0;

	moment[count++] = (struct moment){0.0f, true};
	moment[count++] = (struct moment){clip->duration_s, true};
	for (int i = 0; i < clip->channel_count; i++) {
		if (!clip->channel[i].constant) {
			count += collect_channel(&clip->channel[i],
				clip->duration_s, moment + count);
		}
	}
	qsort(moment, count, sizeof(*moment), compare_times);
	return count;
}

/* Drops moments too close to the one before, unless a value jumps there. */
static size_t thin_out(const struct moment *moment, size_t count, float *time_s)
{
	size_t kept = 1;

	time_s[0] = moment[0].time_s;
	for (size_t i = 1; i < count; i++) {
		float gap_s = moment[i].time_s - time_s[kept - 1];

		if (gap_s >= gap_least_s || (moment[i].jump && gap_s > 0.0f)) {
			time_s[kept++] = moment[i].time_s;
		}
	}
	return kept;
}

static int pieces_of(float gap_s)
{
	return (int)(gap_s / gap_most_s - 1e-3f) + 1;
}

static int fill(const float *time_s, size_t count, struct time_grid *out)
{
	size_t total = 1;

	for (size_t i = 1; i < count; i++) {
		total += (size_t)pieces_of(time_s[i] - time_s[i - 1]);
	}
	out->time_s = malloc(total * sizeof(*out->time_s));
	if (!out->time_s) {
		return -ENOMEM;
	}
	out->time_s[out->count++] = time_s[0];
	for (size_t i = 1; i < count; i++) {
		float from = time_s[i - 1], to = time_s[i];
		int pieces = pieces_of(to - from);

		for (int p = 1; p < pieces; p++) {
			out->time_s[out->count++] =
				from + (to - from) * (float)p / (float)pieces;
		}
		out->time_s[out->count++] = to;
	}
	return 0;
}

int time_grid_make(const struct model_clip *clip, struct time_grid *out)
{
	struct moment *moment;
	float *time_s;
	size_t count;
	int error = -ENOMEM;

	*out = (struct time_grid){0};
	if (clip->duration_s > longest_s) {
		return -E2BIG;
	}
	count = count_keys(clip);
	moment = malloc(count * sizeof(*moment));
	time_s = malloc(count * sizeof(*time_s));
	if (moment && time_s) {
		count = collect(clip, moment);
		error = fill(time_s, thin_out(moment, count, time_s), out);
	}
	free(moment);
	free(time_s);
	return error;
}

int time_grid_add(struct time_grid *grid, const float *time_s, int count)
{
	size_t total = (size_t)grid->count + (size_t)count;
	float *all = realloc(grid->time_s, total * sizeof(*all));
	int kept = 1;

	if (!all) {
		return -ENOMEM;
	}
	grid->time_s = all;
	memcpy(all + grid->count, time_s, (size_t)count * sizeof(*all));
	qsort(all, total, sizeof(*all), compare_times);
	for (size_t i = 1; i < total; i++) {
		if (all[i] > all[kept - 1]) {
			all[kept++] = all[i];
		}
	}
	grid->count = kept;
	return 0;
}

/*
 * Of each run of intervals one is kept. Its place in the run changes by the
 * golden ratio, so that a motion that repeats is not met at one phase alone.
 */
void time_grid_thin(struct time_grid *grid, double share)
{
	static const double golden = 0.6180339887498949;
	int intervals = grid->count - 1, kept = 1, last = 0;
	int runs = scalar_to_int(0.5 * share * intervals, 1, intervals);
	double phase = 0.5;

	for (int run = 0; run < runs; run++) {
		int at = (int)(((double)run + phase) * intervals / runs);

		for (int i = at > last ? at : last + 1; i <= at + 1; i++) {
			grid->time_s[kept++] = grid->time_s[i];
			last = i;
		}
		phase += golden;
		phase -= phase >= 1.0 ? 1.0 : 0.0;
	}
	if (last < intervals) {
		grid->time_s[kept++] = grid->time_s[intervals];
	}
	grid->count = kept;
	grid->thinned = true;
}

bool time_grid_is_gap(const struct time_grid *grid, int i)
{
	return grid->thinned &&
		grid->time_s[i + 1] - grid->time_s[i] > 1.25f * gap_most_s;
}

void time_grid_release(struct time_grid *grid)
{
	free(grid->time_s);
	*grid = (struct time_grid){0};
}
