/* What limber doctor counts in clips: kinds of keys, their times, what moves. */
#include "app/model/examine/examine.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	CLIPS = 3,
	CHANNELS = 4,
	NODES = 4
};

struct fixture {
	struct model_node node[NODES];
	struct model_channel channel[CLIPS][CHANNELS];
	struct model_clip clip[CLIPS];
	struct model model;
	char heard[3000]; /* the findings, each with a newline */
};

static const float from_start_to_end[] = {0, 0.5f, 1};
static const float still[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

static void keep(void *context, const char *finding)
{
	struct fixture *f = context;

	snprintf(f->heard + strlen(f->heard),
		sizeof(f->heard) - strlen(f->heard), "%s\n", finding);
}

/* One clip of a second that turns four nodes, of which there is nothing to say. */
static void begin(struct fixture *f)
{
	static const char *const names[] = {"stand", "walk", "run"};

	memset(f, 0, sizeof(*f));
	for (int n = 0; n < NODES; n++) {
		f->node[n] = (struct model_node){
			.name = "", .mesh = -1, .skin = -1, .parent = -1};
	}
	for (int c = 0; c < CLIPS; c++) {
		f->clip[c] = (struct model_clip){.name = names[c],
			.duration_s = 1,
			.channel_count = CHANNELS,
			.channel = f->channel[c]};
		for (int i = 0; i < CHANNELS; i++) {
			f->channel[c][i] = (struct model_channel){.node = i,
				.path = MODEL_ROTATION,
				.interpolation = MODEL_LINEAR,
				.width = 4,
				.key_count = 3,
				.time_s = from_start_to_end,
				.value = still};
		}
	}
	f->model = (struct model){.node_count = NODES,
		.node = f->node,
		.clip_count = 1,
		.clip = f->clip};
}

static void expect(struct fixture *f, const char *wanted)
{
	const struct examiner examiner = {keep, f};
	struct log log = log_to_stderr(LOG_WARNING);

	f->heard[0] = '\0';
	assert_int_equal(examine_clips(&f->model, &examiner, &log), 0);
	assert_string_equal(f->heard, wanted);
}

/* Only whether these words are among the findings. */
static bool finds(struct fixture *f, const char *words)
{
	const struct examiner examiner = {keep, f};
	struct log log = log_to_stderr(LOG_WARNING);

	f->heard[0] = '\0';
	assert_int_equal(examine_clips(&f->model, &examiner, &log), 0);
	return strstr(f->heard, words) != NULL;
}

static void test_a_plain_clip_has_no_findings(void **state)
{
	static const float shear[4][4] = {{0}};
	struct fixture f;

	(void)state;
	begin(&f);
	expect(&f, "");
	for (int n = 0; n < NODES; n++) {
		f.node[n].matrix = shear;
		f.model.node_count = n + 1;
		f.clip[0].channel_count = n + 1;
		assert_true(finds(&f, "nodes with a sheared matrix ("));
		assert_int_equal(
			strchr(f.heard, '(')[1] - '0', f.model.node_count);
	}
}

/* Each channel is counted, wherever it is in the list. */
static void test_cubic_channels_are_counted(void **state)
{
	static const float tangents[36] = {[4] = 1, [16] = 1, [28] = 1};

	(void)state;
	for (int i = 0; i < CHANNELS; i++) {
		struct fixture f;

		begin(&f);
		f.channel[0][i].interpolation = MODEL_CUBICSPLINE;
		f.channel[0][i].value = tangents;
		expect(&f,
			"clip stand: CUBICSPLINE channels (1): limber multiplies their tangents by the interval between keys, and normalises rotations afterwards\n");
		f.channel[0][(i + 1) % CHANNELS].interpolation =
			MODEL_CUBICSPLINE;
		f.channel[0][(i + 1) % CHANNELS].path = MODEL_WEIGHTS;
		f.channel[0][(i + 2) % CHANNELS].path = MODEL_WEIGHTS;
		expect(&f,
			"clip stand: CUBICSPLINE channels (2): limber multiplies their tangents by the interval between keys, and normalises rotations afterwards\n"
			"clip stand: cubic morph weights (1 channels): each key holds all in-tangents, then all values, then all out-tangents\n");
	}
}

static void test_single_keys_and_steps_are_counted(void **state)
{
	static const char single[] =
		"clip stand: channels with a single key (2): limber uses its value at every time\n";

	(void)state;
	for (int i = 0; i < CHANNELS; i++) {
		struct fixture f;
		struct model_channel *first = &f.channel[0][i],
				     *second = &f.channel[0][(i + 1) % CHANNELS];

		begin(&f);
		first->key_count = second->key_count = 1;
		expect(&f, single);
		first->interpolation = MODEL_STEP; /* of one key is none */
		expect(&f, single);
		first->key_count = second->key_count = 2;
		first->time_s = second->time_s = from_start_to_end + 1;
		second->interpolation = MODEL_STEP;
		assert_true(finds(&f,
			"clip stand: STEP channels (2) beside LINEAR ones: limber interpolates each channel in its own mode\n"));
	}
}

/* Linear channels of a single key, and cubic ones, are no linear ones. */
static void test_steps_alone_stand_beside_none(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.clip[0].channel_count = 3;
	f.channel[0][0].interpolation = MODEL_STEP;
	f.channel[0][1].key_count = 1;
	f.channel[0][2].interpolation = MODEL_CUBICSPLINE;
	f.channel[0][2].path = MODEL_SCALE;
	assert_true(finds(&f,
		"clip stand: STEP channels (1): limber interpolates each channel in its own mode\n"));
	f.channel[0][2].interpolation = MODEL_LINEAR;
	f.channel[0][2].key_count = 2;
	f.channel[0][2].time_s = from_start_to_end + 1;
	expect(&f,
		"clip stand: some first keys lie up to 0.5000 s after the start; limber holds the value of such a key until then\n"
		"clip stand: channels with a single key (1): limber uses its value at every time\n"
		"clip stand: STEP channels (1) beside LINEAR ones: limber interpolates each channel in its own mode\n");
}

static const char late[] =
	"clip stand: some first keys lie up to 0.5000 s after the start; limber holds the value of such a key until then\n";
static const char none_before[] =
	"clip stand: no key lies before 0.2500 s; limber holds the first pose until then, each time the clip begins again: export it from frame 0\n";
static const char none_moves[] =
	"clip stand: nothing moves before 0.2500 s; limber holds the first pose until then when the clip begins, but later rounds of a loop begin there\n";

/* The latest of first keys is told where others, or the lead, come before. */
static void test_first_keys_of_all_channels_are_compared(void **state)
{
	static const float early[] = {0.25f, 1}, middle[] = {0.5f, 1};

	(void)state;
	for (int i = 0; i < CHANNELS; i++) {
		struct fixture f;
		struct model_channel *last = &f.channel[0][i];
		char both[600];

		begin(&f);
		last->key_count = 2;
		last->time_s = middle;
		expect(&f, late);
		for (int k = 0; k < CHANNELS; k++) {
			f.channel[0][k].key_count = 2;
			f.channel[0][k].time_s = early;
		}
		expect(&f, none_before);
		last->time_s = middle;
		snprintf(both, sizeof(both), "%s%s", none_before, late);
		expect(&f, both);
		f.clip[0].lead_s = 0.25f;
		snprintf(both, sizeof(both), "%s%s", none_moves, late);
		expect(&f, both);
		last->time_s = early;
		expect(&f, none_moves);
		last->time_s = from_start_to_end; /* and never moves */
		last->key_count = 3;
		expect(&f, none_moves);
	}
}

/* A single key ends nothing, as it holds at each time. */
static void test_channels_that_end_early_are_told(void **state)
{
	static const float soon[] = {0, 0.75f};

	(void)state;
	for (int i = 0; i < CHANNELS; i++) {
		struct fixture f;

		begin(&f);
		f.channel[0][i].key_count = 2;
		expect(&f,
			"clip stand: some channels end at 0.5000 s of 1.0000 s; limber holds the value of their last key\n");
		f.channel[0][(i + 1) % CHANNELS].key_count = 2;
		f.channel[0][(i + 1) % CHANNELS].time_s = soon;
		assert_true(finds(&f, "some channels end at 0.5000 s"));
		f.channel[0][i].key_count = 1;
		assert_true(finds(&f, "some channels end at 0.7500 s"));
		f.channel[0][(i + 1) % CHANNELS].key_count = 1;
		assert_false(finds(&f, "some channels end"));
	}
}

static void test_a_clip_without_channels_has_no_findings(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.clip[0].channel_count = 0;
	expect(&f, "");
}

/* Of three keys the second and the third can each be turned the long way. */
static void test_long_arcs_of_all_keys_are_counted(void **state)
{
	static const float one[] = {0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, -1};
	static const float last[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1};
	static const float both[] = {0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, 1};
	static const float square[] = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
	static const float splines[36] = {[7] = 1, [19] = -1, [31] = 1};
	struct fixture f;

	(void)state;
	begin(&f);
	f.channel[0][0].value = square;
	expect(&f, "");
	f.channel[0][1].value = one;
	f.channel[0][2].value = both;
	f.channel[0][3].value = last;
	expect(&f,
		"clip stand: rotation keys with a negative dot product to the key before (4): limber negates them, so that the rotation takes the shorter arc\n");
	f.channel[0][1].path = f.channel[0][2].path = MODEL_TRANSLATION;
	assert_true(finds(&f, "to the key before (1): limber negates them"));
	for (int i = 0; i < 2; i++) {
		f.channel[0][i] = f.channel[0][3];
		f.channel[0][i].node = i;
		f.channel[0][i].interpolation = MODEL_CUBICSPLINE;
		f.channel[0][i].value = splines;
	}
	assert_true(finds(&f,
		"clip stand: rotation keys with a negative dot product to the key before (1): limber negates"));
	assert_true(finds(&f,
		"clip stand: CUBICSPLINE rotation keys with a negative dot product to the key before (4): limber follows the spline as glTF defines it, which turns the longer way there; if this is not meant, export sampled keys\n"));
}

#define UNSHARED(counts)                                                    \
	"channels of a node that another clip does not move (" counts       \
	"): when limber changes to that clip, the node returns to its rest" \
	" pose\n"

static void test_what_some_clips_alone_move_is_counted(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.model.clip_count = 3;
	expect(&f, "");
	f.clip[2].channel_count = 3; /* the last node stays, the others move */
	expect(&f, UNSHARED("2, in 3 clips"));
	f.clip[1].channel_count = 3;
	expect(&f, UNSHARED("1, in 3 clips"));
	f.channel[0][3] = f.channel[0][2]; /* twice: the clip counts once */
	expect(&f, "");
	f.channel[2][0].path = MODEL_SCALE; /* another path is another thing */
	expect(&f, UNSHARED("3, in 3 clips"));
	f.channel[0][0].path = f.channel[1][0].path = MODEL_WEIGHTS;
	expect(&f, UNSHARED("3, in 3 clips"));
	f.channel[2][0].path = MODEL_WEIGHTS;
	expect(&f, "");
}

/* Of the last node, too. */
static void test_each_path_that_some_clips_alone_move_counts(void **state)
{
	(void)state;
	for (int path = MODEL_TRANSLATION; path <= MODEL_WEIGHTS; path++) {
		struct fixture f;

		begin(&f);
		f.model.clip_count = 2;
		for (int c = 0; c < 2; c++) {
			f.channel[c][3].path = (enum model_path)path;
		}
		assert_false(finds(&f, "returns to its rest"));
		f.clip[1].channel_count = 3;
		assert_true(finds(&f, UNSHARED("1, in 2 clips")));
	}
}

/* Channels of one clip do not stand for those of another. */
static void test_a_clip_with_two_channels_counts_once(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.model.clip_count = 2;
	f.clip[0].channel_count = f.clip[1].channel_count = 2;
	f.channel[0][1].node = 0;
	f.channel[1][0].node = f.channel[1][1].node = 1;
	assert_true(finds(&f, UNSHARED("4, in 2 clips")));
}

static void test_clips_that_each_move_other_nodes_are_told(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.model.clip_count = 3;
	f.clip[0].channel_count = 1;
	f.clip[1].channel_count = 1;
	f.clip[2].channel_count = 1;
	f.channel[1][0].node = 1;
	f.channel[2][0].node = 2;
	expect(&f,
		UNSHARED("3, in 3 clips") "clips that each move nodes of their own (3 of 3), such as a clip for each object: limber plays one at a time; limber character suggests layers that play them together\n");
	f.channel[2][0].node = 1;
	assert_true(finds(&f, "nodes of their own (2 of 3)"));
	f.channel[1][0].node = f.channel[2][0].node = 0;
	expect(&f, "");
}

/* At 99 bytes, so that the finding itself is seen. */
static void test_a_long_name_is_cut(void **state)
{
	char name[120], wanted[200];
	struct fixture f;

	(void)state;
	memset(name, 'n', sizeof(name));
	name[sizeof(name) - 1] = '\0';
	begin(&f);
	f.clip[0].name = name;
	f.channel[0][0].key_count = 1;
	snprintf(wanted, sizeof(wanted), "clip %.99s: channels", name);
	assert_true(finds(&f, wanted));
}

static void test_findings_are_one_line_of_at_most_399_bytes(void **state)
{
	struct fixture f;
	const struct examiner examiner = {keep, &f};

	(void)state;
	begin(&f);
	examine_report(&examiner, "%0500d", 7);
	assert_int_equal(strlen(f.heard), 399 + 1);
	f.heard[0] = '\0';
	examine_report(&examiner, "%s\n%c", "two", '\x1b');
	assert_int_equal(strcspn(f.heard, "\n\x1b"), strlen(f.heard) - 1);
	f.heard[0] = '\0';
	examine_count(&examiner, 0, "none", "nothing");
	examine_count(&examiner, -1, "fewer", "nothing");
	assert_string_equal(f.heard, "");
	examine_count(&examiner, 1, "one", "something");
	assert_string_equal(f.heard, "one (1): something\n");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_plain_clip_has_no_findings),
		cmocka_unit_test(test_cubic_channels_are_counted),
		cmocka_unit_test(test_single_keys_and_steps_are_counted),
		cmocka_unit_test(test_steps_alone_stand_beside_none),
		cmocka_unit_test(test_first_keys_of_all_channels_are_compared),
		cmocka_unit_test(test_channels_that_end_early_are_told),
		cmocka_unit_test(test_a_clip_without_channels_has_no_findings),
		cmocka_unit_test(test_long_arcs_of_all_keys_are_counted),
		cmocka_unit_test(test_what_some_clips_alone_move_is_counted),
		cmocka_unit_test(
			test_each_path_that_some_clips_alone_move_counts),
		cmocka_unit_test(test_a_clip_with_two_channels_counts_once),
		cmocka_unit_test(test_clips_that_each_move_other_nodes_are_told),
		cmocka_unit_test(test_a_long_name_is_cut),
		cmocka_unit_test(test_findings_are_one_line_of_at_most_399_bytes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
