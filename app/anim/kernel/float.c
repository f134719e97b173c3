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

const struct kernel kernel_float = {
	.name = "float",
	.summary = "plain C in float, the reference",
	.skin = skin,
	.morph_lerp = morph_lerp,
	.morph_targets = morph_targets,
	.normalize = normalize,
};
