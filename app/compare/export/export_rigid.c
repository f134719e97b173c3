#include "app/compare/export/export_bake.h"

#include <errno.h>
#include <stdlib.h>

static json_t *part_json(struct glb *glb, const struct rigid_bake *rigid,
	const struct rigid_part *part, const struct model_primitive *primitive,
	const int *source)
{
	json_t *attributes = json_object();
	int first = part->first_vertex;

	export_attribute(attributes, "POSITION",
		glb_add_array(glb, rigid->position + first, part->vertex_count,
			3, GLB_FLOAT));
	if (primitive->normal) {
		export_attribute(attributes, "NORMAL",
			glb_add_array(glb, rigid->normal + first,
				part->vertex_count, 3, GLB_FLOAT));
	}
	export_attributes(
		glb, attributes, primitive, part->vertex_count, source);
	return json_pack("{s:o, s:i, s:i}", "attributes", attributes, "indices",
		export_indices(glb, rigid->index + part->first_index,
			part->index_count),
		"material", primitive->material);
}

static json_t *primitive_json(struct glb *glb, const struct rigid_bake *rigid,
	const struct rigid_part *part)
{
	const struct reference *reference = rigid->reference;
	const struct reference_part *from = &reference->part[part->part];
	const struct drawable *drawable =
		&reference->instance->drawable[from->drawable];
	int *source = malloc((size_t)part->vertex_count * sizeof(*source));
	json_t *json;

	if (!source) {
		glb->error = -ENOMEM;
		return NULL;
	}
	for (int i = 0; i < part->vertex_count; i++) {
		source[i] = rigid->source[part->first_vertex + i] -
			from->first_vertex;
	}
	json = part_json(glb, rigid, part, drawable->primitive, source);
	free(source);
	return json;
}

/* Makes a mesh whose primitives are the node's parts; NULL if it has none. */
static json_t *mesh_json(
	struct glb *glb, const struct rigid_bake *rigid, int node)
{
	json_t *primitives = json_array();

	for (int i = 0; i < rigid->part_count; i++) {
		if (rigid->part[i].node == node) {
			json_array_append_new(primitives,
				primitive_json(glb, rigid, &rigid->part[i]));
		}
	}
	if (json_array_size(primitives) == 0) {
		json_decref(primitives);
		return NULL;
	}
	return json_pack("{s:o}", "primitives", primitives);
}

void export_rigid(struct glb *glb, const struct rigid_bake *rigid,
	const struct comparison *comparison)
{
	const struct model *model = comparison->model;
	json_t *meshes = json_array();
	int *mesh = malloc((size_t)model->node_count * sizeof(*mesh));

	if (!mesh) {
		glb->error = -ENOMEM;
		json_decref(meshes);
		return;
	}
	for (int i = 0; i < model->node_count; i++) {
		json_t *json = mesh_json(glb, rigid, i);

		mesh[i] = json ? (int)json_array_size(meshes) : -1;
		if (json) {
			json_array_append_new(meshes, json);
		}
	}
	export_materials(glb, model);
	glb_set(glb, "meshes", meshes);
	export_nodes(glb, model, mesh, false, false, NULL);
	export_clips(glb, comparison, false);
	free(mesh);
}
