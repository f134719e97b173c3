/* What limber doctor says about the keys and names of clips. */
#include "app/model/examine/examine.h"
#include "app/model/model_loader.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static void append_finding(void *context, const char *finding)
{
	char *heard = context;
	size_t length = strlen(heard);

	snprintf(heard + length, 400 - length, "%s; ", finding);
}

/* Keeps the finding about long arcs; the others are let go. */
static void keep_long_arcs(void *context, const char *finding)
{
	if (strstr(finding, "negative dot product")) {
		append_finding(context, finding);
	}
}

/* Examines a clip of a second that moves one node. */
static const char *examine(const struct model_channel *moved,
	void (*keep)(void *context, const char *finding))
{
	static char heard[400];
	struct model_channel channel = *moved;
	struct model_clip clip = {.name = "go",
		.duration_s = 1,
		.channel_count = 1,
		.channel = &channel};
	struct model_node node = {.name = "arm", .mesh = -1, .skin = -1};
	struct model model = {
		.node_count = 1, .node = &node, .clip_count = 1, .clip = &clip};
	const struct examiner examiner = {keep, heard};
	struct log log = log_to_stderr(LOG_WARNING);

	heard[0] = '\0';
	model_prepare_clips(&model);
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	return heard;
}

/* Examines a clip that turns the node from the first key to the second. */
static const char *examine_keys(
	enum model_interpolation interpolation, float *value)
{
	static const float time_s[2] = {0, 1};

	return examine(&(struct model_channel){.path = MODEL_ROTATION,
			       .interpolation = interpolation,
			       .key_count = 2,
			       .width = 4,
			       .time_s = time_s,
			       .value = value},
		keep_long_arcs);
}

/* Each of the four numbers decides alone about the sign of the product. */
static void test_keys_that_take_the_longer_arc_are_counted(void **state)
{
	(void)state;
	for (int k = 0; k < 4; k++) {
		float same[8] = {0}, linear[8] = {0}, cubic[24] = {0};

		same[k] = same[4 + k] = 1;
		linear[k] = 1;
		linear[4 + k] = -1;
		cubic[4 + k] = 1;
		cubic[16 + k] = -1;
		assert_string_equal(examine_keys(MODEL_LINEAR, same), "");
		assert_contains(examine_keys(MODEL_LINEAR, linear), "(1)");
		assert_contains(examine_keys(MODEL_CUBICSPLINE, cubic), "(1)");
	}
}

static void test_only_linear_rotations_take_the_shorter_arc(void **state)
{
	static float keys[8] = {1, 0, 0, 0, -1};
	static float splines[24] = {[4] = 1, [16] = -1};

	(void)state;
	assert_string_equal(examine_keys(MODEL_STEP, keys), "");
	assert_contains(examine_keys(MODEL_LINEAR, keys), "the shorter arc");
	assert_contains(
		examine_keys(MODEL_CUBICSPLINE, splines), "the longer way");
}

/* Examines a clip that moves the node from first_s on. */
static const char *examine_start(float first_s)
{
	static const float value[6] = {0, 0, 0, 1, 0, 0};
	const float time_s[2] = {first_s, 1};

	return examine(&(struct model_channel){.path = MODEL_TRANSLATION,
			       .interpolation = MODEL_LINEAR,
			       .key_count = 2,
			       .width = 3,
			       .time_s = time_s,
			       .value = value},
		append_finding);
}

static void test_a_late_start_tells_what_a_loop_does(void **state)
{
	(void)state;
	assert_string_equal(examine_start(0), "");
	assert_string_equal(examine_start(0.0417f),
		"clip go: nothing moves before 0.0417 s; limber holds the first pose until then when the clip begins, but later rounds of a loop begin there; ");
	assert_string_equal(examine_start(0.5f),
		"clip go: no key lies before 0.5000 s; limber holds the first pose until then, each time the clip begins again: export it from frame 0; ");
}

static void keep_equal_names(void *context, const char *finding)
{
	if (strstr(finding, "name of an earlier clip")) {
		append_finding(context, finding);
	}
}

/* Clips without a name have none in common. */
static void test_clips_of_one_name_are_counted(void **state)
{
	struct model_clip clip[] = {{.name = "walk"}, {.name = "run"},
		{.name = "walk"}, {.name = ""}, {.name = "run"}, {.name = ""},
		{.name = "walk"}};
	struct model model = {.clip = clip};
	char heard[400] = "";
	const struct examiner examiner = {keep_equal_names, heard};
	struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	for (model.clip_count = 0; model.clip_count < 7; model.clip_count++) {
		heard[0] = '\0';
		assert_int_equal(examine_clips(&model, &examiner, &log), 0);
		assert_int_equal(heard[0] != '\0',
			model.clip_count > 2 /* the second walk */);
	}
	heard[0] = '\0';
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	assert_string_equal(heard,
		"clips with the name of an earlier clip (3): limber finds the earlier one by this name, and the others by their numbers, which limber info lists; ");
}

struct names {
	char name[8][20];
	int count;
};

/* Keeps how findings about late first keys begin. */
static void keep_start(void *context, const char *finding)
{
	struct names *heard = context;
	const char *end = strstr(finding, "no key lies before");

	if (end && heard->count < 8) {
		(void)snprintf(heard->name[heard->count++],
			sizeof(heard->name[0]), "%.*s", (int)(end - finding),
			finding);
	}
}

/* A name that two clips have, or none, does not tell which clip is meant. */
static void test_the_number_tells_clips_of_one_name_apart(void **state)
{
	static const float time_s[2] = {0.5f, 1}, value[6] = {0, 0, 0, 1};
	struct model_channel channel = {.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.key_count = 2,
		.width = 3,
		.time_s = time_s,
		.value = value};
	struct model_node node = {.name = "arm", .mesh = -1, .skin = -1};
	struct model_clip clip[] = {{.name = "walk"}, {.name = "run"},
		{.name = "walk"}, {.name = ""}};
	struct model model = {
		.node_count = 1, .node = &node, .clip_count = 4, .clip = clip};
	const struct log log = log_to_stderr(LOG_WARNING);
	static const char *const starts[] = {
		"clip 0, walk: ", "clip run: ", "clip 2, walk: ", "clip 3: "};
	struct names heard = {.count = 0};
	const struct examiner examiner = {keep_start, &heard};

	(void)state;
	for (int i = 0; i < 4; i++) {
		clip[i].duration_s = 1;
		clip[i].channel_count = 1;
		clip[i].channel = &channel;
	}
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	assert_int_equal(heard.count, 4);
	for (int i = 0; i < 4; i++) {
		assert_string_equal(heard.name[i], starts[i]);
	}
}

/* Programs that export a clip for each object would make as many lines. */
static void test_many_clips_with_the_same_finding_share_a_line(void **state)
{
	enum {
		CLIPS = 6
	};
	float time_s[] = {0, 1}, value[] = {0, 0, 0, 1, 0, 0};
	struct model_node node = {.name = "one"};
	struct model_channel channel = {.path = MODEL_TRANSLATION,
		.width = 3,
		.interpolation = MODEL_STEP,
		.key_count = 2,
		.time_s = time_s,
		.value = value};
	struct model_clip clip[CLIPS];
	struct model model = {.node_count = 1,
		.node = &node,
		.clip_count = CLIPS,
		.clip = clip};
	const struct log log = log_to_stderr(LOG_WARNING);
	char heard[1200] = "";
	const struct examiner examiner = {append_finding, heard};

	(void)state;
	for (int i = 0; i < CLIPS; i++) {
		clip[i] = (struct model_clip){.name = "",
			.duration_s = 1,
			.channel_count = i > 0,
			.channel = &channel};
	}
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	assert_non_null(
		strstr(heard, "5 clips, such as 1: STEP channels (1): "));
	assert_null(strstr(heard, "clip 2"));
	/* Four are few enough for lines of their own. */
	heard[0] = '\0';
	clip[1].channel_count = 0;
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	assert_null(strstr(heard, "clips, such as"));
	assert_non_null(strstr(heard, "clip 2: STEP channels (1): "));
	assert_non_null(strstr(heard, "clip 5: STEP channels (1): "));
}

static void keep_equal_nodes(void *context, const char *finding)
{
	if (strstr(finding, "name of an earlier node")) {
		append_finding(context, finding);
	}
}

/* Such as the bones of two figures; nodes without a name have none. */
static void test_nodes_of_one_name_are_counted(void **state)
{
	struct model_node node[] = {{.name = "hips"}, {.name = ""},
		{.name = "head"}, {.name = ""}, {.name = "hips"}};
	struct model model = {.node_count = 4, .node = node};
	char heard[400] = "";
	const struct examiner examiner = {keep_equal_nodes, heard};
	struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	assert_string_equal(heard, "");
	model.node_count = 5;
	assert_int_equal(examine_clips(&model, &examiner, &log), 0);
	assert_string_equal(heard,
		"nodes with the name of an earlier node (1): character files find the earlier one by this name; give the others names of their own if you refer to them; ");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keys_that_take_the_longer_arc_are_counted),
		cmocka_unit_test(test_only_linear_rotations_take_the_shorter_arc),
		cmocka_unit_test(test_a_late_start_tells_what_a_loop_does),
		cmocka_unit_test(test_clips_of_one_name_are_counted),
		cmocka_unit_test(test_the_number_tells_clips_of_one_name_apart),
		cmocka_unit_test(test_nodes_of_one_name_are_counted),
		cmocka_unit_test(
			test_many_clips_with_the_same_finding_share_a_line),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
