#include "app/anim/pose_blend.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"

/*
 * Returns the number of a node's morph weights and sets first to the index of
 * the first one in pose.weight.
 */
static int weight_range(const struct pose *pose, int node, int *first)
{
	const struct model *model = pose->model;
	int mesh = model->node[node].mesh;

	*first = model->node[node].weight_offset;
	return mesh < 0 ? 0 : model->mesh[mesh].target_count;
}

/* Copies one node's transform and morph weights. */
static void copy_node(const struct pose *from, int node, struct pose *out)
{
	int first;
	int count = weight_range(from, node, &first);

	out->animated[node] = from->animated[node];
	out->local[node] = from->local[node];
	for (int i = first; i < first + count; i++) {
		out->weight[i] = from->weight[i];
	}
}

static void mix_node(const struct pose *a, const struct pose *b, int node,
	float t, struct pose *out)
{
	int first;
	int count = weight_range(a, node, &first);

	out->animated[node] = a->animated[node] || b->animated[node];
	transform_mix(&a->local[node], &b->local[node], t, &out->local[node]);
	for (int i = first; i < first + count; i++) {
		out->weight[i] = a->weight[i] * (1 - t) + b->weight[i] * t;
	}
}

void pose_mix(const struct pose *a, const struct pose *b, float t,
	const float *mask, struct pose *out)
{
	for (int i = 0; i < out->node_count; i++) {
		float amount = mask ? t * mask[i] : t;

		if (amount > 0 && amount < 1) {
			mix_node(a, b, i, amount, out);
		} else if (out != (amount >= 1 ? b : a)) {
			copy_node(amount >= 1 ? b : a, i, out);
		}
	}
}

static void add_transform(struct transform *pose, const struct transform *layer,
	const struct transform *reference, float weight)
{
	static const float none[4] = {0, 0, 0, 1};
	float turn[4];

	for (int i = 0; i < 3; i++) {
		float scale = reference->scale[i];

		pose->translation[i] += weight *
			(layer->translation[i] - reference->translation[i]);
		/* There is no ratio to a scale of 0. */
		if (scale != 0) {
			pose->scale[i] *=
				1 + weight * (layer->scale[i] / scale - 1);
		}
	}
	quat_conjugate(reference->rotation, turn);
	quat_multiply(turn, layer->rotation, turn);
	quat_slerp(none, turn, weight, turn);
	quat_multiply(pose->rotation, turn, pose->rotation);
	quat_normalize(pose->rotation);
}

void pose_add(struct pose *pose, const struct pose *layer,
	const struct pose *reference, float weight, const float *mask)
{
	for (int n = 0; n < pose->node_count; n++) {
		float amount = mask ? weight * mask[n] : weight;
		int first;
		int count = weight_range(pose, n, &first);

		if (amount == 0) {
			continue;
		}
		add_transform(&pose->local[n], &layer->local[n],
			&reference->local[n], amount);
		pose->animated[n] = pose->animated[n] || layer->animated[n];
		for (int i = first; i < first + count; i++) {
			pose->weight[i] += amount *
				(layer->weight[i] - reference->weight[i]);
		}
	}
}
