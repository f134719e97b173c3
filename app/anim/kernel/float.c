/*
 * The reference: plain C in float. Every other kernel is measured against it.
 */
#include "app/anim/kernel/kernel.h"

#include "platform/base/scalar.h"

#include <string.h>

/* The offsets of struct joint_weight count in bytes (AN4044, Example 3). */
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

/* sum += matrix * base, base.w being the weight: MadMatVec of Example 6. */
static void add_point(float sum[3], const mat4 *matrix, const float base[4])
{
	for (int r = 0; r < 3; r++) {
		sum[r] += (*matrix)[0][r] * base[0] + (*matrix)[1][r] * base[1] +
			(*matrix)[2][r] * base[2] + (*matrix)[3][r] * base[3];
	}
}

static void add_vector(float sum[3], const mat4 *matrix, const float base[4])
{
	for (int r = 0; r < 3; r++) {
		sum[r] += (*matrix)[0][r] * base[0] +
			(*matrix)[1][r] * base[1] + (*matrix)[2][r] * base[2];
	}
}

static void make_unit(float v[3])
{
	float length2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
	float scale;

	/* Too short to have a direction: left alone, and zero stays zero. */
	if (!(length2 > 1e-36f)) {
		return;
	}
	scale = 1 / scalar_sqrt(length2);
	v[0] *= scale;
	v[1] *= scale;
	v[2] *= scale;
}

/* How many influences of a vertex to use, and what their weights sum to. */
static int cap(const struct joint_weight *influence,
	const struct joint_weight *next, int max_influences, float *sum)
{
	int count = (int)(next - influence);

	*sum = 1;
	if (max_influences <= 0 || count <= max_influences) {
		return count;
	}
	*sum = 0;
	for (int i = 0; i < max_influences; i++) {
		*sum += influence[i].weight;
	}
	return max_influences;
}

static void skin_positions(const struct skin_stream *stream,
	const mat4 *palette, int max_influences, float (*position)[3])
{
	const struct joint_weight *first = stream->influence;
	const struct joint_weight *influence = first;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *next = next_vertex(influence);
		const float(*base)[4] = stream->position + (influence - first);
		float weights;
		int count = cap(influence, next, max_influences, &weights);
		float sum[3] = {0, 0, 0};

		for (int i = 0; i < count; i++) {
			add_point(sum,
				joint_matrix(palette, influence[i].joint_offset),
				base[i]);
		}
		if (weights != 1) {
			float scale = 1 / weights;

			sum[0] *= scale;
			sum[1] *= scale;
			sum[2] *= scale;
		}
		memcpy(position[v], sum, sizeof(sum));
		influence = next;
	}
}

/* The length is lost in any case, so the weights' sum does not matter. */
static void skin_directions(const struct skin_stream *stream,
	const float (*stream_base)[4], const mat4 *palette, int max_influences,
	float (*direction)[3])
{
	const struct joint_weight *first = stream->influence;
	const struct joint_weight *influence = first;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *next = next_vertex(influence);
		const float(*base)[4] = stream_base + (influence - first);
		float unused;
		int count = cap(influence, next, max_influences, &unused);
		float sum[3] = {0, 0, 0};

		for (int i = 0; i < count; i++) {
			add_vector(sum,
				joint_matrix(palette, influence[i].joint_offset),
				base[i]);
		}
		make_unit(sum);
		memcpy(direction[v], sum, sizeof(sum));
		influence = next;
	}
}

static void skin(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*position)[3], float (*normal)[3])
{
	skin_positions(stream, palette, max_influences, position);
	if (normal) {
		skin_directions(stream, (const float(*)[4])stream->normal,
			palette, max_influences, normal);
	}
}

static void skin_tangents(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*tangent)[3])
{
	skin_directions(stream, (const float(*)[4])stream->tangent, palette,
		max_influences, tangent);
}

static void morph_lerp(int count, const float (*source)[3],
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

static void morph_targets(int count, const float (*base)[3],
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

static void normalize(int count, float (*vector)[3])
{
	for (int i = 0; i < count; i++) {
		make_unit(vector[i]);
	}
}

/* One vertex while it is morphed and skinned. */
struct vertex {
	float position[4]; /* w is 1 for a place and 0 for directions */
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

/* out = the sum of weight * matrix * v, over count influences. */
static void carry(const struct joint_weight *influence, int count,
	const mat4 *palette, const float v[4], float out[3])
{
	float sum[3] = {0, 0, 0};

	for (int i = 0; i < count; i++) {
		float weight = influence[i].weight;
		const float base[4] = {v[0] * weight, v[1] * weight,
			v[2] * weight, v[3] * weight};

		add_point(sum, joint_matrix(palette, influence[i].joint_offset),
			base);
	}
	memcpy(out, sum, sizeof(sum));
}

static void skin_morphed(const struct skin_stream *stream,
	const struct morph_input *input, const mat4 *palette,
	int max_influences, const struct skin_output *output)
{
	const struct joint_weight *influence = stream->influence;

	for (int v = 0; v < stream->vertex_count; v++) {
		const struct joint_weight *next = next_vertex(influence);
		struct vertex vertex;
		float weights;
		int count = cap(influence, next, max_influences, &weights);

		morph_vertex(input, output, v, &vertex);
		carry(influence, count, palette, vertex.position,
			output->position[v]);
		for (int k = 0; weights != 1 && k < 3; k++) {
			output->position[v][k] *= 1 / weights;
		}
		if (output->normal) {
			carry(influence, count, palette, vertex.normal,
				output->normal[v]);
			make_unit(output->normal[v]);
		}
		if (output->tangent) {
			carry(influence, count, palette, vertex.tangent,
				output->tangent[v]);
			make_unit(output->tangent[v]);
		}
		influence = next;
	}
}

static void bitangents(int count, const float (*normal)[3],
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
	.skin = skin,
	.morph_lerp = morph_lerp,
	.morph_targets = morph_targets,
	.normalize = normalize,
	.skin_tangents = skin_tangents,
	.skin_morphed = skin_morphed,
	.bitangents = bitangents,
};
