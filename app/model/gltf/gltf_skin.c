#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum {
	SET_WIDTH = 4,
	SETS_MAX = 2,
};

static int read_joint_numbers(const struct gltf_at *at,
	const struct gltf_accessor *accessor, int set,
	struct model_primitive *out)
{
	uint32_t *joint;
	int v, k;

	if (accessor->count != out->vertex_count) {
		return gltf_fail(at, -EINVAL,
			"has %d elements, but POSITION has %d", accessor->count,
			out->vertex_count);
	}
	if ((accessor->base.component != GLTF_U8 &&
		    accessor->base.component != GLTF_U16) ||
		accessor->normalized) {
		return gltf_fail(
			at, -EINVAL, "does not hold unsigned bytes or shorts");
	}
	joint = GLTF_BRIEF(at, uint32_t, (size_t)accessor->count * SET_WIDTH);
	if (!joint) {
		return -ENOMEM;
	}
	gltf_unpack_uints(accessor, joint);
	for (v = 0; v < out->vertex_count; v++) {
		uint16_t *to = out->joint +
			(size_t)v * (size_t)out->influences + set * SET_WIDTH;

		for (k = 0; k < SET_WIDTH; k++) {
			to[k] = (uint16_t)joint[(size_t)v * SET_WIDTH + (size_t)k];
		}
	}
	return 0;
}

/* Reads JOINTS_set and WEIGHTS_set, both of which the file has. */
static int read_set(
	const struct gltf_at *attributes, int set, struct model_primitive *out)
{
	const struct gltf_accessor *joints;
	struct gltf_at member;
	float *weights;
	char joints_key[32], weights_key[32];
	int error, v, k;

	snprintf(joints_key, sizeof(joints_key), "JOINTS_%d", set);
	snprintf(weights_key, sizeof(weights_key), "WEIGHTS_%d", set);
	member = gltf_member(attributes, joints_key);
	error = gltf_maybe_accessor(attributes, joints_key, "VEC4", &joints);
	if (!error) {
		error = gltf_read_attribute(attributes, weights_key, "VEC4",
			out->vertex_count, &attributes->gltf->brief, &weights);
	}
	if (!error) {
		error = read_joint_numbers(&member, joints, set, out);
	}
	for (v = 0; v < out->vertex_count && !error; v++) {
		float *to = out->weight + (size_t)v * (size_t)out->influences +
			set * SET_WIDTH;

		for (k = 0; k < SET_WIDTH; k++) {
			to[k] = weights[(size_t)v * SET_WIDTH + (size_t)k];
		}
	}
	gltf_end_brief(attributes->gltf);
	return error;
}

/* Counts the sets of influences. JOINTS_n and WEIGHTS_n must come in pairs. */
static int count_sets(const struct gltf_at *attributes, int *out)
{
	char joints[32], weights[32];
	int set;

	for (set = 0; set <= SETS_MAX; set++) {
		bool has_joints, has_weights;

		snprintf(joints, sizeof(joints), "JOINTS_%d", set);
		snprintf(weights, sizeof(weights), "WEIGHTS_%d", set);
		has_joints = json_object_get(attributes->json, joints);
		has_weights = json_object_get(attributes->json, weights);
		if (has_joints != has_weights) {
			return gltf_fail(attributes, -EINVAL,
				"has %s without %s",
				has_joints ? joints : weights,
				has_joints ? weights : joints);
		}
		if (!has_joints) {
			break;
		}
	}
	if (set > SETS_MAX) {
		gltf_warn(attributes,
			"limber uses only the first %d influences of each vertex",
			SETS_MAX * SET_WIDTH);
		set = SETS_MAX;
	}
	*out = set;
	return 0;
}

int gltf_read_influences(
	const struct gltf_at *attributes, struct model_primitive *out)
{
	size_t total;
	int sets = 0;
	int set;
	int error = count_sets(attributes, &sets);

	if (error || !sets) {
		return error;
	}
	out->influences = sets * SET_WIDTH;
	total = (size_t)out->vertex_count * (size_t)out->influences;
	out->joint = GLTF_KEEP(attributes, uint16_t, total);
	out->weight = GLTF_KEEP(attributes, float, total);
	if (!out->joint || !out->weight) {
		return -ENOMEM;
	}
	for (set = 0; set < sets && !error; set++) {
		error = read_set(attributes, set, out);
	}
	if (!error) {
		model_normalize_influences(out);
	}
	return error;
}

static int read_joints(const struct gltf_at *at, struct model_skin *out)
{
	struct gltf_at array;
	int i;
	int error = gltf_array(at, "joints", &array, &out->joint_count);

	if (!error && out->joint_count == 0) {
		error = gltf_fail(at, -EINVAL, "has no joints");
	}
	if (error) {
		return error;
	}
	out->joint = GLTF_KEEP(&array, int, out->joint_count);
	if (!out->joint) {
		return -ENOMEM;
	}
	for (i = 0; i < out->joint_count && !error; i++) {
		struct gltf_at element = gltf_element(&array, i);

		error = gltf_node(&element, &out->joint[i]);
	}
	return error;
}

static void set_identity(mat4 matrix)
{
	int i;

	memset(matrix, 0, sizeof(mat4));
	for (i = 0; i < 4; i++) {
		matrix[i][i] = 1;
	}
}

/*
 * Reads the inverse bind matrices. Without the accessor they are identities
 * (glTF 2.0, 3.7.3.3).
 */
static int read_inverse_binds(const struct gltf_at *at, struct model_skin *out)
{
	struct gltf_at member = gltf_member(at, "inverseBindMatrices");
	const struct gltf_accessor *accessor;
	int count = out->joint_count;
	int i;
	int error = gltf_maybe_accessor(
		at, "inverseBindMatrices", "MAT4", &accessor);

	if (error) {
		return error;
	}
	if (accessor && accessor->count < count) {
		return gltf_fail(&member, -EINVAL,
			"has %d matrices for %d joints", accessor->count, count);
	}
	if (accessor && accessor->base.component != GLTF_F32) {
		return gltf_fail(&member, -EINVAL, "does not hold floats");
	}
	count = accessor ? accessor->count : count;
	out->inverse_bind = GLTF_KEEP(&member, mat4, count);
	if (!out->inverse_bind) {
		return -ENOMEM;
	}
	if (accessor) {
		return gltf_unpack_floats(
			&member, accessor, &out->inverse_bind[0][0][0]);
	}
	for (i = 0; i < count; i++) {
		set_identity(out->inverse_bind[i]);
	}
	return 0;
}

static int read_skin(const struct gltf_at *at)
{
	struct model_skin *out = &at->gltf->model->skin[at->index];
	int skeleton = -1;
	int error = gltf_name(at, &out->name);

	if (!error) {
		error = read_joints(at, out);
	}
	if (!error) {
		error = gltf_maybe_index(at, "skeleton", at->gltf->node_count,
			"node", &skeleton);
	}
	return error ? error : read_inverse_binds(at, out);
}

/* Finds each mesh's skin with the fewest joints, or -1 without a skin. */
static void find_smallest_skins(const struct model *model, int *smallest)
{
	int i;

	for (i = 0; i < model->mesh_count; i++) {
		smallest[i] = -1;
	}
	for (i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		int *skin;

		if (node->skin < 0) {
			continue;
		}
		skin = &smallest[node->mesh];
		if (*skin < 0 ||
			model->skin[node->skin].joint_count <
				model->skin[*skin].joint_count) {
			*skin = node->skin;
		}
	}
}

static int check_primitive(const struct gltf_at *mesh,
	const struct model *model, int skin, struct model_primitive *primitive)
{
	struct gltf_at array = gltf_member(mesh, "primitives");
	struct gltf_at at = gltf_element(&array, primitive->file_index);
	int joint = model_max_joint(primitive);

	if (skin < 0) {
		/* Without a skin the joint numbers mean nothing. */
		primitive->influences = 0;
		primitive->joint = NULL;
		primitive->weight = NULL;
		return 0;
	}
	if (joint < 0) {
		gltf_warn(&at,
			"has no JOINTS_0, so skin %d does not move this primitive",
			skin);
	}
	if (joint >= model->skin[skin].joint_count) {
		return gltf_fail(&at, -EINVAL,
			"a vertex uses joint %d, but skin %d has %d joints",
			joint, skin, model->skin[skin].joint_count);
	}
	return 0;
}

static int check_joints(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at meshes = gltf_member(&gltf->root, "meshes");
	int *smallest = GLTF_SCRATCH(&meshes, int, model->mesh_count);
	int error = 0;
	int i, k;

	if (!smallest) {
		return -ENOMEM;
	}
	find_smallest_skins(model, smallest);
	for (i = 0; i < model->mesh_count; i++) {
		struct model_mesh *mesh = &model->mesh[i];
		struct gltf_at at =
			gltf_element(&meshes, gltf->mesh_file_index[i]);

		for (k = 0; k < mesh->primitive_count && !error; k++) {
			error = check_primitive(
				&at, model, smallest[i], &mesh->primitive[k]);
		}
	}
	return error;
}

int gltf_read_skins(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "skins", &array, &count);

	if (error) {
		return error;
	}
	model->skin = GLTF_KEEP(&array, struct model_skin, count);
	if (!model->skin) {
		return -ENOMEM;
	}
	model->skin_count = count;
	error = gltf_for_each(&array, count, read_skin);
	return error ? error : check_joints(gltf);
}
