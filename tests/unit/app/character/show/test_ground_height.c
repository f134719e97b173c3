/* The height of the ground below clips that stand at several heights. */
#include "app/character/show/character_bounds.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <time.h>

/* The ground of clips of which those from `unplayed` on are not played. */
static float ground_of_played(
	float rest, const float *low, int count, int unplayed)
{
	struct bounds clip[4];
	bool is_played[4];
	float height[4];
	struct character_bounds bounds = {.clip = clip,
		.is_played = is_played,
		.height = height,
		.extent = 2.0f};

	bounds.rest = bounds.all =
		(struct bounds){{-1.0f, rest, -1.0f}, {1.0f, 2.0f, 1.0f}};
	for (int i = 0; i < count; i++) {
		clip[i] = bounds.rest;
		clip[i].low[1] = low[i];
		is_played[i] = i < unplayed;
	}
	return character_bounds_ground(&bounds, count);
}

static float ground_of(float rest, const float *low, int count)
{
	return ground_of_played(rest, low, count, count);
}

static void test_the_ground_is_where_most_clips_stand(void **state)
{
	(void)state;
	/* One of them falls, and sinks a little. */
	assert_near(ground_of(0, (float[]){0, 0.01f, -0.2f}, 3), 0, 0);
	assert_near(ground_of(0, (float[]){-0.2f, 0.01f}, 2), 0.01, 1e-6);
	/* One leaps, and none is on the ground at rest. */
	assert_near(ground_of(-1, (float[]){0.3f, 0, 0}, 3), 0, 0);
	/* A bird lands far below. */
	assert_near(ground_of(1.6f, (float[]){1.6f, 0.1f}, 2), 0.1, 1e-6);
	assert_near(ground_of(0.5f, NULL, 0), 0.5, 0);
}

/* Heights count as equal within 3% of the extent, which is 2. */
static void test_clips_that_stand_within_a_little_share_a_ground(void **state)
{
	(void)state;
	/* The rest pose supports one of two clips, while it is near. */
	assert_near(ground_of(0.15f, (float[]){0, 0.1f}, 2), 0.1f, 0);
	assert_near(ground_of(0.17f, (float[]){0, 0.1f}, 2), 0, 0);
	/* Two clips count more than one with the rest pose. */
	assert_near(ground_of(0, (float[]){0, 0.1f, 0.15f}, 3), 0.1f, 0);
	assert_near(ground_of(0, (float[]){0, 0.1f, 0.17f}, 3), 0, 0);
	/* Of the heights of as many clips, the lowest one. */
	assert_near(ground_of(1, (float[]){0.1f, 0.05f, 0.07f}, 3), 0.05f, 0);
	assert_near(ground_of(1, (float[]){0.05f, 0.1f, 0.07f}, 3), 0.05f, 0);
}

/* The ground may hide what is below it by 15% of the extent, which is 2. */
static void test_a_clip_far_below_the_others_is_not_hidden(void **state)
{
	(void)state;
	assert_near(ground_of(0, (float[]){0, 0, -0.29f}, 3), 0, 0);
	assert_near(ground_of(0, (float[]){0, 0, -0.31f}, 3), -0.31, 1e-6);
	assert_near(ground_of(0, (float[]){-0.31f, 0, 0}, 3), -0.31, 1e-6);
	assert_near(
		ground_of(-0.1f, (float[]){-0.31f, -0.1f, 0, 0}, 4), -0.1f, 0);
}

/* Else a figure that walks would hover, as the model has a clip that falls. */
static void test_a_clip_that_nothing_plays_does_not_count(void **state)
{
	(void)state;
	assert_near(ground_of_played(0, (float[]){0, 0, -5}, 3, 2), 0, 0);
	assert_near(ground_of_played(0, (float[]){0.1f, 0, 0}, 3, 1), 0.1f, 0);
	assert_near(ground_of_played(0.5f, (float[]){0, -5}, 2, 0), 0.5f, 0);
}

/* Below all that a model without clips takes; else the model at rest stands. */
static void test_without_played_clips_the_model_stands(void **state)
{
	struct bounds clip = {{-1, -3, -1}, {1, 2, 1}};
	bool is_played = false;
	float height;
	struct character_bounds bounds = {.clip = &clip,
		.is_played = &is_played,
		.height = &height,
		.extent = 2.0f,
		.rest = {{-1, 0.5f, -1}, {1, 2, 1}},
		.all = {{-1, -1.5f, -1}, {1, 2, 1}}};

	(void)state;
	assert_near(character_bounds_ground(&bounds, 0), -1.5, 0);
	assert_near(character_bounds_ground(&bounds, 1), 0.5, 0);
}

static void test_many_clips_take_a_moment(void **state)
{
	enum {
		MANY = 200000
	};
	struct bounds *clip = calloc(MANY, sizeof(*clip));
	bool *is_played = calloc(MANY, sizeof(*is_played));
	float *height = calloc(MANY, sizeof(*height));
	struct character_bounds bounds = {.clip = clip,
		.is_played = is_played,
		.height = height,
		.extent = 2.0f};
	double begun_s;

	(void)state;
	assert_non_null(clip);
	assert_non_null(is_played);
	assert_non_null(height);
	for (int i = 0; i < MANY; i++) {
		clip[i].low[1] = (float)(i * 7919L % MANY) / MANY;
		is_played[i] = true;
	}
	begun_s = (double)clock() / CLOCKS_PER_SEC;
	/* Most clips are near heights of 0.06 and more. */
	assert_near(character_bounds_ground(&bounds, MANY), 0.06f, 1e-3);
	/* Comparing each with each takes half a minute. */
	assert_true((double)clock() / CLOCKS_PER_SEC - begun_s < 5.0);
	free(clip);
	free(is_played);
	free(height);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_ground_is_where_most_clips_stand),
		cmocka_unit_test(
			test_clips_that_stand_within_a_little_share_a_ground),
		cmocka_unit_test(test_a_clip_far_below_the_others_is_not_hidden),
		cmocka_unit_test(test_a_clip_that_nothing_plays_does_not_count),
		cmocka_unit_test(test_without_played_clips_the_model_stands),
		cmocka_unit_test(test_many_clips_take_a_moment),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
