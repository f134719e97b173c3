#include "app/model/model_deltas.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	GAP_MAX = 1 /* as many unmoved vertices in a row do not end a span */
};

static size_t value_bytes(enum model_number number)
{
	return number == MODEL_FLOAT    ? sizeof(float[3])
		: number == MODEL_INT16 ? sizeof(int16_t[3])
					: sizeof(int8_t[3]);
}

struct model_deltas model_deltas_view(const float (*value)[3], int vertex_count)
{
	return (struct model_deltas){
		.vertex_count = vertex_count, .unit = 1.0f, .value = value};
}

static bool moves(const float value[3])
{
	return value[0] != 0.0f || value[1] != 0.0f || value[2] != 0.0f;
}

/* Finds the next span from a vertex on; its count is 0 if there is none. */
static struct model_span next_span(
	const float (*value)[3], int vertex_count, int from)
{
	struct model_span span = {.first = from};

	for (int v = from; v < vertex_count; v++) {
		if (moves(value[v])) {
			span.first = span.count ? span.first : v;
			span.count = v - span.first + 1;
		} else if (span.count &&
			v > span.first + span.count + GAP_MAX - 1) {
			break;
		}
	}
	return span;
}

/*
 * Returns the number of spans and sets *stored to that of their vertices.
 * Writes the spans too, unless list is NULL.
 */
static int find_spans(const float (*value)[3], int vertex_count,
	struct model_span *list, int *stored)
{
	struct model_span span = {0};
	int count = 0;

	*stored = 0;
	for (;; count++) {
		span = next_span(value, vertex_count, span.first + span.count);
		if (span.count == 0) {
			return count;
		}
		span.at = *stored;
		*stored += span.count;
		if (list) {
			list[count] = span;
		}
	}
}

static int rounded(float value)
{
	return (int)(value + (value < 0.0f ? -0.5f : 0.5f));
}

static void put(enum model_number number, float unit, const float value[3],
	void *out, size_t at)
{
	for (size_t k = 0; k < 3; k++) {
		size_t i = at * 3 + k;

		if (number == MODEL_FLOAT) {
			((float *)out)[i] = value[k];
		} else if (number == MODEL_INT16) {
			((int16_t *)out)[i] = (int16_t)rounded(value[k] * unit);
		} else {
			((int8_t *)out)[i] = (int8_t)rounded(value[k] * unit);
		}
	}
}

int model_deltas_pack(struct model_deltas *deltas, const float (*value)[3],
	int vertex_count, enum model_number number, float unit,
	struct arena *arena)
{
	int stored;
	int span_count = find_spans(value, vertex_count, NULL, &stored);
	size_t each = value_bytes(number);
	bool sparse = (size_t)stored * each +
			(size_t)span_count * sizeof(struct model_span) <
		(size_t)vertex_count * each;
	struct model_span *span = NULL;
	void *out;

	if (sparse) {
		span = ARENA_ARRAY(arena, struct model_span, (size_t)span_count);
	}
	out = arena_alloc(arena, (size_t)(sparse ? stored : vertex_count), each);
	if (!out || (sparse && !span)) {
		return -ENOMEM;
	}
	if (sparse) {
		find_spans(value, vertex_count, span, &stored);
	}
	for (int s = 0; s < (sparse ? span_count : 1); s++) {
		struct model_span all = {.count = vertex_count};
		struct model_span of = sparse ? span[s] : all;

		for (int i = 0; i < of.count; i++) {
			put(number, unit, value[of.first + i], out,
				(size_t)(of.at + i));
		}
	}
	*deltas = (struct model_deltas){
		.vertex_count = vertex_count,
		.number = number,
		.unit = unit,
		.span_count = sparse ? span_count : 0,
		.span = span,
		.value = out,
	};
	return 0;
}

int model_deltas_copy(struct model_deltas *out, const struct model_deltas *from,
	struct arena *arena)
{
	size_t values = (size_t)model_deltas_count(from);
	size_t each = value_bytes(from->number);
	void *value = arena_alloc(arena, values, each);
	struct model_span *span =
		ARENA_ARRAY(arena, struct model_span, (size_t)from->span_count);

	if (!value || !span) {
		return -ENOMEM;
	}
	*out = *from;
	if (values > 0) {
		out->value = memcpy(value, from->value, values * each);
	}
	if (from->span) {
		memcpy(span, from->span,
			(size_t)from->span_count * sizeof(*span));
		out->span = span;
	}
	return 0;
}

/* Reads the integers of stored value `at`, less base unless it is NULL. */
static void get_numbers(const struct model_deltas *deltas, size_t at,
	const int16_t base[3], int out[3])
{
	const int16_t *shorts = (const int16_t *)deltas->value + at * 3;
	const int8_t *bytes = (const int8_t *)deltas->value + at * 3;

	for (int k = 0; k < 3; k++) {
		out[k] = deltas->number == MODEL_INT16 ? shorts[k] : bytes[k];
		out[k] -= base ? base[k] : 0;
	}
}

/* The same as floats. */
static void get(const struct model_deltas *deltas, size_t at,
	const int16_t base[3], float out[3])
{
	int number[3];

	if (deltas->number == MODEL_FLOAT) {
		memcpy(out, (const float *)deltas->value + at * 3,
			sizeof(float[3]));
		return;
	}
	get_numbers(deltas, at, base, number);
	for (int k = 0; k < 3; k++) {
		out[k] = (float)number[k];
		if (deltas->unit != 1.0f) {
			out[k] /= deltas->unit;
		}
	}
}

static const int16_t *base_of(const struct model_deltas *deltas, int vertex)
{
	return deltas->base ? deltas->base[vertex] : NULL;
}

/* Returns the index of a vertex's stored value, or -1. */
static int find(const struct model_deltas *deltas, int vertex)
{
	const struct model_span *span = deltas->span;
	int low = 0, high = deltas->span_count;

	if (!span) {
		return vertex < deltas->vertex_count ? vertex : -1;
	}
	while (high - low > 1) {
		int middle = (low + high) / 2;

		if (span[middle].first <= vertex) {
			low = middle;
		} else {
			high = middle;
		}
	}
	if (low == high || vertex < span[low].first ||
		vertex >= span[low].first + span[low].count) {
		return -1;
	}
	return span[low].at + vertex - span[low].first;
}

void model_deltas_get(
	const struct model_deltas *deltas, int vertex, float out[3])
{
	int at = find(deltas, vertex);

	if (at < 0) {
		memset(out, 0, sizeof(float[3]));
	} else {
		get(deltas, (size_t)at, base_of(deltas, vertex), out);
	}
}

void model_deltas_numbers(
	const struct model_deltas *deltas, int vertex, int out[3])
{
	int at = find(deltas, vertex);

	if (at < 0) {
		memset(out, 0, sizeof(int[3]));
	} else {
		get_numbers(deltas, (size_t)at, base_of(deltas, vertex), out);
	}
}

bool model_deltas_moves(const struct model_deltas *deltas, int vertex)
{
	float moved[3];
	int number[3];

	if (deltas->number == MODEL_FLOAT) {
		model_deltas_get(deltas, vertex, moved);
		return moves(moved);
	}
	model_deltas_numbers(deltas, vertex, number);
	return number[0] || number[1] || number[2];
}

void model_deltas_unpack(
	const struct model_deltas *deltas, int vertex_count, float (*out)[3])
{
	if (deltas->vertex_count > 0 && !deltas->span) {
		for (int v = 0; v < vertex_count; v++) {
			get(deltas, (size_t)v, base_of(deltas, v), out[v]);
		}
		return;
	}
	memset(out, 0, (size_t)vertex_count * sizeof(*out));
	for (int s = 0; s < deltas->span_count; s++) {
		const struct model_span *span = &deltas->span[s];

		for (int i = 0; i < span->count; i++) {
			get(deltas, (size_t)(span->at + i), NULL,
				out[span->first + i]);
		}
	}
}

int model_deltas_floats(const struct model_deltas *deltas, struct arena *arena,
	const float (**out)[3])
{
	float(*copy)[3];

	*out = NULL;
	if (deltas->vertex_count == 0) {
		return 0;
	}
	if (deltas->number == MODEL_FLOAT && !deltas->span) {
		*out = deltas->value;
		return 0;
	}
	copy = arena_alloc(arena, (size_t)deltas->vertex_count, sizeof(*copy));
	if (!copy) {
		return -ENOMEM;
	}
	model_deltas_unpack(deltas, deltas->vertex_count, copy);
	*out = (const float(*)[3])copy;
	return 0;
}

int model_deltas_count(const struct model_deltas *deltas)
{
	const struct model_span *last;

	if (!deltas->span) {
		return deltas->vertex_count;
	}
	if (deltas->span_count == 0) {
		return 0;
	}
	last = &deltas->span[deltas->span_count - 1];
	return last->at + last->count;
}

size_t model_deltas_bytes(const struct model_deltas *deltas)
{
	return (size_t)model_deltas_count(deltas) * value_bytes(deltas->number) +
		(size_t)deltas->span_count * sizeof(*deltas->span);
}
