#include "app/model/xfile/xfile_build.h"
#include "app/model/xfile/xfile_convert.h"

#include <cglm/mat4.h>
#include <string.h>

enum {
	WIDTH_MAX = 8,
	JOINTS_MAX = 65535,
};

/*
 * Inserts an influence in order of weight. Returns whether one was dropped,
 * which is the smallest.
 */
static bool insert(
	uint16_t *joint, float *weight, uint16_t new_joint, float new_weight)
{
	bool drops_one = weight[WIDTH_MAX - 1] > 0;
	int at = WIDTH_MAX - 1;

	if (!(new_weight > weight[at])) {
		return drops_one;
	}
	for (; at > 0 && new_weight > weight[at - 1]; at--) {
		weight[at] = weight[at - 1];
		joint[at] = joint[at - 1];
	}
	weight[at] = new_weight;
	joint[at] = new_joint;
	return drops_one;
}

static void gather_influences(struct xfile_build *build,
	const struct xfile_mesh *mesh, struct xfile_influences *out)
{
	const struct xfile_bone *bone = mesh->bones;
	size_t dropped = 0;

	for (uint16_t joint = 0; bone; bone = bone->next, joint++) {
		for (uint32_t i = 0; i < bone->count; i++) {
			uint32_t vertex = bone->vertex[i];

			if (bone->weight[i] > 0) {
				dropped += insert(out->joint[vertex],
					out->weight[vertex], joint,
					bone->weight[i]);
			}
		}
	}
	if (dropped) {
		log_note(build->log,
			"%s: mesh \"%.200s\" has vertices with more than %d bones; limber drops the %zu smallest weights",
			build->context->path, mesh->name, WIDTH_MAX, dropped);
	}
}

/*
 * Attaches vertices without a bone to the given joint and sets out->width.
 * Returns whether there are such vertices.
 */
static bool bind_unweighted(const struct xfile_mesh *mesh, uint16_t joint,
	struct xfile_influences *out)
{
	bool any = false;

	out->width = 4;
	for (uint32_t i = 0; i < mesh->vertex_count; i++) {
		if (out->weight[i][4] > 0) {
			out->width = WIDTH_MAX;
		}
		if (!(out->weight[i][0] > 0)) {
			out->weight[i][0] = 1;
			out->joint[i][0] = joint;
			any = true;
		}
	}
	return any;
}

static void fill_joint(struct xfile_build *build, const struct xfile_mesh *mesh,
	const struct xfile_bone *bone, int mesh_node, int *joint, mat4 bind)
{
	int frame = xfile_names_find(&build->frame_names, bone->name);

	if (frame >= 0) {
		*joint = build->node_index[frame];
		xfile_convert_matrix(bone->offset, bind);
		return;
	}
	xfile_warn_at(build->context, bone->location,
		"the bone \"%.200s\" of mesh \"%.200s\" has no frame; it stays at rest",
		bone->name, mesh->name);
	*joint = mesh_node;
	glm_mat4_identity(bind);
}

static int make_skin(struct xfile_build *build, const struct xfile_mesh *mesh,
	int mesh_index, int joint_count)
{
	struct model *model = build->model;
	struct model_skin *skin = &model->skin[model->skin_count];
	const struct xfile_bone *bone = mesh->bones;
	int mesh_node = build->mesh_node[mesh_index];

	build->mesh_skin[mesh_index] = model->skin_count++;
	skin->name = arena_strdup(&model->arena, mesh->name);
	skin->joint_count = joint_count;
	skin->joint = ARENA_ARRAY(&model->arena, int, joint_count);
	skin->inverse_bind = ARENA_ARRAY(&model->arena, mat4, joint_count);
	if (!skin->name || !skin->joint || !skin->inverse_bind) {
		return xfile_no_memory(build->context);
	}
	for (int i = 0; bone; bone = bone->next, i++) {
		fill_joint(build, mesh, bone, mesh_node, &skin->joint[i],
			skin->inverse_bind[i]);
	}
	if (joint_count > (int)mesh->bone_count) {
		skin->joint[joint_count - 1] = mesh_node;
		glm_mat4_identity(skin->inverse_bind[joint_count - 1]);
	}
	return 0;
}

int xfile_build_skin(struct xfile_build *build, const struct xfile_mesh *mesh,
	int mesh_index, struct xfile_influences *out)
{
	bool unweighted;

	if (!mesh->bone_count) {
		return 0;
	}
	if (mesh->bone_count >= JOINTS_MAX) {
		return xfile_fail_at(build->context, mesh->location,
			"mesh \"%.200s\" has %u bones; limber supports up to %d",
			mesh->name, (unsigned)mesh->bone_count, JOINTS_MAX - 1);
	}
	out->joint = arena_alloc(
		build->scratch, mesh->vertex_count, sizeof(*out->joint));
	out->weight = arena_alloc(
		build->scratch, mesh->vertex_count, sizeof(*out->weight));
	if (!out->joint || !out->weight) {
		return xfile_no_memory(build->context);
	}
	gather_influences(build, mesh, out);
	unweighted = bind_unweighted(mesh, (uint16_t)mesh->bone_count, out);
	return make_skin(
		build, mesh, mesh_index, (int)mesh->bone_count + unweighted);
}
