#include "app/model/examine/examine.h"

/* Marks a node, and all above it, whose motion moves it. */
static void mark(const struct model *model, int node, bool *moves)
{
	while (node >= 0 && !moves[node]) {
		moves[node] = true;
		node = model->node[node].parent;
	}
}

/*
 * Finds the nodes that move what is shown: those of meshes, the joints of skins
 * that meshes have, and all above them. Returns false if nothing is shown.
 */
static bool find_moving_nodes(const struct model *model, bool *moves)
{
	bool any = false;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		const struct model_skin *skin =
			node->skin < 0 ? NULL : &model->skin[node->skin];

		if (node->mesh < 0 || !node->in_scene ||
			model->mesh[node->mesh].primitive_count == 0) {
			continue;
		}
		any = true;
		mark(model, i, moves);
		for (int j = 0; skin && j < skin->joint_count; j++) {
			mark(model, skin->joint[j], moves);
		}
	}
	return any;
}

static bool is_still(const struct model_clip *clip, const bool *moves)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (moves[clip->channel[i].node]) {
			return false;
		}
	}
	return true;
}

int examine_still_clips(const struct model *model,
	const struct examiner *examiner, const struct log *log)
{
	struct arena arena = arena_empty();
	bool *moves = ARENA_ARRAY(&arena, bool, (size_t)model->node_count);
	int count = 0, first = -1;
	bool any;

	if (!moves) {
		return memory_budget_fail(model->budget, model->path, log);
	}
	any = find_moving_nodes(model, moves);
	for (int i = 0; i < model->clip_count; i++) {
		if (is_still(&model->clip[i], moves)) {
			first = first < 0 ? i : first;
			count++;
		}
	}
	/* Another finding says that a model shows nothing. */
	if (count > 0 && any) {
		examine_report_clips(examiner, model, count, first,
			"clips that move nothing that limber shows",
			"they move cameras, lights, empty nodes or nothing at all, and the model stands still");
	}
	arena_release(&arena);
	return 0;
}
