/* What each part of posing costs, as fitted (app/compare/figures.md). */
#include "app/anim/kernel/arm11_cost.h"
#include "app/compare/cost/board_cost.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static void expect_cost(
	struct board_cost cost, double cycles, double instructions)
{
	assert_near(cost.cycles, cycles, 1e-3);
	assert_near(cost.instructions, instructions, 1e-3);
}

static void test_nodes_joints_and_solid_drawables(void **state)
{
	(void)state;
	expect_cost(board_cost_matrices(0, 0, 0), 1000.0, 125.0);
	expect_cost(
		board_cost_matrices(3, 0, 0), 1000.0 + 3 * 413, 125.0 + 3 * 93);
	expect_cost(board_cost_matrices(3, 2, 0), 1000.0 + 3 * 413 - 2 * 120,
		125.0 + 3 * 93 - 2 * 21);
	expect_cost(
		board_cost_matrices(0, 0, 5), 1000.0 + 5 * 620, 125.0 + 5 * 54);
	expect_cost(board_cost_solid(4), 4 * 347.0, 4 * 54.0);
}

static void test_roots_are_nodes_without_a_parent(void **state)
{
	struct model_node node[5] = {{.parent = -1}, {.parent = 0},
		{.parent = -1}, {.parent = 1}, {.parent = -1}};
	struct model model = {.node_count = 4, .node = node};

	(void)state;
	assert_int_equal(board_cost_count_roots(&model), 2);
	model.node_count = 1;
	assert_int_equal(board_cost_count_roots(&model), 1);
	model.node_count = 0;
	assert_int_equal(board_cost_count_roots(&model), 0);
}

static void test_key_frames(void **state)
{
	(void)state;
	expect_cost(board_cost_keys(0, false, 0), 1000.0, 287.0);
	expect_cost(board_cost_keys(0, true, 9), 1000.0 + 9 * 25, 287 + 9 * 7.4);
	expect_cost(board_cost_keys(100, false, 0), 1000.0 + 1910 + 16 * 26,
		287 + 1110.0);
	expect_cost(board_cost_keys(100, true, 0), 1000.0 + 3820 + 2 * 16 * 26,
		287 + 2220.0);
	expect_cost(board_cost_sample_keys(0), 1315.0 + 75 + 653 + 60,
		120 + 7.1 + 82 + 9.2);
	expect_cost(board_cost_sample_keys(10), 1315.0 + 75 + 653 + 60 + 720,
		120 + 7.1 + 82 + 9.2 + 58);
}

static void test_weighted_targets(void **state)
{
	const struct arm11_cost *pair = &arm11_cost[ARM11_TARGETS_2];

	(void)state;
	expect_cost(board_cost_targets(&(struct board_targets){0}), 0, 0);
	expect_cost(board_cost_targets(&(struct board_targets){.copied = 10}),
		138, 16);
	expect_cost(board_cost_targets(&(struct board_targets){.paired = 10}),
		10 * (double)pair->cycles, 10 * (double)pair->instructions);
	expect_cost(board_cost_targets(&(struct board_targets){.begun = 10}),
		167, 82);
	expect_cost(board_cost_targets(&(struct board_targets){.added = 10}),
		178, 75);
	expect_cost(board_cost_targets(&(struct board_targets){.spans = 10}),
		1100, 313);
	expect_cost(board_cost_targets(&(struct board_targets){.visits = 10}),
		300, 120);
	expect_cost(board_cost_targets(&(struct board_targets){.searches = 10}),
		950, 160);
	expect_cost(board_cost_targets(&(struct board_targets){.steps = 10}),
		200, 130);
	expect_cost(board_cost_targets(&(struct board_targets){.pieces = 10}),
		620, 353);
	expect_cost(board_cost_targets(&(struct board_targets){.weights = 10}),
		1350, 335);
	expect_cost(board_cost_targets(&(struct board_targets){.rebased = 10}),
		400, 140);
}

static void test_shadows_that_are_laid_on_hills(void **state)
{
	(void)state;
	expect_cost(board_cost_lay(0.0, 0.0), 0.0, 0.0);
	expect_cost(board_cost_lay(100.0, 0.0), 97000.0, 45500.0);
	expect_cost(board_cost_lay(0.0, 10.0), 6400.0, 2400.0);
}

/* The cost of a vertex of that many influences, of as many joints. */
static void expect_vertex(
	int influences, bool normals, double cycles, double instructions)
{
	float position[1][3] = {{0}}, weight[8] = {0};
	uint16_t joint[8] = {65535, 3, 8, 1, 9, 0, 7, 5};
	const struct model_primitive primitive = {.vertex_count = 1,
		.position = position,
		.normal = normals ? position : NULL,
		.influences = 8,
		.joint = joint,
		.weight = weight};

	for (int i = 0; i < influences; i++) {
		weight[i] = 1.0f / (float)influences;
	}
	expect_cost(board_cost_skin(&primitive, 0), influences * 270 + cycles,
		influences * 250 + instructions);
}

/* So many times one row of the table, and so many times another. */
static void expect_rows(int influences, bool normals, enum arm11_work a,
	double a_share, enum arm11_work b, double b_share)
{
	expect_vertex(influences, normals,
		a_share * (double)arm11_cost[a].cycles +
			b_share * (double)arm11_cost[b].cycles,
		a_share * (double)arm11_cost[a].instructions +
			b_share * (double)arm11_cost[b].instructions);
}

static void test_vertices_of_a_skin_by_their_influences(void **state)
{
	static const enum arm11_work plain[] = {
		ARM11_SKIN_1, ARM11_SKIN_2, ARM11_SKIN_3, ARM11_SKIN_4};

	(void)state;
	for (int i = 1; i <= 4; i++) {
		expect_rows(i, false, plain[i - 1], 1, ARM11_SKIN_1, 0);
	}
	expect_rows(5, false, ARM11_SKIN_4, 0.75, ARM11_SKIN_8, 0.25);
	expect_rows(7, false, ARM11_SKIN_4, 0.25, ARM11_SKIN_8, 0.75);
	expect_rows(8, false, ARM11_SKIN_8, 1, ARM11_SKIN_1, 0);
	expect_rows(1, true, ARM11_SKIN_NORMALS_1, 1, ARM11_SKIN_1, 0);
	expect_rows(2, true, ARM11_SKIN_NORMALS_2, 1, ARM11_SKIN_1, 0);
	expect_rows(
		3, true, ARM11_SKIN_NORMALS_2, 0.5, ARM11_SKIN_NORMALS_4, 0.5);
	expect_rows(4, true, ARM11_SKIN_NORMALS_4, 1, ARM11_SKIN_1, 0);
	expect_rows(
		6, true, ARM11_SKIN_NORMALS_4, 0.5, ARM11_SKIN_NORMALS_8, 0.5);
	expect_rows(8, true, ARM11_SKIN_NORMALS_8, 1, ARM11_SKIN_1, 0);
}

/* Loops take the eight heaviest influences, so that more cost no more. */
static void test_no_more_than_eight_influences_cost(void **state)
{
	float position[1][3] = {{0}}, weight[12];
	uint16_t joint[12] = {0};
	const struct model_primitive primitive = {.vertex_count = 1,
		.position = position,
		.influences = 12,
		.joint = joint,
		.weight = weight};

	(void)state;
	for (int i = 0; i < 12; i++) {
		weight[i] = 1.0f / 12.0f;
	}
	expect_cost(board_cost_skin(&primitive, 0),
		270 + (double)arm11_cost[ARM11_SKIN_8].cycles,
		250 + (double)arm11_cost[ARM11_SKIN_8].instructions);
}

/* A joint counts once, and a vertex without weights has one influence. */
static void test_joints_count_once(void **state)
{
	float position[3][3] = {{0}}, weight[12] = {1, 0, 0, 0, 0.5f, 0.5f};
	uint16_t joint[12] = {8, 0, 0, 0, 8, 16};
	const struct model_primitive primitive = {.vertex_count = 3,
		.position = position,
		.influences = 4,
		.joint = joint,
		.weight = weight};

	(void)state;
	expect_cost(board_cost_skin(&primitive, 0),
		2 * 270 + 2 * (double)arm11_cost[ARM11_SKIN_1].cycles +
			(double)arm11_cost[ARM11_SKIN_2].cycles,
		2 * 250 + 2 * (double)arm11_cost[ARM11_SKIN_1].instructions +
			(double)arm11_cost[ARM11_SKIN_2].instructions);
}

static void expect_sample(const struct model_channel *channel, int count,
	double cycles, double instructions)
{
	struct model_channel channels[4];
	const struct model_clip clip = {
		.channel_count = count, .channel = channels};

	memcpy(channels, channel, (size_t)count * sizeof(*channel));
	expect_cost(
		board_cost_sample(&clip, 0), 1315 + cycles, 120 + instructions);
	expect_cost(board_cost_sample(&clip, 10), 1315 + 750 + cycles,
		120 + 71 + instructions);
}

static const float some_times[3] = {0, 1, 4}, other_times[3] = {0, 1, 4};
static const float value[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

static void test_channels_that_move_have_times_once(void **state)
{
	const struct model_channel moved = {.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 3,
		.time_s = some_times,
		.value = value};
	struct model_channel channel[3] = {moved, moved, moved};

	(void)state;
	expect_sample(channel, 0, 0, 0);
	expect_sample(channel, 1, 653 + 60, 82 + 9.2);
	expect_sample(channel, 3, 3 * 653 + 60, 3 * 82 + 9.2);
	channel[1].time_s = other_times;
	expect_sample(channel, 3, 3 * 653 + 2 * 60, 3 * 82 + 2 * 9.2);
	channel[2].path = MODEL_WEIGHTS;
	expect_sample(channel, 3, 3 * 653 + 2 * 60 + 3 * 72,
		3 * 82 + 2 * 9.2 + 3 * 5.8);
	/* What does not move costs nothing, and others have its times. */
	channel[0].constant = true;
	expect_sample(channel, 3, 2 * 653 + 2 * 60 + 3 * 72,
		2 * 82 + 2 * 9.2 + 3 * 5.8);
}

enum {
	MANY = 150000
};

struct many {
	struct model_channel channel[MANY];
	float time_s[MANY];
};

/* That many channels, each with key times of its own. */
static struct many *make_many(void)
{
	struct many *many = calloc(1, sizeof(*many));

	assert_non_null(many);
	for (int i = 0; i < MANY; i++) {
		many->channel[i] = (struct model_channel){.path = MODEL_ROTATION,
			.interpolation = MODEL_LINEAR,
			.unit = i % 3 == 0,
			.width = 4,
			.key_count = 1,
			.time_s = &many->time_s[i],
			.value = value};
	}
	return many;
}

/* So many turns and other channels, of which so many have their own times. */
static void expect_times(const struct many *many, int count, int turns,
	int turn_times, int others, int times)
{
	const struct model_clip clip = {.channel_count = count,
		.channel = (struct model_channel *)many->channel};

	expect_cost(board_cost_sample(&clip, 0),
		1315 + turns * 344 + turn_times * 121 + others * (653 + 300) +
			times * 60,
		120 + turns * 35.4 + turn_times * 12.4 + others * (82 + 100) +
			times * 9.2);
}

/* Comparing each channel with each takes several seconds. */
static void test_many_channels_with_their_own_times_are_counted_quickly(
	void **state)
{
	struct many *many = make_many();
	clock_t began = clock();

	(void)state;
	expect_times(many, MANY, MANY / 3, MANY / 3, MANY / 3 * 2, MANY / 3 * 2);
	assert_true(clock() - began < 2 * CLOCKS_PER_SEC);
	free(many);
}

/* Times belong to the first channel that has them and moves, however far. */
static void test_many_channels_share_the_times_of_the_first_that_moves(
	void **state)
{
	static const int counts[] = {1, 2, 1023, 1024, 1025, 2048, 2049, 3000};
	struct many *many = make_many();

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(counts); i++) {
		int count = counts[i], turns = (count + 2) / 3;

		expect_times(many, count, turns, turns, count - turns,
			count - turns);
	}
	/* The last of 3000 has those of the first, and others' are too. */
	many->channel[2999].time_s = many->time_s;
	expect_times(many, 3000, 1000, 1000, 2000, 1999);
	many->channel[1500].time_s = many->time_s;
	expect_times(many, 3000, 1000, 999, 2000, 1999);
	many->channel[1].time_s = many->time_s;
	expect_times(many, 3000, 1000, 999, 2000, 1998);
	many->channel[0].constant = true;
	expect_times(many, 3000, 999, 998, 2000, 1999);
	many->channel[1].constant = true;
	expect_times(many, 3000, 999, 999, 1999, 1998);
	many->channel[1500].constant = true;
	expect_times(many, 3000, 998, 998, 1999, 1999);
	for (int i = 0; i < 3000; i++) {
		many->channel[i].constant = false;
		many->channel[i].time_s = &many->time_s[i % 1500];
	}
	expect_times(many, 3000, 1000, 500, 2000, 1000);
	free(many);
}

/*
 * Turns by more than 38 degrees need sines while they last, and those by more
 * than 14 another term. The sines' constants are read once a frame.
 */
static void test_turns_cost_by_how_far_they_are(void **state)
{
	/* Half of each angle: none, 90, 17.9 and 19.2 degrees. */
	static const float keys[4][12] = {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1},
		{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0},
		{0, 0, 0, 1, 0.307f, 0, 0, 0.9517f, 0.307f, 0, 0, 0.9517f},
		{0, 0, 0, 1, 0.329f, 0, 0, 0.9443f, 0.329f, 0, 0, 0.9443f}};
	static const float long_keys[12] = {
		0, 0, 0, 2, 0, 0, 0, 0.5f, 0, 0, 0, -3};
	/* 19.2 degrees, as of the fourth keys. */
	static const float long_turn[12] = {0, 0, 0, 2, 3 * 0.329f, 0, 0,
		3 * 0.9443f, 0.329f, 0, 0, 0.9443f};
	static const double wide[4] = {0, 0.75, 0, 0.25};
	static const double middle[4] = {0, 0, 0.25, 0};
	struct model_channel four[4];
	struct model_clip clip = {.channel_count = 4, .channel = four};
	struct model_channel channel = {.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.unit = true,
		.width = 4,
		.key_count = 3,
		.time_s = some_times};

	(void)state;
	for (int i = 0; i < 4; i++) {
		channel.value = keys[i];
		expect_sample(&channel, 1,
			344 + 121 + (1150 + 480) * wide[i] + 40 * middle[i],
			35.4 + 12.4 + 203 * wide[i] + 11.5 * middle[i]);
	}
	channel.value = keys[1];
	for (int i = 0; i < 4; i++) {
		four[i] = channel;
	}
	expect_cost(board_cost_sample(&clip, 0),
		1315 + 4 * 344 + 121 + 1150 + 480 * 3,
		120 + 4 * 35.4 + 12.4 + 203 * 3);
	channel.key_count = 1;
	expect_sample(&channel, 1, 344 + 121, 35.4 + 12.4);
	/* Only linear rotations of unit length are turns. */
	channel.interpolation = MODEL_STEP;
	expect_sample(&channel, 1, 653 + 60, 82 + 9.2);
	channel.interpolation = MODEL_LINEAR;
	channel.unit = false;
	channel.key_count = 3;
	for (int i = 0; i < 4; i++) {
		channel.value = keys[i];
		expect_sample(&channel, 1, 653 + 60 + 300 + 950 * wide[i],
			82 + 9.2 + 100 + 145 * wide[i]);
	}
	/* Their length does not tell how far apart they are. */
	channel.value = long_keys;
	expect_sample(&channel, 1, 653 + 60 + 300, 82 + 9.2 + 100);
	channel.value = long_turn;
	expect_sample(&channel, 1, 653 + 60 + 300 + 950 * 0.25,
		82 + 9.2 + 100 + 145 * 0.25);
}

static void test_a_frame_is_the_sum_of_its_steps(void **state)
{
	const struct board_frame frame = {.sample = {1, 20},
		.matrices = {2, 30},
		.vertices = {4, 50},
		.draw = {8, 70}};

	(void)state;
	expect_cost(board_frame_posing(&frame), 7, 100);
	expect_cost(board_frame_sum(&frame), 15, 170);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_nodes_joints_and_solid_drawables),
		cmocka_unit_test(test_roots_are_nodes_without_a_parent),
		cmocka_unit_test(test_key_frames),
		cmocka_unit_test(test_weighted_targets),
		cmocka_unit_test(test_shadows_that_are_laid_on_hills),
		cmocka_unit_test(test_vertices_of_a_skin_by_their_influences),
		cmocka_unit_test(test_no_more_than_eight_influences_cost),
		cmocka_unit_test(test_joints_count_once),
		cmocka_unit_test(test_channels_that_move_have_times_once),
		cmocka_unit_test(
			test_many_channels_with_their_own_times_are_counted_quickly),
		cmocka_unit_test(
			test_many_channels_share_the_times_of_the_first_that_moves),
		cmocka_unit_test(test_turns_cost_by_how_far_they_are),
		cmocka_unit_test(test_a_frame_is_the_sum_of_its_steps),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
