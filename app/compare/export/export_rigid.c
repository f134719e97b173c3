#include "app/compare/export/export_bake.h"

#include <errno.h>
#include <stdlib.h>

static json_t *node_json(const struct model_node *node)
{
	json_t *json = json_pack("{s:s}", "name", node->name);

	if (json && node->matrix) {
		json_object_set_new(
			json, "matrix", glb_floats(&node->matrix[0][0], 16));
	} else if (json) {
		json_object_set_new(json, "translation",
			glb_floats(node->rest.translation, 3));
		json_object_set_new(
			json, "rotation", glb_floats(node->rest.rotation, 4));
		json_object_set_new(
			json, "scale", glb_floats(node->rest.scale, 3));
	}
	return json;
}

static void add_child(json_t *nodes, int parent, int child)
{
	json_t *node = json_array_get(nodes, (size_t)parent);
	json_t *children = json_object_get(node, "children");

	if (!children) {
		children = json_array();
		json_object_set_new(node, "children", children);
	}
	json_array_append_new(children, json_integer(child));
}

/* Adds the model's nodes, then a child node for each part. */
static void add_nodes(struct glb *glb, const struct rigid_bake *rigid)
{
	const struct model *model = rigid->reference->model;
	json_t *nodes = json_array(), *roots = json_array();

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		json_array_append_new(nodes, node_json(node));
		if (node->parent >= 0) {
			add_child(nodes, node->parent, i);
		} else {
			json_array_append_new(roots, json_integer(i));
		}
	}
	for (int i = 0; i < rigid->part_count; i++) {
		json_array_append_new(nodes, json_pack("{s:i}", "mesh", i));
		add_child(nodes, rigid->part[i].node, model->node_count + i);
	}
	glb_set(glb, "nodes", nodes);
	glb_set(glb, "scenes", json_pack("[{s:o}]", "nodes", roots));
	glb_set(glb, "scene", json_integer(0));
}

static json_t *primitive_json(struct glb *glb, const struct rigid_bake *rigid,
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
		glb_add_array(glb, rigid->index + part->first_index,
			part->index_count, 1, GLB_UINT),
		"material", primitive->material);
}

static json_t *mesh_json(struct glb *glb, const struct rigid_bake *rigid,
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
	json = json_pack("{s:[o]}", "primitives",
		primitive_json(glb, rigid, part, drawable->primitive, source));
	free(source);
	return json;
}

static json_t *channel_json(const struct model_channel *channel, int sampler)
{
	static const char *const path[] = {
		[MODEL_TRANSLATION] = "translation",
		[MODEL_ROTATION] = "rotation",
		[MODEL_SCALE] = "scale",
	};

	return json_pack("{s:i, s:{s:i, s:s}}", "sampler", sampler, "target",
		"node", channel->node, "path", path[channel->path]);
}

static json_t *sampler_json(struct glb *glb, const struct model_channel *channel)
{
	static const char *const interpolation[] = {
		[MODEL_STEP] = "STEP",
		[MODEL_LINEAR] = "LINEAR",
		[MODEL_CUBICSPLINE] = "CUBICSPLINE",
	};
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;
	int values = channel->key_count * (cubic ? 3 : 1);

	return json_pack("{s:i, s:i, s:s}", "input",
		glb_add_array(
			glb, channel->time_s, channel->key_count, 1, GLB_FLOAT),
		"output",
		glb_add_array(
			glb, channel->value, values, channel->width, GLB_FLOAT),
		"interpolation", interpolation[channel->interpolation]);
}

static void add_clip(struct glb *glb, const struct model_clip *clip)
{
	json_t *samplers = json_array(), *channels = json_array();
	int count = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->path != MODEL_WEIGHTS) {
			json_array_append_new(
				samplers, sampler_json(glb, channel));
			json_array_append_new(
				channels, channel_json(channel, count++));
		}
	}
	glb_set(glb, "animations",
		json_pack("[{s:s, s:o, s:o}]", "name", clip->name, "samplers",
			samplers, "channels", channels));
}

void export_rigid(struct glb *glb, const struct rigid_bake *rigid)
{
	json_t *meshes = json_array();

	for (int i = 0; i < rigid->part_count; i++) {
		json_array_append_new(
			meshes, mesh_json(glb, rigid, &rigid->part[i]));
	}
	export_materials(glb, rigid->reference->model);
	glb_set(glb, "meshes", meshes);
	add_nodes(glb, rigid);
	add_clip(glb, rigid->reference->clip);
}
