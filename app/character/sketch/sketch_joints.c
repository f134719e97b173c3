#include "app/character/sketch/sketch_joints.h"

#include "app/anim/math/vec.h"
#include "platform/base/arena.h"

#include <errno.h>

static float area_of(const struct model_primitive *one, const uint32_t *corner)
{
	float side[2][3], across[3];

	for (int i = 0; i < 2; i++) {
		vec_subtract(one->position[corner[i + 1]],
			one->position[corner[0]], side[i]);
	}
	vec_cross(side[0], side[1], across);
	return 0.5f * vec_length(across);
}

/* Shares the areas of triangles among the joints of their corners. */
static void add_primitive(const struct model_primitive *one,
	const struct model_skin *skin, float *to_node, float *moved)
{
	for (int t = 0; t < one->index_count; t += 3) {
		const uint32_t *corner = &one->index[t];
		float area = area_of(one, corner);

		if (!skin) {
			*to_node += area;
			continue;
		}
		for (int i = 0; i < 3 * one->influences; i++) {
			size_t at = (size_t)corner[i % 3] *
					(size_t)one->influences +
				(size_t)(i / 3);

			moved[skin->joint[one->joint[at]]] +=
				one->weight[at] * area / 3;
		}
	}
}

/* Adds the surface of a node's mesh to the nodes that move it. */
static void add_mesh(const struct model *model, int node, float *moved)
{
	const struct model_node *of = &model->node[node];
	const struct model_mesh *mesh = &model->mesh[of->mesh];
	const struct model_skin *skin =
		of->skin >= 0 ? &model->skin[of->skin] : NULL;

	for (int p = 0; p < mesh->primitive_count; p++) {
		add_primitive(&mesh->primitive[p], skin, &moved[node], moved);
	}
}

/*
 * Adds a little of what hangs below a node. So joints of limbs come before
 * those of fingers, and joints that carry nothing but other joints come last.
 */
static void add_below(const struct model *model, float *moved, float *below)
{
	for (int i = model->node_count - 1; i >= 0; i--) {
		int parent = model->node[i].parent;

		if (parent >= 0) {
			below[parent] += moved[i] + below[i];
		}
		moved[i] += 0.001f * below[i];
	}
}

/* Returns the node that moves most, or -1 if all that are left move nothing. */
static int find_largest(
	const struct model *model, const bool *may_be_part, const float *moved)
{
	int best = -1;

	for (int i = 0; i < model->node_count; i++) {
		if (may_be_part[i] && moved[i] > 0 &&
			(best < 0 || moved[i] > moved[best])) {
			best = i;
		}
	}
	return best;
}

/* Inserts a node into those found so far, which are in order. */
static void insert(int *node, int count, int one)
{
	int at = count;

	for (; at > 0 && node[at - 1] > one; at--) {
		node[at] = node[at - 1];
	}
	node[at] = one;
}

int sketch_find_joints(const struct model *model, const bool *may_be_part,
	int most, int *node, int *count)
{
	struct arena arena = arena_empty();
	float *moved = ARENA_ARRAY(&arena, float, (size_t)model->node_count);
	float *below = ARENA_ARRAY(&arena, float, (size_t)model->node_count);
	int one = -1;

	*count = 0;
	if (!moved || !below) {
		arena_release(&arena);
		return -ENOMEM;
	}
	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].mesh >= 0) {
			add_mesh(model, i, moved);
		}
	}
	add_below(model, moved, below);
	while (*count < most &&
		(one = find_largest(model, may_be_part, moved)) >= 0) {
		insert(node, (*count)++, one);
		moved[one] = 0;
	}
	arena_release(&arena);
	return 0;
}
