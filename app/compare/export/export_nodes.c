#include "app/compare/export/export_bake.h"

#include "app/compare/export/export_levels.h"

#include <math.h>

static json_t *node_json(const struct model_node *node, int mesh, bool skins)
{
	json_t *json = json_pack("{s:s}", "name", node->name);

	if (!json) {
		return NULL;
	}
	if (mesh >= 0) {
		json_object_set_new(json, "mesh", json_integer(mesh));
	}
	if (mesh >= 0 && skins && node->skin >= 0) {
		json_object_set_new(json, "skin", json_integer(node->skin));
	}
	if (node->matrix) {
		json_object_set_new(
			json, "matrix", glb_floats(&node->matrix[0][0], 16));
		return json;
	}
	json_object_set_new(
		json, "translation", glb_floats(node->rest.translation, 3));
	json_object_set_new(
		json, "rotation", glb_floats(node->rest.rotation, 4));
	json_object_set_new(json, "scale", glb_floats(node->rest.scale, 3));
	return json;
}

/* The node's own weights at rest, unless all of them are 0: glTF's default. */
static void add_rest_weights(
	json_t *json, const struct model *model, const struct model_node *node)
{
	int count = node->mesh >= 0 ? model->mesh[node->mesh].target_count : 0;
	const float *weight =
		count > 0 ? model->rest_weights + node->weight_offset : NULL;

	for (int t = 0; t < count; t++) {
		if (weight[t] != 0.0f) {
			json_object_set_new(
				json, "weights", glb_floats(weight, count));
			return;
		}
	}
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

void export_nodes(struct glb *glb, const struct model *model, const int *mesh,
	bool skins, bool targets, const json_t *levels)
{
	json_t *nodes = json_array(), *roots = json_array();

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		json_t *json = node_json(node, mesh[i], skins);

		if (targets) {
			add_rest_weights(json, model, node);
		}
		json_array_append_new(nodes, json);
		if (node->parent >= 0) {
			add_child(nodes, node->parent, i);
		} else if (node->in_scene || !skins) {
			json_array_append_new(roots, json_integer(i));
		}
	}
	export_level_nodes(
		glb, nodes, json_object_get(glb->root, "meshes"), levels);
	glb_set(glb, "nodes", nodes);
	glb_set(glb, "scenes", json_pack("[{s:o}]", "nodes", roots));
	glb_set(glb, "scene", json_integer(0));
}

void export_origin(struct glb *glb, const struct model *model)
{
	json_t *nodes = json_object_get(glb->root, "nodes");
	json_t *scene = json_array_get(json_object_get(glb->root, "scenes"), 0);
	const double *at = model->origin;

	if (at[0] == 0 && at[1] == 0 && at[2] == 0) {
		return;
	}
	json_array_append_new(nodes,
		json_pack("{s:s, s:[f,f,f], s:O}", "name", "origin",
			"translation", at[0], at[1], at[2], "children",
			json_object_get(scene, "nodes")));
	json_object_set_new(scene, "nodes",
		json_pack("[i]", (int)json_array_size(nodes) - 1));
}

static json_t *channel_json(const struct model_channel *channel, int sampler)
{
	static const char *const path[] = {
		[MODEL_TRANSLATION] = "translation",
		[MODEL_ROTATION] = "rotation",
		[MODEL_SCALE] = "scale",
		[MODEL_WEIGHTS] = "weights",
	};

	return json_pack("{s:i, s:{s:i, s:s}}", "sampler", sampler, "target",
		"node", channel->node, "path", path[channel->path]);
}

/* Consecutive channels often have the same times, which are stored once. */
struct last_times {
	const float *time_s;
	int count, accessor;
};

static json_t *sampler_json(struct glb *glb,
	const struct model_channel *channel, struct last_times *last)
{
	static const char *const interpolation[] = {
		[MODEL_STEP] = "STEP",
		[MODEL_LINEAR] = "LINEAR",
		[MODEL_CUBICSPLINE] = "CUBICSPLINE",
	};
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;
	bool scalars = channel->path == MODEL_WEIGHTS;
	int values = channel->key_count * (cubic ? 3 : 1);
	int width = scalars ? 1 : channel->width;

	if (last->time_s != channel->time_s ||
		last->count != channel->key_count) {
		*last = (struct last_times){channel->time_s, channel->key_count,
			glb_add_array(glb, channel->time_s, channel->key_count,
				1, GLB_FLOAT)};
	}
	return json_pack("{s:i, s:i, s:s}", "input", last->accessor, "output",
		channel->packed
			? glb_add_array(glb, channel->packed, values, width,
				  GLB_SHORT)
			: glb_add_array(glb, channel->value,
				  scalars ? values * channel->width : values,
				  width, GLB_FLOAT),
		"interpolation", interpolation[channel->interpolation]);
}

/* Finds a node whose translation the clip does not change, or -1. */
static int find_still_node(
	const struct model *model, const struct model_clip *clip)
{
	for (int node = 0; node < model->node_count; node++) {
		bool still = !model->node[node].matrix;

		for (int i = 0; still && i < clip->channel_count; i++) {
			still = clip->channel[i].node != node ||
				clip->channel[i].path != MODEL_TRANSLATION;
		}
		if (still) {
			return node;
		}
	}
	return -1;
}

/*
 * Without the weights of targets, a clip might end early or have no channels. A
 * channel that holds a node at its rest translation keeps the clip's duration.
 */
static void keep_duration(struct glb *glb, const struct model *model,
	const struct model_clip *clip, json_t *samplers, json_t *channels)
{
	int node = find_still_node(model, clip);
	float time_s[2] = {0.0f, clip->duration_s}, still[2][3];
	int input, output;

	if (node < 0) {
		return;
	}
	for (int axis = 0; axis < 3; axis++) {
		still[0][axis] = still[1][axis] =
			model->node[node].rest.translation[axis];
	}
	json_array_append_new(channels,
		json_pack("{s:i, s:{s:i, s:s}}", "sampler",
			(int)json_array_size(samplers), "target", "node", node,
			"path", "translation"));
	/* In two statements, so that all compilers order the file alike. */
	input = glb_add_array(glb, time_s, 2, 1, GLB_FLOAT);
	output = glb_add_array(glb, still, 2, 3, GLB_FLOAT);
	json_array_append_new(samplers,
		json_pack("{s:i, s:i, s:s}", "input", input, "output", output,
			"interpolation", "STEP"));
}

static float later(float end_s, const struct model_channel *channel)
{
	return fmaxf(end_s, channel->time_s[channel->key_count - 1]);
}

static json_t *clip_json(struct glb *glb, const struct model *model,
	const struct model_clip *clip, bool targets)
{
	json_t *samplers = json_array(), *channels = json_array();
	struct last_times last = {.time_s = NULL};
	float end_s = 0.0f;
	int count = 0;

	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->path != MODEL_WEIGHTS || targets) {
			json_array_append_new(
				samplers, sampler_json(glb, channel, &last));
			json_array_append_new(
				channels, channel_json(channel, count++));
			end_s = later(end_s, channel);
		}
	}
	if (end_s < clip->duration_s) {
		keep_duration(glb, model, clip, samplers, channels);
	}
	if (json_array_size(channels) == 0) {
		json_decref(samplers);
		json_decref(channels);
		return NULL;
	}
	return json_pack("{s:s, s:o, s:o}", "name", clip->name, "samplers",
		samplers, "channels", channels);
}

void export_clips(
	struct glb *glb, const struct comparison *comparison, bool targets)
{
	json_t *animations = json_array();

	for (int c = 0; c < comparison->clip_count; c++) {
		int clip = comparison->clip[c].clip;
		json_t *json = clip_json(glb, comparison->model,
			&comparison->model->clip[clip], targets);

		if (json) {
			json_array_append_new(animations, json);
		}
	}
	if (json_array_size(animations) > 0) {
		glb_set(glb, "animations", animations);
	} else {
		json_decref(animations);
	}
}
