/* Morphs of a character: over time and by frames. */
#include "app/character/character_open.h"
#include "app/character/show/character_overlay.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>

static const double rate_hz = 50.0;

/* The weight of a morph target now. */
static float weight_of(const struct acting *acting, int target)
{
	const struct model *model = acting->model;
	int node = model_find_node(model, "Face");

	return acting->instance->pose
		.weight[model->node[node].weight_offset + target];
}

static void test_a_morph_goes_from_key_frame_to_key_frame(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	acting_expect(&acting,
		"[state a]\nclip = rest\n[morph face]\ntime = 1\n"
		"[buttons]\nUP = morph face smile\nDOWN = morph face frown\n");
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(weight_of(&acting, 0), 0.5, 1e-3);
	acting_press(&acting, BUTTON_DOWN); /* from the shape of this moment */
	acting_run_to(&acting, 1.0, rate_hz);
	assert_near(weight_of(&acting, 0), 0.25, 1e-3);
	assert_near(weight_of(&acting, 1), 0.5, 1e-3);
	acting_run_to(&acting, 2.0, rate_hz);
	assert_near(weight_of(&acting, 0), 0.0, 0.0);
	assert_near(weight_of(&acting, 1), 1.0, 0.0);
	acting_end(&acting);
}

static void test_a_morph_by_frames_takes_so_many_frames(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	acting_expect(&acting,
		"[state a]\nclip = rest\n[morph face]\nframes = 8\n"
		"curve = table 0 0 1 1\n[buttons]\nUP = morph face smile\n");
	acting_run_to(&acting, 0.1, rate_hz);
	acting_press(&acting, BUTTON_UP);
	for (int frame = 1; frame <= 8; frame++) {
		double u = frame / 8.0;

		acting_run_to(&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
		assert_near(weight_of(&acting, 0),
			fmax(0.0, fmin(1.0, 3.0 * u - 1.0)), 1e-5);
	}
	acting_end(&acting);
}

/* The document's sum of float steps, and its end. */
static void test_a_linear_morph_by_frames_adds_equal_steps(void **state)
{
	struct acting acting;
	float expected = 0;

	(void)state;
	acting_begin(&acting, "assets/face.glb");
	acting_expect(&acting,
		"[state a]\nclip = rest\n[morph face]\nframes = 7\n"
		"[buttons]\nUP = morph face smile\n");
	acting_run_to(&acting, 0.1, rate_hz);
	acting_press(&acting, BUTTON_UP);
	for (int frame = 1; frame <= 7; frame++) {
		acting_run_to(&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
		expected += 1.0f / 7.0f;
		assert_near(weight_of(&acting, 0),
			frame < 7 ? (double)expected : 1.0, 0.0);
	}
	acting_end(&acting);
}

/* Frames over the pace, rounded; one at least. */
static void test_the_pace_shortens_a_morph_by_frames(void **state)
{
	static const struct {
		int frames;
		const char *pace;
		int taken;
	} cases[] = {{1, "1", 1}, {2, "1", 2}, {1, "8", 1}, {3, "8", 1},
		{9, "4", 2}, {10, "4", 3}, {1, "0.125", 8}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct acting acting;
		char text[200];
		int taken = 0;

		(void)snprintf(text, sizeof(text),
			"[state a]\nclip = rest\n[morph face]\nframes = %d\n"
			"[buttons]\nUP = morph face smile\nDOWN = pace face %s\n",
			cases[i].frames, cases[i].pace);
		acting_begin(&acting, "assets/face.glb");
		acting_expect(&acting, text);
		acting_press(&acting, BUTTON_DOWN);
		acting_run_to(&acting, 0.1, rate_hz);
		acting_press(&acting, BUTTON_UP);
		assert_near(weight_of(&acting, 0), 0.0, 0.0);
		while (weight_of(&acting, 0) < 1 && taken < 20) {
			acting_run_to(
				&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
			taken++;
		}
		assert_int_equal(taken, cases[i].taken);
		acting_end(&acting);
	}
}

/* Of a model without a character file. */
static int count_morphs(const char *model_path)
{
	const struct character_request request = {
		.model_path = model_path, .rate = 1, .repeat = CLIP_LOOP};
	struct acting acting;
	struct log log;
	int count;

	acting_begin(&acting, model_path);
	log = log_capture_begin(&acting.logged);
	assert_int_equal(character_open(&request, acting.instance, &log,
				 &acting.character),
		0);
	count = acting.character->morph_count;
	acting_end(&acting);
	return count;
}

/* Else the camera would leave room for shapes that no button shows. */
static void test_shapes_that_a_clip_moves_get_no_morph_of_their_own(void **state)
{
	(void)state;
	assert_int_equal(
		count_morphs("tests/fixtures/gltf/mesh/weights.gltf"), 1);
	assert_int_equal(
		count_morphs("tests/fixtures/gltf/skin/and_morph.gltf"), 0);
}

/* What overlays show of a clip of 1 s that goes between these weights. */
static struct overlay_motion describe(const float weights[4], double time_s)
{
	struct acting acting;
	struct overlay_motion motion = overlay_motion_none();

	acting_begin(&acting, "tests/fixtures/gltf/skin/and_morph.gltf");
	for (int i = 0; i < acting.model->clip[0].channel_count; i++) {
		struct model_channel *channel =
			&acting.model->clip[0].channel[i];

		if (channel->path == MODEL_WEIGHTS) {
			channel->value = weights;
		}
	}
	acting_expect(&acting, "[state a]\nclip = both\n");
	acting_run_to(&acting, time_s, rate_hz);
	character_overlay_describe(acting.character, &motion);
	acting_end(&acting);
	return motion;
}

static void test_overlays_show_the_key_frames_between_which_a_clip_is(
	void **state)
{
	static const float first[4] = {0, 0, 1, 0}, second[4] = {1, 0, 0, 1};
	static const float mixed[4] = {0, 0, 1, 1};
	struct overlay_motion motion = describe(first, 0.5);

	(void)state;
	assert_true(motion.morphing);
	assert_int_equal(motion.from, -1);
	assert_int_equal(motion.to, 0);
	assert_near(motion.omega, 0.5, 0.03);
	motion = describe(second, 0.75);
	assert_true(motion.morphing);
	assert_int_equal(motion.from, 0);
	assert_int_equal(motion.to, 1);
	assert_near(motion.omega, 0.75, 0.03);
	assert_false(describe(mixed, 0.25).morphing);
}

/* The first node, too, may be the one that clips move. */
static void test_overlays_leave_out_what_a_root_travels(void **state)
{
	struct overlay_motion motion = overlay_motion_none();
	struct acting acting;
	char text[128];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, "[state a]\nclip = walk\n");
	character_overlay_describe(acting.character, &motion);
	assert_int_equal(motion.traveller, -1);
	assert_null(motion.travel);
	snprintf(text, sizeof(text),
		"[motion]\nroot = %s\n[state a]\nclip = walk\n",
		acting.model->node[0].name);
	acting_expect(&acting, text);
	character_overlay_describe(acting.character, &motion);
	assert_int_equal(motion.traveller, 0);
	assert_non_null(motion.travel);
	acting_end(&acting);
}

static void test_overlays_list_each_layer_and_effect_once(void **state)
{
	struct overlay_motion motion = overlay_motion_none();
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state a]\nclip = walk\n[layer greeting]\nclip = wave\n"
		"[breath life]\nbone = chest\n");
	acting_run_to(&acting, 1.0, rate_hz);
	character_overlay_describe(acting.character, &motion);
	assert_int_equal(motion.layer_count, 2);
	assert_string_equal(motion.layer[0].name, "greeting");
	assert_string_equal(motion.layer[1].name, "life");
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_morph_goes_from_key_frame_to_key_frame),
		cmocka_unit_test(test_a_morph_by_frames_takes_so_many_frames),
		cmocka_unit_test(test_a_linear_morph_by_frames_adds_equal_steps),
		cmocka_unit_test(test_the_pace_shortens_a_morph_by_frames),
		cmocka_unit_test(
			test_shapes_that_a_clip_moves_get_no_morph_of_their_own),
		cmocka_unit_test(
			test_overlays_show_the_key_frames_between_which_a_clip_is),
		cmocka_unit_test(test_overlays_leave_out_what_a_root_travels),
		cmocka_unit_test(test_overlays_list_each_layer_and_effect_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
