#include "app/anim/pose_normals.h"

#include "app/anim/math/matrix.h"

#include <errno.h>

/*
 * Scales may differ by this many units of a float's last place, which is 1 in
 * 512 to 1 in 256 of the value.
 */
static const uint32_t tolerance_bits = 0x8000;

static void find_uneven_binds(
	struct pose_normals *normals, const struct model *model)
{
	for (int i = 0; i < model->skin_count; i++) {
		const struct model_skin *skin = &model->skin[i];

		for (int j = 0; j < skin->joint_count; j++) {
			if (!matrix_is_even(
				    (const mat4 *)&skin->inverse_bind[j])) {
				normals->uneven_bind[i] = true;
			}
		}
		normals->always = normals->always || normals->uneven_bind[i];
	}
}

int pose_normals_init(struct pose_normals *normals, const struct model *model,
	struct arena *arena)
{
	size_t nodes = (size_t)model->node_count;
	size_t skins = (size_t)model->skin_count;

	*normals = (struct pose_normals){
		.uneven = ARENA_ARRAY(arena, bool, nodes),
		.uneven_bind = ARENA_ARRAY(arena, bool, skins),
		.palette = ARENA_ARRAY(arena, mat4 *, skins),
	};
	if (!normals->uneven || !normals->uneven_bind || !normals->palette) {
		return -ENOMEM;
	}
	for (size_t i = 0; i < skins; i++) {
		normals->palette[i] = ARENA_ARRAY(
			arena, mat4, (size_t)model->skin[i].joint_count);
		if (!normals->palette[i]) {
			return -ENOMEM;
		}
	}
	find_uneven_binds(normals, model);
	return 0;
}

static inline uint32_t magnitude_bits(float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	return bits & INT32_MAX;
}

/* Compares bits as integers, since VFP11 takes long to compare floats. */
static inline bool is_uneven(const float scale[3])
{
	uint32_t x = magnitude_bits(scale[0]) + tolerance_bits;
	uint32_t y = x - magnitude_bits(scale[1]);
	uint32_t z = x - magnitude_bits(scale[2]);

	return (y > z ? y : z) > 2 * tolerance_bits;
}

/* The loader gives a node a matrix only if the matrix shears. */
static bool is_sheared(const struct pose *pose, int node)
{
	return pose->model->node[node].matrix && !pose->animated[node];
}

static bool any_is_uneven(const struct pose *pose)
{
	for (int i = 0; i < pose->matrix_end; i++) {
		if (is_sheared(pose, i)) {
			return true;
		}
	}
	for (int i = 0; i < pose->node_count; i++) {
		if (is_uneven(pose->local[i].scale)) {
			return true;
		}
	}
	return false;
}

bool pose_normals_find(struct pose_normals *normals, const struct pose *pose)
{
	const struct model_node *node = pose->model->node;

	if (!normals->always && !any_is_uneven(pose)) {
		return false;
	}
	for (int i = 0; i < pose->node_count; i++) {
		int parent = node[i].parent;

		normals->uneven[i] = (parent >= 0 && normals->uneven[parent]) ||
			is_sheared(pose, i) || is_uneven(pose->local[i].scale);
	}
	return true;
}

static bool has_uneven_joint(
	const struct pose_normals *normals, const struct model_skin *skin)
{
	for (int j = 0; j < skin->joint_count; j++) {
		if (normals->uneven[skin->joint[j]]) {
			return true;
		}
	}
	return false;
}

const mat4 *pose_normals_palette(struct pose_normals *normals,
	const struct model *model, int skin, const mat4 *palette)
{
	const struct model_skin *s = &model->skin[skin];
	bool all = normals->uneven_bind[skin];
	mat4 *out = normals->palette[skin];

	if (!all && !has_uneven_joint(normals, s)) {
		return palette;
	}
	for (int j = 0; j < s->joint_count; j++) {
		if (all || normals->uneven[s->joint[j]]) {
			matrix_normals(&palette[j], &out[j]);
		} else {
			memcpy(out[j], palette[j], sizeof(mat4));
		}
	}
	return (const mat4 *)out;
}
