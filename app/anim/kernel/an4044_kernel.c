/*
 * AN4044's loops as a kernel. The loops write blocks of an4044_vertex, which
 * are then copied to the caller's arrays.
 */
#include "app/anim/kernel/an4044.h"
#include "app/anim/kernel/float.h"

#include <string.h>

enum {
	VERTICES = 64, /* vertices in a block */
	JOINTS_MAX = 256
};

/* Padded to the size of mat4, in which joint_offset counts. */
struct padded_joint {
	struct an4044_joint_mat joint;
	float unused[4];
};

_Static_assert(sizeof(struct padded_joint) == sizeof(mat4), "joint_offset");

/*
 * Copies the matrices up to the last one that the stream uses. Returns false if
 * these are more than JOINTS_MAX.
 */
static bool set_joints(const struct skin_stream *stream, const mat4 *palette,
	struct padded_joint joint[JOINTS_MAX])
{
	int count = 0;

	for (int i = 0; i < stream->influence_count; i++) {
		int used =
			stream->influence[i].joint_offset / (int)sizeof(mat4) +
			1;

		count = used > count ? used : count;
	}
	if (count > JOINTS_MAX) {
		return false;
	}
	for (int j = 0; j < count; j++) {
		for (int i = 0; i < 12; i++) {
			joint[j].joint.mat[i] = palette[j][i % 4][i / 4];
		}
	}
	return true;
}

/* Returns how many influences the vertex_count vertices from weight on have. */
static int count_influences(const struct joint_weight *weight, int vertex_count)
{
	const struct joint_weight *end = weight;

	for (int v = 0; v < vertex_count; v++) {
		end += end->next_vertex_offset / (int32_t)sizeof(*end);
	}
	return (int)(end - weight);
}

static void copy(const struct an4044_vec4 *from, float out[3])
{
	out[0] = from->x;
	out[1] = from->y;
	out[2] = from->z;
}

static void transform(const struct skin_stream *stream,
	const struct padded_joint *joint, float (*position)[3],
	float (*normal)[3])
{
	struct an4044_vertex vertex[VERTICES];
	int influence = 0;

	for (int first = 0; first < stream->vertex_count; first += VERTICES) {
		const struct joint_weight *weight =
			stream->influence + influence;
		const float(*base)[4] =
			(const float(*)[4])stream->position + influence;
		int left = stream->vertex_count - first;
		int count = left < VERTICES ? left : VERTICES;

		if (normal) {
			an4044_transform_normals(vertex, count, &joint->joint,
				base,
				(const float(*)[4])stream->normal + influence,
				weight);
		} else {
			an4044_transform(
				vertex, count, &joint->joint, base, weight);
		}
		for (int v = 0; v < count; v++) {
			copy(&vertex[v].position, position[first + v]);
			if (normal) {
				copy(&vertex[v].normal, normal[first + v]);
			}
		}
		influence += count_influences(weight, count);
	}
}

static void skin(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*position)[3], float (*normal)[3])
{
	struct padded_joint joint[JOINTS_MAX];

	/* The document's loops cannot cap influences and rescale the others. */
	if (max_influences > 0 || !set_joints(stream, palette, joint)) {
		float_skin(stream, palette, max_influences, position, normal);
		return;
	}
	transform(stream, joint, position, normal);
	if (normal) {
		float_normalize(stream->vertex_count, normal);
	}
}

static void morph_lerp(int count, const float (*source)[3],
	const float (*destiny)[3], float omega, const float offset[3],
	float (*out)[3])
{
	an4044_over_time(count, source, destiny, omega, out);
	if (offset[0] != 0 || offset[1] != 0 || offset[2] != 0) {
		an4044_add(count, offset, out);
	}
}

static void morph_targets(int count, const float (*base)[3],
	const struct morph_term *term, int term_count, bool use_normals,
	float (*out)[3])
{
	const float(*waiting)[3] = NULL;
	float weight = 0;

	if (out != (float(*)[3])base) {
		memcpy(out, base, (size_t)count * sizeof(*out));
	}
	for (int t = 0; t < term_count; t++) {
		const float(*delta)[3] =
			use_normals ? term[t].normal : term[t].position;

		if (!delta || term[t].weight == 0) {
			continue;
		}
		if (waiting) {
			an4044_two_targets(count, (const float(*)[3])out,
				waiting, weight, delta, term[t].weight, out);
			waiting = NULL;
		} else {
			waiting = delta;
			weight = term[t].weight;
		}
	}
	if (waiting) {
		an4044_two_targets(count, (const float(*)[3])out, waiting,
			weight, waiting, 0, out);
	}
}

const struct kernel kernel_an4044 = {
	.name = "an4044",
	.summary = "the loops of AN4044 in float, for comparison",
	.skin = skin,
	.morph_lerp = morph_lerp,
	.morph_targets = morph_targets,
	.normalize = float_normalize,
	.skin_directions = float_skin_directions,
	.skin_morphed = float_skin_morphed,
	.bitangents = float_bitangents,
};
