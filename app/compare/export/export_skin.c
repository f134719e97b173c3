#include "app/compare/export/export_bake.h"

#include "app/compare/candidate/capped_influences.h"
#include "app/compare/export/export_levels.h"
#include "app/model/model_deltas.h"

#include <errno.h>
#include <stdlib.h>

enum {
	SET = 4 /* influences in each JOINTS_n and WEIGHTS_n */
};

/* Adds JOINTS_n and WEIGHTS_n, where n is set: influences 4 n to 4 n + 3. */
static void add_set(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int max, int set)
{
	size_t count = (size_t)primitive->vertex_count;
	uint16_t(*joint)[SET] = malloc(count * sizeof(*joint));
	float(*weight)[SET] = malloc(count * sizeof(*weight));
	char name[32];

	if (!joint || !weight) {
		glb->error = -ENOMEM;
		goto out;
	}
	for (int v = 0; v < primitive->vertex_count; v++) {
		struct capped_influences kept =
			capped_influences_of(primitive, v, max);

		for (int i = 0; i < SET; i++) {
			joint[v][i] = kept.joint[set * SET + i];
			weight[v][i] = kept.weight[set * SET + i];
		}
	}
	snprintf(name, sizeof(name), "JOINTS_%d", set);
	export_attribute(attributes, name,
		glb_add_array(
			glb, joint, primitive->vertex_count, SET, GLB_USHORT));
	snprintf(name, sizeof(name), "WEIGHTS_%d", set);
	export_attribute(attributes, name,
		glb_add_array(
			glb, weight, primitive->vertex_count, SET, GLB_FLOAT));
out:
	free(joint);
	free(weight);
}

static void add_influences(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int max)
{
	int most = max > 0 && max < primitive->influences
		? max
		: primitive->influences;

	for (int set = 0; set * SET < most; set++) {
		add_set(glb, attributes, primitive, max, set);
	}
}

static void add_deltas(struct glb *glb, json_t *target, const char *name,
	const struct model_deltas *deltas)
{
	struct arena arena = arena_empty();
	const float(*value)[3];

	if (model_deltas_floats(deltas, &arena, &value) != 0) {
		glb->error = -ENOMEM;
	} else if (value) {
		export_attribute(target, name,
			glb_add_array(glb, value, deltas->vertex_count, 3,
				GLB_FLOAT));
	}
	arena_release(&arena);
}

static json_t *targets_json(struct glb *glb,
	const struct model_primitive *primitive, int target_count)
{
	json_t *targets = json_array();

	for (int t = 0; t < target_count; t++) {
		const struct model_target *target = &primitive->target[t];
		json_t *json = json_object();

		add_deltas(glb, json, "POSITION", &target->position);
		add_deltas(glb, json, "NORMAL", &target->normal);
		json_array_append_new(targets, json);
	}
	return targets;
}

static json_t *primitive_json(struct glb *glb,
	const struct model_primitive *primitive, int max, int target_count)
{
	json_t *attributes = json_object(), *json;
	int count = primitive->vertex_count;

	export_attribute(attributes, "POSITION",
		glb_add_array(glb, primitive->position, count, 3, GLB_FLOAT));
	if (primitive->normal) {
		export_attribute(attributes, "NORMAL",
			glb_add_array(
				glb, primitive->normal, count, 3, GLB_FLOAT));
	}
	export_attributes(glb, attributes, primitive, count, NULL);
	add_influences(glb, attributes, primitive, max);
	json = json_pack("{s:o, s:i, s:i}", "attributes", attributes, "indices",
		export_indices(glb, primitive->index, primitive->index_count),
		"material", primitive->material);
	if (json && target_count > 0) {
		json_object_set_new(json, "targets",
			targets_json(glb, primitive, target_count));
	}
	return json;
}

/*
 * The lists of a mesh's primitives, which the caller frees. NULL and glb->error
 * is set if there is no memory.
 */
static struct export_lists *lists_of(
	struct glb *glb, const struct model_mesh *mesh)
{
	struct export_lists *lists =
		malloc((size_t)mesh->primitive_count * sizeof(*lists) + 1);

	for (int p = 0; lists && p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		lists[p] = (struct export_lists){primitive->index_count,
			primitive->lod_count, primitive->lod, 1.0f, false};
	}
	glb->error = lists ? glb->error : -ENOMEM;
	return lists;
}

static json_t *meshes_json(
	struct glb *glb, const struct model *model, int max, bool targets)
{
	json_t *meshes = json_array();

	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];
		json_t *primitives = json_array();

		for (int p = 0; p < mesh->primitive_count; p++) {
			json_array_append_new(primitives,
				primitive_json(glb, &mesh->primitive[p], max,
					targets ? mesh->target_count : 0));
		}
		json_array_append_new(meshes,
			json_pack("{s:s, s:o}", "name", mesh->name,
				"primitives", primitives));
	}
	return meshes;
}

static json_t *levels_json(
	struct glb *glb, const struct model *model, json_t *meshes)
{
	json_t *levels = json_array();

	for (int m = 0; m < model->mesh_count; m++) {
		struct export_lists *lists = lists_of(glb, &model->mesh[m]);

		if (lists) {
			export_level_meshes(glb, meshes, m, lists, levels);
		}
		free(lists);
	}
	return levels;
}

static void add_skins(struct glb *glb, const struct model *model)
{
	json_t *skins = json_array();

	for (int s = 0; s < model->skin_count; s++) {
		const struct model_skin *skin = &model->skin[s];
		json_t *joints = json_array();

		for (int j = 0; j < skin->joint_count; j++) {
			json_array_append_new(
				joints, json_integer(skin->joint[j]));
		}
		json_array_append_new(skins,
			json_pack("{s:o, s:i}", "joints", joints,
				"inverseBindMatrices",
				glb_add_array(glb, skin->inverse_bind,
					skin->joint_count, 16, GLB_FLOAT)));
	}
	if (model->skin_count > 0) {
		glb_set(glb, "skins", skins);
	} else {
		json_decref(skins);
	}
}

void export_skin(struct glb *glb, const struct comparison *comparison,
	int max_influences, bool targets)
{
	const struct model *model = comparison->model;
	int *mesh = malloc((size_t)model->node_count * sizeof(*mesh));
	json_t *meshes, *levels;

	if (!mesh) {
		glb->error = -ENOMEM;
		return;
	}
	for (int i = 0; i < model->node_count; i++) {
		mesh[i] = model->node[i].mesh;
	}
	export_materials(glb, model);
	meshes = meshes_json(glb, model, max_influences, targets);
	levels = levels_json(glb, model, meshes);
	glb_set(glb, "meshes", meshes);
	add_skins(glb, model);
	export_nodes(glb, model, mesh, true, targets, levels);
	json_decref(levels);
	export_clips(glb, comparison, targets);
	free(mesh);
}
