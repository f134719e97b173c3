/* How long after its start a clip begins to move. */
#include "app/model/model_loader.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

/* Prepares a clip of one second of a channel that begins at 0.02 s and one that
   begins at first_s and is constant or not. */
static float find_lead_s(float first_s, float change)
{
	const float early_s[] = {0.02f, 1}, late_s[] = {first_s, 1};
	const float still[] = {5, 5, 5, 5, 5, 5};
	const float move[] = {0, 0, 0, change, 0, 0};
	struct model_channel channel[] = {
		{.path = MODEL_SCALE,
			.interpolation = MODEL_LINEAR,
			.width = 3,
			.key_count = 2,
			.time_s = early_s,
			.value = still},
		{.path = MODEL_TRANSLATION,
			.interpolation = MODEL_LINEAR,
			.width = 3,
			.key_count = 2,
			.time_s = late_s,
			.value = move},
	};
	struct model_clip clip = {
		.duration_s = 1, .channel_count = 2, .channel = channel};
	struct model model = {.clip_count = 1, .clip = &clip};

	model_prepare_clips(&model);
	return clip.lead_s;
}

static void test_finds_when_a_clip_begins_to_move(void **state)
{
	struct model *blender = model_fixture("gltf/clip/frame_one.gltf", NULL);
	struct model *late = model_fixture("gltf/clip/late_start.gltf", NULL);

	(void)state;
	assert_near(find_lead_s(0.04f, 1), 0.04f, 0);
	assert_near(find_lead_s(0.1f, 1), 0.1f, 0);
	assert_near(find_lead_s(0.11f, 1), 0, 0);
	assert_near(find_lead_s(0, 1), 0, 0);
	assert_near(find_lead_s(0.04f, 0), 0, 0);
	assert_near(blender->clip[0].lead_s, 1 / 24.0, 1e-7);
	assert_near(late->clip[0].lead_s, 0, 0);
	model_destroy(blender);
	model_destroy(late);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_finds_when_a_clip_begins_to_move),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
