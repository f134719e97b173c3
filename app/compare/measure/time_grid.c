#include "app/compare/measure/time_grid.h"

#include <errno.h>
#include <stdlib.h>

static const float gap_most_s = 1.0f / 60.0f;
static const float gap_least_s = 1.0f / 80.0f;
static const float before_step_s = 1e-4f;
static const float longest_s = 18000.0f;

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

/* Returns the number of times: those within the clip, and its two ends. */
static size_t collect(const struct model_clip *clip, float *time_s)
{
	size_t count = 0;

	time_s[count++] = 0.0f;
	time_s[count++] = clip->duration_s;
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		for (int k = 0; !channel->constant && k < channel->key_count;
			k++) {
			float at = channel->time_s[k];

			if (at > 0.0f && at < clip->duration_s) {
				time_s[count++] = at;
			}
			at -= before_step_s;
			if (channel->interpolation == MODEL_STEP && at > 0.0f &&
				at < clip->duration_s) {
				time_s[count++] = at;
			}
		}
	}
	qsort(time_s, count, sizeof(*time_s), compare_times);
	return count;
}

/*
 * Leaves out keys too close to the one before, but not the moment before a
 * jump, which is closer to the jump than to anything else.
 */
static size_t thin_out(float *time_s, size_t count)
{
	float end_s = time_s[count - 1];
	size_t kept = 1;

	for (size_t i = 1; i + 1 < count; i++) {
		float gap_s = time_s[i] - time_s[kept - 1];
		bool jump = gap_s > 0.5f * before_step_s &&
			gap_s < 2.0f * before_step_s;

		if ((gap_s >= gap_least_s || jump) &&
			end_s - time_s[i] > 0.5f * before_step_s) {
			time_s[kept++] = time_s[i];
		}
	}
	time_s[kept++] = end_s;
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
	out->count = 0;
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
	float *time_s;
	size_t count;
	int error;

	*out = (struct time_grid){0};
	if (clip->duration_s > longest_s) {
		return -E2BIG;
	}
	time_s = malloc(count_keys(clip) * sizeof(*time_s));
	if (!time_s) {
		return -ENOMEM;
	}
	count = thin_out(time_s, collect(clip, time_s));
	error = fill(time_s, count, out);
	free(time_s);
	return error;
}

void time_grid_release(struct time_grid *grid)
{
	free(grid->time_s);
	*grid = (struct time_grid){0};
}
