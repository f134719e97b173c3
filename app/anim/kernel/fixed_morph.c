#include "app/anim/kernel/fixed_morph.h"

#include "app/anim/kernel/fixed_number.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	GAP_MAX = 3, /* unmoved vertices that do not end a span */
	CHUNK = 256, /* vertices whose sums stay in L1 */
	REACH_MAX = 1024
};

/* An attribute's vertex, less what the middle of all is. */
static void base_of(const struct fixed_morph *morph,
	enum fixed_attribute attribute, int vertex, float out[3])
{
	const struct model_primitive *primitive = morph->primitive;
	const float *from = attribute == FIXED_POSITION
		? primitive->position[vertex]
		: attribute == FIXED_NORMAL ? primitive->normal[vertex]
					    : primitive->tangent[vertex];

	for (int k = 0; k < 3; k++) {
		out[k] = attribute == FIXED_POSITION
			? from[k] - morph->placement.offset[k]
			: from[k];
	}
}

/* A target's deltas, or NULL, which a pair's missing half has too. */
static const float (*deltas_of(const struct fixed_morph *morph,
	enum fixed_attribute attribute, int target))[3]
{
	const struct model_target *from;

	if (target >= morph->target_count) {
		return NULL;
	}
	from = &morph->primitive->target[target];
	return (const float(*)[3])(attribute == FIXED_POSITION ? from->position
			: attribute == FIXED_NORMAL            ? from->normal
							       : from->tangent);
}

static float largest_delta(const float (*delta)[3], int count)
{
	float most = 0.0f;

	for (int i = 0; delta && i < count * 3; i++) {
		float size = scalar_abs(delta[i / 3][i % 3]);

		most = size > most ? size : most;
	}
	return most;
}

static int find_middle(struct fixed_morph *morph)
{
	const struct model_primitive *primitive = morph->primitive;

	for (int k = 0; k < 3 && morph->vertex_count > 0; k++) {
		float low = primitive->position[0][k], high = low;

		for (int v = 0; v < morph->vertex_count; v++) {
			float at = primitive->position[v][k];

			if (!fixed_can_use(at)) {
				return -ERANGE;
			}
			low = at < low ? at : low;
			high = at > high ? at : high;
		}
		morph->placement.offset[k] = 0.5f * (low + high);
	}
	return 0;
}

/*
 * So that a vertex with all targets at weight 1 fits, and one target's weight
 * of 1 as well (see set_scales()).
 */
static int choose_unit(struct fixed_morph *morph, enum fixed_attribute attribute)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];
	float total = 1e-12f, single = 1e-12f;

	for (int v = 0; v < morph->vertex_count; v++) {
		float base[3];

		base_of(morph, attribute, v, base);
		for (int k = 0; k < 3; k++) {
			float sum = scalar_abs(base[k]);

			for (int t = 0; t < morph->target_count; t++) {
				const float(*delta)[3] =
					deltas_of(morph, attribute, t);

				sum += delta ? scalar_abs(delta[v][k]) : 0.0f;
			}
			if (!fixed_can_use(sum)) {
				return -ERANGE;
			}
			total = sum > total ? sum : total;
		}
	}
	for (int t = 0; t < morph->target_count; t++) {
		float size = largest_delta(
			deltas_of(morph, attribute, t), morph->vertex_count);

		single = size > single ? size : single;
	}
	stream->fits = 32600.0f / total;
	if (stream->fits > 16383.0f / single) {
		stream->fits = 16383.0f / single;
	}
	return 0;
}

/* One half of a pair, at 32767 for the largest. */
static int16_t delta_number(
	const float (*delta)[3], int vertex, int axis, float scale)
{
	return delta ? fixed_round(delta[vertex][axis] * scale) : 0;
}

/* Two targets while they are laid out. */
struct source {
	const float (*delta[2])[3];
	float scale[2];
};

static bool write_pair(
	const struct source *source, int vertex, struct fixed_pair out[3])
{
	bool moves = false;

	for (int k = 0; k < 3; k++) {
		out[k].a = delta_number(
			source->delta[0], vertex, k, source->scale[0]);
		out[k].b = delta_number(
			source->delta[1], vertex, k, source->scale[1]);
		moves = moves || out[k].a || out[k].b;
	}
	return moves;
}

/* The next span at or after a vertex; one of no length at the end. */
static struct fixed_span next_span(
	const struct source *source, int from, int vertex_count)
{
	struct fixed_span span = {.first = from};
	struct fixed_pair unused[3];
	int gap = 0;

	for (int v = from; v < vertex_count && gap <= GAP_MAX; v++) {
		if (write_pair(source, v, unused)) {
			span.first = span.count ? span.first : v;
			span.count = v - span.first + 1;
			gap = 0;
		} else if (span.count) {
			gap++;
		}
	}
	return span;
}

static int lay_out_pair(struct fixed_deltas *deltas,
	const struct source *source, int vertex_count, struct arena *arena)
{
	struct fixed_span span = next_span(source, 0, vertex_count);
	struct fixed_span *list;
	int vertices = 0;

	for (; span.count; deltas->span_count++) {
		vertices += span.count;
		span = next_span(source, span.first + span.count, vertex_count);
	}
	list = ARENA_ARRAY(arena, struct fixed_span, (size_t)deltas->span_count);
	deltas->pair =
		arena_alloc(arena, (size_t)vertices, sizeof(*deltas->pair));
	deltas->span = list;
	if (!list || !deltas->pair) {
		return -ENOMEM;
	}
	span = (struct fixed_span){0};
	for (int i = 0, at = 0; i < deltas->span_count; i++) {
		span = next_span(source, span.first + span.count, vertex_count);
		span.first_pair = at;
		list[i] = span;
		for (int v = 0; v < span.count; v++) {
			write_pair(source, span.first + v, deltas->pair[at++]);
		}
	}
	return 0;
}

static int lay_out_pairs(struct fixed_morph *morph,
	enum fixed_attribute attribute, struct arena *arena)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];

	for (int p = 0; p < morph->pair_count; p++) {
		struct source source;
		int error;

		for (int half = 0; half < 2; half++) {
			float size;

			source.delta[half] =
				deltas_of(morph, attribute, p * 2 + half);
			size = largest_delta(
				source.delta[half], morph->vertex_count);
			source.scale[half] =
				size > 1e-12f ? 32767.0f / size : 0.0f;
			stream->deltas[p].scale[half] =
				65536.0f * size / 32767.0f;
		}
		error = lay_out_pair(&stream->deltas[p], &source,
			morph->vertex_count, arena);
		if (error) {
			return error;
		}
	}
	return 0;
}

/* Base vectors in the unit that the reach leaves. */
static void write_base(struct fixed_morph *morph, enum fixed_attribute attribute)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];

	stream->unit = stream->fits / morph->reach;
	for (int v = 0; v < morph->vertex_count; v++) {
		float base[3];

		base_of(morph, attribute, v, base);
		stream->base[v] = (struct fixed_vector){FIXED_HALF,
			fixed_round(base[0] * stream->unit),
			fixed_round(base[1] * stream->unit),
			fixed_round(base[2] * stream->unit)};
	}
	if (attribute == FIXED_POSITION) {
		morph->placement.scale = 1.0f / stream->unit;
	}
}

static int init_stream(struct fixed_morph *morph,
	enum fixed_attribute attribute, struct arena *arena)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];
	int error = choose_unit(morph, attribute);

	if (error) {
		return error;
	}
	stream->base = ARENA_ARRAY(
		arena, struct fixed_vector, (size_t)morph->vertex_count);
	stream->deltas = ARENA_ARRAY(
		arena, struct fixed_deltas, (size_t)morph->pair_count);
	if (!stream->base || !stream->deltas) {
		return -ENOMEM;
	}
	write_base(morph, attribute);
	return lay_out_pairs(morph, attribute, arena);
}

int fixed_morph_init(struct fixed_morph *morph,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena)
{
	int error;

	*morph = (struct fixed_morph){
		.primitive = primitive,
		.vertex_count = primitive->vertex_count,
		.target_count = target_count,
		.pair_count = (target_count + 1) / 2,
		.reach = 1.0f,
	};
	error = find_middle(morph);
	if (!error) {
		error = init_stream(morph, FIXED_POSITION, arena);
	}
	if (!error && (streams & FIXED_NORMALS)) {
		error = init_stream(morph, FIXED_NORMAL, arena);
	}
	if (!error && (streams & FIXED_TANGENTS)) {
		error = init_stream(morph, FIXED_TANGENT, arena);
	}
	return error;
}

/*
 * With |weight| <= reach, a number is at most 2 * 16383: delta * unit is at
 * most 16383 at reach 1.
 */
static int16_t weight_number(const struct fixed_morph *morph,
	const struct fixed_deltas *deltas, const float *weight, int target,
	float unit)
{
	return target < morph->target_count
		? fixed_round(weight[target] * deltas->scale[target & 1] * unit)
		: 0;
}

static void set_reach(struct fixed_morph *morph, float reach)
{
	morph->reach = reach;
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (morph->stream[a].base) {
			write_base(morph, (enum fixed_attribute)a);
		}
	}
}

int fixed_morph_set_weights(struct fixed_morph *morph, const float *weight)
{
	float reach = morph->reach;

	for (int t = 0; t < morph->target_count; t++) {
		if (!(scalar_abs(weight[t]) <= REACH_MAX)) {
			return -ERANGE;
		}
		while (scalar_abs(weight[t]) > reach) {
			reach *= 2.0f;
		}
	}
	if (reach > morph->reach) {
		set_reach(morph, reach);
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

static bool is_active(const struct fixed_deltas *deltas)
{
	return deltas->span_count > 0 &&
		(deltas->weights.a != 0 || deltas->weights.b != 0);
}

static void copy(const struct fixed_vector *from, int first, int end,
	struct fixed_vector *to)
{
	if (end > first) {
		memcpy(to + first, from + first,
			(size_t)(end - first) * sizeof(*to));
	}
}

/* Added in one go, and the vertices between its spans copied. */
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

/* What of a pair's spans lies within first .. first + count. */
static void add_within(const struct fixed_loops *loops,
	const struct fixed_deltas *deltas, int first, int count,
	struct fixed_sum *sum)
{
	for (int i = 0; i < deltas->span_count; i++) {
		const struct fixed_span *span = &deltas->span[i];
		int from = span->first > first ? span->first : first;
		int to = span->first + span->count;

		to = to < first + count ? to : first + count;
		if (from < to) {
			loops->morph_add(to - from,
				(const struct fixed_pair(*)[3])deltas->pair +
					span->first_pair + from - span->first,
				deltas->weights, sum + from - first);
		}
	}
}

static void run_many(const struct fixed_morph *morph,
	const struct fixed_loops *loops,
	const struct fixed_morph_stream *stream, struct fixed_vector *out)
{
	struct fixed_sum sum[CHUNK];

	for (int first = 0; first < morph->vertex_count; first += CHUNK) {
		int left = morph->vertex_count - first;
		int count = left < CHUNK ? left : CHUNK;

		loops->morph_begin(count, stream->base + first, sum);
		for (int p = 0; p < morph->pair_count; p++) {
			if (is_active(&stream->deltas[p])) {
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
		if (is_active(&stream->deltas[p])) {
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

size_t fixed_morph_bytes(const struct fixed_morph *morph)
{
	size_t bytes = 0;

	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		const struct fixed_morph_stream *stream = &morph->stream[a];

		if (!stream->base) {
			continue;
		}
		bytes += (size_t)morph->vertex_count * sizeof(*stream->base);
		for (int p = 0; p < morph->pair_count; p++) {
			const struct fixed_deltas *deltas = &stream->deltas[p];

			bytes += sizeof(*deltas) +
				(size_t)deltas->span_count *
					sizeof(*deltas->span);
			for (int i = 0; i < deltas->span_count; i++) {
				bytes += (size_t)deltas->span[i].count *
					sizeof(*deltas->pair);
			}
		}
	}
	return bytes;
}
