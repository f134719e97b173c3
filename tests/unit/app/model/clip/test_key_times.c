/* key_times.h: keys of equal time, in a model and alone. */
#include "app/anim/clip.h"
#include "app/model/clip/key_times.h"
#include "platform/base/compiler.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static void expect_separated(
	const float *times, int count, struct key_times expected)
{
	float time_s[8];
	struct key_times found;

	memcpy(time_s, times, (size_t)count * sizeof(*times));
	found = key_times_separate(time_s, count);
	assert_int_equal(found.wrong, 0);
	assert_int_equal(found.equal, expected.equal);
	assert_int_equal(found.first, expected.first);
	for (int i = found.first + 1; i < count; i++) {
		assert_true(time_s[i] > time_s[i - 1]);
		/* A float of this size has steps of 1.2e-7 of its value. */
		assert_near(time_s[i], times[i], 5e-7 * fabsf(times[i]));
	}
	assert_near(time_s[count - 1], times[count - 1], 0);
	/* Again they stay. */
	memcpy(time_s, times, (size_t)count * sizeof(*times));
	(void)key_times_separate(time_s, count);
	found = key_times_separate(time_s, count);
	assert_int_equal(found.first, expected.first);
}

static void test_separates_equal_times(void **state)
{
	const float beside = nextafterf(1, 0);

	(void)state;
	expect_separated((const float[]){7}, 1, (struct key_times){0});
	expect_separated((const float[]){0, 1, 2}, 3, (struct key_times){0});
	expect_separated(
		(const float[]){0, 1, 1, 2}, 4, (struct key_times){.equal = 1});
	expect_separated((const float[]){0.5f, 0.5f, 0.5f, 0.5f}, 4,
		(struct key_times){.equal = 3});
	expect_separated((const float[]){0, beside, 1, 1, 1}, 5,
		(struct key_times){.equal = 2});
	expect_separated(
		(const float[]){-1, -1, 1}, 3, (struct key_times){.equal = 1});
}

/* Floats just below 0 are denormal, and no clip begins before 0. */
static void test_leaves_out_what_ends_at_the_start(void **state)
{
	(void)state;
	expect_separated((const float[]){0, 0, 0, 1, 1, 2}, 6,
		(struct key_times){.equal = 3, .first = 2});
	expect_separated((const float[]){-1, -0.0f, 0, 1}, 4,
		(struct key_times){.equal = 1, .first = 2});
	expect_separated((const float[]){0, 1e-40f, 1e-40f, 1}, 4,
		(struct key_times){.equal = 1, .first = 2});
	expect_separated((const float[]){0, 0}, 2,
		(struct key_times){.equal = 1, .first = 1});
}

static void test_names_a_time_that_goes_back(void **state)
{
	float time_s[] = {0, 1, 1, 0.5f, 2};

	(void)state;
	assert_int_equal(key_times_separate(time_s, 5).wrong, 3);
	assert_near(time_s[1], 1, 0);
}

/* At the time of two keys the later one counts; until then the earlier one. */
static void test_a_clip_jumps_where_two_keys_have_one_time(void **state)
{
	static const struct {
		float time_s, x, cubic_x, scale;
	} moments[] = {
		{0, 0, 0, 1},
		{0.25f, 0.25f, 0.15625f, 1},
		{0.5f, 0.5f, 0.5f, 2},
		{0.9999f, 0.9999f, 1, 2},
		{1, 5, 5, 3},
		{1.5f, 5.5f, 5.5f, 3},
		{2, 6, 6, 3},
	};
	struct log_capture heard;
	struct model *model = model_fixture("gltf/clip/jump.gltf", &heard);
	struct arena arena = {0};
	struct clip_cursor cursor;
	struct pose pose;

	(void)state;
	assert_int_equal(heard.count, 1);
	assert_contains(heard.sentence[0],
		"/animations/0/samplers/0/input: 2 of 5 keys have the same time as the key before them");
	assert_int_equal(clip_cursor_init(&cursor, model, &arena), 0);
	assert_int_equal(pose_init(&pose, model, &arena), 0);
	for (size_t i = 0; i < ARRAY_COUNT(moments); i++) {
		clip_pose(&model->clip[0], moments[i].time_s, CLIP_AUTO,
			&cursor, &pose);
		assert_near(pose.local[0].translation[0], moments[i].x, 1e-5);
		assert_near(
			pose.local[1].translation[0], moments[i].cubic_x, 1e-5);
		assert_near(pose.local[1].scale[0], moments[i].scale, 0);
	}
	clip_pose(&model->clip[0], 0, CLIP_AUTO, &cursor, &pose);
	assert_near(pose.local[0].rotation[3], 1, 1e-6);
	arena_release(&arena);
	model_destroy(model);
}

/* Loads a clip of one channel with two key times, in base64. */
static int load_times(
	const char *times, struct log_capture *heard, struct model **model)
{
	char text[600];

	snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},'nodes':[{}],'buffers':[{'uri':"
		"'data:;base64,%s','byteLength':8}],"
		"'bufferViews':[{'buffer':0,'byteLength':8}],'accessors':[{"
		"'bufferView':0,'componentType':5126,'count':2,'type':"
		"'SCALAR'},{'componentType':5126,'count':2,'type':'VEC3'}],"
		"'animations':[{'samplers':[{'input':0,'output':1}],"
		"'channels':[{'sampler':0,'target':{'node':0,'path':"
		"'scale'}}]}]}",
		times);
	*model = NULL;
	return model_from_text(text, heard, model);
}

/* The times 1 and 0. */
static void test_refuses_a_time_that_goes_back(void **state)
{
	struct log_capture heard;
	struct model *model;

	(void)state;
	assert_int_equal(load_times("AACAPwAAAAA=", &heard, &model), -EINVAL);
	assert_contains(heard.sentence[0],
		"/animations/0/samplers/0/input: key 1 at 0 s is earlier than key 0 at 1 s");
}

/* The times -1 and 1, and 0 and 1. */
static void test_tells_of_keys_before_the_start(void **state)
{
	struct log_capture heard;
	struct model *model;

	(void)state;
	assert_int_equal(load_times("AACAvwAAgD8=", &heard, &model), 0);
	assert_int_equal(heard.count, 1);
	assert_contains(heard.sentence[0],
		"/animations/0/samplers/0/input: no player shows keys before 0 s, and the first is at -1 s: ");
	model_destroy(model);
	assert_int_equal(load_times("AAAAAAAAgD8=", &heard, &model), 0);
	assert_int_equal(heard.count, 0);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_separates_equal_times),
		cmocka_unit_test(test_leaves_out_what_ends_at_the_start),
		cmocka_unit_test(test_names_a_time_that_goes_back),
		cmocka_unit_test(test_a_clip_jumps_where_two_keys_have_one_time),
		cmocka_unit_test(test_refuses_a_time_that_goes_back),
		cmocka_unit_test(test_tells_of_keys_before_the_start),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
