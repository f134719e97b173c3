/* Which of several cards, screens and CRTCs limber takes, and gives back. */
#include "platform/base/compiler.h"
#include "platform/display/kms/card_find.h"
#include "tests/support/fake/fake_card.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>

extern const struct display_driver display_driver_kms;

enum {
	CRTC = 51,
	OTHER_CRTC = 52, /* the first in the card's list */
	FB_BEFORE = 77
};

struct scene {
	struct display *display;
	struct display_options options;
	struct log_capture capture;
	struct log log;
};

static int begin(void **state)
{
	static const struct pixel_layout any = {
		.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};

	(void)state;
	fake_card_begin();
	fake_fb_begin(8, 8, 8, 8, 16, any);
	return 0;
}

static int scene_open(struct scene *scene)
{
	scene->log = log_capture_begin(&scene->capture);
	scene->options.log = &scene->log;
	return kms_create_on(&fake_card_calls, &scene->options, &scene->display);
}

static void expect_closed(void)
{
	assert_int_equal(fake_card.open_count, 0);
	assert_int_equal(fake_card.resource_count, 0);
}

static void scene_close(struct scene *scene)
{
	display_driver_kms.destroy(scene->display);
	expect_closed();
}

/* Fails unless that card was opened. */
static void expect_card(struct scene *scene, const char *path)
{
	assert_int_equal(scene_open(scene), 0);
	assert_true(log_capture_has(&scene->capture, LOG_NOTE, path));
	scene_close(scene);
}

static void test_a_connected_screen_is_better_than_an_unsure_one(void **state)
{
	struct scene scene = {0};

	for (int number = 0; number < 2; number++) {
		begin(state);
		fake_card.number = number;
		fake_card.second_number = !number;
		fake_card.second_unsure = true;
		expect_card(
			&scene, number ? "/dev/dri/card1" : "/dev/dri/card0");
		/* Of two that are alike, the first. */
		fake_card.unsure = true;
		expect_card(&scene, "/dev/dri/card0");
		fake_card.unsure = fake_card.second_unsure = false;
		expect_card(&scene, "/dev/dri/card0");
		/* A card that the user names is not compared. */
		fake_card.unsure = true;
		scene.options.device =
			number ? "/dev/dri/card1" : "/dev/dri/card0";
		expect_card(&scene, scene.options.device);
		scene.options.device = NULL;
	}
}

/* The number of its descriptor may be that of the next card. */
static void test_a_card_in_use_is_closed_once_before_a_free_one(void **state)
{
	struct scene scene = {0};

	begin(state);
	fake_card.number = 1;
	fake_card.second_number = 0;
	fake_card.second_in_use = true;
	expect_card(&scene, "/dev/dri/card1");
}

static void test_the_message_is_of_the_card_that_lacks_least(void **state)
{
	static const struct {
		bool second_drives_none, second_in_use;
		int second_error;
		bool not_connected, not_master;
		const char *path, *words;
	} cases[] = {
		{.second_drives_none = true,
			.not_master = true,
			.path = "card1",
			.words = "another program"},
		{.second_drives_none = true,
			.not_connected = true,
			.path = "card1",
			.words = "no screen is connected"},
		{.second_error = ENOENT,
			.not_connected = true,
			.path = "card1",
			.words = "no screen is connected"},
		{.second_error = EACCES,
			.not_connected = true,
			.path = "card0",
			.words = "no permission"},
		{.second_in_use = true,
			.not_connected = true,
			.path = "card0",
			.words = "another program"},
	};

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct scene scene = {0};

		begin(state);
		fake_card.number = 1;
		fake_card.second_number = 0;
		fake_card.second_drives_none = cases[i].second_drives_none;
		fake_card.second_in_use = cases[i].second_in_use;
		fake_card.second_error = cases[i].second_error;
		fake_card.not_connected = cases[i].not_connected;
		fake_card.not_master = cases[i].not_master;
		assert_false(card_is_available(&fake_card_calls));
		assert_true(scene_open(&scene) < 0);
		assert_int_equal(
			log_capture_count(&scene.capture, LOG_ERROR), 1);
		assert_contains(scene.capture.sentence[0], cases[i].path);
		assert_contains(scene.capture.sentence[0], cases[i].words);
		expect_closed();
	}
}

/* Two screens; the other one is driven by the CRTC that is first in the list. */
static void begin_two_screens(void **state)
{
	begin(state);
	fake_card.two_connectors = true;
	fake_card.encoder_count = 2;
	fake_card.encoders[0].crtc = 0;
	fake_card.encoders[0].possible = 3;
	fake_card.encoders[1].crtc = OTHER_CRTC;
	fake_card.encoders[1].possible = 1;
	fake_card.other_encoder = 1;
	fake_card.other_state = DRM_MODE_DISCONNECTED;
}

static void test_another_screens_crtc_is_left_alone(void **state)
{
	struct scene scene = {0};

	begin_two_screens(state);
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_card.shown_crtc, CRTC);
	scene_close(&scene);
	/* It was off before, so it is again. */
	assert_int_not_equal(fake_card.shown_fb, FB_BEFORE);
}

static void test_the_only_crtc_is_borrowed_from_another_screen(void **state)
{
	struct scene scene = {0};

	begin_two_screens(state);
	fake_card.encoders[0].possible = 1;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_card.shown_crtc, OTHER_CRTC);
	assert_int_equal(fake_card.shown_count, 1);
	assert_int_equal(fake_card.shown_connectors[0], FAKE_CARD_CONNECTOR);
	scene_close(&scene);
	/* The other screen gets its picture back, and no screen another's. */
	assert_int_equal(fake_card.shown_fb, FB_BEFORE);
	assert_int_equal(fake_card.shown_count, 1);
	assert_int_equal(
		fake_card.shown_connectors[0], FAKE_CARD_OTHER_CONNECTOR);
}

static void test_a_screen_with_a_crtc_is_better_than_one_without(void **state)
{
	struct scene scene = {0};

	begin_two_screens(state);
	fake_card.encoders[0].possible = 1;
	fake_card.other_state = DRM_MODE_CONNECTED;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(
		fake_card.shown_connectors[0], FAKE_CARD_OTHER_CONNECTOR);
	scene_close(&scene);
}

static void test_screens_that_showed_the_same_do_so_again(void **state)
{
	struct scene scene = {0};

	begin(state);
	fake_card.two_connectors = true;
	fake_card.other_encoder = 0;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_card.shown_count, 1);
	scene_close(&scene);
	assert_int_equal(fake_card.shown_fb, FB_BEFORE);
	assert_int_equal(fake_card.shown_count, 2);
	assert_int_equal(
		fake_card.shown_connectors[0] + fake_card.shown_connectors[1],
		FAKE_CARD_CONNECTOR + FAKE_CARD_OTHER_CONNECTOR);
}

/* Probing takes long, so it is done only if the kernel knows no screen. */
static void test_a_card_that_was_never_used_is_asked_for_screens(void **state)
{
	struct scene scene = {0};

	begin(state);
	assert_int_equal(scene_open(&scene), 0);
	scene_close(&scene);
	assert_int_equal(fake_card.probe_count, 0);
	fake_card.must_ask = true;
	assert_int_equal(scene_open(&scene), 0);
	assert_int_equal(fake_card.shown_mode.hdisplay, 20);
	scene_close(&scene);
	assert_true(fake_card.probe_count > 0);
}

static void test_modes_that_no_picture_has_are_not_set(void **state)
{
	static const uint16_t sides[][2] = {
		{0, 8}, {8, 0}, {PIXELS_SIZE_MAX + 1, 8}, {8, 65535}};
	struct scene scene = {0};

	for (size_t i = 0; i < ARRAY_COUNT(sides); i++) {
		begin(state);
		fake_card.modes[0].hdisplay = fake_card.modes[1].hdisplay =
			sides[i][0];
		fake_card.modes[0].vdisplay = fake_card.modes[1].vdisplay =
			sides[i][1];
		assert_int_equal(scene_open(&scene), 0);
		assert_int_equal(fake_card.shown_mode.hdisplay, 10);
		scene_close(&scene);
		fake_card.mode_count = 2;
		assert_int_equal(scene_open(&scene), -ENODEV);
		assert_true(log_capture_has(
			&scene.capture, LOG_ERROR, "no screen is connected"));
		expect_closed();
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_connected_screen_is_better_than_an_unsure_one),
		cmocka_unit_test(
			test_a_card_in_use_is_closed_once_before_a_free_one),
		cmocka_unit_test(
			test_the_message_is_of_the_card_that_lacks_least),
		cmocka_unit_test(test_another_screens_crtc_is_left_alone),
		cmocka_unit_test(
			test_the_only_crtc_is_borrowed_from_another_screen),
		cmocka_unit_test(
			test_a_screen_with_a_crtc_is_better_than_one_without),
		cmocka_unit_test(test_screens_that_showed_the_same_do_so_again),
		cmocka_unit_test(
			test_a_card_that_was_never_used_is_asked_for_screens),
		cmocka_unit_test(test_modes_that_no_picture_has_are_not_set),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
