/* Which card and screen are opened through KMS, and what is said if none is. */
#include "platform/display/kms/card.h"
#include "tests/unit/platform/display/kms_scene.h"

#include <errno.h>

static void test_an_idle_crtc_is_found(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_card.encoders[0].crtc = 0;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_card.shown_crtc, 51);
	draw(&scene, 1);
	scene_close(&scene);
}

static void test_any_card_with_a_screen_is_found(void **state)
{
	struct scene scene = {0};

	(void)state;
	for (fake_card.number = 0; fake_card.number < 8; fake_card.number++) {
		assert_int_equal(scene_open(&scene), 0);
		draw(&scene, 1);
		scene_close(&scene);
	}
	assert_true(scene_open(&scene) < 0);
	scene.options.device = "/dev/dri/card1";
	assert_true(scene_open(&scene) < 0);
	assert_contains(scene.capture.sentence[0], "/dev/dri/card1");
	expect_all_closed();
}

static void test_looking_for_a_card_leaves_none_open(void **state)
{
	assert_true(card_is_available(&fake_card_calls));
	expect_all_closed();
	fake_card.not_connected = true;
	assert_false(card_is_available(&fake_card_calls));
	expect_all_closed();
	reset(state);
	fake_card.number = 99;
	assert_false(card_is_available(&fake_card_calls));
	expect_all_closed();
}

static void test_the_message_names_what_is_missing(void **state)
{
	static const struct {
		const char *words;
		int open_error;
		bool no_dumb, not_master, not_connected;
		enum fake_card_call fail;
	} cases[] = {
		{.words = "group", .open_error = EACCES},
		{.words = "No such file", .open_error = ENOENT},
		{.words = "no buffers", .no_dumb = true},
		{.words = "another program", .not_master = true},
		{.words = "no screen is connected", .not_connected = true},
		{.words = "drives no screens", .fail = CALL_RESOURCES},
		{.words = "no screen", .fail = CALL_CONNECTOR},
		{.words = "no CRTC", .fail = CALL_ENCODER},
		{.words = "no buffer", .fail = CALL_CREATE},
		{.words = "no buffer", .fail = CALL_ADD},
		{.words = "no buffer", .fail = CALL_MAP_DUMB},
		{.words = "no buffer", .fail = CALL_MAP},
		{.words = "no buffer", .fail = CALL_SET},
	};

	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct scene scene = {0};

		reset(state);
		fake_card.open_error = cases[i].open_error;
		fake_card.no_dumb = cases[i].no_dumb;
		fake_card.not_master = cases[i].not_master;
		fake_card.not_connected = cases[i].not_connected;
		fake_card.fail = cases[i].fail;
		assert_true(scene_open(&scene) < 0);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 1);
		assert_contains(scene.capture.sentence[0], "/dev/dri/card0");
		assert_contains(scene.capture.sentence[0], cases[i].words);
		expect_all_closed();
	}
}

static void test_a_later_failure_is_logged_and_everything_closed(void **state)
{
	static const enum fake_card_call calls[] = {
		CALL_FLIP, CALL_WAIT, CALL_EVENT};

	for (int i = 0; i < 3; i++) {
		struct scene scene = {0};
		struct pixels pixels;
		int error = 0;

		reset(state);
		fake_card.fail = calls[i];
		fake_card.fail_from = 3;
		assert_int_equal(scene_open(&scene), 0);
		for (int frame = 0; !error && frame < 200; frame++) {
			error = scene.driver->begin_frame(
				scene.display, &pixels);
			error = error ? error
				      : scene.driver->end_frame(scene.display);
		}
		assert_true(error < 0);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 1);
		/* The card never completes a page flip. */
		fake_card.flip_user = NULL;
		fake_card.flip_fb = 0;
		fake_card.fail = CALL_NONE;
		scene_close(&scene);
	}
}

static void test_a_screen_without_a_former_mode_is_fine(void **state)
{
	struct scene scene = {0};

	(void)state;
	fake_card.fail = CALL_GET_CRTC;
	assert_int_equal(scene_open(&scene), 0);
	draw(&scene, 1);
	scene_close(&scene);
}

static void test_the_real_library_refuses_another_device(void **state)
{
	struct scene scene = {.options = {.device = "/dev/null"}};

	(void)state;
	scene.driver = &display_driver_kms;
	scene.log = log_capture_begin(&scene.capture);
	scene.options.log = &scene.log;
	assert_true(scene.driver->create(&scene.options, &scene.display) < 0);
	assert_int_equal(scene.capture.count, 1);
	assert_contains(scene.capture.sentence[0], "/dev/null");
}

#define KMS_TEST(name) cmocka_unit_test_setup(name, reset)

int main(void)
{
	const struct CMUnitTest tests[] = {
		KMS_TEST(test_an_idle_crtc_is_found),
		KMS_TEST(test_any_card_with_a_screen_is_found),
		KMS_TEST(test_looking_for_a_card_leaves_none_open),
		KMS_TEST(test_the_message_names_what_is_missing),
		KMS_TEST(test_a_later_failure_is_logged_and_everything_closed),
		KMS_TEST(test_a_screen_without_a_former_mode_is_fine),
		KMS_TEST(test_the_real_library_refuses_another_device),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
