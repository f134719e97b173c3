/* What targets cost, and weighted ones by where the vertices are they move. */
#include "app/anim/kernel/run/fixed_morph_run.h"
#include "app/compare/cost/board_cost.h"
#include "app/model/model_deltas.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	COLUMNS = 31,
	ROWS = 23,
	VERTICES = 32 * 24, /* three chunks of the loop */
	TARGETS = 4         /* two pairs */
};

struct bench {
	struct model *model;
	float delta[TARGETS][VERTICES][3];
	struct model_target target[TARGETS];
	float time_s[2], weight[2][TARGETS];
	struct model_channel channel;
	struct model_clip clip;
	float rest[2 * TARGETS];
};

/* A clip that mixes all four targets, none of which moves a vertex yet. */
static void begin_with(struct bench *b, bool normals)
{
	memset(b, 0, sizeof(*b));
	b->model = small_model_grid(COLUMNS, ROWS, 1.0f, normals);
	for (int t = 0; t < TARGETS; t++) {
		b->target[t].position = model_deltas_view(
			(const float(*)[3])b->delta[t], VERTICES);
		b->weight[0][t] = b->weight[1][t] = 0.25f;
	}
	b->time_s[1] = 1.0f;
	b->channel = (struct model_channel){.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = TARGETS,
		.key_count = 2,
		.time_s = b->time_s,
		.value = b->weight[0]};
	b->clip = (struct model_clip){.name = "",
		.duration_s = 1.0f,
		.channel_count = 1,
		.channel = &b->channel};
	b->model->mesh->target_count = TARGETS;
	b->model->mesh->primitive->target = b->target;
	b->model->rest_weights = b->rest;
	b->model->weight_count = TARGETS;
	b->model->clip = &b->clip;
	b->model->clip_count = 1;
}

static void begin(struct bench *b)
{
	begin_with(b, false);
}

static void end(struct bench *b)
{
	model_destroy(b->model);
}

/* Lets a target move these vertices alone. */
static void move(struct bench *b, int target, int first, int count)
{
	memset(b->delta[target], 0, sizeof(b->delta[target]));
	for (int v = first; v < first + count; v++) {
		b->delta[target][v][1] = 0.5f;
	}
}

/* What vertices cost beyond being gathered. */
static struct board_cost predict(struct bench *b)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct arena arena = arena_empty();
	struct clip_cursor cursor;
	struct instance *instance;
	struct board_frame frame;
	struct board_cost gathered;

	assert_int_equal(
		instance_create(b->model, kernel_find("fixed"), &log, &instance),
		0);
	assert_int_equal(clip_cursor_init(&cursor, b->model, &arena), 0);
	frame = board_cost_clip(&b->clip, instance, &cursor, 0, 10.0);
	/* What moves with its node is not gathered. */
	if (instance->drawable[0].morphed) {
		gathered = board_cost_gather(&instance->drawable[0]);
		frame.vertices.cycles -= gathered.cycles;
		frame.vertices.instructions -= gathered.instructions;
	}
	instance_destroy(instance);
	arena_release(&arena);
	return frame.vertices;
}

/* How much a span of so many vertices from the first one on costs more. */
static double more(struct bench *b, int target, int first, int count)
{
	struct board_cost before, after;

	move(b, target, first, count - 1);
	before = predict(b);
	move(b, target, first, count);
	after = predict(b);
	return after.cycles - before.cycles;
}

static struct board_cost of(const struct board_targets *targets)
{
	return board_cost_targets(targets);
}

/*
 * Of several pairs with weights, a span is a piece in each chunk of the loop's
 * that it reaches; one pair alone has no chunks.
 */
static void test_spans_of_several_pairs_are_cut_at_the_ends_of_chunks(
	void **state)
{
	const struct board_targets piece = {.pieces = 1.0};
	const int chunk = FIXED_MORPH_CHUNK;

	(void)state;
	for (int pairs = 1; pairs <= 2; pairs++) {
		const double whole = pairs == 2 ? of(&piece).cycles : 0.0;
		struct bench b;
		double vertex;

		begin(&b);
		if (pairs == 2) {
			move(&b, 2, 5, 300);
		}
		vertex = more(&b, 0, 0, chunk - 1);
		assert_int_equal(whole > 1.0, pairs == 2);
		assert_near(more(&b, 0, 0, chunk), vertex, 1e-6);
		assert_near(more(&b, 0, 0, chunk + 1), vertex + whole, 1e-6);
		assert_near(more(&b, 0, 0, chunk + 2), vertex, 1e-6);
		assert_near(more(&b, 0, 0, 2 * chunk + 1), vertex + whole, 1e-6);
		assert_near(more(&b, 0, 100, chunk - 100), vertex, 1e-6);
		assert_near(more(&b, 0, 100, chunk - 99), vertex + whole, 1e-6);
		assert_near(more(&b, 1, chunk, 3), vertex, 1e-6);
		end(&b);
	}
}

/*
 * One pair writes the vertices that it moves, and the others are copied; of
 * several each adds to all of them.
 */
static void test_one_pair_is_written_and_several_are_added(void **state)
{
	struct board_targets counts = {.weights = TARGETS,
		.copied = VERTICES - 100,
		.paired = 100,
		.spans = 1};
	struct board_cost none, one, two, base;
	struct bench b;

	(void)state;
	begin(&b);
	none = predict(&b);
	move(&b, 3, 7, 100);
	one = predict(&b);
	base = of(
		&(struct board_targets){.weights = TARGETS, .copied = VERTICES});
	assert_near(one.cycles - none.cycles, of(&counts).cycles - base.cycles,
		1e-6);
	assert_near(one.instructions - none.instructions,
		of(&counts).instructions - base.instructions, 1e-6);
	move(&b, 0, 600, 30);
	two = predict(&b);
	counts = (struct board_targets){.weights = TARGETS,
		.begun = VERTICES,
		.added = 130,
		.pieces = 2,
		.visits = 2 * 3,
		.searches = 2 * 3,
		.steps = 2 * 3};
	assert_near(two.cycles - none.cycles, of(&counts).cycles - base.cycles,
		1e-6);
	assert_near(two.instructions - none.instructions,
		of(&counts).instructions - base.instructions, 1e-6);
	end(&b);
}

/* Two chunks and a vertex, which each of two pairs looks for. */
static void test_a_chunk_may_have_a_single_vertex(void **state)
{
	const struct board_targets counts = {.weights = TARGETS,
		.begun = 2 * FIXED_MORPH_CHUNK + 1,
		.added = 20,
		.pieces = 2,
		.visits = 2 * 3,
		.searches = 2 * 3,
		.steps = 2 * 3};
	struct board_cost targets = of(&counts);
	struct bench b;

	(void)state;
	begin(&b);
	b.model->mesh->primitive->vertex_count = 2 * FIXED_MORPH_CHUNK + 1;
	b.model->mesh->primitive->index_count = 30;
	move(&b, 0, 0, 10);
	move(&b, 2, 30, 10);
	assert_near(predict(&b).cycles, 1900 + targets.cycles, 1e-6);
	end(&b);
}

/* Those of other nodes come before. */
static void test_weights_are_those_of_the_meshs_node(void **state)
{
	struct board_cost first, second;
	struct bench b;

	(void)state;
	begin(&b);
	move(&b, 0, 0, 200);
	first = predict(&b);
	b.model->node->weight_offset = TARGETS;
	b.model->weight_count = 2 * TARGETS;
	second = predict(&b);
	assert_near(second.cycles, first.cycles, 1e-6);
	end(&b);
}

/* Each frame looks at the weights of all targets. */
static void test_each_target_has_a_weight_to_look_at(void **state)
{
	struct board_cost four, two, weights;
	struct bench b;

	(void)state;
	begin(&b);
	four = predict(&b);
	b.model->mesh->target_count = b.model->weight_count = 2;
	b.channel.width = 2;
	two = predict(&b);
	weights = of(&(struct board_targets){.weights = 2});
	assert_near(four.cycles - two.cycles, weights.cycles, 1e-6);
	end(&b);
}

/* In half of the frames one pair has weights of 0. */
static void test_costs_are_means_over_the_frames(void **state)
{
	struct board_cost always, never, half;
	struct bench b;

	(void)state;
	begin(&b);
	move(&b, 0, 0, 200);
	always = predict(&b);
	b.channel.interpolation = MODEL_STEP;
	b.time_s[1] =
		0.45f; /* the fifth of ten frames is the last one before */
	memset(b.weight[0], 0, sizeof(b.weight[0]));
	half = predict(&b);
	memset(b.weight[1], 0, sizeof(b.weight[1]));
	never = predict(&b);
	assert_true(always.cycles > never.cycles + 100);
	assert_near(half.cycles, 0.5 * (always.cycles + never.cycles), 1e-6);
	end(&b);
}

static void expect_cost(struct bench *b, double cycles, double instructions)
{
	struct board_cost cost = predict(b);

	assert_near(cost.cycles, cycles, 1e-6);
	assert_near(cost.instructions, instructions, 1e-6);
}

/* Positions are morphed, and normals if the grid has any. */
static void test_a_morph_costs_its_drawable_and_each_attribute(void **state)
{
	(void)state;
	for (int normals = 0; normals < 2; normals++) {
		double attributes = normals + 1;
		struct board_targets counts = {.weights = TARGETS * attributes,
			.copied = VERTICES * attributes - 30,
			.paired = 30,
			.spans = 2};
		struct board_cost targets = of(&counts);
		struct bench b;

		begin_with(&b, normals);
		move(&b, 1, 50, 20);
		for (int v = 300; v < 310; v++) {
			b.delta[1][v][0] = 0.25f;
		}
		expect_cost(
			&b, 1900 + targets.cycles, 370 + targets.instructions);
		end(&b);
	}
}

/* Each key frame shows one target. */
static void test_key_frames_cost_what_interpolating_does(void **state)
{
	(void)state;
	for (int normals = 0; normals < 2; normals++) {
		struct board_cost keys =
			board_cost_keys(VERTICES, normals, TARGETS);
		struct bench b;

		begin_with(&b, normals);
		for (int t = 0; t < TARGETS; t++) {
			move(&b, t, 50 * t, 20);
			b.weight[0][t] = t == 0;
			b.weight[1][t] = t == 1;
		}
		b.model->mesh->key_frames = true;
		expect_cost(&b, keys.cycles, keys.instructions);
		end(&b);
	}
}

static void test_a_mesh_without_targets_moves_with_its_node(void **state)
{
	struct board_cost solid = board_cost_solid(1);
	struct bench b;

	(void)state;
	begin(&b);
	b.model->mesh->target_count = b.model->weight_count = 0;
	b.clip.channel_count = 0;
	expect_cost(&b, solid.cycles, solid.instructions);
	end(&b);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_spans_of_several_pairs_are_cut_at_the_ends_of_chunks),
		cmocka_unit_test(test_one_pair_is_written_and_several_are_added),
		cmocka_unit_test(test_a_chunk_may_have_a_single_vertex),
		cmocka_unit_test(test_weights_are_those_of_the_meshs_node),
		cmocka_unit_test(test_each_target_has_a_weight_to_look_at),
		cmocka_unit_test(test_costs_are_means_over_the_frames),
		cmocka_unit_test(
			test_a_morph_costs_its_drawable_and_each_attribute),
		cmocka_unit_test(test_key_frames_cost_what_interpolating_does),
		cmocka_unit_test(test_a_mesh_without_targets_moves_with_its_node),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
