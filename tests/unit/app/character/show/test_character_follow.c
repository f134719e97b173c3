/* What the camera follows in clips that go far. */
#include "app/character/show/character_bounds.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <string.h>

/*
 * A triangle from 0 0 0 to 1 1 0 is the mesh of node 1, below node 0, which the
 * clip "leave" moves at 0, 1 and 2 s, and "climb" at 0 and 2 s.
 */
static const char model_path[] = "tests/fixtures/gltf/clip/far.gltf";

enum {
	LEAVE,
	CLIMB,
	CIRCLE,
	SWAY
};

static const float unit = 0.5f;                     /* scene units a metre */
static const double rate_hz = 50.0, begun_s = 0.02; /* the first frame */

static void load(struct acting *acting)
{
	acting_begin(acting, model_path);
	acting->instance->unit_scale = unit;
}

/* Replaces the places to which a clip moves its node. */
static void set_way(struct acting *acting, int clip, const float (*place)[3])
{
	const struct model_channel *channel = acting->model->clip[clip].channel;

	memcpy((float *)channel->value, place,
		(size_t)channel->key_count * sizeof(float[3]));
}

static void measure(struct acting *acting, struct character_bounds *bounds,
	const char *text)
{
	acting_expect(acting, text);
	memset(bounds, 0, sizeof(*bounds));
	assert_int_equal(character_bounds_init(bounds, acting->character), 0);
}

static void expect_box(const struct bounds *box, const float low[3],
	const float high[3], double tolerance)
{
	for (int axis = 0; axis < 3; axis++) {
		assert_near(box->low[axis], unit * low[axis], tolerance);
		assert_near(box->high[axis], unit * high[axis], tolerance);
	}
}

static void expect_side(
	const struct bounds *box, int axis, float low, float high)
{
	assert_near(box->low[axis], unit * low, 1e-5);
	assert_near(box->high[axis], unit * high, 1e-5);
}

static void expect_axes(
	const struct character_follow *follow, bool x, bool y, bool z)
{
	assert_int_equal(follow->axis[0], x);
	assert_int_equal(follow->axis[1], y);
	assert_int_equal(follow->axis[2], z);
	if (!x && !y && !z) {
		assert_int_equal(follow->node, -1);
	}
}

static const char plain_text[] = "[state a]\nclip = leave\n"
				 "[state b]\nclip = sway\n"
				 "[buttons]\nUP = go b\nDOWN = go a\n";

static void test_a_clip_is_followed_along_the_axes_on_which_it_goes_far(
	void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	measure(&acting, &bounds, plain_text);
	expect_axes(&bounds.follow[LEAVE], true, false, true);
	expect_axes(&bounds.follow[CLIMB], false, true, false);
	expect_axes(&bounds.follow[CIRCLE], true, false, true);
	expect_axes(&bounds.follow[SWAY], false, false, false);
	expect_box(&bounds.clip[SWAY], ((float[]){0, 0, 0}),
		((float[]){3, 1, 0}), 1e-6);
	acting_end(&acting);
}

/* Six times the longest side, which is 1. */
static void test_a_clip_that_goes_six_sides_is_not_followed(void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	set_way(&acting, LEAVE, (const float[3][3]){{0}, {2}, {4.9f}});
	set_way(&acting, CLIMB, (const float[2][3]){{0}, {5.1f}});
	measure(&acting, &bounds, plain_text);
	expect_axes(&bounds.follow[LEAVE], false, false, false);
	expect_axes(&bounds.follow[CLIMB], true, false, false);
	acting_end(&acting);
}

/* Twice as wide, it has to go twice as far. */
static void test_the_longest_side_counts_on_any_axis(void **state)
{
	static const float turned[2][4] = {
		{0, 0, 0, 1}, {0, 0.70710678f, 0, 0.70710678f}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct character_bounds bounds;
		struct acting acting;
		struct transform *rest;

		load(&acting);
		rest = &acting.model->node[1].rest;
		memcpy(rest->rotation, turned[i], sizeof(turned[i]));
		rest->scale[0] = 2.0f;
		set_way(&acting, LEAVE,
			(const float[3][3]){{0}, {0, 5}, {0, 10.9f}});
		set_way(&acting, CLIMB, (const float[2][3]){{0}, {0, 11.1f}});
		measure(&acting, &bounds, plain_text);
		expect_axes(&bounds.follow[LEAVE], false, false, false);
		expect_axes(&bounds.follow[CLIMB], false, true, false);
		acting_end(&acting);
	}
}

/* The model in the place of the rest pose, but as low as the clip goes. */
static void test_the_box_of_a_far_clip_is_that_of_the_model_at_rest(void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	set_way(&acting, CIRCLE,
		(const float[5][3]){{20, 5, 3}, {0, 5, 20}, {-20, 5, 0},
			{0, 5, -20}, {20, 5, 3}});
	set_way(&acting, CLIMB, (const float[2][3]){{3, -10, 2}, {3, 50, 2}});
	measure(&acting, &bounds, plain_text);
	expect_box(&bounds.clip[LEAVE], ((float[]){0, 0, 0}),
		((float[]){1, 1, 0}), 1e-5);
	expect_box(&bounds.clip[CLIMB], ((float[]){3, -10, 2}),
		((float[]){4, 1, 2}), 1e-5);
	expect_box(&bounds.clip[CIRCLE], ((float[]){0, 5, 0}),
		((float[]){1, 6, 0}), 1e-5);
	acting_end(&acting);
}

/* Node 0 goes far, and node 1 a little further. */
static void test_the_node_nearest_to_the_middle_is_followed(void **state)
{
	static const float times[2] = {0, 2};

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		float way[2][2][3] = {{{0}, {2, 2, 2}}, {{5, 4, 3}, {5, 4, 3}}};
		struct model_channel channel[2];
		struct character_bounds bounds;
		const struct character_follow *follow;
		struct acting acting;

		load(&acting);
		way[0][1][axis] = 40;
		way[1][1][axis] += 1.5f;
		for (int i = 0; i < 2; i++) {
			channel[i] = acting.model->clip[CLIMB].channel[0];
			channel[i].node = i;
			channel[i].time_s = times;
			channel[i].value = way[i][0];
		}
		acting.model->clip[CLIMB].channel = channel;
		acting.model->clip[CLIMB].channel_count = 2;
		measure(&acting, &bounds, plain_text);
		follow = &bounds.follow[CLIMB];
		expect_axes(follow, axis == 0, axis == 1, axis == 2);
		assert_int_equal(follow->node, 1);
		assert_all_near(follow->start,
			((float[]){unit * 5, unit * 4, unit * 3}), 3, 1e-6);
		assert_all_near(follow->offset,
			((float[]){unit * 0.5f, unit * 0.5f, 0}), 3, 1e-6);
		/* It is where the rest pose is, but as low as the clip goes. */
		expect_side(
			&bounds.clip[CLIMB], axis, axis == 1 ? 4 : 0, axis < 2);
		assert_near(
			follow->half[axis], axis < 2 ? unit * 0.5f : 0, 1e-5);
		acting_end(&acting);
	}
}

/* The last clip begins with the mesh away from its node. */
static void test_a_clip_is_followed_from_the_rest_pose(void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	acting.model->clip[SWAY].channel[0].node = 1;
	set_way(&acting, SWAY, (const float[3][3]){{2}, {0}, {2}});
	measure(&acting, &bounds, plain_text);
	assert_all_near(bounds.follow[LEAVE].offset,
		((float[]){unit * 0.5f, unit * 0.5f, 0}), 3, 1e-6);
	acting_end(&acting);
}

/* The middle of a triangle that grows moves away from its node. */
static void test_the_box_holds_what_moves_away_from_the_node(void **state)
{
	static const float times[2] = {0, 2}, far[2][3] = {{0}, {-40, 0, 0}},
			   scale[2][3] = {{1, 1, 1}, {3, 1, 1}};
	struct model_channel channel[2];
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	for (int i = 0; i < 2; i++) {
		channel[i] = acting.model->clip[CLIMB].channel[0];
		channel[i].time_s = times;
		channel[i].value = i == 0 ? far[0] : scale[0];
	}
	channel[1].path = MODEL_SCALE;
	acting.model->clip[CLIMB].channel = channel;
	acting.model->clip[CLIMB].channel_count = 2;
	measure(&acting, &bounds, plain_text);
	expect_axes(&bounds.follow[CLIMB], true, false, false);
	assert_int_equal(bounds.follow[CLIMB].node, 0);
	/* Half of 3, and 1 from 0.5 to 1.5. */
	assert_near(bounds.follow[CLIMB].half[0], unit * 2.5, 1e-5);
	expect_box(&bounds.clip[CLIMB], ((float[]){-2, 0, 0}),
		((float[]){3, 1, 0}), 1e-5);
	acting_end(&acting);
}

/* The travel of the root is taken out evenly; 1.4 of 40 are too little. */
static void test_a_walk_is_followed_if_little_of_its_way_is_left(void **state)
{
	static const float way[][3][3] = {{{0}, {17.6f}, {40}},
		{{0}, {0, 0, -17}, {0, 0, -40}}, {{0}, {-4}, {0}},
		{{0}, {18.6f}, {40}}};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct character_bounds bounds;
		struct acting acting;
		float place[3];

		load(&acting);
		set_way(&acting, LEAVE, way[i]);
		acting.model->node[0].name = "carrier";
		measure(&acting, &bounds,
			"[state a]\nclip = leave\n[motion]\nroot = carrier\n");
		expect_axes(&bounds.follow[LEAVE], i == 0, false, i == 1);
		acting_run_to(&acting, begun_s + 1.0, rate_hz);
		if (i < 2) {
			character_follow_way(
				&bounds.follow[LEAVE], acting.instance, place);
			assert_near(place[2 * i],
				i == 0 ? -2.4 * unit : 3 * unit, 0.05);
			assert_near(place[1], 0, 0);
			/* Its node stands for the middle at each moment. */
			assert_near(bounds.follow[LEAVE].half[2 * i],
				i == 0 ? 0.5 * unit : 0, 1e-4);
		}
		acting_end(&acting);
	}
}

/* The ground moves instead. */
static void test_an_even_walk_stays_in_its_place(void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	set_way(&acting, LEAVE,
		(const float[3][3]){{0}, {20, 0, -8}, {40, 0, -16}});
	set_way(&acting, CLIMB, (const float[2][3]){{0}, {-30, 0, 10}});
	set_way(&acting, SWAY, (const float[3][3]){{0}, {0, 0, 15}, {0, 0, 30}});
	acting.model->node[0].name = "carrier";
	measure(&acting, &bounds,
		"[state a]\nclip = leave\n[motion]\nroot = carrier\n");
	expect_axes(&bounds.follow[LEAVE], false, false, false);
	expect_axes(&bounds.follow[CLIMB], false, false, false);
	expect_axes(&bounds.follow[SWAY], false, false, false);
	expect_box(&bounds.clip[SWAY], ((float[]){0, 0, 0}),
		((float[]){1, 1, 0}), 1e-4);
	expect_box(&bounds.clip[LEAVE], ((float[]){0, 0, 0}),
		((float[]){1, 1, 0}), 1e-4);
	expect_box(&bounds.clip[CLIMB], ((float[]){0, 0, 0}),
		((float[]){1, 1, 0}), 1e-4);
	acting_end(&acting);
}

static const float *now(struct character_bounds *bounds,
	const struct acting *acting, const float low[3], const float high[3])
{
	static float moved[3];
	struct bounds box =
		character_bounds_now(bounds, acting->character, moved);

	expect_box(&box, low, high, 0.02);
	return moved;
}

/* How far it went since the call before, along the axes that are followed. */
static void test_the_box_goes_with_a_clip_that_goes_far(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	const float *moved;

	(void)state;
	load(&acting);
	set_way(&acting, LEAVE,
		(const float[3][3]){{4, 0, 2}, {24, 0.5f, -8}, {44, 1, -18}});
	measure(&acting, &bounds, plain_text);
	assert_int_equal(bounds.followed, -1);
	acting_run_to(&acting, begun_s + 0.5, rate_hz);
	moved = now(&bounds, &acting, ((float[]){14, 0, -3}),
		((float[]){15, 2, -3}));
	assert_all_near(moved, ((float[]){0, 0, 0}), 3, 0);
	assert_int_equal(bounds.followed, LEAVE);
	acting_run_to(&acting, begun_s + 1.0, rate_hz);
	moved = now(&bounds, &acting, ((float[]){24, 0, -8}),
		((float[]){25, 2, -8}));
	assert_all_near(moved, ((float[]){unit * 10, 0, unit * -5}), 3, 0.02);
	assert_all_near(
		bounds.way, ((float[]){unit * 20, 0, unit * -10}), 3, 0.02);
	acting_end(&acting);
}

/* The camera then eases to the place of the model. */
static void test_a_clip_that_stays_ends_the_following(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	const float *moved;

	(void)state;
	load(&acting);
	measure(&acting, &bounds, plain_text);
	acting_run_to(&acting, begun_s + 1.0, rate_hz);
	now(&bounds, &acting, ((float[]){8, 0, -4}), ((float[]){9, 1, -4}));
	acting_tap(&acting, BUTTON_UP, 0.5, rate_hz);
	moved = now(
		&bounds, &acting, ((float[]){0, 0, 0}), ((float[]){3, 1, 0}));
	assert_all_near(moved, ((float[]){0, 0, 0}), 3, 0);
	assert_int_equal(bounds.followed, -1);
	assert_all_near(bounds.way, ((float[]){0, 0, 0}), 3, 0);
	acting_tap(&acting, BUTTON_DOWN, 1.0 + begun_s, rate_hz);
	moved = now(
		&bounds, &acting, ((float[]){8, 0, -4}), ((float[]){9, 1, -4}));
	assert_all_near(moved, ((float[]){0, 0, 0}), 3, 0);
	acting_end(&acting);
}

/* A state of the rest pose and of a clip follows the clip. */
static void test_a_blend_with_a_far_clip_is_followed(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	float moved[3];

	(void)state;
	load(&acting);
	measure(&acting, &bounds,
		"[parameter v]\nstart = 1\n[state a]\n"
		"blend = v, rest 0, climb 1\n");
	acting_run_to(&acting, begun_s + 1.0, rate_hz);
	character_bounds_now(&bounds, acting.character, moved);
	assert_int_equal(bounds.followed, CLIMB);
	assert_near(bounds.way[1], unit * 30, 0.02);
	acting_end(&acting);
}

/* What only sways has no ground far below, for another clip, which sinks. */
static void test_only_clips_that_are_played_decide_about_the_ground(void **state)
{
	static const float sinks[][3] = {{0, 0, 0}, {0, -5, 0}};
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting);
	set_way(&acting, CLIMB, sinks);
	measure(&acting, &bounds, "[state a]\nclip = sway\n");
	assert_near(character_bounds_ground(&bounds, 4), 0, 0);
	measure(&acting, &bounds, "[state a]\nclip = rest\n");
	assert_near(character_bounds_ground(&bounds, 4), 0, 0);
	measure(&acting, &bounds,
		"[state a]\nclip = sway\n[state b]\nclip = climb\n");
	assert_near(character_bounds_ground(&bounds, 4), unit * -5, 1e-5);
	measure(&acting, &bounds,
		"[state a]\nclip = sway\n[layer b]\nclip = climb\n");
	assert_near(character_bounds_ground(&bounds, 4), unit * -5, 1e-5);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_clip_is_followed_along_the_axes_on_which_it_goes_far),
		cmocka_unit_test(test_a_clip_that_goes_six_sides_is_not_followed),
		cmocka_unit_test(test_the_longest_side_counts_on_any_axis),
		cmocka_unit_test(test_a_clip_is_followed_from_the_rest_pose),
		cmocka_unit_test(
			test_the_box_of_a_far_clip_is_that_of_the_model_at_rest),
		cmocka_unit_test(test_the_node_nearest_to_the_middle_is_followed),
		cmocka_unit_test(
			test_the_box_holds_what_moves_away_from_the_node),
		cmocka_unit_test(
			test_a_walk_is_followed_if_little_of_its_way_is_left),
		cmocka_unit_test(test_an_even_walk_stays_in_its_place),
		cmocka_unit_test(test_the_box_goes_with_a_clip_that_goes_far),
		cmocka_unit_test(test_a_clip_that_stays_ends_the_following),
		cmocka_unit_test(test_a_blend_with_a_far_clip_is_followed),
		cmocka_unit_test(
			test_only_clips_that_are_played_decide_about_the_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
