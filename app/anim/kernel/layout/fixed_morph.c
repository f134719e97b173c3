#include "app/anim/kernel/layout/fixed_morph.h"

#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/layout/fixed_attribute.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <errno.h>

enum {
	GAP_MAX = 3 /* as many unmoved vertices in a row do not end a span */
};

/*
 * Reads a vertex's attribute. Positions become relative to the centre of the
 * box around all of them.
 */
static void base_of(const struct fixed_morph *morph,
	enum fixed_attribute attribute, int vertex, float out[3])
{
	const float *from = fixed_attribute_of(
		morph->primitive, attribute, (uint32_t)vertex);

	for (int k = 0; k < 3; k++) {
		out[k] = attribute == FIXED_POSITION
			? from[k] - morph->placement.offset[k]
			: from[k];
	}
}

/*
 * Reads a target's deltas as floats. With an odd number of targets, the second
 * one of the last pair does not exist, and its deltas are 0.
 */
static void read_deltas(const struct fixed_morph *morph,
	enum fixed_attribute attribute, int target, float (*out)[3])
{
	static const struct model_deltas none;

	model_deltas_unpack(target < morph->target_count
			? fixed_attribute_deltas(
				  &morph->primitive->target[target], attribute)
			: &none,
		morph->vertex_count, out);
}

static float largest_delta(const float (*delta)[3], int count)
{
	float most = 0.0f;

	for (int i = 0; i < count * 3; i++) {
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

/* Scratch memory for two targets' deltas as floats: [vertex_count] each. */
struct buffers {
	float (*vector[2])[3];
};

/*
 * Chooses the unit so that two things fit in 16 bits: a vertex with all targets
 * at weight 1, and the weight of each target (see weight_number() in
 * fixed_morph_run.c).
 */
static int choose_unit(struct fixed_morph *morph,
	enum fixed_attribute attribute, const struct buffers *buffers)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];
	int count = morph->vertex_count;
	float total = 1e-12f, single = 1e-12f;
	float(*sum)[3] = buffers->vector[0], (*delta)[3] = buffers->vector[1];

	for (int v = 0; v < count; v++) {
		base_of(morph, attribute, v, sum[v]);
		for (int k = 0; k < 3; k++) {
			sum[v][k] = scalar_abs(sum[v][k]);
		}
	}
	for (int t = 0; t < morph->target_count; t++) {
		float size;

		read_deltas(morph, attribute, t, delta);
		for (int i = 0; i < count * 3; i++) {
			sum[i / 3][i % 3] += scalar_abs(delta[i / 3][i % 3]);
		}
		size = largest_delta((const float(*)[3])delta, count);
		single = size > single ? size : single;
	}
	for (int i = 0; i < count * 3; i++) {
		float size = sum[i / 3][i % 3];

		if (!fixed_can_use(size)) {
			return -ERANGE;
		}
		total = size > total ? size : total;
	}
	stream->unit_at_1 = 32600.0f / total;
	if (stream->unit_at_1 > 16383.0f / single) {
		stream->unit_at_1 = 16383.0f / single;
	}
	return 0;
}

/* Converts a coordinate of a delta. A target's largest one becomes 32767. */
static int16_t delta_number(
	const float (*delta)[3], int vertex, int axis, float scale)
{
	return fixed_round(delta[vertex][axis] * scale);
}

/* The two targets of a pair, as floats, and the factors that convert them. */
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

/* Finds the next span from a vertex on; its count is 0 if there is none. */
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
	enum fixed_attribute attribute, const struct buffers *buffers,
	struct arena *arena)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];

	for (int p = 0; p < morph->pair_count; p++) {
		struct source source;
		int error;

		for (int half = 0; half < 2; half++) {
			float size;

			read_deltas(morph, attribute, p * 2 + half,
				buffers->vector[half]);
			source.delta[half] =
				(const float(*)[3])buffers->vector[half];
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

/* Writes the base vectors in the largest unit that the weight limit allows. */
static void write_base(struct fixed_morph *morph, enum fixed_attribute attribute)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];

	stream->unit = stream->unit_at_1 / morph->weight_limit;
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

static int init_stream(struct fixed_morph *morph, enum fixed_attribute attribute,
	const struct buffers *buffers, struct arena *arena)
{
	struct fixed_morph_stream *stream = &morph->stream[attribute];
	int error = choose_unit(morph, attribute, buffers);

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
	return lay_out_pairs(morph, attribute, buffers, arena);
}

static int init_streams(
	struct fixed_morph *morph, unsigned streams, struct arena *arena)
{
	struct arena scratch = arena_within(arena->budget);
	struct buffers buffers;
	int error = 0;

	for (int i = 0; i < 2; i++) {
		buffers.vector[i] = arena_alloc(&scratch,
			(size_t)morph->vertex_count, sizeof(float[3]));
		error = buffers.vector[i] ? error : -ENOMEM;
	}
	if (!error) {
		error = init_stream(morph, FIXED_POSITION, &buffers, arena);
	}
	if (!error && (streams & FIXED_NORMALS)) {
		error = init_stream(morph, FIXED_NORMAL, &buffers, arena);
	}
	if (!error && (streams & FIXED_TANGENTS)) {
		error = init_stream(morph, FIXED_TANGENT, &buffers, arena);
	}
	arena_release(&scratch);
	return error;
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
		.weight_limit = 1.0f,
	};
	error = find_middle(morph);
	return error ? error : init_streams(morph, streams, arena);
}

void fixed_morph_set_limit(struct fixed_morph *morph, float weight_limit)
{
	morph->weight_limit = weight_limit;
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (morph->stream[a].base) {
			write_base(morph, (enum fixed_attribute)a);
		}
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
