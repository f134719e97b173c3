/* What --clip is answered when the model has no such clip. */
#include "app/model/model.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>

/* Chooses a clip of animations given as JSON, and expects the message. */
static void expect_no_clip(
	const char *animations, const char *wanted, const char *message)
{
	struct log_capture logged;
	struct log log;
	struct model *model;
	char text[256];
	int clip;

	snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},'animations':[%s]}", animations);
	assert_int_equal(model_from_text(text, &logged, &model), 0);
	log = log_capture_begin(&logged);
	assert_int_equal(
		model_choose_clip(model, wanted, 0, &log, &clip), -ENOENT);
	assert_int_equal(logged.count, 1);
	assert_string_equal(logged.sentence[0], message);
	model_destroy(model);
}

static void test_a_missing_clip_is_answered_with_the_others(void **state)
{
	(void)state;
	expect_no_clip("{'name':'Spin'},{'name':'Open door'},{}", "opendoor",
		"--clip opendoor: t.gltf has no such clip: give \"Open door\", Spin, or a number from 0 to 2");
	expect_no_clip("{'name':'Spin'}", "Turn",
		"--clip Turn: t.gltf has no such clip: give Spin, or 0");
	expect_no_clip("{'name':'a'},{'name':'b'}", "c",
		"--clip c: t.gltf has no such clip: give a, b, or a number from 0 to 1");
	expect_no_clip("{},{}", "2",
		"--clip 2: t.gltf has no such clip: give a number from 0 to 1");
}

static void test_a_model_without_clips_needs_no_clip(void **state)
{
	(void)state;
	expect_no_clip("", "Turn",
		"--clip Turn: t.gltf has no clips: leave out --clip");
}

static void test_a_clip_is_chosen_by_its_name_or_number(void **state)
{
	static const struct {
		const char *wanted;
		int clip;
	} cases[] = {{"a", 0}, {"b", 1}, {"0", 0}, {"1", 1}, {NULL, -1}};
	struct log_capture logged;
	struct log log;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text("{'asset':{'version':'2.0'},'animations':[{"
				"'name':'a'},{'name':'b'}]}",
			&logged, &model),
		0);
	log = log_capture_begin(&logged);
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		int clip = 99;

		assert_int_equal(model_choose_clip(model, cases[i].wanted, -1,
					 &log, &clip),
			0);
		assert_int_equal(clip, cases[i].clip);
	}
	assert_int_equal(logged.count, 0);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_missing_clip_is_answered_with_the_others),
		cmocka_unit_test(test_a_clip_is_chosen_by_its_name_or_number),
		cmocka_unit_test(test_a_model_without_clips_needs_no_clip),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
