#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"

#include <errno.h>

/* Whether all nodes with the mesh use its targets as keys, without a skin. */
static bool is_shown_as_keys(const struct model *model, int mesh)
{
	bool shown = false;

	for (int n = 0; n < model->node_count; n++) {
		if (model->node[n].mesh != mesh) {
			continue;
		}
		if (model->node[n].skin >= 0 || !model_has_key_frames(model, n)) {
			return false;
		}
		shown = true;
	}
	return shown;
}

/*
 * Stores the mesh's targets as key frames if possible; sets *any if it did so
 * for any primitive. Returns 0 or -ENOMEM.
 */
static int round_mesh(struct model *model, int mesh, bool *any)
{
	const struct model_mesh *of = &model->mesh[mesh];
	int error = 0;

	if (!is_shown_as_keys(model, mesh)) {
		return 0;
	}
	for (int p = 0; p < of->primitive_count && !error; p++) {
		struct model_primitive *primitive = &of->primitive[p];
		bool tangents =
			model->material[primitive->material].normal_texture >= 0;

		if (!primitive->keys) {
			error = model_keys_store(primitive, of->target_count,
				tangents, true, &model->arena);
			*any = *any || primitive->keys;
		}
	}
	return error;
}

static bool keep_floats(struct model_deltas *deltas, struct arena *arena)
{
	return deltas->vertex_count == 0 || deltas->number != MODEL_FLOAT ||
		model_deltas_copy(deltas, deltas, arena) == 0;
}

/*
 * Copies a mesh's remaining deltas in floats to another arena. Returns false if
 * memory is short.
 */
static bool keep_mesh(const struct model_mesh *mesh, struct arena *arena)
{
	for (int p = 0; p < mesh->primitive_count; p++) {
		for (int t = 0; t < mesh->target_count; t++) {
			struct model_target *of = &mesh->primitive[p].target[t];

			if (!keep_floats(&of->position, arena) ||
				!keep_floats(&of->normal, arena) ||
				!keep_floats(&of->tangent, arena)) {
				return false;
			}
		}
	}
	return true;
}

static int round_all(struct model *model)
{
	bool any = false;
	int error = 0;

	for (int m = 0;
		model->targets.newest && m < model->mesh_count && !error; m++) {
		error = round_mesh(model, m, &any);
	}
	for (int m = 0; any && m < model->mesh_count && !error; m++) {
		error = keep_mesh(&model->mesh[m], &model->arena) ? 0 : -ENOMEM;
	}
	if (any && !error) {
		arena_release(&model->targets);
	}
	return error;
}

int model_keys_round(struct model *model, const struct log *log)
{
	struct memory_budget *budget = model->budget;
	bool exceeded = budget && budget->exceeded;
	int error;

	if (budget) {
		budget->exceeded = false;
	}
	error = round_all(model);
	/* Key frames for which the budget has no room stay as floats. */
	if (budget && budget->exceeded) {
		error = 0;
	}
	if (budget) {
		budget->exceeded = exceeded;
	}
	if (error) {
		log_error(log, "%s: there is not enough memory", model->path);
	}
	return error;
}
