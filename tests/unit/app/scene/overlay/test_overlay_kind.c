/* What --show accepts. */
#include "app/scene/overlay/overlay_kind.h"
#include "tests/support/test.h"

static void test_names_choose_overlays(void **state)
{
	struct overlay_choice choice;

	(void)state;
	assert_true(overlay_choice_parse("skeleton", &choice));
	assert_int_equal(choice.kinds, 1 << OVERLAY_SKELETON);
	assert_string_equal(choice.joint, "");
	assert_true(overlay_choice_parse("curve,wireframe,curve", &choice));
	assert_int_equal(
		choice.kinds, 1 << OVERLAY_CURVE | 1 << OVERLAY_WIREFRAME);
	assert_true(overlay_choice_parse("all", &choice));
	assert_int_equal(choice.kinds, (1 << OVERLAY_KINDS) - 1);
	assert_true(overlay_choice_parse("none", &choice));
	assert_int_equal(choice.kinds, 0);
	for (int kind = 0; kind < OVERLAY_KINDS; kind++) {
		assert_true(overlay_choice_parse(
			overlay_kind_name((enum overlay_kind)kind), &choice));
		assert_int_equal(choice.kinds, 1 << kind);
	}
}

static void test_weights_may_name_a_joint(void **state)
{
	struct overlay_choice choice;

	(void)state;
	assert_true(overlay_choice_parse("keys,weights:hand.R,curve", &choice));
	assert_int_equal(choice.kinds,
		1 << OVERLAY_KEYS | 1 << OVERLAY_WEIGHTS | 1 << OVERLAY_CURVE);
	assert_string_equal(choice.joint, "hand.R");
	assert_true(overlay_choice_parse("weights:mixamo:Hips", &choice));
	assert_string_equal(choice.joint, "mixamo:Hips");
}

static void test_wrong_lists_are_refused(void **state)
{
	static const char *const wrong[] = {"", "bones", "skeleton,", ",curve",
		"skeleton;curve", "weights:", "keys:hand", "none,curve",
		"skeletons", "Skeleton",
		"weights:a234567890123456789012345678901234567890123456789012345678901234"};
	struct overlay_choice choice = {.kinds = 5};

	(void)state;
	for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); i++) {
		assert_false(overlay_choice_parse(wrong[i], &choice));
		assert_int_equal(choice.kinds, 5);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_names_choose_overlays),
		cmocka_unit_test(test_weights_may_name_a_joint),
		cmocka_unit_test(test_wrong_lists_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
