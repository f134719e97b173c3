/*
 * Loads any bytes as a glTF file in memory. Expects a model that satisfies
 * model.h, or exactly one error and no leak.
 */
#include "app/model/gltf/gltf.h"
#include "app/model/model_loader.h"
#include "app/model/model_stats.h"
#include "tests/fuzz/fuzz_expect.h"

#include <math.h>
#include <stdlib.h>

static void check_primitive(const struct model *model,
	const struct model_mesh *mesh, const struct model_primitive *primitive)
{
	size_t total =
		(size_t)primitive->vertex_count * (size_t)primitive->influences;
	size_t i;
	int k;

	fuzz_expect(primitive->material >= 0 &&
		primitive->material < model->material_count);
	fuzz_expect(primitive->vertex_count > 0 && primitive->position);
	fuzz_expect(primitive->index_count % 3 == 0);
	for (k = 0; k < primitive->index_count; k++) {
		fuzz_expect(primitive->index[k] <
			(uint32_t)primitive->vertex_count);
	}
	fuzz_expect(primitive->influences == 0 || primitive->influences == 4 ||
		primitive->influences == 8);
	for (i = 0; i < total; i++) {
		fuzz_expect(
			primitive->weight[i] >= 0 && primitive->weight[i] <= 1);
	}
	fuzz_expect(mesh->target_count == 0 || primitive->target);
	fuzz_expect(isfinite(primitive->position[0][0]));
}

static void check_nodes(const struct model *model, const int *joint_of_mesh)
{
	int i;

	for (i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		fuzz_expect(node->parent >= -1 && node->parent < i);
		fuzz_expect(node->mesh >= -1 && node->mesh < model->mesh_count);
		fuzz_expect(node->camera < model->camera_count);
		fuzz_expect(node->skin < model->skin_count);
		if (node->skin >= 0) {
			fuzz_expect(joint_of_mesh[node->mesh] <
				model->skin[node->skin].joint_count);
		}
		if (node->mesh >= 0) {
			fuzz_expect(node->weight_offset +
					model->mesh[node->mesh].target_count <=
				model->weight_count);
		}
	}
}

static void check_key(const struct model_channel *channel, int key)
{
	float rotation[4], length2 = 0;

	if (!channel->packed) {
		fuzz_expect(isfinite(channel->value[key * channel->width]));
		return;
	}
	model_channel_key(channel, key, rotation);
	for (int i = 0; i < 4; i++) {
		length2 += rotation[i] * rotation[i];
	}
	fuzz_expect(fabsf(length2 - 1) < 1e-5f);
}

static void check_clips(const struct model *model)
{
	int i, k;

	for (i = 0; i < model->clip_count; i++) {
		for (k = 0; k < model->clip[i].channel_count; k++) {
			const struct model_channel *channel =
				&model->clip[i].channel[k];

			fuzz_expect(channel->node >= 0 &&
				channel->node < model->node_count);
			fuzz_expect(
				channel->key_count > 0 && channel->width > 0);
			check_key(channel, 0);
			check_key(channel, channel->key_count - 1);
			fuzz_expect(channel->time_s[channel->key_count - 1] <=
					model->clip[i].duration_s ||
				channel->time_s[0] < 0);
		}
	}
}

static void check(const struct model *model)
{
	int *joint_of_mesh =
		calloc((size_t)model->mesh_count + 1, sizeof(*joint_of_mesh));
	struct model_stats stats;
	int i, k;

	fuzz_expect(joint_of_mesh != NULL);
	for (i = 0; i < model->mesh_count; i++) {
		const struct model_mesh *mesh = &model->mesh[i];

		joint_of_mesh[i] = -1;
		for (k = 0; k < mesh->primitive_count; k++) {
			int joint = model_max_joint(&mesh->primitive[k]);

			check_primitive(model, mesh, &mesh->primitive[k]);
			joint_of_mesh[i] = joint > joint_of_mesh[i]
				? joint
				: joint_of_mesh[i];
		}
	}
	check_nodes(model, joint_of_mesh);
	check_clips(model);
	model_measure(model, &stats);
	free(joint_of_mesh);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	int errors = 0;
	struct log log = fuzz_log(&errors);
	struct model *model;

	if (!gltf_recognise(data, size)) {
		return 0;
	}
	if (model_load_memory(data, size, "fuzz", &log, &model) == 0) {
		fuzz_expect(errors == 0);
		check(model);
	} else {
		fuzz_expect(errors == 1 && model == NULL);
	}
	model_destroy(model);
	return 0;
}
