#include "app/model/gltf/gltf_internal.h"
#include "app/model/model_order.h"
#include "app/model/transform_decompose.h"

#include <errno.h>
#include <math.h>
#include <string.h>

static int read_matrix(const struct gltf_at *at, struct model_node *out)
{
	static const float last_row[4] = {0, 0, 0, 1};
	struct gltf_at member = gltf_member(at, "matrix");
	float(*matrix)[4];
	int i;
	int error;

	if (json_object_get(at->json, "translation") ||
		json_object_get(at->json, "rotation") ||
		json_object_get(at->json, "scale")) {
		return gltf_fail(at, -EINVAL,
			"has a matrix and also a translation, rotation or scale");
	}
	matrix = gltf_alloc(
		&member, &at->gltf->model->arena, 4, sizeof(*matrix));
	if (!matrix) {
		return -ENOMEM;
	}
	error = gltf_maybe_floats(at, "matrix", &matrix[0][0], 16);
	for (i = 0; i < 4 && !error; i++) {
		if (matrix[i][3] != last_row[i]) {
			error = gltf_fail(&member, -EINVAL,
				"the last row is not 0 0 0 1");
		}
	}
	if (!error && !transform_decompose(matrix, &out->rest)) {
		out->matrix = matrix;
	}
	return error;
}

int gltf_normalize_rotation(const struct gltf_at *at, float rotation[4])
{
	double sum = 0;
	int i;

	for (i = 0; i < 4; i++) {
		sum += (double)rotation[i] * rotation[i];
	}
	if (!(sum > 0)) {
		return gltf_fail(at, -EINVAL, "is a quaternion of length 0");
	}
	for (i = 0; i < 4; i++) {
		rotation[i] = (float)(rotation[i] / sqrt(sum));
	}
	return 0;
}

static int read_transform(const struct gltf_at *at, struct model_node *out)
{
	struct gltf_at rotation = gltf_member(at, "rotation");
	struct transform *rest = &out->rest;
	int error;

	*rest = (struct transform){
		.rotation = {0, 0, 0, 1},
		.scale = {1, 1, 1},
	};
	if (json_object_get(at->json, "matrix")) {
		return read_matrix(at, out);
	}
	error = gltf_maybe_floats(at, "translation", rest->translation, 3);
	if (!error) {
		error = gltf_maybe_floats(at, "rotation", rest->rotation, 4);
	}
	if (!error) {
		error = gltf_maybe_floats(at, "scale", rest->scale, 3);
	}
	return error ? error
		     : gltf_normalize_rotation(&rotation, rest->rotation);
}

/* Reads KHR_node_visibility. */
static int read_visibility(const struct gltf_at *at, bool *hidden)
{
	struct gltf_at extensions, visibility;
	bool visible = true;
	int error = gltf_object(at, "extensions", &extensions);

	if (!error) {
		error = gltf_object(
			&extensions, "KHR_node_visibility", &visibility);
	}
	if (!error) {
		error = gltf_maybe_bool(&visibility, "visible", &visible);
	}
	*hidden = !visible;
	return error;
}

/* Warns of what the node would show with a mesh, or more than once. */
static void check_mesh(const struct gltf_at *at, struct model_node *node)
{
	const json_t *extensions = json_object_get(at->json, "extensions");

	if (node->skin >= 0 && node->mesh < 0) {
		gltf_warn(at, "has a skin but no mesh; limber ignores the skin");
		node->skin = -1;
	}
	if (node->mesh >= 0 &&
		json_object_get(extensions, "EXT_mesh_gpu_instancing")) {
		gltf_warn(at,
			"limber draws one of the instances that EXT_mesh_gpu_instancing defines: export them as nodes");
	}
}

/* Reads a node, unless it is a level of detail. */
static int read_node(const struct gltf_at *at)
{
	struct gltf *gltf = at->gltf;
	int index = gltf->node_index[at->index];
	struct model_node *out;
	int error;

	if (index < 0) {
		return 0;
	}
	out = &gltf->model->node[index];
	error = gltf_name(at, &out->name);
	out->mesh = out->skin = out->camera = -1;
	if (!error) {
		error = read_visibility(at, &out->hidden);
	}
	if (!error) {
		error = read_transform(at, out);
	}
	if (!error) {
		error = gltf_maybe_index(
			at, "mesh", gltf->mesh_count, "mesh", &out->mesh);
	}
	if (!error && out->mesh >= 0) {
		out->mesh = gltf->mesh_index[out->mesh];
	}
	if (!error) {
		error = gltf_maybe_root_index(
			at, "skin", "skins", "skin", &out->skin);
	}
	if (!error) {
		error = gltf_maybe_index(at, "camera",
			gltf->model->camera_count, "camera", &out->camera);
	}
	if (!error) {
		check_mesh(at, out);
	}
	return error;
}

/* Sets the parent of each child; a second parent is an error. */
static int read_children(const struct gltf_at *at)
{
	int *parent = at->gltf->node_parent;
	struct gltf_at array;
	int children, i;
	int error = gltf_array(at, "children", &array, &children);

	for (i = 0; i < children && !error; i++) {
		struct gltf_at element = gltf_element(&array, i);
		int child = 0;

		error = gltf_index(
			&element, at->gltf->node_count, "node", &child);
		if (error) {
			break;
		}
		if (parent[child] >= 0) {
			return gltf_fail(&element, -EINVAL,
				"node %d is already a child of node %d", child,
				parent[child]);
		}
		parent[child] = at->index;
	}
	return error;
}

/* Assigns indices to the nodes, without those that are levels of detail. */
static void number_nodes(struct gltf *gltf, const int *order)
{
	struct model_node *node = gltf->model->node;
	const int *parent = gltf->node_parent;
	int next = 0;
	int i;

	for (i = 0; i < gltf->node_count; i++) {
		int number = order[i];
		int *index = &gltf->node_index[number];

		*index = gltf->node_is_level[number] ? -1 : next++;
		if (*index >= 0) {
			node[*index].file_index = number;
			node[*index].parent = parent[number] < 0
				? -1
				: gltf->node_index[parent[number]];
		}
	}
	gltf->model->node_count = next;
}

static int order_nodes(const struct gltf_at *array, int count)
{
	struct gltf *gltf = array->gltf;
	int *order = GLTF_SCRATCH(array, int, count);
	struct gltf_at item;
	int node_on_cycle, i;
	int error;

	gltf->node_index = GLTF_SCRATCH(array, int, count);
	gltf->node_parent = GLTF_SCRATCH(array, int, count);
	if (!order || !gltf->node_index || !gltf->node_parent) {
		return -ENOMEM;
	}
	for (i = 0; i < count; i++) {
		gltf->node_parent[i] = -1;
	}
	error = gltf_for_each(array, count, read_children);
	if (error) {
		return error;
	}
	error = model_order_nodes(gltf->node_parent, count, order,
		gltf->node_index, &node_on_cycle);
	if (error == -ELOOP) {
		item = gltf_element(array, node_on_cycle);
		return gltf_fail(&item, -EINVAL, "is an ancestor of itself");
	}
	if (error) {
		return gltf_no_memory(array);
	}
	number_nodes(gltf, order);
	return 0;
}

int gltf_node(const struct gltf_at *at, int *out)
{
	int number = 0;
	int error = gltf_index(at, at->gltf->node_count, "node", &number);

	if (!error) {
		*out = at->gltf->node_index[number];
	}
	if (!error && *out < 0) {
		error = gltf_fail(at, -EINVAL,
			"node %d is a level of detail of another node", number);
	}
	return error;
}

static int mark_roots(struct gltf *gltf, const struct gltf_at *scene)
{
	struct gltf_at array;
	int count, i;
	int error = gltf_array(scene, "nodes", &array, &count);

	for (i = 0; i < count && !error; i++) {
		struct gltf_at element = gltf_element(&array, i);
		int node = 0;

		error = gltf_node(&element, &node);
		if (!error) {
			gltf->model->node[node].in_scene = true;
		}
	}
	return error;
}

/*
 * Marks the nodes of the default scene, or of the first scene if there is no
 * default, or all nodes if there is no scene.
 */
static int mark_scene(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array, item;
	int scene = 0;
	int count, i;
	int error = gltf_array(&gltf->root, "scenes", &array, &count);

	if (!error) {
		error = gltf_maybe_index(
			&gltf->root, "scene", count, "scene", &scene);
	}
	if (!error && count > 0) {
		error = gltf_item(&array, scene, &item);
		if (!error) {
			error = mark_roots(gltf, &item);
		}
	}
	for (i = 0; i < model->node_count && !error; i++) {
		int parent = model->node[i].parent;

		model->node[i].in_scene |= count == 0 ||
			(parent >= 0 && model->node[parent].in_scene);
		model->node[i].hidden |=
			parent >= 0 && model->node[parent].hidden;
	}
	return error;
}

/* Reads a node's weights, else its mesh's, else 0 (glTF 2.0, 3.7.2.2). */
static int read_node_weights(
	const struct gltf_at *at, const struct model_node *node, float *out)
{
	const struct gltf *gltf = at->gltf;
	float *weights = NULL;
	int count = gltf->model->mesh[node->mesh].target_count;
	int error = gltf_read_weights(at, count, &weights);

	if (error) {
		return error;
	}
	weights = weights ? weights : gltf->mesh_weights[node->mesh];
	if (weights) {
		memcpy(out, weights, (size_t)count * sizeof(*out));
	}
	return 0;
}

static int read_rest_weights(const struct gltf_at *array)
{
	struct gltf *gltf = array->gltf;
	struct model *model = gltf->model;
	int total = 0;
	int error = 0;
	int i;

	for (i = 0; i < model->node_count; i++) {
		struct model_node *node = &model->node[i];

		node->weight_offset = total;
		if (node->mesh >= 0 &&
			!count_add(total, model->mesh[node->mesh].target_count,
				&total)) {
			return gltf_fail(array, -EFBIG,
				"the nodes have too many morph weights");
		}
	}
	model->rest_weights = GLTF_KEEP(array, float, total);
	if (!model->rest_weights) {
		return -ENOMEM;
	}
	model->weight_count = total;
	for (i = 0; i < model->node_count && !error; i++) {
		const struct model_node *node = &model->node[i];
		struct gltf_at item = gltf_element(array, node->file_index);

		if (node->mesh >= 0) {
			error = read_node_weights(&item, node,
				model->rest_weights + node->weight_offset);
		}
	}
	return error;
}

int gltf_read_nodes(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "nodes", &array, &count);

	if (error) {
		return error;
	}
	model->node = GLTF_KEEP(&array, struct model_node, count);
	if (!model->node) {
		return -ENOMEM;
	}
	error = order_nodes(&array, count);
	if (!error) {
		error = gltf_for_each(&array, count, read_node);
	}
	if (!error) {
		error = mark_scene(gltf);
	}
	return error ? error : read_rest_weights(&array);
}
