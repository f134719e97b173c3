#include "app/model/xfile/xfile_build.h"

#include "app/model/model_order.h"
#include "app/model/origin/model_origin.h"
#include "app/model/xfile/xfile_convert.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <limits.h>
#include <string.h>

/* Whether a clip or a skin names frames. */
static bool names_frames(const struct xfile_scene *scene)
{
	const struct xfile_mesh *mesh = scene->meshes;

	while (mesh && mesh->bone_count == 0) {
		mesh = mesh->next;
	}
	return mesh || scene->set_count > 0;
}

static void index_frames(struct xfile_build *build)
{
	const struct xfile_frame *frame = build->scene->frames;
	const char *name = NULL;
	int equal = 0;

	for (int i = 0; frame; frame = frame->next, i++) {
		if (!xfile_names_add(&build->frame_names, frame->name, i)) {
			name = name ? name : frame->name;
			equal++;
		}
	}
	if (equal > 0 && names_frames(build->scene)) {
		log_warning(build->log,
			"%s: frames with the name of an earlier frame, such as \"%.200s\" (%d): clips and skins move the earlier one, so give each frame a name of its own",
			build->context->path, name, equal);
	}
}

static int index_names(struct xfile_build *build)
{
	const struct xfile_scene *scene = build->scene;
	struct arena *scratch = build->scratch;
	const struct xfile_material *material = scene->materials;
	const struct xfile_mesh *mesh = scene->meshes;

	build->mesh = ARENA_ARRAY(
		scratch, const struct xfile_mesh *, scene->mesh_count);
	if (!build->mesh ||
		xfile_names_init(&build->frame_names, scratch,
			(size_t)scene->frame_count) ||
		xfile_names_init(&build->mesh_names, scratch,
			(size_t)scene->mesh_count) ||
		xfile_names_init(&build->material_names, scratch,
			(size_t)scene->material_count)) {
		return xfile_no_memory(build->context);
	}
	index_frames(build);
	for (int i = 0; mesh; mesh = mesh->next, i++) {
		xfile_names_add(&build->mesh_names, mesh->name, i);
		build->mesh[i] = mesh;
	}
	for (; material; material = material->next) {
		xfile_names_add(&build->material_names, material->name,
			material->index);
	}
	return 0;
}

static void add_instance(struct xfile_build *build, int mesh, int frame)
{
	if (build->mesh[mesh]->faces.count) {
		build->instance[build->instance_count++] =
			(struct xfile_instance){.mesh = mesh, .frame = frame};
	}
}

/* Adds the instances that refer to a mesh by name. */
static void list_references(struct xfile_build *build, bool *referenced)
{
	const struct xfile_frame *frame = build->scene->frames;

	for (int i = 0; frame; frame = frame->next, i++) {
		const struct xfile_reference *at = frame->references;

		for (; at; at = at->next) {
			int mesh =
				xfile_names_find(&build->mesh_names, at->name);

			if (mesh < 0) {
				xfile_warn_at(build->context, at->location,
					"this frame refers to the mesh \"%.200s\", which does not exist",
					at->name);
				continue;
			}
			referenced[mesh] = true;
			add_instance(build, mesh, i);
		}
	}
}

static int list_instances(struct xfile_build *build)
{
	const struct xfile_scene *scene = build->scene;
	const struct xfile_frame *frame = scene->frames;
	size_t count = (size_t)scene->mesh_count;
	bool *referenced = ARENA_ARRAY(build->scratch, bool, count);

	for (; frame; frame = frame->next) {
		const struct xfile_reference *at = frame->references;

		for (; at; at = at->next) {
			count++;
		}
	}
	build->instance =
		ARENA_ARRAY(build->scratch, struct xfile_instance, count);
	if (!build->instance || !referenced) {
		return xfile_no_memory(build->context);
	}
	list_references(build, referenced);
	for (int i = 0; i < scene->mesh_count; i++) {
		if (build->mesh[i]->frame >= 0 || !referenced[i]) {
			add_instance(build, i, build->mesh[i]->frame);
		}
	}
	return 0;
}

/* Numbers the nodes. A frame's own node draws the frame's first mesh. */
static int number_nodes(struct xfile_build *build, int *parent)
{
	const struct xfile_frame *frame = build->scene->frames;
	bool *drawn =
		ARENA_ARRAY(build->scratch, bool, build->scene->frame_count);
	int count = 0;

	if (!drawn) {
		return xfile_no_memory(build->context);
	}
	for (; frame; frame = frame->next) {
		parent[count++] = frame->parent;
	}
	for (int i = 0; i < build->instance_count; i++) {
		struct xfile_instance *instance = &build->instance[i];

		if (instance->frame >= 0 && !drawn[instance->frame]) {
			drawn[instance->frame] = true;
			instance->node = instance->frame;
		} else {
			instance->node = count;
			parent[count++] = instance->frame;
		}
	}
	build->model->node_count = count;
	return 0;
}

static int order_nodes(struct xfile_build *build, int *parent)
{
	struct model *model = build->model;
	int count = model->node_count;
	int *order = ARENA_ARRAY(build->scratch, int, count);
	int culprit;

	build->node_index = ARENA_ARRAY(build->scratch, int, count);
	build->moved = ARENA_ARRAY(build->scratch, bool, count);
	model->node = ARENA_ARRAY(&model->arena, struct model_node, count);
	if (!order || !build->node_index || !build->moved || !model->node ||
		model_order_nodes(
			parent, count, order, build->node_index, &culprit)) {
		return xfile_no_memory(build->context);
	}
	for (int i = 0; i < count; i++) {
		int from = parent[order[i]];

		model->node[i] = (struct model_node){
			.name = "",
			.file_index = order[i],
			.parent = from < 0 ? -1 : build->node_index[from],
			.in_scene = true,
			.rest = {.rotation = {0, 0, 0, 1}, .scale = {1, 1, 1}},
			.mesh = -1,
			.skin = -1,
			.camera = -1,
		};
	}
	return 0;
}

static int make_nodes(struct xfile_build *build)
{
	size_t count = (size_t)build->scene->frame_count +
		(size_t)build->instance_count;
	int *parent = ARENA_ARRAY(build->scratch, int, count);
	int error;

	if (!parent || count > INT_MAX) {
		return xfile_no_memory(build->context);
	}
	error = number_nodes(build, parent);
	return error ? error : order_nodes(build, parent);
}

/*
 * Sets a frame's name and transform. This runs after the clips, because a node
 * that a clip moves keeps no matrix.
 */
static int fill_frame(struct xfile_build *build,
	const struct xfile_frame *frame, int node_index)
{
	struct arena *arena = &build->model->arena;
	struct model_node *node = &build->model->node[node_index];
	mat4 matrix;
	mat4 *kept;

	node->name = arena_strdup(arena, frame->name);
	if (!node->name) {
		return xfile_no_memory(build->context);
	}
	xfile_convert_matrix(frame->matrix, matrix);
	if (xfile_decompose(matrix, &node->rest)) {
		return 0;
	}
	if (build->moved[node_index]) {
		log_warning(build->log,
			"%s: limber drops the shear of frame \"%.200s\", because a clip moves the frame",
			build->context->path, frame->name);
		return 0;
	}
	kept = ARENA_NEW(arena, mat4);
	if (!kept) {
		return xfile_no_memory(build->context);
	}
	memcpy(kept, matrix, sizeof(matrix));
	node->matrix = (const float(*)[4]) * kept;
	return 0;
}

static int fill_nodes(struct xfile_build *build)
{
	const struct xfile_frame *frame = build->scene->frames;
	struct model *model = build->model;

	for (int i = 0; frame; frame = frame->next, i++) {
		int error = fill_frame(build, frame, build->node_index[i]);

		if (error) {
			return error;
		}
	}
	for (int i = 0; i < build->instance_count; i++) {
		const struct xfile_instance *instance = &build->instance[i];
		struct model_node *node =
			&model->node[build->node_index[instance->node]];

		node->mesh = build->mesh_index[instance->mesh];
		node->skin = build->mesh_skin[instance->mesh];
		if (instance->node >= build->scene->frame_count) {
			node->name = model->mesh[node->mesh].name;
		}
	}
	return 0;
}

static int move_to_origin(struct xfile_build *build)
{
	return model_origin_move(build->model, build->scratch) == 0
		? 0
		: xfile_no_memory(build->context);
}

int xfile_build(struct xfile_build *build)
{
	static int (*const step[])(struct xfile_build *) = {
		index_names,
		list_instances,
		make_nodes,
		xfile_build_materials,
		xfile_build_meshes,
		xfile_build_clips,
		fill_nodes,
		move_to_origin,
	};
	int error = 0;

	for (size_t i = 0; !error && i < ARRAY_COUNT(step); i++) {
		error = interrupt_pending() ? -EINTR : step[i](build);
	}
	return error;
}
