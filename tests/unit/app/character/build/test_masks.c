/* Which nodes a layer moves, and by how much: against a search for each node. */
#include "app/character/character_data.h"
#include "app/character/run/layers.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>

struct mask {
	const char *top;
	float weight;
};

/* How many levels the node is below the top, or -1. */
static int levels_below(const struct model *model, int node, int top)
{
	int levels = 0;

	while (node >= 0 && node != top) {
		node = model->node[node].parent;
		levels++;
	}
	return node < 0 ? -1 : levels;
}

/* The last mask that holds the node gives its weight. */
static float weight_of(const struct model *model, int node,
	const struct mask *masks, int count, int soft)
{
	float weight = count == 0 ? 1 : 0;

	for (int i = 0; i < count; i++) {
		int levels = levels_below(
			model, node, model_find_node(model, masks[i].top));

		if (levels >= 0) {
			weight = masks[i].weight;
		}
		if (levels >= 0 && levels < soft) {
			weight *= (float)(levels + 1) / (float)(soft + 1);
		}
	}
	return weight;
}

static bool is_moved(const struct model_clip *clip, int node)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].node == node) {
			return true;
		}
	}
	return false;
}

static void check(const struct mask *masks, int count, int soft, bool moved)
{
	struct acting acting;
	const struct model_clip *clip;
	const float *mask;
	char text[256];
	int used = snprintf(text, sizeof(text),
		"[layer a]\nclip = wave\nsoft = %d\nnodes = %s\n", soft,
		moved ? "moved" : "all");

	for (int i = 0; i < count; i++) {
		used += snprintf(text + used, sizeof(text) - (size_t)used,
			"mask = \"%s\" %g\n", masks[i].top,
			(double)masks[i].weight);
	}
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, text);
	clip = &acting.model->clip[model_find_clip(acting.model, "wave")];
	mask = acting.character->layer[0].mask;
	assert_int_equal(mask != NULL, count > 0 || moved);
	for (int i = 0; mask && i < acting.model->node_count; i++) {
		float weight = weight_of(acting.model, i, masks, count, soft);

		assert_near(mask[i],
			moved && !is_moved(clip, i) ? 0.0f : weight, 1e-6);
	}
	acting_end(&acting);
}

static void test_a_layer_moves_what_its_masks_and_its_clip_say(void **state)
{
	static const struct mask masks[] = {
		{"hips", 0.75f}, {"chest", 0.5f}, {"upper_arm.R", 1}};

	(void)state;
	for (int count = 0; count <= (int)ARRAY_COUNT(masks); count++) {
		for (int soft = 0; soft <= 2; soft++) {
			check(masks, count, soft, false);
			check(masks, count, soft, true);
		}
	}
}

/* The model's first node is the top of all others. */
static void test_a_mask_may_begin_at_the_first_node(void **state)
{
	struct acting acting;
	struct mask mask = {NULL, 0.25f};

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	mask.top = acting.model->node[0].name;
	check(&mask, 1, 0, false);
	check(&mask, 1, 0, true);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_layer_moves_what_its_masks_and_its_clip_say),
		cmocka_unit_test(test_a_mask_may_begin_at_the_first_node),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
