#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"

/* Whether all nodes show the mesh's targets as key frames, without a skin. */
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

/* Returns whether any of the mesh's targets are key frames now. */
static bool round_mesh(struct model *model, int mesh)
{
	const struct model_mesh *of = &model->mesh[mesh];
	bool any = false;

	if (!is_shown_as_keys(model, mesh)) {
		return false;
	}
	for (int p = 0; p < of->primitive_count; p++) {
		struct model_primitive *primitive = &of->primitive[p];
		bool tangents =
			model->material[primitive->material].normal_texture >= 0;

		if (!primitive->keys &&
			model_keys_store(primitive, of->target_count, tangents,
				true, &model->arena) == 0) {
			any = any || primitive->keys;
		}
	}
	return any;
}

static bool keep_floats(struct model_deltas *deltas, struct arena *arena)
{
	return deltas->vertex_count == 0 || deltas->number != MODEL_FLOAT ||
		model_deltas_copy(deltas, deltas, arena) == 0;
}

/* Copies the floats that other meshes need. False if memory is short. */
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

void model_keys_round(struct model *model)
{
	bool exceeded = model->budget && model->budget->exceeded;
	bool any = false, kept = true;

	for (int m = 0; model->targets.newest && m < model->mesh_count; m++) {
		any = round_mesh(model, m) || any;
	}
	for (int m = 0; any && kept && m < model->mesh_count; m++) {
		kept = keep_mesh(&model->mesh[m], &model->arena);
	}
	if (any && kept) {
		arena_release(&model->targets);
	}
	/* Without the memory, the floats stay. */
	if (model->budget) {
		model->budget->exceeded = exceeded;
	}
}
