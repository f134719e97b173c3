/* glTF animations: interpolations, number formats, durations. */
#include "app/model/model_loader.h"
#include "app/model/model_stats.h"
#include "platform/base/compiler.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <math.h>

static const struct model_channel *channel_of(
	const struct model *model, int clip, int channel)
{
	assert_true(clip < model->clip_count);
	assert_true(channel < model->clip[clip].channel_count);
	return &model->clip[clip].channel[channel];
}

/* A key holds both in-tangents, both values, both out-tangents. */
static void test_keeps_the_layout_of_cubic_weights(void **state)
{
	static const float expected[12] = {
		1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
	struct model *model = model_fixture("gltf/clip/cubic.gltf", NULL);
	const struct model_channel *channel = channel_of(model, 0, 0);

	(void)state;
	assert_int_equal(channel->path, MODEL_WEIGHTS);
	assert_int_equal(channel->interpolation, MODEL_CUBICSPLINE);
	assert_int_equal(channel->width, 2);
	assert_int_equal(channel->key_count, 2);
	assert_all_near(channel->value, expected, 12, 0);
	model_destroy(model);
}

/* Normalising the keys would change a spline; its result is normalised. */
static void test_leaves_cubic_rotations_as_they_are(void **state)
{
	struct model *model = model_fixture("gltf/clip/cubic.gltf", NULL);
	const struct model_channel *channel = channel_of(model, 0, 1);

	(void)state;
	assert_int_equal(channel->path, MODEL_ROTATION);
	assert_int_equal(channel->width, 4);
	assert_near(channel->value[4 + 3], 1, 0);
	assert_near(channel->value[8 + 2], 1, 0);
	assert_near(channel->value[16 + 2], 2, 0);
	model_destroy(model);
}

static void test_converts_signed_integer_rotations(void **state)
{
	static const float bytes[8] = {0, 0, 0, 1, 0, 0, -1, 0};
	static const float shorts[8] = {0, 0, 0, 1, 0, -1, 0, 0};
	struct model *model = model_fixture("gltf/clip/normalized.gltf", NULL);

	(void)state;
	assert_all_near(channel_of(model, 0, 0)->value, bytes, 8, 0);
	for (int k = 0; k < 2; k++) {
		float key[4];

		model_channel_key(channel_of(model, 0, 1), k, key);
		assert_all_near(key, shorts + 4 * k, 4, 0);
	}
	model_destroy(model);
}

/* Two keys as shorts, a quarter of a turn about z apart, and their interpolation. */
#define TURNING(keys, interpolation)                                        \
	"{'asset':{'version':'2.0'},'nodes':[{}],'buffers':[{'uri':"        \
	"'data:;base64,AAAAAAAAgD8" keys "','byteLength':24}],"             \
	"'bufferViews':[{'buffer':0,'byteLength':24}],'accessors':[{"       \
	"'bufferView':0,'componentType':5126,'count':2,'type':'SCALAR',"    \
	"'min':[0],'max':[1]},{'bufferView':0,'byteOffset':8,"              \
	"'componentType':5122,'normalized':true,'count':2,'type':'VEC4'}]," \
	"'animations':[{'samplers':[{'input':0,'output':1,"                 \
	"'interpolation':'" interpolation "'}],'channels':[{'sampler':0,"   \
	"'target':{'node':0,'path':'rotation'}}]}]}"

static struct model *load_turning(const char *text)
{
	struct log_capture logged;
	struct model *model;

	assert_int_equal(model_from_text(text, &logged, &model), 0);
	return model;
}

/* (0, 0, 0, 1) and (0, 0, -r, -r), where r is the root of one half. */
static void test_keeps_linear_rotations_as_shorts(void **state)
{
	static const int16_t packed[2][4] = {
		{0, 0, 0, 32767}, {0, 0, 23170, 23170}};
	static const float second[4] = {0, 0, 0.70710678f, 0.70710678f};
	static const char keys[] = TURNING("AAAAAAAD/fwAAAAB+pX6l", "LINEAR");
	struct model *model = load_turning(keys);
	const struct model_channel *channel = channel_of(model, 0, 0);
	struct model_stats stats;
	float key[4];

	(void)state;
	assert_null(channel->value);
	assert_true(channel->unit);
	assert_false(channel->constant);
	assert_memory_equal(channel->packed, packed, sizeof(packed));
	model_channel_key(channel, 1, key);
	assert_all_near(key, second, 4, 1e-7);
	model_measure(model, &stats);
	assert_int_equal(stats.clip_bytes, 2 * 4 + 2 * 8);
	model_destroy(model);
}

/* Only the loops over linear rotations of unit length know shorts. */
static void test_makes_floats_of_other_rotations_in_shorts(void **state)
{
	static const float second[4] = {0, 0, -0.70710678f, -0.70710678f};
	static const float longer[4] = {0, 0, 0.70710678f, 0.70710678f};
	/* (0, 0, 0, 1) and (0, 0, 0.5, 0.5) */
	static const char unlike[] = TURNING("AAAAAAAD/fwAAAAAAQABA", "LINEAR");
	struct model *model =
		load_turning(TURNING("AAAAAAAD/fwAAAAB+pX6l", "STEP"));

	(void)state;
	assert_null(channel_of(model, 0, 0)->packed);
	assert_all_near(channel_of(model, 0, 0)->value + 4, second, 4, 1e-7);
	model_destroy(model);
	model = load_turning(unlike);
	assert_null(channel_of(model, 0, 0)->packed);
	assert_all_near(channel_of(model, 0, 0)->value + 4, longer, 4, 1e-7);
	model_destroy(model);
}

static void test_converts_unsigned_integer_weights(void **state)
{
	static const float expected[4] = {0, 1, 0.2f, 0.4f};
	struct model *model = model_fixture("gltf/clip/normalized.gltf", NULL);
	int i;

	(void)state;
	for (i = 2; i < 4; i++) {
		assert_int_equal(channel_of(model, 0, i)->width, 2);
		assert_all_near(
			channel_of(model, 0, i)->value, expected, 4, 1e-7);
	}
	model_destroy(model);
}

static void test_normalises_integer_rotations(void **state)
{
	static const float expected[4] = {0, 0.6f, 0, 0.8f};
	struct log_capture logged;
	struct model *model;

	(void)state;
	/* One key at 0: (0, 3, 0, 4) as bytes that are not normalised. */
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'nodes':[{}],'buffers':[{"
			"'uri':'data:;base64,AAMABA==','byteLength':4}],"
			"'bufferViews':[{'buffer':0,'byteLength':4}],"
			"'accessors':[{'componentType':5126,'count':1,'type':"
			"'SCALAR'},{'bufferView':0,'componentType':5120,"
			"'count':1,'type':'VEC4'}],'animations':[{'samplers':"
			"[{'input':0,'output':1}],'channels':[{'sampler':0,"
			"'target':{'node':0,'path':'rotation'}}]}]}",
			&logged, &model),
		0);
	assert_all_near(channel_of(model, 0, 0)->value, expected, 4, 1e-7);
	model_destroy(model);
}

/* An animation without channels follows one that has some. */
static void test_reads_an_animation_without_channels(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'nodes':[{}],'accessors':["
			"{'componentType':5126,'count':1,'type':'SCALAR'},"
			"{'componentType':5126,'count':1,'type':'VEC3'}],"
			"'animations':[{'samplers':[{'input':0,'output':1}],"
			"'channels':[{'sampler':0,'target':{'node':0,'path':"
			"'translation'}},{'sampler':0,'target':{'node':0,"
			"'path':'scale'}}]},{'samplers':[],'channels':[]}]}",
			&logged, &model),
		0);
	assert_int_equal(model->clip_count, 2);
	assert_int_equal(model->clip[0].channel_count, 2);
	assert_int_equal(model->clip[1].channel_count, 0);
	assert_near(model->clip[1].duration_s, 0.0, 0.0);
	model_destroy(model);
}

#define ROTATING(bytes)                                                    \
	"{'asset':{'version':'2.0'},'nodes':[{}],'buffers':[{'uri':"       \
	"'data:;base64," bytes "','byteLength':16}],'bufferViews':[{"      \
	"'buffer':0,'byteLength':16}],'accessors':[{'componentType':5126," \
	"'count':1,'type':'SCALAR'},{'bufferView':0,'componentType':5126," \
	"'count':1,'type':'VEC4'}],'animations':[{'samplers':[{'input':0," \
	"'output':1}],'channels':[{'sampler':0,'target':{'node':0,'path':" \
	"'rotation'}}]}]}"

/* (0, 3, 0, 4), then (0, 0, 0, 1.001), as floats. */
static void test_normalises_float_rotations_far_from_unit_length(void **state)
{
	static const float far[4] = {0, 0.6f, 0, 0.8f};
	static const float near[4] = {0, 0, 0, 1.001f};
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(model_from_text(ROTATING("AAAAAAAAQEAAAAAAAACAQA=="),
				 &logged, &model),
		0);
	assert_all_near(channel_of(model, 0, 0)->value, far, 4, 1e-7);
	model_destroy(model);
	assert_int_equal(model_from_text(ROTATING("AAAAAAAAAAAAAAAAxSCAPw=="),
				 &logged, &model),
		0);
	assert_all_near(channel_of(model, 0, 0)->value, near, 4, 0);
	model_destroy(model);
}

static void test_reads_samplers_with_a_single_key(void **state)
{
	struct model *model = model_fixture("gltf/clip/single_key.gltf", NULL);
	int i;

	(void)state;
	for (i = 0; i < 3; i++) {
		assert_int_equal(channel_of(model, 0, i)->key_count, 1);
	}
	assert_int_equal(channel_of(model, 0, 0)->interpolation, MODEL_STEP);
	assert_int_equal(channel_of(model, 0, 1)->interpolation, MODEL_LINEAR);
	assert_int_equal(
		channel_of(model, 0, 2)->interpolation, MODEL_CUBICSPLINE);
	assert_near(channel_of(model, 0, 2)->value[3], 4, 0);
	model_destroy(model);
}

static void test_takes_the_last_key_as_the_duration(void **state)
{
	struct model *model = model_fixture("gltf/clip/single_key.gltf", NULL);
	struct model *late = model_fixture("gltf/clip/late_start.gltf", NULL);

	(void)state;
	assert_near(model->clip[0].duration_s, 1.25, 0);
	assert_near(late->clip[0].duration_s, 3, 0);
	assert_near(channel_of(late, 0, 0)->time_s[0], 0.5, 0);
	model_destroy(model);
	model_destroy(late);
}

static void test_reads_the_interpolation_of_each_channel(void **state)
{
	struct model *model = model_fixture("gltf/clip/late_start.gltf", NULL);

	(void)state;
	assert_int_equal(channel_of(model, 0, 0)->interpolation, MODEL_STEP);
	assert_int_equal(channel_of(model, 0, 1)->interpolation, MODEL_LINEAR);
	model_destroy(model);
}

static void test_skips_a_channel_without_a_node(void **state)
{
	struct model *model = model_fixture("gltf/clip/late_start.gltf", NULL);

	(void)state;
	assert_int_equal(model->clip_count, 2);
	assert_int_equal(model->clip[1].channel_count, 1);
	model_destroy(model);
}

static void test_shares_the_key_times_of_an_accessor(void **state)
{
	struct model *model = model_fixture("gltf/clip/late_start.gltf", NULL);

	(void)state;
	assert_ptr_equal(channel_of(model, 0, 0)->time_s,
		channel_of(model, 1, 0)->time_s);
	model_destroy(model);
}

static void test_finds_clips_by_name_or_number(void **state)
{
	struct model *model = model_fixture("gltf/clip/late_start.gltf", NULL);

	(void)state;
	assert_int_equal(model_find_clip(model, "late"), 0);
	assert_int_equal(model_find_clip(model, "other"), 1);
	assert_int_equal(model_find_clip(model, "1"), 1);
	assert_int_equal(model_find_clip(model, "01"), 1);
	assert_int_equal(model_find_clip(model, "2"), -1);
	assert_int_equal(model_find_clip(model, "-1"), -1);
	assert_int_equal(model_find_clip(model, "1x"), -1);
	assert_int_equal(model_find_clip(model, ""), -1);
	assert_int_equal(model_find_clip(model, " 1"), -1);
	assert_int_equal(model_find_clip(model, "99999999999999999999999"), -1);
	model_destroy(model);
}

static void test_prefers_a_clip_named_like_a_number(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text("{'asset':{'version':'2.0'},'animations':[{},"
				"{'name':'0'}]}",
			&logged, &model),
		0);
	assert_int_equal(model_find_clip(model, "0"), 1);
	assert_int_equal(model_find_clip(model, "1"), 1);
	assert_string_equal(model->clip[0].name, "");
	assert_int_equal(model->clip[0].channel_count, 0);
	assert_near(model->clip[0].duration_s, 0, 0);
	model_destroy(model);
}

static void test_marks_constant_channels(void **state)
{
	static const float time_s[2] = {0, 1}, again_s[2] = {0, 1};
	static const float moving[6] = {0, 0, 0, 2, 0, 0};
	static const float noisy[6] = {0.1f, 0.2f, 0.3f, 0.1f, 0.200003f, 0.3f};
	static const float tiny[6] = {0, 1e-5f, 0, 0, 0, 0};
	static const float invalid[6] = {1, 1, 1, 1, NAN, 1};
	static const float curve[18] = {0};
	struct model_channel channel[] = {
		{.value = moving},
		{.value = noisy},
		{.value = tiny},
		{.value = invalid, .path = MODEL_SCALE},
		{.value = curve, .interpolation = MODEL_CUBICSPLINE},
	};
	struct model_clip clip = {.channel_count = 5, .channel = channel};
	struct model model = {.clip_count = 1, .clip = &clip};

	(void)state;
	for (int i = 0; i < 5; i++) {
		channel[i].width = 3;
		channel[i].key_count = 2;
		channel[i].time_s = i % 2 ? again_s : time_s;
		channel[i].interpolation =
			i == 4 ? MODEL_CUBICSPLINE : MODEL_LINEAR;
	}
	model_prepare_clips(&model);
	assert_false(channel[0].constant);
	assert_true(channel[1].constant); /* small against the 2 of channel 0 */
	assert_false(channel[2].constant);
	assert_false(channel[3].constant);
	assert_false(channel[4].constant);
	for (int i = 0; i < 5; i++) {
		assert_ptr_equal(channel[i].time_s, time_s);
	}
}

static void test_keeps_one_key_of_constant_channels(void **state)
{
	static const float time_s[3] = {0, 1, 2};
	static const float still[9] = {1, 2, 3, 1, 2, 3, 1, 2.000001f, 3};
	static const float moved[9] = {1, 2, 3, 1, 2, 3, 1, 2.1f, 3};
	struct model_channel channel[2] = {
		{.width = 3, .key_count = 3, .time_s = time_s, .value = still},
		{.width = 3, .key_count = 3, .time_s = time_s, .value = moved},
	};
	struct model_clip clip = {.channel_count = 2, .channel = channel};
	struct arena arena = arena_empty(), keys[2] = {{0}, {0}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		channel[i].interpolation = MODEL_LINEAR;
		assert_non_null(arena_alloc(&keys[i], 1, 1));
	}
	assert_int_equal(model_keep_clip(&clip, keys, &arena), 0);
	assert_null(keys[0].newest);
	assert_null(keys[1].newest);
	assert_int_equal(channel[0].key_count, 1);
	assert_ptr_not_equal(channel[0].value, still);
	assert_all_near(channel[0].value, still, 3, 0);
	assert_int_equal(channel[1].key_count, 3);
	assert_all_near(channel[1].value, moved, 9, 0);
	arena_release(&arena);
}

static void test_marks_rotations_of_unit_length(void **state)
{
	static const float time_s[2] = {0, 1};
	static const float unit[8] = {0, 0.6f, 0, 0.8f, 0, 0, -1, 0};
	static const float rounded[8] = {0, 0, 0, 1, 0, 0, 0.707f, 0.707f};
	struct model_channel channel[3] = {
		{.path = MODEL_ROTATION, .value = unit},
		{.path = MODEL_ROTATION, .value = rounded},
		{.path = MODEL_WEIGHTS, .value = unit},
	};
	struct model_clip clip = {.channel_count = 3, .channel = channel};
	struct model model = {.clip_count = 1, .clip = &clip};

	(void)state;
	for (int i = 0; i < 3; i++) {
		channel[i].interpolation = MODEL_LINEAR;
		channel[i].width = 4;
		channel[i].key_count = 2;
		channel[i].time_s = time_s;
	}
	model_prepare_clips(&model);
	assert_true(channel[0].unit);
	assert_false(channel[1].unit);
	assert_false(channel[2].unit);
}

/* Lengths are 1 and so many steps of a float below or above 1. */
static void test_a_unit_length_is_right_to_a_millionth(void **state)
{
	static const float below = 0x1p-24f, above = 0x1p-23f;
	const struct {
		float key[4];
		bool unit;
	} cases[] = {
		{{0, 0, 0, 1 - 16 * below}, true},
		{{0, 0, 0, 1 - 17 * below}, false},
		{{0, 1 + 8 * above, 0, 0}, true},
		/* 8.5 steps */
		{{0, 1 + 8 * above, 0x1p-11f * 0.70710678f, 0}, false},
		{{1 + 9 * above, 0, 0, 0}, false},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		static const float time_s[1] = {0};
		struct model_channel channel = {.path = MODEL_ROTATION,
			.interpolation = MODEL_LINEAR,
			.width = 4,
			.key_count = 1,
			.time_s = time_s,
			.value = cases[i].key};
		struct model_clip clip = {
			.channel_count = 1, .channel = &channel};
		struct model model = {.clip_count = 1, .clip = &clip};

		model_prepare_clips(&model);
		assert_int_equal(channel.unit, cases[i].unit);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keeps_the_layout_of_cubic_weights),
		cmocka_unit_test(test_leaves_cubic_rotations_as_they_are),
		cmocka_unit_test(test_converts_signed_integer_rotations),
		cmocka_unit_test(test_keeps_linear_rotations_as_shorts),
		cmocka_unit_test(test_makes_floats_of_other_rotations_in_shorts),
		cmocka_unit_test(test_converts_unsigned_integer_weights),
		cmocka_unit_test(test_reads_an_animation_without_channels),
		cmocka_unit_test(test_normalises_integer_rotations),
		cmocka_unit_test(
			test_normalises_float_rotations_far_from_unit_length),
		cmocka_unit_test(test_reads_samplers_with_a_single_key),
		cmocka_unit_test(test_takes_the_last_key_as_the_duration),
		cmocka_unit_test(test_reads_the_interpolation_of_each_channel),
		cmocka_unit_test(test_skips_a_channel_without_a_node),
		cmocka_unit_test(test_shares_the_key_times_of_an_accessor),
		cmocka_unit_test(test_finds_clips_by_name_or_number),
		cmocka_unit_test(test_prefers_a_clip_named_like_a_number),
		cmocka_unit_test(test_marks_constant_channels),
		cmocka_unit_test(test_keeps_one_key_of_constant_channels),
		cmocka_unit_test(test_marks_rotations_of_unit_length),
		cmocka_unit_test(test_a_unit_length_is_right_to_a_millionth),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
