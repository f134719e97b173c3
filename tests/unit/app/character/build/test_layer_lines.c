/* What the lines of a layer say, apart from its masks' edges. */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static const struct character_layer *read(
	struct acting *acting, const char *lines)
{
	char text[1024];

	snprintf(text, sizeof(text), "[layer a]\n%s\n", lines);
	acting_expect(acting, text);
	return &acting->character->layer[0];
}

/* A layer that plays once waits for its action. */
static void test_a_layer_is_on_unless_it_plays_once(void **state)
{
	static const struct {
		const char *lines;
		bool once, on;
	} cases[] = {{"clip = wave", false, true},
		{"clip = wave\non = yes\nplay = loop", false, true},
		{"clip = wave\non = no", false, false},
		{"clip = wave\nplay = once", true, false},
		{"clip = wave\nplay = once\non = yes", true, false},
		{"clip = wave\nplay = once\non = no", true, false}};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct character_layer *layer =
			read(&acting, cases[i].lines);

		assert_int_equal(layer->once, cases[i].once);
		assert_int_equal(layer->is.is_on, cases[i].on);
		assert_false(layer->playing);
		assert_near(*layer->rate, 1, 0);
		assert_false(layer->additive);
		assert_null(layer->mask);
	}
	acting_end(&acting);
}

static void test_a_mask_has_full_weight_unless_told_otherwise(void **state)
{
	const struct character_layer *layer;
	struct acting acting;
	int head, hand;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	head = model_find_node(acting.model, "head");
	hand = model_find_node(acting.model, "hand.R");
	layer = read(&acting, "clip = wave\nmask = head, hand.R 0.25");
	assert_near(layer->mask[head], 1, 0);
	assert_near(layer->mask[hand], 0.25, 0);
	assert_near(layer->mask[0], 0, 0);
	assert_ptr_equal(layer->entry.cursor->only, layer->mask);
	acting_end(&acting);
}

static void test_a_layer_has_up_to_32_masks(void **state)
{
	char text[1024] = "[layer a]\nclip = wave\n";
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (int i = 0; i < 32; i++) {
		strcat(text, "mask = head 0.5\n");
	}
	acting_expect(&acting, text);
	strcat(text, "mask = head 0.5\n");
	acting_read(&acting, text);
	assert_int_equal(acting.error, -EINVAL);
	assert_contains(
		acting.logged.sentence[0], "a layer has at most 32 masks");
	acting_end(&acting);
}

/* The first node, too, if the clip moves it. */
static void test_a_layer_may_be_of_what_its_clip_moves(void **state)
{
	const struct character_layer *layer;
	struct acting acting;
	int clip;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	clip = model_find_clip(acting.model, "wave");
	acting.model->clip[clip].channel[0].node = 0;
	layer = read(&acting, "clip = wave\nnodes = moved");
	assert_near(layer->mask[0], 1, 0);
	layer = read(&acting, "clip = rest\nnodes = moved");
	for (int i = 0; i < acting.model->node_count; i++) {
		assert_near(layer->mask[i], 0, 0);
	}
	acting_end(&acting);
}

/* What no clip of the model changes needs no mixing in any layer. */
static void test_layers_mix_what_some_clip_changes(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	read(&acting, "clip = wave\n[layer b]\nclip = idle");
	for (int layer = 0; layer < 2; layer++) {
		const uint8_t *paths =
			acting.character->layer[layer].entry.cursor->paths;

		assert_non_null(paths);
		for (int n = 0; n < acting.model->node_count; n++) {
			bool moved = false;

			for (int i = 0; i < acting.model->clip_count; i++) {
				uint8_t one[256] = {0};

				assert_true(acting.model->node_count <= 256);
				clip_add_paths(&acting.model->clip[i],
					acting.model, one);
				moved = moved || one[n];
			}
			assert_int_equal(paths[n] != 0, moved);
		}
	}
	acting_end(&acting);
}

/* The rest pose, if that is its clip. */
static void test_an_additive_layer_starts_from_its_clips_start(void **state)
{
	static const char *const clips[] = {"wave", "rest"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(clips); i++) {
		const struct pose *wanted = &acting.instance->pose;
		const struct character_layer *layer;
		char lines[64];

		snprintf(lines, sizeof(lines), "clip = %s\nmode = additive",
			clips[i]);
		layer = read(&acting, lines);
		assert_true(layer->additive);
		if (layer->entry.of->clip) {
			clip_sample(layer->entry.of->clip, 0,
				&(struct clip_cursor){0},
				&acting.instance->pose);
		}
		for (int n = 0; n < acting.model->node_count; n++) {
			assert_memory_equal(&layer->reference.local[n],
				&wanted->local[n], sizeof(wanted->local[n]));
		}
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_layer_is_on_unless_it_plays_once),
		cmocka_unit_test(
			test_a_mask_has_full_weight_unless_told_otherwise),
		cmocka_unit_test(test_a_layer_has_up_to_32_masks),
		cmocka_unit_test(test_a_layer_may_be_of_what_its_clip_moves),
		cmocka_unit_test(test_layers_mix_what_some_clip_changes),
		cmocka_unit_test(
			test_an_additive_layer_starts_from_its_clips_start),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
