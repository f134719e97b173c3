#include "app/anim/kernel/run/fixed_morph_run.h"

#include "app/anim/kernel/fixed_number.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	LIMIT_MAX = 1024
};

/*
 * Converts a target's weight. With |weight| <= weight_limit the number is at
 * most 2 * 16383, since the largest delta times unit_at_1 is at most 16383.
 */
static int16_t weight_number(const struct fixed_morph *morph,
	const struct fixed_deltas *deltas, const float *weight, int target,
	float unit)
{
	return target < morph->target_count
		? fixed_round(weight[target] * deltas->scale[target & 1] * unit)
		: 0;
}

int fixed_morph_set_weights(struct fixed_morph *morph, const float *weight)
{
	float limit = morph->weight_limit;

	for (int t = 0; t < morph->target_count; t++) {
		if (!(scalar_abs(weight[t]) <= LIMIT_MAX)) {
			return -ERANGE;
		}
		while (scalar_abs(weight[t]) > limit) {
			limit *= 2.0f;
		}
	}
	if (limit > morph->weight_limit) {
		fixed_morph_set_limit(morph, limit);
	}
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		struct fixed_morph_stream *stream = &morph->stream[a];

		for (int p = 0; stream->base && p < morph->pair_count; p++) {
			struct fixed_deltas *deltas = &stream->deltas[p];

			deltas->weights.a = weight_number(
				morph, deltas, weight, 2 * p, stream->unit);
			deltas->weights.b = weight_number(
				morph, deltas, weight, 2 * p + 1, stream->unit);
		}
	}
	return 0;
}

static void copy(const struct fixed_vector *from, int first, int end,
	struct fixed_vector *to)
{
	if (end > first) {
		memcpy(to + first, from + first,
			(size_t)(end - first) * sizeof(*to));
	}
}

/*
 * For a frame with a single active pair: adds it in one pass and copies the
 * vertices between its spans.
 */
static void run_one(const struct fixed_morph *morph,
	const struct fixed_loops *loops, const struct fixed_vector *base,
	const struct fixed_deltas *deltas, struct fixed_vector *out)
{
	int done = 0;

	for (int i = 0; i < deltas->span_count; i++) {
		const struct fixed_span *span = &deltas->span[i];

		copy(base, done, span->first, out);
		loops->morph_pair(span->count, base + span->first,
			(const struct fixed_pair(*)[3])deltas->pair +
				span->first_pair,
			deltas->weights, out + span->first);
		done = span->first + span->count;
	}
	copy(base, done, morph->vertex_count, out);
}

/* Adds a pair's deltas for the vertices from first to first + count - 1. */
static void add_within(const struct fixed_loops *loops,
	const struct fixed_deltas *deltas, int first, int count,
	struct fixed_sum *sum)
{
	int steps = 0;

	for (int i = fixed_deltas_find(deltas, first, &steps);
		i < deltas->span_count && deltas->span[i].first < first + count;
		i++) {
		const struct fixed_span *span = &deltas->span[i];
		int from = span->first > first ? span->first : first;
		int to = span->first + span->count;

		to = to < first + count ? to : first + count;
		loops->morph_add(to - from,
			(const struct fixed_pair(*)[3])deltas->pair +
				span->first_pair + from - span->first,
			deltas->weights, sum + from - first);
	}
}

static void run_many(const struct fixed_morph *morph,
	const struct fixed_loops *loops,
	const struct fixed_morph_stream *stream, struct fixed_vector *out)
{
	struct fixed_sum sum[FIXED_MORPH_CHUNK];

	for (int first = 0; first < morph->vertex_count;
		first += FIXED_MORPH_CHUNK) {
		int left = morph->vertex_count - first;
		int count = left < FIXED_MORPH_CHUNK ? left : FIXED_MORPH_CHUNK;

		loops->morph_begin(count, stream->base + first, sum);
		for (int p = 0; p < morph->pair_count; p++) {
			if (fixed_deltas_active(&stream->deltas[p])) {
				add_within(loops, &stream->deltas[p], first,
					count, sum);
			}
		}
		loops->morph_end(count, sum, out + first);
	}
}

void fixed_morph_run(const struct fixed_morph *morph,
	const struct fixed_loops *loops, enum fixed_attribute attribute,
	struct fixed_vector *out)
{
	const struct fixed_morph_stream *stream = &morph->stream[attribute];
	const struct fixed_deltas *only = NULL;
	int active = 0;

	for (int p = 0; p < morph->pair_count; p++) {
		if (fixed_deltas_active(&stream->deltas[p])) {
			only = &stream->deltas[p];
			active++;
		}
	}
	if (active == 0) {
		copy(stream->base, 0, morph->vertex_count, out);
	} else if (active == 1) {
		run_one(morph, loops, stream->base, only, out);
	} else {
		run_many(morph, loops, stream, out);
	}
}
