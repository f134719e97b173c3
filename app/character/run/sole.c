#include "app/character/run/sole.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"

#include <string.h>

struct character_sole character_sole_on_node(int node, const float at[3])
{
	struct character_sole sole = {.node = {node, node}, .weight = {1, 0}};

	memcpy(sole.at[0], at, sizeof(sole.at[0]));
	return sole;
}

static const struct model_skin *skin_of(const struct model *model, int node,
	const struct model_primitive *primitive)
{
	int skin = model->node[node].skin;

	return skin >= 0 && primitive->influences > 0 ? &model->skin[skin]
						      : NULL;
}

/*
 * Returns the influence with the largest weight; other is left out (-1: none).
 */
static int main_influence(
	const struct model_primitive *primitive, int vertex, int other)
{
	const float *weight = &primitive->weight[vertex * primitive->influences];
	int best = other == 0 ? 1 : 0;

	for (int i = 0; i < primitive->influences; i++) {
		best = i != other && weight[i] > weight[best] ? i : best;
	}
	return best;
}

int character_sole_mover(const struct model *model, int node,
	const struct model_primitive *primitive, int vertex)
{
	const struct model_skin *skin = skin_of(model, node, primitive);

	return skin
		? skin->joint[primitive->joint[vertex * primitive->influences +
			  main_influence(primitive, vertex, -1)]]
		: node;
}

struct character_sole character_sole_of_vertex(const struct model *model,
	int node, const struct model_primitive *primitive, int vertex,
	const float at[3])
{
	const struct model_skin *skin = skin_of(model, node, primitive);
	int first = vertex * primitive->influences, influence = -1;
	struct character_sole sole;
	float sum = 0;

	if (!skin) {
		return character_sole_on_node(node, at);
	}
	for (int i = 0; i < 2; i++) {
		int joint;

		influence = main_influence(primitive, vertex, influence);
		joint = primitive->joint[first + influence];
		sole.node[i] = skin->joint[joint];
		sole.weight[i] = primitive->weight[first + influence];
		sum += sole.weight[i];
		matrix_apply(skin->inverse_bind[joint], at, sole.at[i]);
	}
	for (int i = 0; i < 2; i++) {
		sole.weight[i] = sum > 0 ? sole.weight[i] / sum : 0.5f;
	}
	return sole;
}

void character_sole_place(const struct character_sole *sole,
	const struct instance *instance, float out[3])
{
	float second[3];

	matrix_apply(instance->world[sole->node[0]], sole->at[0], out);
	if (sole->weight[1] > 0) {
		matrix_apply(
			instance->world[sole->node[1]], sole->at[1], second);
		vec_mix(out, second, sole->weight[1], out);
	}
}
