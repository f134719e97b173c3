#include "app/model/examine/examine.h"

#include "platform/base/scalar.h"

#include <stdarg.h>
#include <stdio.h>

enum {
	SENTENCE_ROOM = 400
};

void examine_say(const struct examiner *examiner, const char *format, ...)
{
	char sentence[SENTENCE_ROOM];
	va_list values;

	va_start(values, format);
	vsnprintf(sentence, sizeof(sentence), format, values);
	va_end(values);
	examiner->say(examiner->context, sentence);
}

static bool near(float a, float b)
{
	return scalar_abs(a - b) < 1e-5f;
}

static bool is_scaled(const struct transform *rest)
{
	return !near(rest->scale[0], 1.0f) || !near(rest->scale[1], 1.0f) ||
		!near(rest->scale[2], 1.0f);
}

static bool is_identity(const struct model_node *node)
{
	const struct transform *rest = &node->rest;

	return !node->matrix && !is_scaled(rest) &&
		near(rest->translation[0], 0.0f) &&
		near(rest->translation[1], 0.0f) &&
		near(rest->translation[2], 0.0f) &&
		near(scalar_abs(rest->rotation[3]), 1.0f);
}

static bool is_joint(const struct model *model, int node)
{
	for (int i = 0; i < model->skin_count; i++) {
		for (int j = 0; j < model->skin[i].joint_count; j++) {
			if (model->skin[i].joint[j] == node) {
				return true;
			}
		}
	}
	return false;
}

/* The skinned nodes, and what is above them. */
static void say_nodes(const struct model *model, const struct examiner *examiner)
{
	int placed = 0, ancestors = 0, carried = 0, scaled = 0;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		bool joint = is_joint(model, i);
		bool below = node->parent >= 0 && is_joint(model, node->parent);

		placed += node->skin >= 0 && !is_identity(node);
		carried += node->mesh >= 0 && node->skin < 0 && (below || joint);
		scaled += joint && is_scaled(&node->rest);
		ancestors += joint && node->parent >= 0 &&
			!is_joint(model, node->parent) &&
			!is_identity(&model->node[node->parent]);
	}
	if (placed > 0) {
		examine_say(examiner,
			"skinned nodes with a transform of their own (%d): it "
			"counts for nothing, joints alone place a skin",
			placed);
	}
	if (ancestors > 0) {
		examine_say(examiner,
			"joints below nodes that are none and have a transform "
			"(%d): it counts all the same",
			ancestors);
	}
	if (carried > 0) {
		examine_say(examiner,
			"rigid meshes carried by joints (%d): they move with "
			"the "
			"bone, without weights",
			carried);
	}
	if (scaled > 0) {
		examine_say(examiner,
			"scaled joints (%d): normals need more than the "
			"joint's "
			"rotation",
			scaled);
	}
}

static bool is_ordered(const struct model_skin *skin)
{
	for (int j = 1; j < skin->joint_count; j++) {
		if (skin->joint[j] < skin->joint[j - 1]) {
			return false;
		}
	}
	return true;
}

static void say_skins(const struct model *model, const struct examiner *examiner)
{
	int unordered = 0;

	for (int i = 0; i < model->skin_count; i++) {
		unordered += !is_ordered(&model->skin[i]);
	}
	if (unordered > 0) {
		examine_say(examiner,
			"skins that list joints in another order than the tree "
			"(%d): the vertices' numbers count in the skin's list",
			unordered);
	}
	for (int m = 0; m < model->mesh_count; m++) {
		int first = -1, users = 0;

		for (int i = 0; i < model->node_count; i++) {
			const struct model_node *node = &model->node[i];

			if (node->mesh == m && node->skin >= 0 &&
				node->skin != first) {
				first = first < 0 ? node->skin : first;
				users++;
			}
		}
		if (users > 1) {
			examine_say(examiner,
				"mesh %d is drawn with %d skins: it is posed "
				"once for each",
				m, users);
		}
	}
}

static void say_meshes(
	const struct model *model, const struct examiner *examiner)
{
	int flat = 0, many = 0;

	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			const struct model_primitive *primitive =
				&model->mesh[m].primitive[p];

			flat += primitive->normal == NULL;
			many += primitive->influences > 4;
		}
	}
	if (flat > 0) {
		examine_say(examiner,
			"parts without normals (%d): limber lights the posed "
			"triangles flat, as glTF asks",
			flat);
	}
	if (many > 0) {
		examine_say(examiner,
			"parts with a second set of joints and weights (%d): "
			"whoever reads the first four only tears them",
			many);
	}
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (node->skin >= 0 && node->mesh >= 0 &&
			model->mesh[node->mesh].target_count > 0) {
			examine_say(examiner,
				"node %d is morphed and skinned: the morph "
				"comes first, and normals are made unit length "
				"again",
				node->file_index);
		}
	}
}

void examine_skins(const struct model *model, const struct examiner *examiner)
{
	say_nodes(model, examiner);
	say_skins(model, examiner);
	say_meshes(model, examiner);
}
