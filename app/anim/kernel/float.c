/*
 * The reference in plain C and float. Tests compare every other kernel with it.
 */
#include "app/anim/kernel/float.h"

#include "platform/base/scalar.h"

#include <string.h>

/* offset is joint_weight.joint_offset, in bytes (AN4044, Example 3). */
static const mat4 *joint_matrix(const mat4 *palette, int32_t offset)
{
	return (const mat4 *)((const char *)palette + offset);
}

static const struct joint_weight *next_vertex(
	const struct joint_weight *influence)
{
	return (const struct joint_weight *)((const char *)influence +
		influence->next_vertex_offset);
}

/*
 * sum += matrix * base, where base.w is the weight (MadMatVec of AN4044's
 * Example 6). In this order, each line is a sequence of multiply-accumulates.
 */
static inline void add_point(
	float sum[3], const mat4 *matrix, const float base[4])
{
	const vec4 *m = *matrix;
	float x = base[0], y = base[1], z = base[2], w = base[3];

	sum[0] = sum[0] + m[0][0] * x + m[1][0] * y + m[2][0] * z + m[3][0] * w;
	sum[1] = sum[1] + m[0][1] * x + m[1][1] * y + m[2][1] * z + m[3][1] * w;
	sum[2] = sum[2] + m[0][2] * x + m[1][2] * y + m[2][2] * z + m[3][2] * w;
}

static inline void add_vector(
	float sum[3], const mat4 *matrix, const float base[4])
{
	const vec4 *m = *matrix;
	float x = base[0], y = base[1], z = base[2];

	sum[0] = sum[0] + m[0][0] * x + m[1][0] * y + m[2][0] * z;
	sum[1] = sum[1] + m[0][1] * x + m[1][1] * y + m[2][1] * z;
	sum[2] = sum[2] + m[0][2] * x + m[1][2] * y + m[2][2] * z;
}

static inline void store(const float sum[3], float out[3])
{
	out[0] = sum[0];
	out[1] = sum[1];
	out[2] = sum[2];
}

static inline void scale_vector(float v[3], float scale)
{
	v[0] *= scale;
	v[1] *= scale;
	v[2] *= scale;
}

static inline void make_unit(float v[3])
{
	float length2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

	/* A vector that is too short to have a direction stays as it is. */
	if (length2 > 1e-36f) {
		scale_vector(v, 1 / scalar_sqrt(length2));
	}
}

/*
 * Returns the end of a vertex's first max influences (0: of all), given its
 * first one and the next vertex's.
 */
static const struct joint_weight *cap(const struct joint_weight *first,
	const struct joint_weight *next, int max)
{
	return max > 0 && next - first > max ? first + max : next;
}

/* The factor that makes the weights from first to end sum to 1. */
static float rest_scale(
	const struct joint_weight *first, const struct joint_weight *end)
{
	float sum = 0;

	for (; first < end; first++) {
		sum += first->weight;
	}
	return 1 / sum;
}

static void skin_positions(const struct skin_stream *stream,
	const mat4 *palette, int max_influences, float (*position)[3])
{
	const struct joint_weight *influence = stream->influence;
	const float(*base)[4] = (const float(*)[4])stream->position;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *first = influence;
		const struct joint_weight *next = next_vertex(first);
		const struct joint_weight *end =
			cap(first, next, max_influences);
		float sum[3] = {0, 0, 0};

		for (; influence < end; influence++) {
			add_point(sum,
				joint_matrix(palette, influence->joint_offset),
				*base++);
		}
		if (end != next) {
			scale_vector(sum, rest_scale(first, end));
			base += next - end;
			influence = next;
		}
		store(sum, position[v]);
	}
}

/* Skins positions and normals in one pass, so each matrix is loaded once. */
static void skin_both(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*position)[3], float (*normal)[3])
{
	const struct joint_weight *influence = stream->influence;
	const float(*base)[4] = (const float(*)[4])stream->position;
	const float(*base_normal)[4] = (const float(*)[4])stream->normal;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *first = influence;
		const struct joint_weight *next = next_vertex(first);
		const struct joint_weight *end =
			cap(first, next, max_influences);
		float sum[3] = {0, 0, 0};
		float direction[3] = {0, 0, 0};

		for (; influence < end; influence++) {
			const mat4 *matrix =
				joint_matrix(palette, influence->joint_offset);

			add_point(sum, matrix, *base++);
			add_vector(direction, matrix, *base_normal++);
		}
		if (end != next) {
			scale_vector(sum, rest_scale(first, end));
			base += next - end;
			base_normal += next - end;
			influence = next;
		}
		make_unit(direction);
		store(sum, position[v]);
		store(direction, normal[v]);
	}
}

/* Weights are not rescaled under a cap, since the results are normalised. */
void float_skin_directions(const struct skin_stream *stream,
	const float (*base)[4], const mat4 *palette, int max_influences,
	float (*direction)[3])
{
	const struct joint_weight *influence = stream->influence;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *next = next_vertex(influence);
		const struct joint_weight *end =
			cap(influence, next, max_influences);
		float sum[3] = {0, 0, 0};

		for (; influence < end; influence++) {
			add_vector(sum,
				joint_matrix(palette, influence->joint_offset),
				*base++);
		}
		base += end != next ? next - end : 0;
		influence = next;
		make_unit(sum);
		store(sum, direction[v]);
	}
}

void float_skin(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*position)[3], float (*normal)[3])
{
	if (normal) {
		skin_both(stream, palette, max_influences, position, normal);
	} else {
		skin_positions(stream, palette, max_influences, position);
	}
}

void float_morph_lerp(int count, const float (*source)[3],
	const float (*destiny)[3], float omega, const float offset[3],
	float (*out)[3])
{
	float rest = 1 - omega;

	for (int i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			out[i][k] = destiny[i][k] * omega +
				source[i][k] * rest + offset[k];
		}
	}
}

static void add_target(
	int count, float weight, const float (*delta)[3], float (*out)[3])
{
	for (int i = 0; i < count; i++) {
		out[i][0] += delta[i][0] * weight;
		out[i][1] += delta[i][1] * weight;
		out[i][2] += delta[i][2] * weight;
	}
}

void float_morph_targets(int count, const float (*base)[3],
	const struct morph_term *term, int term_count, bool use_normals,
	float (*out)[3])
{
	if (out != (float(*)[3])base) {
		memcpy(out, base, (size_t)count * sizeof(*out));
	}
	for (int t = 0; t < term_count; t++) {
		const float(*delta)[3] =
			use_normals ? term[t].normal : term[t].position;

		if (delta && term[t].weight != 0) {
			add_target(count, term[t].weight, delta, out);
		}
	}
}

void float_normalize(int count, float (*vector)[3])
{
	for (int i = 0; i < count; i++) {
		make_unit(vector[i]);
	}
}

/* One vertex while it is morphed and skinned. */
struct vertex {
	float position[4]; /* w is 1, but 0 in normal and tangent */
	float normal[4];
	float tangent[4];
};

static void add_delta(
	float to[4], const float (*delta)[3], int index, float weight)
{
	if (delta) {
		to[0] += delta[index][0] * weight;
		to[1] += delta[index][1] * weight;
		to[2] += delta[index][2] * weight;
	}
}

static void load(const float *from, float w, float to[4])
{
	to[0] = from[0];
	to[1] = from[1];
	to[2] = from[2];
	to[3] = w;
}

static void morph_vertex(const struct morph_input *input,
	const struct skin_output *output, int index, struct vertex *vertex)
{
	load(input->position[index], 1, vertex->position);
	if (output->normal) {
		load(input->normal[index], 0, vertex->normal);
	}
	if (output->tangent) {
		load(input->tangent[index], 0, vertex->tangent);
	}
	for (int t = 0; t < input->term_count; t++) {
		const struct morph_term *term = &input->term[t];

		if (term->weight == 0) {
			continue;
		}
		add_delta(vertex->position, term->position, index, term->weight);
		if (output->normal) {
			add_delta(vertex->normal, term->normal, index,
				term->weight);
		}
		if (output->tangent) {
			add_delta(vertex->tangent, term->tangent, index,
				term->weight);
		}
	}
	for (int k = 0; k < 3; k++) {
		vertex->position[k] *= input->position_scale;
	}
}

/* out = the sum of weight * matrix * v over the influences up to end. */
static void carry(const struct joint_weight *influence,
	const struct joint_weight *end, const mat4 *palette, const float v[4],
	float out[3])
{
	float sum[3] = {0, 0, 0};

	for (; influence < end; influence++) {
		float weight = influence->weight;
		const float base[4] = {v[0] * weight, v[1] * weight,
			v[2] * weight, v[3] * weight};

		add_point(sum, joint_matrix(palette, influence->joint_offset),
			base);
	}
	store(sum, out);
}

void float_skin_morphed(const struct skin_stream *stream,
	const struct morph_input *input, const mat4 *palette,
	int max_influences, const struct skin_output *output)
{
	const struct joint_weight *first = stream->influence;
	const mat4 *normal_palette =
		input->normal_palette ? input->normal_palette : palette;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *next = next_vertex(first);
		const struct joint_weight *end =
			cap(first, next, max_influences);
		struct vertex vertex;

		morph_vertex(input, output, v, &vertex);
		carry(first, end, palette, vertex.position, output->position[v]);
		if (end != next) {
			scale_vector(
				output->position[v], rest_scale(first, end));
		}
		if (output->normal) {
			carry(first, end, normal_palette, vertex.normal,
				output->normal[v]);
			make_unit(output->normal[v]);
		}
		if (output->tangent) {
			carry(first, end, palette, vertex.tangent,
				output->tangent[v]);
			make_unit(output->tangent[v]);
		}
		first = next;
	}
}

void float_bitangents(int count, const float (*normal)[3],
	const float (*tangent)[3], const float (*attribute)[4],
	float (*bitangent)[3])
{
	for (int i = 0; i < count; i++) {
		const float *n = normal[i];
		const float *t = tangent[i];
		float sign = attribute[i][3];

		bitangent[i][0] = sign * (n[1] * t[2] - n[2] * t[1]);
		bitangent[i][1] = sign * (n[2] * t[0] - n[0] * t[2]);
		bitangent[i][2] = sign * (n[0] * t[1] - n[1] * t[0]);
	}
}

const struct kernel kernel_float = {
	.name = "float",
	.summary = "plain C in float, the reference",
	FLOAT_LOOPS,
};
