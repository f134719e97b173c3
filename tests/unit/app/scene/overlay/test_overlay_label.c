/* What the labels of overlays say: the same as rows that a test adds. */
#include "app/scene/hud/hud_group.h"
#include "app/scene/overlay/overlay.h"
#include "app/scene/overlay/overlay_curve.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

static struct hud shown, wanted;
static struct hud_group group;

static const struct hud_place place = {HUD_TOP_LEFT, 640};

/* Labels of these kinds, and a group with the wanted title. */
static void begin(const struct overlay *overlay,
	const struct overlay_motion *motion, const char *title)
{
	struct overlay copy = *overlay;
	struct hud *const both[] = {&shown, &wanted};

	for (int i = 0; i < 2; i++) {
		both[i]->font = &font_default;
		hud_begin(both[i], 480, 640);
	}
	overlay_label(&copy, motion, &place, &shown);
	group = hud_group_begin(&wanted, HUD_TOP_LEFT, title);
}

static void expect_wanted(void)
{
	hud_group_end(&group);
	assert_int_equal(shown.quad_count, wanted.quad_count);
	assert_memory_equal(shown.vertex, wanted.vertex,
		(size_t)shown.quad_count * 4 * sizeof(shown.vertex[0]));
}

static void test_overlays_without_rows_are_named(void **state)
{
	const struct overlay_motion motion = overlay_motion_none();
	const struct overlay none = {.kinds = 0};
	const struct overlay two = {
		.kinds = 1U << OVERLAY_SKELETON | 1U << OVERLAY_WIREFRAME};

	(void)state;
	begin(&two, &motion, NULL);
	hud_group_text(&group, "Skeleton, wireframe", "");
	expect_wanted();
	begin(&none, &motion, NULL);
	assert_int_equal(shown.quad_count, 0);
}

static void test_layers_have_their_weight_and_a_colour_for_masks(void **state)
{
	const struct overlay overlay = {.kinds = 1U << OVERLAY_LAYERS};
	const float mask[1] = {1.0f};
	struct overlay_motion motion = overlay_motion_none();

	(void)state;
	begin(&overlay, &motion, "Layers");
	hud_group_text(&group, "no layers", "");
	expect_wanted();
	motion.layer[0] = (struct overlay_layer){
		.name = "wave", .weight = 0.25f, .mask = mask};
	motion.layer[1] =
		(struct overlay_layer){.name = "breath", .weight = 1.0f};
	motion.layer_count = 2;
	begin(&overlay, &motion, "Layers");
	hud_group_weight(&group, "wave", 0.25f, hud_color_rose);
	hud_group_weight(&group, "breath", 1.0f, hud_color_green);
	expect_wanted();
}

static void test_a_curve_of_nothing_is_a_sentence(void **state)
{
	const struct overlay overlay = {
		.kinds = 1U << OVERLAY_SKELETON | 1U << OVERLAY_CURVE};
	const struct overlay_motion motion = overlay_motion_none();

	(void)state;
	begin(&overlay, &motion, "Skeleton, curve");
	hud_group_text(&group, "nothing moves", "");
	expect_wanted();
}

/* Of a clip the frames before and after, of a morph its ends. */
static void test_key_frames_have_two_colours(void **state)
{
	struct overlay overlay = {
		.kinds = 1U << OVERLAY_KEYS, .target_count = 2};
	struct overlay_motion motion = overlay_motion_none();

	(void)state;
	begin(&overlay, &motion, "Keys");
	hud_group_mark(&group, "before", "", hud_color_blue);
	hud_group_mark(&group, "after", "", hud_color_amber);
	expect_wanted();
	overlay.chooses_target = true;
	begin(&overlay, &motion, "Keys");
	hud_group_text(&group, "neutral, targets", "");
	expect_wanted();
	motion.morphing = true;
	/* They are in no picture of the row. */
	motion.from = motion.to = 12;
	begin(&overlay, &motion, "Keys");
	hud_group_mark(&group, "source", "", hud_color_blue);
	hud_group_mark(&group, "destiny", "", hud_color_amber);
	expect_wanted();
}

static void test_axes_have_their_colours(void **state)
{
	const struct overlay overlay = {
		.kinds = 1U << OVERLAY_PIVOTS | 1U << OVERLAY_LAYERS};
	const struct overlay_motion motion = overlay_motion_none();

	(void)state;
	begin(&overlay, &motion, "Pivots, layers");
	hud_group_mark(&group, "x", "", hud_color_rose);
	hud_group_mark(&group, "y", "", hud_color_green);
	hud_group_mark(&group, "z", "", hud_color_blue);
	hud_group_text(&group, "no layers", "");
	expect_wanted();
}

/* The graph is of the chosen node's rotation rather than of what else moves. */
static void test_the_curve_is_of_what_suits_it_best(void **state)
{
	static const int shown_of[] = {0, 0, 2, 3, 4}; /* the first channels */
	static const char *const words[][2] = {{"root", "position"}, {0},
		{"arm", "scale"}, {"arm", "position"}, {"arm", "rotation"}};
	static const float time_s[2] = {0, 1};
	float value[8] = {0, 0, 0, 1, 0, 0, 0, 1}, sample[4];
	struct model_channel channel[] = {
		{.node = 0, .path = MODEL_TRANSLATION, .width = 3},
		{.node = 0, .path = MODEL_WEIGHTS, .width = 1},
		{.node = 1, .path = MODEL_SCALE, .width = 3, .constant = true},
		{.node = 1, .path = MODEL_TRANSLATION, .width = 3},
		{.node = 1, .path = MODEL_ROTATION, .width = 4},
	};
	struct model_clip clip = {.duration_s = 1, .channel = channel};
	struct model_node node[] = {{.name = "root"}, {.name = "arm"}};
	struct model model = {
		.node_count = 2, .node = node, .clip_count = 1, .clip = &clip};
	struct instance instance = {.model = &model};
	const struct overlay overlay = {.kinds = 1U << OVERLAY_CURVE,
		.subject = {.instance = &instance},
		.sample = sample,
		.chosen = 1};
	struct overlay_motion motion = overlay_motion_none();

	(void)state;
	motion.clip = 0;
	for (size_t i = 0; i < ARRAY_COUNT(channel); i++) {
		const int best = shown_of[i];
		struct overlay_curve curve;

		channel[i].key_count = 2;
		channel[i].time_s = time_s;
		channel[i].value = value;
		clip.channel_count = (int)i + 1;
		begin(&overlay, &motion, "Curve");
		hud_group_text(&group, words[best][0], words[best][1]);
		curve = overlay_curve_of_channel(&clip, &channel[best], 0, 0,
			motion.interpolation, sample);
		overlay_curve_show(&curve, &group);
		expect_wanted();
	}
}

/* The least height with which an overlay's rows are shown; 0 for none. */
static int least_room(
	const struct overlay *overlay, const struct overlay_motion *motion)
{
	int without = 0;

	for (int room = 1; room < 400; room++) {
		const struct hud_place low = {HUD_TOP_LEFT, room};
		struct overlay copy = *overlay;

		shown.font = &font_default;
		hud_begin(&shown, 480, 640);
		overlay_label(&copy, motion, &low, &shown);
		without = room == 1 ? shown.quad_count : without;
		if (shown.quad_count > without) {
			return room;
		}
	}
	return 0;
}

/* The least height in which so many rows fit below the title. */
static int room_of_rows(const char *title, int rows)
{
	int room = 0;

	do {
		wanted.font = &font_default;
		hud_begin(&wanted, 480, 640);
		group = hud_group_begin(&wanted, HUD_TOP_LEFT, title);
		hud_group_limit(&group, ++room);
	} while (!hud_group_fits(&group, rows, 0));
	return room;
}

/* Not a part of them. */
static void test_rows_are_shown_where_all_of_them_fit(void **state)
{
	struct overlay keys = {.kinds = 1U << OVERLAY_KEYS, .target_count = 2};
	const struct overlay pivots = {.kinds = 1U << OVERLAY_PIVOTS};
	struct overlay_motion motion = overlay_motion_none();

	(void)state;
	assert_int_equal(least_room(&keys, &motion), room_of_rows("Keys", 2));
	keys.chooses_target = true;
	assert_int_equal(least_room(&keys, &motion), room_of_rows("Keys", 1));
	assert_int_equal(
		least_room(&pivots, &motion), room_of_rows("Pivots", 3));
}

static void test_a_morphs_curve_has_no_row_besides(void **state)
{
	const struct overlay curve = {.kinds = 1U << OVERLAY_CURVE};
	struct overlay_motion motion = overlay_motion_none();
	int room = 0;

	(void)state;
	motion.morphing = true;
	do {
		wanted.font = &font_default;
		hud_begin(&wanted, 480, 640);
		group = hud_group_begin(&wanted, HUD_TOP_LEFT, "Curve");
		hud_group_limit(&group, ++room);
	} while (!hud_group_fits(&group, 0, OVERLAY_CURVE_EMS * hud_em(&wanted)));
	assert_int_equal(least_room(&curve, &motion), room);
}

/* Then other labels give way. */
static void test_a_title_alone_is_told(void **state)
{
	const struct overlay pivots = {.kinds = 1U << OVERLAY_PIVOTS};
	const struct overlay_motion motion = overlay_motion_none();
	int least = room_of_rows("Pivots", 3);

	(void)state;
	for (int more = -1; more <= 0; more++) {
		const struct hud_place low = {HUD_TOP_LEFT, least + more};
		struct overlay copy = pivots;

		hud_begin(&shown, 480, 640);
		assert_int_equal(
			overlay_label(&copy, &motion, &low, &shown), more == 0);
	}
}

static void test_all_overlays_together_have_a_short_title(void **state)
{
	struct overlay all = {.kinds = (1U << OVERLAY_KINDS) - 1};
	const struct overlay_motion motion = overlay_motion_none();
	const struct hud_place low = {HUD_TOP_LEFT, 1};

	(void)state;
	for (int left_out = 0; left_out < 2; left_out++) {
		shown.font = wanted.font = &font_default;
		hud_begin(&shown, 480, 640);
		hud_begin(&wanted, 480, 640);
		assert_false(overlay_label(&all, &motion, &low, &shown));
		group = hud_group_begin(&wanted, HUD_TOP_LEFT,
			left_out ? "Skeleton, weights, keys, pivots, curve, layers"
				 : "All overlays");
		hud_group_limit(&group, low.room);
		expect_wanted();
		all.kinds &= ~(1U << OVERLAY_WIREFRAME);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_overlays_without_rows_are_named),
		cmocka_unit_test(
			test_layers_have_their_weight_and_a_colour_for_masks),
		cmocka_unit_test(test_a_curve_of_nothing_is_a_sentence),
		cmocka_unit_test(test_key_frames_have_two_colours),
		cmocka_unit_test(test_axes_have_their_colours),
		cmocka_unit_test(test_the_curve_is_of_what_suits_it_best),
		cmocka_unit_test(test_rows_are_shown_where_all_of_them_fit),
		cmocka_unit_test(test_a_morphs_curve_has_no_row_besides),
		cmocka_unit_test(test_a_title_alone_is_told),
		cmocka_unit_test(test_all_overlays_together_have_a_short_title),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
