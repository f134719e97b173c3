#include "app/model/model_stats.h"

#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"
#include "platform/base/scalar.h"

static void add_influences(
	struct model_stats *stats, const struct model_primitive *primitive)
{
	int v, k;

	if (primitive->influences == 0) {
		return;
	}
	for (v = primitive->repeated_count; v < primitive->vertex_count; v++) {
		const float *weight = primitive->weight +
			(size_t)v * (size_t)primitive->influences;
		int count = 0;

		for (k = 0; k < primitive->influences; k++) {
			count += weight[k] > 0;
		}
		stats->influence_histogram[count]++;
		if (count > stats->max_influences) {
			stats->max_influences = count;
		}
	}
	stats->influence_bytes += (size_t)primitive->vertex_count *
		(size_t)primitive->influences *
		(sizeof(*primitive->joint) + sizeof(*primitive->weight));
}

static size_t vertex_bytes(const struct model_primitive *primitive)
{
	size_t bytes = sizeof(*primitive->position);

	bytes += primitive->normal ? sizeof(*primitive->normal) : 0;
	bytes += primitive->tangent ? sizeof(*primitive->tangent) : 0;
	bytes += primitive->texcoord ? sizeof(*primitive->texcoord) : 0;
	bytes += primitive->color ? sizeof(*primitive->color) : 0;
	return bytes;
}

static size_t target_bytes(
	const struct model_primitive *primitive, int target_count)
{
	size_t bytes = 0;

	if (primitive->keys) {
		return model_keys_bytes(primitive->keys, target_count);
	}
	for (int t = 0; t < target_count; t++) {
		const struct model_target *target = &primitive->target[t];

		bytes += model_deltas_bytes(&target->position) +
			model_deltas_bytes(&target->normal) +
			model_deltas_bytes(&target->tangent);
	}
	return bytes;
}

static size_t lod_bytes(const struct model_primitive *primitive)
{
	size_t count = 0;
	int i;

	for (i = 0; i < primitive->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		count += (size_t)lod->index_count * (lod->corner ? 2 : 1);
	}
	return count * sizeof(*primitive->index);
}

int model_level_count(const struct model_mesh *mesh)
{
	int count = 0;
	int i;

	for (i = 0; i < mesh->primitive_count; i++) {
		if (mesh->primitive[i].lod_count > count) {
			count = mesh->primitive[i].lod_count;
		}
	}
	return count;
}

struct model_level model_level(const struct model_mesh *mesh, int level)
{
	struct model_level out = {0};
	int i;

	for (i = 0; i < mesh->primitive_count; i++) {
		const struct model_primitive *primitive = &mesh->primitive[i];
		const struct model_lod *lod;

		if (level >= primitive->lod_count) {
			out.triangle_count += primitive->index_count / 3;
			continue;
		}
		lod = &primitive->lod[level];
		out.triangle_count += lod->index_count / 3;
		out.shadow_only = lod->shadow_only;
		out.error_m = scalar_max(lod->error_m, out.error_m);
	}
	return out;
}

void model_stats_add_mesh(
	struct model_stats *stats, const struct model_mesh *mesh)
{
	int i;

	stats->target_count += mesh->target_count;
	for (i = 0; i < mesh->primitive_count; i++) {
		const struct model_primitive *primitive = &mesh->primitive[i];
		size_t vertices = (size_t)primitive->vertex_count;

		stats->primitive_count += i == 0 ||
			primitive->file_index != primitive[-1].file_index;
		stats->vertex_count +=
			primitive->vertex_count - primitive->repeated_count;
		stats->triangle_count += primitive->index_count / 3;
		stats->geometry_bytes += vertices * vertex_bytes(primitive) +
			(size_t)primitive->index_count *
				sizeof(*primitive->index) +
			lod_bytes(primitive);
		add_influences(stats, primitive);
		stats->target_bytes +=
			target_bytes(primitive, mesh->target_count);
		if (mesh->target_count > 0) {
			stats->morph_vertex_count += primitive->vertex_count -
				primitive->repeated_count;
		}
	}
}

void model_stats_add_clip(
	struct model_stats *stats, const struct model_clip *clip)
{
	int i;

	stats->longest_s = scalar_max(clip->duration_s, stats->longest_s);
	for (i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		size_t keys = (size_t)channel->key_count;
		size_t width = (size_t)channel->width;

		if (channel->interpolation == MODEL_CUBICSPLINE) {
			width *= 3;
		}
		stats->channel_count++;
		stats->key_count += channel->key_count;
		stats->clip_bytes += keys * sizeof(*channel->time_s) +
			keys * width *
				(channel->packed ? sizeof(int16_t)
						 : sizeof(float));
	}
}

void model_measure(const struct model *model, struct model_stats *out)
{
	int i;

	*out = (struct model_stats){0};
	for (i = 0; i < model->mesh_count; i++) {
		model_stats_add_mesh(out, &model->mesh[i]);
	}
	for (i = 0; i < model->clip_count; i++) {
		model_stats_add_clip(out, &model->clip[i]);
	}
	for (i = 0; i < model->skin_count; i++) {
		out->influence_bytes += (size_t)model->skin[i].joint_count *
			sizeof(*model->skin[i].inverse_bind);
	}
	for (i = 0; i < model->image_count; i++) {
		out->image_bytes += (size_t)model->image[i].width *
			(size_t)model->image[i].height * 4;
	}
}
