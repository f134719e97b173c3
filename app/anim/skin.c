#include "app/anim/skin.h"

#include <errno.h>

int skin_gather_influences(const struct model_primitive *primitive,
	uint32_t vertex, struct skin_influence *out)
{
	int width = primitive->influences;
	size_t first = vertex * (size_t)width;
	const float *weight = primitive->weight + first;
	const uint16_t *joint = primitive->joint + first;
	int count = 0;

	for (int i = 0; i < width && i < SKIN_INFLUENCES_MAX; i++) {
		int to = count;

		if (!(weight[i] > 0)) {
			continue;
		}
		while (to > 0 && out[to - 1].weight < weight[i]) {
			out[to] = out[to - 1];
			to--;
		}
		out[to] = (struct skin_influence){weight[i], joint[i]};
		count++;
	}
	if (count == 0) {
		out[0] = (struct skin_influence){1, joint[0]};
		count = 1;
	}
	return count;
}

void skin_stream_count(
	struct skin_stream *stream, const struct model_primitive *primitive)
{
	struct skin_influence scratch[SKIN_INFLUENCES_MAX];

	*stream = (struct skin_stream){
		.vertex_count = primitive->vertex_count,
	};
	for (int v = 0; v < primitive->vertex_count; v++) {
		int count =
			skin_gather_influences(primitive, (uint32_t)v, scratch);

		stream->influence_count += count;
		for (int k = 1; k <= SKIN_INFLUENCES_MAX; k++) {
			stream->capped[k] += count < k ? count : k;
		}
		if (count > stream->max_influences) {
			stream->max_influences = count;
		}
	}
}

static void write_influences(
	const struct model_primitive *primitive, struct skin_stream *stream)
{
	struct skin_influence sorted[SKIN_INFLUENCES_MAX];
	struct joint_weight *out = stream->influence;

	for (int v = 0; v < primitive->vertex_count; v++) {
		int count =
			skin_gather_influences(primitive, (uint32_t)v, sorted);

		for (int i = 0; i < count; i++) {
			size_t joint = (size_t)sorted[i].joint;
			size_t left = (size_t)(count - i);

			/* Fits: 65,536 joints of 64 bytes are below 2^31. */
			*out++ = (struct joint_weight){
				.weight = sorted[i].weight,
				.joint_offset = (int32_t)(joint * sizeof(mat4)),
				.next_vertex_offset =
					(int32_t)(left * sizeof(*out)),
			};
		}
	}
}

int skin_stream_init(struct skin_stream *stream,
	const struct model_primitive *primitive, float position_scale,
	struct arena *arena)
{
	size_t count;

	skin_stream_count(stream, primitive);
	count = (size_t)stream->influence_count;
	stream->influence = ARENA_ARRAY(arena, struct joint_weight, count);
	stream->position = arena_alloc(arena, count, sizeof(float[4]));
	if (!stream->influence || !stream->position) {
		return -ENOMEM;
	}
	if (primitive->normal) {
		stream->normal = arena_alloc(arena, count, sizeof(float[4]));
		if (!stream->normal) {
			return -ENOMEM;
		}
	}
	write_influences(primitive, stream);
	skin_stream_rebase(stream, (const float(*)[3])primitive->position,
		(const float(*)[3])primitive->normal, position_scale);
	return 0;
}

static void scale_into(const float v[3], float factor, float w, float out[4])
{
	out[0] = v[0] * factor;
	out[1] = v[1] * factor;
	out[2] = v[2] * factor;
	out[3] = w;
}

int skin_stream_add_tangents(struct skin_stream *stream,
	const struct model_primitive *primitive, struct arena *arena)
{
	const int last = sizeof(struct joint_weight);
	size_t count = (size_t)stream->influence_count;
	int vertex = 0;

	if (!primitive->tangent) {
		return -EINVAL;
	}
	stream->tangent = arena_alloc(arena, count, sizeof(float[4]));
	if (!stream->tangent) {
		return -ENOMEM;
	}
	for (int i = 0; i < stream->influence_count; i++) {
		const struct joint_weight *influence = &stream->influence[i];

		scale_into(primitive->tangent[vertex], influence->weight, 0,
			stream->tangent[i]);
		vertex += influence->next_vertex_offset == last;
	}
	return 0;
}

void skin_stream_rebase(struct skin_stream *stream, const float (*position)[3],
	const float (*normal)[3], float position_scale)
{
	const int last = sizeof(struct joint_weight);
	int vertex = 0;

	for (int i = 0; i < stream->influence_count; i++) {
		const struct joint_weight *influence = &stream->influence[i];
		float weight = influence->weight;

		scale_into(position[vertex], weight * position_scale, weight,
			stream->position[i]);
		if (normal && stream->normal) {
			scale_into(normal[vertex], weight, 0, stream->normal[i]);
		}
		vertex += influence->next_vertex_offset == last;
	}
}

size_t skin_stream_bytes(const struct skin_stream *stream)
{
	size_t each = sizeof(struct joint_weight) + sizeof(float[4]);

	each += stream->normal ? sizeof(float[4]) : 0;
	each += stream->tangent ? sizeof(float[4]) : 0;
	return (size_t)stream->influence_count * each;
}
