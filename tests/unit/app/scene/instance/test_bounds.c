/* The boxes around posed vertices, of clips and of what they carry away. */
#include "app/scene/instance/bounds.h"
#include "platform/base/compiler.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static void expect_box(
	const struct bounds *box, const float low[3], const float high[3])
{
	assert_all_near(box->low, low, 3, 1e-5);
	assert_all_near(box->high, high, 3, 1e-5);
}

static void test_a_box_holds_all_points_that_are_numbers(void **state)
{
	static const float points[][3] = {{1, 2, 3}, {-1, 5, NAN}, {9, NAN, 9},
		{NAN, 9, 9}, {0, -2, 4}, {INFINITY, -2, -4}};
	static const float low[3] = {0, -2, -4}, high[3] = {BOUNDS_MAX, 2, 4};
	struct bounds box = bounds_empty(), other = bounds_empty();

	(void)state;
	assert_true(bounds_is_empty(&box));
	for (size_t i = 0; i < ARRAY_COUNT(points); i++) {
		bounds_add(&box, points[i]);
	}
	assert_false(bounds_is_empty(&box));
	expect_box(&box, low, high);
	bounds_join(&box, &other);
	expect_box(&box, low, high);
	bounds_join(&other, &box);
	expect_box(&other, low, high);
	bounds_add(&other, (const float[3]){0, -INFINITY, 0});
	assert_near(other.low[1], -BOUNDS_MAX, 0.0);
}

static void test_an_empty_box_is_nowhere(void **state)
{
	const struct bounds box = bounds_empty();
	float center[3];

	(void)state;
	assert_near(bounds_extent(&box), 0.0, 0.0);
	assert_near(bounds_ground(&box), 0.0, 0.0);
	bounds_center(&box, center);
	assert_all_near(center, ((const float[]){0, 0, 0}), 3, 0.0);
}

static void test_a_box_without_a_width_is_not_empty(void **state)
{
	const struct bounds box = {{2, -1, 3}, {2, 5, 3}};
	float center[3];

	(void)state;
	assert_false(bounds_is_empty(&box));
	bounds_center(&box, center);
	assert_all_near(center, ((const float[]){2, 2, 3}), 3, 0.0);
	assert_near(bounds_ground(&box), -1, 0);
}

static void test_a_box_has_a_middle_and_a_longest_side(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		struct bounds box = {{1, -2, 3}, {2, -1, 4}};
		float center[3], wanted[3] = {1.5f, -1.5f, 3.5f};

		box.high[axis] += 6;
		wanted[axis] += 3;
		assert_near(bounds_extent(&box), 7.0, 0.0);
		bounds_center(&box, center);
		assert_all_near(center, wanted, 3, 0.0);
	}
}

/* A tenth of the extent is not flat. */
static void test_the_ground_lies_lower_below_a_flat_box(void **state)
{
	struct bounds box = {{-70, 0, 3}, {-6, 0, 13}};

	(void)state;
	assert_near(bounds_ground(&box), -0.064, 1e-6);
	box.high[1] = 6.375f;
	assert_near(bounds_ground(&box), -0.064, 1e-6);
	box.high[1] = 0.1f * 64;
	assert_near(bounds_ground(&box), 0, 0);
	box.high[1] = 9;
	assert_near(bounds_ground(&box), 0, 0);
	box.high[1] = 5;
	box.low[1] = 4;
	assert_near(bounds_ground(&box), 4 - 0.064, 1e-6);
}

static void test_a_box_in_its_place_is_shorter_where_the_figure_went(
	void **state)
{
	static const struct bounds around = {{-4, 0, -8}, {5, 1, 9}};
	static const struct {
		float way[2], low[3], high[3];
	} rows[] = {{{2, 3}, {-4, 0, -8}, {3, 1, 6}},
		{{-2, -3}, {-2, 0, -5}, {5, 1, 9}},
		{{2, -3}, {-4, 0, -5}, {3, 1, 9}},
		{{0.5f, -0.25f}, {-4, 0, -7.75f}, {4.5f, 1, 9}},
		{{0, 0}, {-4, 0, -8}, {5, 1, 9}}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct bounds box = around;

		bounds_stay(&box, rows[i].way);
		expect_box(&box, rows[i].low, rows[i].high);
	}
}

/* A square of size 1 that grows and goes away, from half a second on. */
struct walk {
	struct model_channel channel[2];
	struct model_clip clip;
	struct model *model;
	struct instance *instance;
};

static void walk_begin(struct walk *walk)
{
	static const float time_s[] = {0.5f, 1};
	static const float size[] = {1, 1, 1, 2, 3, 1};
	static const float place[] = {0, 0, 0, 4, 0, -6};
	const struct model_channel usual = {.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 2,
		.time_s = time_s};

	*walk = (struct walk){.model = small_model_grid(1, 1, 1.0f, true)};
	walk->channel[0] = walk->channel[1] = usual;
	walk->channel[0].path = MODEL_SCALE;
	walk->channel[0].value = size;
	walk->channel[1].path = MODEL_TRANSLATION;
	walk->channel[1].value = place;
	walk->clip = (struct model_clip){.name = "walk",
		.duration_s = 1,
		.lead_s = 0.5f,
		.channel_count = 2,
		.channel = walk->channel};
	walk->model->clip = &walk->clip;
	walk->model->clip_count = 1;
	walk->instance = small_model_instance(walk->model);
	assert_near(walk->instance->unit_scale, 1.0, 0.0);
}

static void walk_end(struct walk *walk)
{
	instance_destroy(walk->instance);
	model_destroy(walk->model);
}

static void test_the_box_of_a_clip_holds_its_way_unless_that_is_given(
	void **state)
{
	static const float way[1][2] = {{4, -6}};
	struct bounds box, rest;
	struct bounds_sides sides = {{9, 9, 9}};
	struct walk walk;

	(void)state;
	walk_begin(&walk);
	box = bounds_of_clip(walk.instance, 0);
	expect_box(&box, (const float[]){0, 0, -6}, (const float[]){6, 3, 0});
	/* Its first moment was the last one to be looked at. */
	assert_near(walk.instance->world[0][3][0], 0.0, 0.0);
	rest = bounds_of_model(walk.instance, way, &box, &sides);
	expect_box(&rest, (const float[]){0, 0, 0}, (const float[]){1, 1, 0});
	expect_box(&box, (const float[]){0, 0, 0}, (const float[]){2, 3, 0});
	assert_all_near(sides.side, ((const float[]){2, 3, 0}), 3, 1e-5);
	box = bounds_of_clip(walk.instance, -1);
	expect_box(&box, (const float[]){0, 0, 0}, (const float[]){1, 1, 0});
	walk_end(&walk);
}

/* Whether the caller holds normals and maps bumps stays as it is. */
static void test_a_look_at_clips_changes_no_setting(void **state)
{
	struct walk walk;

	(void)state;
	walk_begin(&walk);
	for (int i = 0; i < 4; i++) {
		walk.instance->hold_normals = i & 1;
		walk.instance->normal_mapping = i & 2;
		(void)bounds_of_clip(walk.instance, 0);
		assert_int_equal(walk.instance->hold_normals, i & 1);
		assert_int_equal(walk.instance->normal_mapping, i >> 1);
	}
	walk_end(&walk);
}

/* A clip that is up for a moment, so that one look in a second sees it. */
static const float blink_s[] = {0, 0.99f, 1.01f};
static const float blink_at[] = {0, 0, 0, 0, 5, 0, 0, 0, 0};
static struct model_channel blink = {.path = MODEL_TRANSLATION,
	.interpolation = MODEL_STEP,
	.width = 3,
	.key_count = 3,
	.time_s = blink_s,
	.value = blink_at};

/* Whether it is seen if the model has so many clips that last so long. */
static bool is_seen(int clips, int seconds)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_clip clip[64];
	struct bounds box[64];
	struct bounds_sides sides[64];
	const float way[64][2] = {{0}};
	struct instance *instance;

	for (int i = 0; i < clips; i++) {
		clip[i] = (struct model_clip){.name = "blink",
			.duration_s = (float)seconds,
			.channel_count = 1,
			.channel = &blink};
	}
	model->clip = clip;
	model->clip_count = clips;
	instance = small_model_instance(model);
	(void)bounds_of_model(instance, way, box, sides);
	for (int i = 0; i < clips; i++) {
		assert_near(box[i].high[1], box[0].high[1], 0.0);
	}
	instance_destroy(instance);
	model_destroy(model);
	return box[0].high[1] > 5.5f;
}

/* 104 moments of all clips, but 3 of each at least and 13 at most. */
static void test_many_clips_are_looked_at_more_coarsely(void **state)
{
	(void)state;
	for (int clips = 1; clips <= 40; clips++) {
		int steps = 12;

		while (steps > 2 && clips * (steps + 1) > 104) {
			steps--;
		}
		assert_true(is_seen(clips, steps));
		assert_false(is_seen(clips, steps + 1));
		assert_false(steps > 2 && is_seen(clips, steps - 1));
	}
}

static void test_a_clip_alone_is_looked_at_13_times(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);

	(void)state;
	for (int seconds = 11; seconds <= 13; seconds++) {
		struct model_clip clip = {.duration_s = (float)seconds,
			.channel_count = 1,
			.channel = &blink};
		struct bounds box;

		model->clip = &clip;
		model->clip_count = 1;
		box = bounds_of_clip(instance, 0);
		assert_near(box.high[1], seconds == 12 ? 6 : 1, 0.0);
	}
	instance_destroy(instance);
	model_destroy(model);
}

/* A triangle with so many targets, of which one doubles it. */
static struct model *load_targets(int count, int doubles)
{
	static char text[8192];
	struct log_capture heard;
	struct model *model;
	size_t at = 0;

	at += (size_t)snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],"
		"'nodes':[{'mesh':0}],'meshes':[{'primitives':[{'attributes':"
		"{'POSITION':0},'targets':[");
	for (int i = 0; i < count; i++) {
		at += (size_t)snprintf(text + at, sizeof(text) - at,
			"%s{'POSITION':%d}", i ? "," : "", i == doubles ? 0 : 1);
	}
	snprintf(text + at, sizeof(text) - at,
		"]}]}],'accessors':[{'bufferView':0,'componentType':5126,"
		"'count':3,'type':'VEC3','min':[0,0,0],'max':[1,1,0]},"
		"{'componentType':5126,'count':3,'type':'VEC3'}],"
		"'bufferViews':[{'buffer':0,'byteLength':36}],"
		"'buffers':[{'byteLength':36,'uri':'data:application/octet-"
		"stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA'}]}");
	assert_int_equal(model_from_text(text, &heard, &model), 0);
	return model;
}

static void test_the_box_of_targets_holds_the_first_104(void **state)
{
	static const struct {
		int count, doubles;
		float side;
	} rows[] = {{1, 0, 2}, {3, 0, 2}, {3, 2, 2}, {105, 103, 2},
		{105, 104, 1}, {3, -1, 1}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct model *model =
			load_targets(rows[i].count, rows[i].doubles);
		struct instance *instance = small_model_instance(model);
		float unit = instance->unit_scale, side = rows[i].side * unit;
		struct bounds box = bounds_of_targets(instance, 0);

		expect_box(&box, (const float[]){0, 0, 0},
			(const float[]){side, side, 0});
		box = bounds_of_instance(instance);
		assert_near(box.high[0], unit, 0.0);
		for (int t = 0; t < rows[i].count; t++) {
			assert_near(instance->pose.weight[t], 0.0, 0.0);
		}
		instance_destroy(instance);
		model_destroy(model);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_box_holds_all_points_that_are_numbers),
		cmocka_unit_test(test_an_empty_box_is_nowhere),
		cmocka_unit_test(test_a_box_without_a_width_is_not_empty),
		cmocka_unit_test(test_a_box_has_a_middle_and_a_longest_side),
		cmocka_unit_test(test_the_ground_lies_lower_below_a_flat_box),
		cmocka_unit_test(
			test_a_box_in_its_place_is_shorter_where_the_figure_went),
		cmocka_unit_test(
			test_the_box_of_a_clip_holds_its_way_unless_that_is_given),
		cmocka_unit_test(test_a_look_at_clips_changes_no_setting),
		cmocka_unit_test(test_many_clips_are_looked_at_more_coarsely),
		cmocka_unit_test(test_a_clip_alone_is_looked_at_13_times),
		cmocka_unit_test(test_the_box_of_targets_holds_the_first_104),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
