/* Whether a clip may reverse the winding of triangles. */
#include "app/compare/measure/winding.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

enum {
	KEYS = 3
};

/* Whether a clip of one channel, for a node with this scale at rest, may. */
static bool may_change(const float rest[3], enum model_path path,
	enum model_interpolation interpolation, float value[KEYS][3])
{
	float time_s[KEYS] = {0.0f, 1.0f, 2.0f};
	struct model_node node = {
		.rest = {.scale = {rest[0], rest[1], rest[2]}}};
	struct model_channel channel = {.path = path,
		.interpolation = interpolation,
		.width = 3,
		.key_count = KEYS,
		.time_s = time_s,
		.value = value[0]};
	const struct model_clip clip = {.channel_count = 1, .channel = &channel};
	const struct model model = {.node_count = 1, .node = &node};

	return winding_may_change(&model, &clip);
}

static void test_a_scale_of_another_sign_may_mirror(void **state)
{
	static const float rest[3] = {1.0f, -2.0f, 0.5f};

	(void)state;
	for (int at = -1; at < KEYS * 3; at++) {
		float value[KEYS][3];

		for (int i = 0; i < KEYS * 3; i++) {
			value[i / 3][i % 3] =
				3.0f * rest[i % 3] * (i == at ? -1.0f : 1.0f);
		}
		assert_int_equal(
			may_change(rest, MODEL_SCALE, MODEL_LINEAR, value),
			at >= 0);
		assert_int_equal(
			may_change(rest, MODEL_SCALE, MODEL_STEP, value),
			at >= 0);
		assert_true(
			may_change(rest, MODEL_SCALE, MODEL_CUBICSPLINE, value));
		assert_false(may_change(
			rest, MODEL_TRANSLATION, MODEL_LINEAR, value));
	}
}

/* Whatever the size of the scale is; 0 has the sign of positive numbers. */
static void test_a_scale_of_the_same_sign_does_not_mirror(void **state)
{
	static const float sizes[] = {0.0f, 0.125f, 1.0f, 100.0f};
	static const float rests[] = {-0.125f, 0.0f, 0.125f, 4.0f};

	(void)state;
	for (size_t r = 0; r < ARRAY_COUNT(rests); r++) {
		float rest[3] = {rests[r], 1.0f, 1.0f};

		for (size_t s = 0; s < ARRAY_COUNT(sizes); s++) {
			float value[KEYS][3] = {{sizes[s], 1, 1},
				{sizes[s], 1, 1}, {sizes[s], 1, 1}};

			assert_int_equal(may_change(rest, MODEL_SCALE,
						 MODEL_LINEAR, value),
				rest[0] < 0.0f);
		}
	}
}

/* How often a fixture with a scale of its own is mirrored, at some moments. */
static bool turns(bool mirrored[KEYS], enum model_interpolation interpolation)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	float time_s[KEYS] = {0.0f, 1.0f, 2.0f}, value[3 * KEYS][3] = {{0}};
	int width = interpolation == MODEL_CUBICSPLINE ? 3 : 1;
	struct model_channel channel = {.node = model->clip[0].channel[0].node,
		.path = MODEL_SCALE,
		.interpolation = interpolation,
		.width = 3,
		.key_count = KEYS,
		.time_s = time_s,
		.value = value[0]};
	struct model_clip *clips = model->clip, own = clips[0];
	int count = model->clip_count;
	const struct time_grid grid = {.count = KEYS, .time_s = time_s};
	struct reference *reference;
	bool found = true;

	own.channel = &channel;
	own.channel_count = 1;
	own.duration_s = time_s[KEYS - 1];
	for (int k = 0; k < KEYS; k++) {
		float *scale = value[k * width + width / 2];

		scale[0] = mirrored[k] ? -1.0f : 1.0f;
		scale[1] = scale[2] = 1.0f;
	}
	model->clip = &own;
	model->clip_count = 1;
	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	assert_int_equal(winding_find_turns(reference, &grid, &found), 0);
	reference_destroy(reference);
	model->clip = clips;
	model->clip_count = count;
	model_destroy(model);
	return found;
}

/* What is mirrored all the time has the same winding all the time. */
static void test_only_surfaces_that_are_mirrored_at_times_turn(void **state)
{
	(void)state;
	for (int i = 0; i < 8; i++) {
		bool mirrored[KEYS] = {i & 1, i >> 1 & 1, i >> 2 & 1};

		assert_int_equal(turns(mirrored, MODEL_STEP), i > 0 && i < 7);
		assert_int_equal(turns(mirrored, MODEL_LINEAR), i > 0 && i < 7);
		assert_int_equal(
			turns(mirrored, MODEL_CUBICSPLINE), i > 0 && i < 7);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_scale_of_another_sign_may_mirror),
		cmocka_unit_test(test_a_scale_of_the_same_sign_does_not_mirror),
		cmocka_unit_test(
			test_only_surfaces_that_are_mirrored_at_times_turn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
