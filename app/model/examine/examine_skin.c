#include "app/model/examine/examine.h"

#include "platform/base/printable.h"
#include "platform/base/scalar.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

enum {
	FINDING_BYTES = 400
};

void examine_report(const struct examiner *examiner, const char *format, ...)
{
	char finding[FINDING_BYTES];
	va_list values;

	va_start(values, format);
	vsnprintf(finding, sizeof(finding), format, values);
	va_end(values);
	printable_make(finding);
	examiner->report(examiner->context, finding);
}

void examine_report_clips(const struct examiner *examiner,
	const struct model *model, int count, int first, const char *feature,
	const char *treatment)
{
	const char *name = model->clip[first].name;
	char number[32];

	snprintf(number, sizeof(number), "clip %d", first);
	examine_report(examiner, "%s (%d), such as %.99s: %s", feature, count,
		name[0] ? name : number, treatment);
}

void examine_count(const struct examiner *examiner, int count,
	const char *feature, const char *treatment)
{
	if (count > 0) {
		examine_report(
			examiner, "%s (%d): %s", feature, count, treatment);
	}
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

static void report_nodes(const struct model *model, const bool *is_joint,
	const struct examiner *examiner)
{
	int transformed = 0, ancestors = 0, rigid = 0, scaled = 0;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		bool joint = is_joint[i];
		bool below = node->parent >= 0 && is_joint[node->parent];

		transformed += node->skin >= 0 && !is_identity(node);
		rigid += node->mesh >= 0 && node->skin < 0 && (below || joint);
		scaled += joint && is_scaled(&node->rest);
		ancestors += joint && node->parent >= 0 &&
			!is_joint[node->parent] &&
			!is_identity(&model->node[node->parent]);
	}
	examine_count(examiner, transformed,
		"skinned nodes with a transform of their own",
		"limber ignores it, because only the joints move a skin");
	examine_count(examiner, ancestors,
		"joints whose parent is not a joint but has a transform",
		"limber applies that transform");
	examine_count(examiner, rigid,
		"meshes without a skin that are attached to joints",
		"limber moves each rigidly with its joint");
	examine_count(examiner, scaled, "joints with a scale",
		"limber transforms normals by the joint matrix, or where the scale is uneven by its inverse transpose, and normalises them");
}

/* Nodes have another order in the model than in the file, whose counts here. */
static bool is_ordered(const struct model *model, const struct model_skin *skin)
{
	for (int j = 1; j < skin->joint_count; j++) {
		if (model->node[skin->joint[j]].file_index <
			model->node[skin->joint[j - 1]].file_index) {
			return false;
		}
	}
	return true;
}

/* A mesh and the skin with which a node draws it. */
struct use {
	int mesh, skin;
};

static int compare_uses(const void *left, const void *right)
{
	const struct use *a = left, *b = right;

	return a->mesh != b->mesh ? a->mesh - b->mesh : a->skin - b->skin;
}

/*
 * Lists all pairs of a mesh and its skin, sorted by mesh, and returns their
 * number. uses has room for node_count pairs.
 */
static int find_uses(const struct model *model, struct use *uses)
{
	int count = 0;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (node->mesh >= 0 && node->skin >= 0) {
			uses[count++] = (struct use){node->mesh, node->skin};
		}
	}
	if (count > 0) {
		qsort(uses, (size_t)count, sizeof(*uses), compare_uses);
	}
	return count;
}

static void report_skins(const struct model *model, struct use *uses,
	const struct examiner *examiner)
{
	int unordered = 0, use_count = find_uses(model, uses), skins = 1;

	for (int i = 0; i < model->skin_count; i++) {
		unordered += !is_ordered(model, &model->skin[i]);
	}
	examine_count(examiner, unordered,
		"skins that list their joints in another order than the nodes",
		"limber takes the joint numbers of vertices as indices into the skin's list");
	for (int i = 1; i <= use_count; i++) {
		if (i < use_count && uses[i].mesh == uses[i - 1].mesh) {
			skins += uses[i].skin != uses[i - 1].skin;
			continue;
		}
		if (skins > 1) {
			examine_report(examiner,
				"mesh %d is drawn with %d skins; limber poses it once for each skin",
				uses[i - 1].mesh, skins);
		}
		skins = 1;
	}
}

/* reversed is the number of primitives that are lit from the wrong side. */
static void report_meshes(const struct model *model, int reversed,
	const struct examiner *examiner)
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
	if (!model_has_triangles(model)) {
		examine_report(examiner,
			"the file has no triangles, so limber shows an empty stage: export it with its meshes");
	}
	examine_count(examiner, flat, "primitives without normals",
		"limber lights the posed triangles with flat normals, as glTF requires");
	examine_count(examiner, reversed,
		"primitives whose normals point to the back of their triangles",
		"limber lights them as the file says, so that the lit side is dark; export them with the normals turned");
	examine_count(examiner, many,
		"primitives with a second set of joints and weights",
		"limber uses all eight influences of a vertex");
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (node->skin >= 0 && node->mesh >= 0 &&
			model->mesh[node->mesh].target_count > 0) {
			examine_report(examiner,
				"node %d is morphed and skinned; limber morphs first, then skins, then normalises the normals",
				node->file_index);
		}
	}
}

static void report_lying(const struct model *model, const bool *is_joint,
	const struct examiner *examiner)
{
	int head, foot;

	if (examine_find_lying(model, is_joint, &head, &foot)) {
		examine_report(examiner,
			"a figure that lies at rest (from %.60s to %.60s): limber takes +Y as up, as glTF says; if it should stand, export it with +Y up",
			model->node[foot].name, model->node[head].name);
	}
}

int examine_skins(const struct model *model, const struct examiner *examiner,
	const struct log *log)
{
	struct arena arena = arena_empty();
	const bool *is_joint = model_find_joints(model, &arena);
	struct use *uses = ARENA_ARRAY(&arena, struct use, model->node_count);
	int reversed = examine_find_reversed(model, &arena);
	int error = 0;

	if (is_joint && uses && reversed >= 0) {
		report_nodes(model, is_joint, examiner);
		report_skins(model, uses, examiner);
		report_lying(model, is_joint, examiner);
		report_meshes(model, reversed, examiner);
	} else {
		error = memory_budget_fail(model->budget, model->path, log);
	}
	arena_release(&arena);
	return error;
}
