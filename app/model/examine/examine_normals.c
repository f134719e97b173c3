/*
 * Which primitives limber lights from the wrong side, since their normals and
 * the order of their triangles' corners contradict each other.
 */
#include "app/model/examine/examine.h"

#include <cglm/mat3.h>
#include <errno.h>
#include <string.h>

/* How nodes show a mesh; a mesh may be shown in both ways. */
enum {
	SHOWN = 1,
	SHOWN_TURNED = 2
};

/*
 * Returns the product of a triangle's normal, by the order of its corners, and
 * of the sum of its corners' normals.
 */
static float facing(
	const struct model_primitive *primitive, const uint32_t corner[3])
{
	float side[2][3], sum[3];

	for (int axis = 0; axis < 3; axis++) {
		float from = primitive->position[corner[0]][axis];

		sum[axis] = primitive->normal[corner[0]][axis];
		for (int i = 0; i < 2; i++) {
			uint32_t v = corner[i + 1];

			side[i][axis] = primitive->position[v][axis] - from;
			sum[axis] += primitive->normal[v][axis];
		}
	}
	return sum[0] * (side[0][1] * side[1][2] - side[0][2] * side[1][1]) +
		sum[1] * (side[0][2] * side[1][0] - side[0][0] * side[1][2]) +
		sum[2] * (side[0][0] * side[1][1] - side[0][1] * side[1][0]);
}

/* -1: the normals of most triangles point to their back; 1: to their front. */
static int find_side(const struct model_primitive *primitive)
{
	int front = 0;

	for (int i = 0; primitive->normal && i < primitive->index_count; i += 3) {
		float product = facing(primitive, &primitive->index[i]);

		front += product > 0.0f ? 1 : product < 0.0f ? -1 : 0;
	}
	return front > 0 ? 1 : front < 0 ? -1 : 0;
}

/* The sign of the determinant of the first three columns. */
static int sign_of(const float (*m)[4])
{
	mat3 turned;
	float determinant;

	for (int i = 0; i < 3; i++) {
		memcpy(turned[i], m[i], sizeof(turned[i]));
	}
	determinant = glm_mat3_det(turned);

	return determinant > 0.0f ? 1 : determinant < 0.0f ? -1 : 0;
}

static int sign_of_node(const struct model_node *node)
{
	int sign = 1;

	if (node->matrix) {
		return sign_of(node->matrix);
	}
	for (int axis = 0; axis < 3; axis++) {
		float scale = node->rest.scale[axis];

		sign *= scale > 0.0f ? 1 : scale < 0.0f ? -1 : 0;
	}
	return sign;
}

/* -1: at rest, the skin mirrors its mesh, by its first joint with an inverse. */
static int sign_of_skin(const struct model_skin *skin, const signed char *sign)
{
	int found = 0;

	for (int j = 0; j < skin->joint_count && found == 0; j++) {
		found = sign[skin->joint[j]] *
			(skin->inverse_bind
					? sign_of((const float(*)[4])
							  skin->inverse_bind[j])
					: 1);
	}
	return found;
}

/*
 * Whether a node turns the triangles of its mesh but not its normals. A
 * mirroring node always turns the triangles (glTF 2.0, section 3.7.4), but the
 * joints alone place the vertices and normals of a skin.
 */
static bool turns_triangles(
	const struct model *model, int node, const signed char *sign)
{
	const struct model_node *of = &model->node[node];

	return sign[node] < 0 && of->skin >= 0 &&
		sign_of_skin(&model->skin[of->skin], sign) > 0;
}

int examine_find_reversed(const struct model *model, struct arena *arena)
{
	signed char *sign =
		ARENA_ARRAY(arena, signed char, (size_t)model->node_count);
	unsigned char *shown =
		ARENA_ARRAY(arena, unsigned char, (size_t)model->mesh_count);
	int reversed = 0;

	if (!sign || !shown) {
		return -ENOMEM;
	}
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		int above = node->parent >= 0 ? sign[node->parent] : 1;

		sign[i] = (signed char)(above * sign_of_node(node));
	}
	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].mesh >= 0) {
			shown[model->node[i].mesh] |=
				turns_triangles(model, i, sign) ? SHOWN_TURNED
								: SHOWN;
		}
	}
	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			int side = find_side(&model->mesh[m].primitive[p]);

			reversed += (side < 0 && (shown[m] & SHOWN)) ||
				(side > 0 && (shown[m] & SHOWN_TURNED));
		}
	}
	return reversed;
}
