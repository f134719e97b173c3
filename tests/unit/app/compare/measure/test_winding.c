/* Whether a clip may reverse the winding of triangles. */
#include "app/compare/measure/winding.h"
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_scale_of_another_sign_may_mirror),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
