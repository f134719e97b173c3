/* Which mode and which CRTC of any card limber chooses, and what it says. */
#include "platform/base/compiler.h"
#include "platform/display/kms/card_find.h"
#include "platform/display/kms/kms_calls.h"
#include "tests/support/fake/fake_card.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/log_capture.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const struct display_driver display_driver_kms;

struct scene {
	struct display *display;
	struct display_options options;
	struct log_capture capture;
	struct log log;
};

static void begin(void)
{
	static const struct pixel_layout any = {
		.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};

	fake_card_begin();
	fake_fb_begin(8, 8, 8, 8, 16, any);
}

static int scene_open(struct scene *scene)
{
	scene->log = log_capture_begin(&scene->capture);
	scene->options.log = &scene->log;
	return kms_create_on(&fake_card_calls, &scene->options, &scene->display);
}

static void scene_close(struct scene *scene)
{
	display_driver_kms.destroy(scene->display);
	assert_int_equal(fake_card.open_count, 0);
	assert_int_equal(fake_card.resource_count, 0);
}

/*
 * What a mode is chosen by, the smallest number first: whether the size that
 * was asked for fits into it, how far it is from that size, whether the screen
 * prefers it, how fast it is, and its place in the screen's list.
 */
static int penalty(int number, const struct display_options *options)
{
	const drmModeModeInfo *mode = &fake_card.modes[number];
	int distance = abs(mode->hdisplay - options->width) +
		abs(mode->vdisplay - options->height);
	int slowness = 100 - (int)mode->vrefresh;
	bool cuts = mode->hdisplay < options->width ||
		mode->vdisplay < options->height;

	if (!options->size_given) {
		cuts = false;
		distance = slowness = 0;
	}
	return cuts * 1000000 + distance * 10000 +
		(mode->type & DRM_MODE_TYPE_PREFERRED ? 0 : 1000) +
		slowness * 8 + number;
}

/* Of these modes, 20x15 is nearest to 25x18, but would cut it. */
static void test_a_picture_is_shown_whole_if_a_mode_can(void **state)
{
	static const int modes[FAKE_CARD_MODES][2] = {
		{20, 15}, {40, 15}, {32, 24}};

	(void)state;
	for (int turn = 0; turn < 2; turn++) {
		struct scene scene = {0};
		/* 25x18 fits into one of them, 62x18 into none. */
		int width = turn == 0 ? 25 : 62;

		begin();
		for (int i = 0; i < FAKE_CARD_MODES; i++) {
			fake_card.modes[i] = (drmModeModeInfo){
				.hdisplay = (uint16_t)modes[i][0],
				.vdisplay = (uint16_t)modes[i][1],
				.vrefresh = 60};
		}
		scene.options.size_given = true;
		scene.options.width = width;
		scene.options.height = 18;
		assert_int_equal(scene_open(&scene), 0);
		assert_int_equal(
			fake_card.shown_mode.hdisplay, turn == 0 ? 32 : 40);
		assert_int_equal(log_capture_has(&scene.capture, LOG_WARNING,
					 "the screen has only 40x15"),
			turn == 1);
		scene_close(&scene);
	}
}

static void test_the_best_of_any_modes_is_set(void **state)
{
	uint32_t seed = 1;

	(void)state;
	for (int turn = 0; turn < 500; turn++) {
		struct scene scene = {0};
		struct display_options *options = &scene.options;
		int best = 0;

		begin();
		options->size_given = random_one_in(&seed, 2);
		options->width = random_between(&seed, 8, 12);
		options->height = random_between(&seed, 8, 12);
		for (int i = 0; i < FAKE_CARD_MODES; i++) {
			fake_card.modes[i] = (drmModeModeInfo){
				.hdisplay =
					(uint16_t)random_between(&seed, 9, 11),
				.vdisplay =
					(uint16_t)random_between(&seed, 9, 11),
				.vrefresh =
					(uint32_t)random_between(&seed, 59, 60),
				.flags = (uint32_t)i,
				.type = random_one_in(&seed, 2)
					? DRM_MODE_TYPE_PREFERRED
					: 0};
			best = penalty(i, options) < penalty(best, options)
				? i
				: best;
		}
		assert_int_equal(scene_open(&scene), 0);
		assert_int_equal(fake_card.shown_mode.flags, best);
		scene_close(&scene);
	}
}

/* The card's CRTCs are 52 and 51; encoders may be able to use either. */
static void test_a_crtc_of_any_encoders_is_used(void **state)
{
	static const uint32_t crtcs[] = {52, 51};
	uint32_t seed = 2;

	(void)state;
	for (int turn = 0; turn < 300; turn++) {
		struct scene scene = {0};
		uint32_t wanted = 0;
		int connected;

		begin();
		fake_card.encoder_count =
			random_between(&seed, 0, FAKE_CARD_ENCODERS);
		connected = random_between(&seed, 0, FAKE_CARD_ENCODERS - 1);
		fake_card.connected_encoder = connected;
		for (int i = 0; i < FAKE_CARD_ENCODERS; i++) {
			fake_card.encoders[i].crtc = random_one_in(&seed, 2)
				? 0
				: crtcs[random_between(&seed, 0, 1)];
			fake_card.encoders[i].possible =
				(uint32_t)random_between(&seed, 0, 7);
		}
		for (int i = fake_card.encoder_count - 1; i >= 0; i--) {
			uint32_t possible = fake_card.encoders[i].possible & 3;

			wanted = possible ? crtcs[possible == 2] : wanted;
		}
		if (connected < fake_card.encoder_count &&
			fake_card.encoders[connected].crtc) {
			wanted = fake_card.encoders[connected].crtc;
		}
		assert_int_equal(scene_open(&scene) == 0, wanted != 0);
		if (wanted) {
			assert_int_equal(fake_card.shown_crtc, wanted);
			scene_close(&scene);
		} else {
			assert_true(log_capture_has(
				&scene.capture, LOG_ERROR, "no CRTC"));
		}
	}
}

static void test_a_connector_that_cannot_tell_is_used_if_no_other_can(
	void **state)
{
	(void)state;
	for (int unsure = 0; unsure < 2; unsure++) {
		struct scene scene = {0};

		begin();
		fake_card.unsure = unsure;
		fake_card.two_connectors = !unsure;
		assert_true(card_is_available(&fake_card_calls));
		assert_int_equal(scene_open(&scene), 0);
		assert_int_equal(
			fake_card.shown_connectors[0], FAKE_CARD_CONNECTOR);
		assert_int_equal(fake_card.shown_mode.hdisplay, 20);
		scene_close(&scene);
	}
}

static void test_every_screen_is_listed_once(void **state)
{
	struct card card = {.calls = &fake_card_calls};
	drmModeResPtr resources;
	drmModeConnectorPtr connector;
	int at = 0, count = 0;

	(void)state;
	begin();
	fake_card.two_connectors = true;
	resources = fake_card_calls.get_resources(card.fd);
	assert_non_null(resources);
	while ((connector = card_next_screen(&card, resources, &at))) {
		assert_int_equal(connector->connection,
			count ? DRM_MODE_UNKNOWNCONNECTION : DRM_MODE_CONNECTED);
		fake_card_calls.free_connector(connector);
		count++;
	}
	assert_int_equal(count, 2);
	assert_null(card_next_screen(&card, resources, &at));
	fake_card_calls.free_resources(resources);
	assert_int_equal(fake_card.resource_count, 0);
}

static void test_a_note_says_how_pictures_are_shown(void **state)
{
	static const struct {
		enum fake_card_call fail;
		int fail_from;
		uint64_t preferred_depth;
		const char *words;
	} cases[] = {
		{CALL_NONE, 0, 16, "20x12, 16 bits, flipped"},
		{CALL_FLIP, 0, 16, "20x12, 16 bits, set"},
		{CALL_CREATE, 1, 16, "20x12, 16 bits, one buffer"},
		{CALL_NONE, 0, 0, "20x12, 32 bits, flipped"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct scene scene = {0};

		begin();
		fake_card.fail = cases[i].fail;
		fake_card.fail_from = cases[i].fail_from;
		fake_card.preferred_depth = cases[i].preferred_depth;
		assert_int_equal(scene_open(&scene), 0);
		assert_true(log_capture_has(
			&scene.capture, LOG_NOTE, cases[i].words));
		scene_close(&scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_picture_is_shown_whole_if_a_mode_can),
		cmocka_unit_test(test_the_best_of_any_modes_is_set),
		cmocka_unit_test(test_a_crtc_of_any_encoders_is_used),
		cmocka_unit_test(
			test_a_connector_that_cannot_tell_is_used_if_no_other_can),
		cmocka_unit_test(test_every_screen_is_listed_once),
		cmocka_unit_test(test_a_note_says_how_pictures_are_shown),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
