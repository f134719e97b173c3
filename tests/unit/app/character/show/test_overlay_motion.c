/* What overlays show of a character's motion. */
#include "app/character/show/character_overlay.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static struct overlay_motion describe(const struct acting *acting)
{
	struct overlay_motion motion = overlay_motion_none();

	character_overlay_describe(acting->character, &motion);
	return motion;
}

/* Begins with the first frame, at 0.02 s. */
static void begin(struct acting *acting, const char *model, const char *text)
{
	acting_begin(acting, model);
	acting_expect(acting, text);
	acting_run_to(acting, 1.0 / rate_hz, rate_hz);
}

static void expect_layer(const struct overlay_motion *motion, int index,
	const char *name, const char *kind, int number, double weight)
{
	const struct overlay_layer *layer = &motion->layer[index];

	assert_true(index < motion->layer_count);
	assert_string_equal(layer->name, name);
	if (kind) {
		assert_string_equal(layer->kind, kind);
	}
	assert_int_equal(layer->number, number);
	assert_near(layer->weight, weight, 1e-5);
}

static int clip_of(const struct acting *acting, const char *name)
{
	int clip = model_find_clip(acting->model, name);

	assert_true(clip >= 0);
	return clip;
}

static void test_a_clip_is_shown_with_its_time(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = walk\n[state b]\nclip = rest\n"
		"[buttons]\nUP = go b\n");
	acting_run_to(&acting, 0.52, rate_hz);
	motion = describe(&acting);
	assert_int_equal(motion.clip, clip_of(&acting, "walk"));
	assert_near(motion.time_s, 0.5, 1e-3);
	assert_int_equal(motion.layer_count, 0);
	assert_int_equal(motion.traveller, -1);
	assert_null(motion.travel);
	assert_false(motion.morphing);
	acting_tap(&acting, BUTTON_UP, 1.0, rate_hz);
	assert_int_equal(describe(&acting).clip, -1);
	acting_end(&acting);
}

/* Of a state of several; one that weighs nothing is left out. */
static void test_the_clips_of_a_blend_are_layers(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[parameter v]\nrange = 0 2\nstart = 0.25\n[state a]\n"
		"blend = v, rest 0, walk 1, run 2\n[buttons]\nUP = set v 1.5\n");
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, 2);
	expect_layer(&motion, 0, "rest", "clip", 0, 0.75);
	expect_layer(&motion, 1, "walk", "clip", clip_of(&acting, "walk"), 0.25);
	assert_null(motion.layer[0].mask);
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, 2);
	expect_layer(&motion, 0, "walk", "clip", clip_of(&acting, "walk"), 0.5);
	expect_layer(&motion, 1, "run", "clip", clip_of(&acting, "run"), 0.5);
	acting_end(&acting);
}

static void test_both_clips_of_a_blend_of_two_are_layers(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[parameter v]\nstart = 0.75\n[state a]\n"
		"blend = v, walk 0, run 1\n");
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, 2);
	expect_layer(&motion, 0, "walk", "clip", clip_of(&acting, "walk"), 0.25);
	expect_layer(&motion, 1, "run", "clip", clip_of(&acting, "run"), 0.75);
	acting_end(&acting);
}

/* Also if it is the first node. */
static void test_the_travel_of_the_root_is_shown(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/far.gltf");
	acting.model->node[0].name = "carrier";
	acting_expect(
		&acting, "[state a]\nclip = leave\n[motion]\nroot = carrier\n");
	acting.character->interpolation = CLIP_STEP;
	acting_run_to(&acting, 0.1, rate_hz);
	motion = describe(&acting);
	assert_int_equal(motion.traveller, 0);
	assert_ptr_equal(motion.travel,
		acting.character->machine.state[0].entry[0].of->travel);
	assert_int_equal(motion.interpolation, CLIP_STEP);
	acting_end(&acting);
}

/* While they are on, and unless they have no label. */
static void test_layers_effects_and_fades_are_layers(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[state b]\nclip = run\n"
		"fade = 2 linear\n[target t]\nplace = 0 1 2\n"
		"[layer off]\nclip = walk\non = no\n"
		"[layer l]\nclip = wave\nmask = shoulder.R\nweight = 0.5\n"
		"[look hidden]\nbone = head\ntarget = t\nlabel = no\n"
		"[look first]\nbone = head\ntarget = t\non = no\n"
		"[look k]\nbone = head\ntarget = t\nweight = 0.25\n"
		"[buttons]\nUP = go b\n");
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, 2);
	expect_layer(&motion, 0, "l", "layer", 2, 0.5);
	assert_ptr_equal(motion.layer[0].mask, acting.character->layer[1].mask);
	assert_non_null(motion.layer[0].mask);
	expect_layer(&motion, 1, "k", "look", 3, 0.25);
	assert_null(motion.layer[1].mask);
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, 3);
	expect_layer(&motion, 2, "fade", NULL, 0, 0.25);
	acting_end(&acting);
}

/* Also the first effect of a file without layers. */
static void test_each_effect_is_a_layer(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[target t]\nplace = 0 1 2\n"
		"[look k]\nbone = head\ntarget = t\nweight = 0.25\n"
		"[breath b]\nbone = chest\n");
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, 2);
	expect_layer(&motion, 0, "k", "look", 1, 0.25);
	expect_layer(&motion, 1, "b", "breath", 1, 1.0);
	acting_end(&acting);
}

static void test_as_many_layers_are_shown_as_there_is_room_for(void **state)
{
	char text[1024] = "[state a]\nclip = rest\n";
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	for (int i = 0; i <= OVERLAY_LAYERS_MAX; i++) {
		size_t length = strlen(text);

		snprintf(text + length, sizeof(text) - length,
			"[layer l%d]\nclip = wave\n", i);
	}
	begin(&acting, "assets/walker.glb", text);
	motion = describe(&acting);
	assert_int_equal(motion.layer_count, OVERLAY_LAYERS_MAX);
	expect_layer(&motion, OVERLAY_LAYERS_MAX - 1, "l7", "layer", 8, 1.0);
	acting_end(&acting);
}

/* Key 0 is the base, and key k is target k - 1. */
static void test_a_morph_goes_from_target_to_target(void **state)
{
	struct overlay_motion motion;
	const struct character_morph *morph;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph m]\ntime = 1\n"
		"curve = bezier 0.4 0 0.2 1\ncurve = sine 0.1\n[buttons]\n"
		"UP = morph m smile\nDOWN = morph m frown\nLEFT = curve m\n");
	morph = acting.character->morph;
	acting_run_to(&acting, 0.1, rate_hz);
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	motion = describe(&acting);
	assert_true(motion.morphing);
	assert_int_equal(motion.node, model_find_node(acting.model, "Face"));
	assert_int_equal(motion.from, -1);
	assert_int_equal(motion.to, morph->destiny - 1);
	assert_true(motion.to >= 0);
	assert_near(motion.omega, 0.5, 0.021);
	assert_near(motion.wave, 0, 0);
	assert_ptr_equal(motion.shape_user, &morph->curve[0]);
	assert_near(motion.shape(motion.shape_user, 0.0f), 0, 1e-6);
	assert_near(motion.shape(motion.shape_user, 1.0f), 1, 1e-6);
	acting_tap(&acting, BUTTON_LEFT, 1.0, rate_hz);
	acting_tap(&acting, BUTTON_DOWN, 0.25, rate_hz);
	motion = describe(&acting);
	assert_int_equal(motion.from, morph->before - 1);
	assert_true(motion.from >= 0 && motion.from != motion.to);
	assert_ptr_equal(motion.shape_user, &morph->curve[1]);
	assert_near(motion.wave, 0.35, 1e-6);
	acting_end(&acting);
}

/* Of a node that is not the first one. */
static void test_the_node_that_morphs_is_named(void **state)
{
	struct overlay_motion motion;
	struct acting acting;
	int node;

	(void)state;
	begin(&acting, "assets/walker.glb",
		"[state a]\nclip = rest\n[morph m]\nnode = walker_head\n"
		"[buttons]\nUP = morph m smile\n");
	acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
	motion = describe(&acting);
	assert_true(motion.morphing);
	assert_int_equal(
		motion.node, model_find_node(acting.model, "walker_head"));
	acting_end(&acting);
	begin(&acting, "tests/fixtures/gltf/clip/door.gltf",
		"[state a]\nclip = smile\n");
	node = model_find_morphed(acting.model);
	assert_true(node > 0);
	acting.instance->pose.weight[acting.model->node[node].weight_offset] =
		0.5f;
	motion = describe(&acting);
	assert_true(motion.morphing);
	assert_int_equal(motion.node, node);
	acting_end(&acting);
}

/* If its keys are mixed, the targets are those of the clip. */
static void test_only_a_first_morph_of_plain_keys_is_shown(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph mixed]\nkey = calm\n"
		"key = glad, smile 0.8\n[morph plain]\n");
	assert_int_equal(acting.character->morph_count, 2);
	assert_false(describe(&acting).morphing);
	acting_end(&acting);
	begin(&acting, "assets/face.glb",
		"[state a]\nclip = rest\n[morph plain]\n[morph mixed]\n"
		"key = calm\nkey = glad, smile 0.8\n");
	assert_true(describe(&acting).morphing);
	acting_end(&acting);
}

/* Sets the weights of the face's first targets, and describes that. */
static struct overlay_motion with_weights(
	struct acting *acting, float first, float second, float third)
{
	int node = model_find_node(acting->model, "Face");
	float *weight =
		&acting->instance->pose
			 .weight[acting->model->node[node].weight_offset];

	memset(weight, 0, 8 * sizeof(*weight));
	weight[0] = first;
	weight[3] = second;
	weight[7] = third;
	return describe(acting);
}

static void expect_keys(
	const struct overlay_motion *motion, int from, int to, double omega)
{
	assert_true(motion->morphing);
	assert_int_equal(motion->from, from);
	assert_int_equal(motion->to, to);
	assert_near(motion->omega, omega, 1e-6);
	assert_null(motion->shape);
	assert_near(motion->wave, 0, 0);
}

/* Of a clip there is one target, or two whose weights sum up to 1. */
static void test_a_clip_goes_from_key_frame_to_key_frame(void **state)
{
	struct overlay_motion motion;
	struct acting acting;

	(void)state;
	begin(&acting, "assets/face.glb", "[state a]\nclip = cycle\n");
	motion = with_weights(&acting, 0, 0, 0);
	assert_true(motion.morphing);
	assert_int_equal(motion.from, -1);
	assert_int_equal(motion.to, -1);
	assert_near(motion.omega, 0, 0);
	motion = with_weights(&acting, 0, 0.3f, 0);
	expect_keys(&motion, -1, 3, 0.3);
	motion = with_weights(&acting, 0.25f, 0, 0.75f);
	expect_keys(&motion, 0, 7, 0.75);
	motion = with_weights(&acting, 0, 0.4f, 0.6005f);
	expect_keys(&motion, 3, 7, 0.6005);
	assert_int_equal(motion.node, model_find_node(acting.model, "Face"));
	assert_false(with_weights(&acting, 0, 0.4f, 0.602f).morphing);
	assert_false(with_weights(&acting, 0.4f, 0.598f, 0).morphing);
	assert_false(with_weights(&acting, 0.2f, 0.4f, 0.4f).morphing);
	acting_end(&acting);
	/* The rest pose moves nothing. */
	begin(&acting, "assets/face.glb", "[state a]\nclip = rest\n");
	assert_false(with_weights(&acting, 0, 0.3f, 0).morphing);
	acting_end(&acting);
	/* Nor does a clip of bones alone. */
	begin(&acting, "assets/walker.glb", "[state a]\nclip = walk\n");
	assert_false(describe(&acting).morphing);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_clip_is_shown_with_its_time),
		cmocka_unit_test(test_the_clips_of_a_blend_are_layers),
		cmocka_unit_test(test_both_clips_of_a_blend_of_two_are_layers),
		cmocka_unit_test(test_the_travel_of_the_root_is_shown),
		cmocka_unit_test(test_layers_effects_and_fades_are_layers),
		cmocka_unit_test(test_each_effect_is_a_layer),
		cmocka_unit_test(
			test_as_many_layers_are_shown_as_there_is_room_for),
		cmocka_unit_test(test_a_morph_goes_from_target_to_target),
		cmocka_unit_test(test_the_node_that_morphs_is_named),
		cmocka_unit_test(test_only_a_first_morph_of_plain_keys_is_shown),
		cmocka_unit_test(test_a_clip_goes_from_key_frame_to_key_frame),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
