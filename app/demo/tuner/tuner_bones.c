#include "app/demo/tuner/tuner_bones.h"

#include "app/character/run/sole.h"
#include "app/scene/hud/hud_name.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

int tuner_bones_mover(const struct tuner_bones *bones, int drawable, int vertex)
{
	const struct drawable *of = &bones->instance->drawable[drawable];

	return character_sole_mover(
		bones->instance->model, of->node, of->primitive, vertex);
}

static void find_moving(struct tuner_bones *bones)
{
	const struct instance *instance = bones->instance;

	for (int d = 0; d < instance->drawable_count; d++) {
		int count = instance->drawable[d].primitive->vertex_count;

		for (int v = 0; v < count; v++) {
			int node = tuner_bones_mover(bones, d, v);

			for (; node >= 0 && !bones->moves[node];
				node = instance->model->node[node].parent) {
				bones->moves[node] = true;
			}
		}
	}
}

/* Sets levels and deepest. Parents precede their children in node[]. */
static void find_levels(struct tuner_bones *bones)
{
	const struct model *model = bones->instance->model;

	bones->deepest = 0;
	for (int i = 0; i < model->node_count; i++) {
		int parent = model->node[i].parent;
		int above = parent < 0 ? TUNER_OFF_CHAIN : bones->level[parent];
		int level = above == TUNER_OFF_CHAIN ? TUNER_OFF_CHAIN
			: above < TUNER_LEVELS_MAX   ? above + 1
						     : TUNER_LEVELS_MAX;

		for (int b = 0; b < bones->count; b++) {
			level = bones->node[b] == i ? 0 : level;
		}
		bones->level[i] = (int8_t)level;
		if (bones->moves[i] && level > bones->deepest) {
			bones->deepest = level;
		}
	}
}

/*
 * The number of levels below a node, down to the deepest that moves vertices.
 */
static int depth_below(const struct tuner_bones *bones, int node)
{
	const struct model *model = bones->instance->model;
	int deepest = 0;

	for (int i = node + 1; i < model->node_count; i++) {
		int depth = 0, at = i;

		while (at > node) {
			at = model->node[at].parent;
			depth++;
		}
		if (at == node && bones->moves[i] && depth > deepest) {
			deepest = depth;
		}
	}
	return deepest;
}

static int moving_children(const struct tuner_bones *bones, int node)
{
	const struct model *model = bones->instance->model;
	int count = 0;

	for (int i = 0; i < model->node_count; i++) {
		count += model->node[i].parent == node && bones->moves[i];
	}
	return count;
}

/*
 * Returns the first bone of the longest limb. A limb begins where bones branch;
 * a model without branches is one limb.
 */
static int longest_limb(const struct tuner_bones *bones)
{
	const struct model *model = bones->instance->model;
	int found = -1, first = 0, longest = -1;

	for (int i = model->node_count - 1; i >= 0; i--) {
		first = bones->moves[i] ? i : first;
		if (bones->moves[i] &&
			moving_children(bones, model->node[i].parent) > 1) {
			int depth = depth_below(bones, i);

			if (depth >= longest) {
				longest = depth;
				found = i;
			}
		}
	}
	return found >= 0 ? found : first;
}

static void choose_default(
	struct tuner_bones *bones, const struct motions *motions)
{
	static const char *const shoulders[] = {"shoulder.L", "shoulder.R"};
	const struct model *model = bones->instance->model;

	bones->default_count = motions->bone_count;
	memcpy(bones->by_default, motions->bone, sizeof(bones->by_default));
	for (int i = 0; i < 2 && motions->bone_count == 0; i++) {
		int node = model_find_node(model, shoulders[i]);

		if (node >= 0) {
			bones->by_default[bones->default_count++] = node;
		}
	}
	if (bones->default_count == 0 && model->node_count > 0) {
		bones->by_default[bones->default_count++] = longest_limb(bones);
	}
}

static void use_chosen(struct tuner_bones *bones)
{
	if (bones->chosen < 0) {
		bones->count = bones->default_count;
		memcpy(bones->node, bones->by_default, sizeof(bones->node));
	} else {
		bones->count = 1;
		bones->node[0] = bones->chosen;
	}
	find_levels(bones);
}

int tuner_bones_init(struct tuner_bones *bones, struct instance *instance,
	const struct motions *motions)
{
	struct arena *arena = &instance->arena;
	size_t nodes = (size_t)instance->model->node_count;

	*bones = (struct tuner_bones){.instance = instance, .chosen = -1};
	bones->moves = ARENA_ARRAY(arena, bool, nodes);
	bones->level = ARENA_ARRAY(arena, int8_t, nodes);
	if (!bones->moves || !bones->level) {
		return -ENOMEM;
	}
	find_moving(bones);
	choose_default(bones, motions);
	use_chosen(bones);
	return 0;
}

void tuner_bones_step(struct tuner_bones *bones, int step)
{
	int count = bones->instance->model->node_count;

	do {
		bones->chosen += step;
		if (bones->chosen < -1) {
			bones->chosen = count - 1;
		} else if (bones->chosen >= count) {
			bones->chosen = -1;
		}
	} while (bones->chosen >= 0 && !bones->moves[bones->chosen]);
	use_chosen(bones);
}

void tuner_bones_name(const struct tuner_bones *bones, char *text, size_t size)
{
	int node = bones->count > 0 ? bones->node[0] : -1;
	char number[HUD_NAME_BYTES], more[24] = "";

	if (bones->count > 1) {
		snprintf(more, sizeof(more), " +%d", bones->count - 1);
	}
	snprintf(text, size, "%s%s",
		node < 0 ? "none"
			 : hud_name(bones->instance->model->node[node].name,
				   "node", node, number),
		more);
}
