/* Compares predicted costs of clips with what the timing model counted. */
#include "app/compare/cost/board_cost.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <math.h>

/*
 * board_cost.h promises to be within 10%; skins are within 5%. In frames of
 * fewer cycles than these, one cache miss more is 1%.
 */
static const double short_cycles = 12000.0;
static const double rate_hz = 60.0;

/*
 * An average frame of tests/bench/play_cost MODEL CLIP 60 INFLUENCES on the
 * timing model (tests/arm1136), without drawing.
 */
struct played {
	const char *path, *clip;
	int max_influences;
	double cycles, instructions;
	double tolerance;
};

static const struct played samples[] = {
	{"CesiumMan.glb", "0", 0, 238861, 174142, 0.05},
	{"CesiumMan.glb", "0", 1, 136302, 86304, 0.05},
	{"RiggedFigure.glb", "0", 0, 67522, 33377, 0.05},
	{"RiggedSimple.glb", "0", 0, 15613, 6354, 0.05},
	{"AnimatedMorphCube.glb", "0", 0, 7113, 1285, 0.10},
	{"BoxAnimated.glb", "0", 0, 7295, 1115, 0.10},
};

static const struct played assets[] = {
	{"assets/walker.glb", "walk", 0, 269410, 176455, 0.05},
	{"assets/walker.glb", "jump", 1, 314662, 168739, 0.05},
	{"assets/face.glb", "cycle", 0, 244546, 69342, 0.10},
};

struct bench {
	struct log log;
	struct model *model;
	struct instance *instance;
	struct arena arena;
	struct clip_cursor cursor;
	const struct model_clip *clip;
};

static void begin(struct bench *bench, const char *path, const char *clip,
	const char *kernel)
{
	int found;

	*bench = (struct bench){.log = log_to_stderr(LOG_WARNING)};
	assert_int_equal(model_load(path, &bench->log, &bench->model), 0);
	assert_int_equal(instance_create(bench->model, kernel_find(kernel),
				 &bench->log, &bench->instance),
		0);
	bench->instance->normal_mapping = false;
	assert_int_equal(
		clip_cursor_init(&bench->cursor, bench->model, &bench->arena),
		0);
	assert_int_equal(
		model_choose_clip(bench->model, clip, -1, &bench->log, &found),
		0);
	bench->clip = &bench->model->clip[found];
}

static void end(struct bench *bench)
{
	instance_destroy(bench->instance);
	arena_release(&bench->arena);
	model_destroy(bench->model);
}

static struct board_frame predict(struct bench *bench, int max_influences)
{
	return board_cost_clip(bench->clip, bench->instance, &bench->cursor,
		max_influences, rate_hz);
}

static void expect_near(
	const struct played *row, const char *what, double got, double wanted)
{
	if (fabs(got / wanted - 1.0) > row->tolerance) {
		fail_msg("%s %s: %.0f %s, the model counted %.0f", row->path,
			row->clip, got, what, wanted);
	}
}

static void expect_row(const struct played *row, const char *path)
{
	struct board_frame frame;
	struct board_cost sum;
	struct bench bench;

	begin(&bench, path, row->clip, "fixed");
	frame = predict(&bench, row->max_influences);
	sum = board_frame_posing(&frame);
	expect_near(row, "cycles", sum.cycles, row->cycles);
	if (row->cycles > short_cycles) {
		expect_near(row, "instructions", sum.instructions,
			row->instructions);
	}
	end(&bench);
}

static void test_own_clips_cost_what_the_model_counted(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(assets); i++) {
		expect_row(&assets[i], assets[i].path);
	}
}

static void test_samples_cost_what_the_model_counted(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(samples); i++) {
		samples_require(samples[i].path);
		expect_row(&samples[i], samples_path(samples[i].path).text);
	}
}

/* A joint of each skin has a matrix of its own. */
static void test_the_joints_of_all_skins_count(void **state)
{
	struct board_cost wanted;
	struct model_skin skins[2];
	struct board_frame frame;
	struct bench bench;
	struct model twice;

	(void)state;
	begin(&bench, "assets/walker.glb", "walk", "fixed");
	twice = *bench.model;
	skins[0] = skins[1] = bench.model->skin[0];
	twice.skin = skins;
	twice.skin_count = 2;
	bench.instance->model = &twice;
	frame = predict(&bench, 0);
	bench.instance->model = bench.model;
	wanted = board_cost_matrices(bench.model->node_count,
		board_cost_count_roots(bench.model), 2 * skins[0].joint_count);
	assert_near(frame.matrices.cycles, wanted.cycles, 1e-6);
	assert_near(frame.matrices.instructions, wanted.instructions, 1e-6);
	end(&bench);
}

/*
 * Region 2 of tests/bench/play_cost.c, by the frame: of controllers for hands
 * with many nodes that carry nothing (the npm package
 * @webxr-input-profiles/assets 1.0.20) and of CesiumMan in rigid parts.
 */
static void test_nodes_cost_what_the_model_counted(void **state)
{
	static const struct {
		int nodes, drawables;
		double cycles, instructions;
	} counted[] = {
		{46, 6, 21554.0, 4637.0},
		{31, 10, 17008.0, 3506.0},
		{10, 3, 5958.0, 1182.0},
		{22, 19, 16239.0, 3146.0},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(counted); i++) {
		struct board_cost sum =
			board_cost_matrices(counted[i].nodes, 1, 0);
		struct board_cost solid = board_cost_solid(counted[i].drawables);

		board_cost_add(&sum, &solid);
		assert_near(sum.cycles, counted[i].cycles,
			0.05 * counted[i].cycles);
		assert_near(sum.instructions, counted[i].instructions,
			0.05 * counted[i].instructions);
	}
}

/*
 * Region 2 of key frames that limber compare exported: of five squares, of a
 * skin and of 600 boxes. Each drawable looks through the weights of all keys.
 */
static void test_key_frames_cost_what_the_model_counted(void **state)
{
	static const struct {
		int drawables, vertices, keys;
		double cycles, instructions;
	} counted[] = {
		{5, 4, 20, 10438.0, 2900.0},
		{5, 4, 26, 11352.0, 3118.0},
		{1, 273, 20, 13886.0, 6647.0},
		{1, 273, 27, 14131.0, 6693.0},
		{600, 24, 5, 1704798.0, 517086.0},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(counted); i++) {
		struct board_cost sum = board_cost_matrices(1, 1, 0);

		for (int d = 0; d < counted[i].drawables; d++) {
			struct board_cost keys = board_cost_keys(
				counted[i].vertices, true, counted[i].keys);

			board_cost_add(&sum, &keys);
		}
		assert_near(sum.cycles, counted[i].cycles,
			0.11 * counted[i].cycles);
		assert_near(sum.instructions, counted[i].instructions,
			0.05 * counted[i].instructions);
	}
}

/*
 * A clip that scales six joints of one skin unevenly: functions that it alone
 * calls took 4,326 cycles a frame for the matrices, and 1,338 to convert them.
 */
static void test_joints_of_uneven_scale_have_two_matrices(void **state)
{
	double joints, drawables = 0, wanted;
	struct board_frame even, uneven, bare;
	const struct model_skin *skin;
	struct bench bench;

	(void)state;
	begin(&bench, "assets/walker.glb", "walk", "fixed");
	even = predict(&bench, 0);
	end(&bench);
	begin(&bench, "assets/walker.glb", "walk", "fixed");
	for (int i = 0; i < bench.instance->drawable_count; i++) {
		drawables += bench.instance->drawable[i].skin == 0;
	}
	skin = &bench.model->skin[0];
	joints = skin->joint_count;
	/* All other joints are below the hips. */
	bench.model->node[skin->joint[0]].rest.scale[1] = 1.5f;
	uneven = predict(&bench, 0);
	wanted = joints * (4326.0 + drawables * 1338.0) / 6.0;
	assert_near(uneven.matrices.cycles - even.matrices.cycles, wanted,
		0.1 * wanted);
	assert_true(uneven.matrices.instructions > even.matrices.instructions);
	/* Without normals a drawable needs no matrices for them. */
	bench.model->mesh[0].primitive[0].normal = NULL;
	bare = predict(&bench, 0);
	wanted = joints * 1338.0 / 6.0;
	assert_near(uneven.matrices.cycles - bare.matrices.cycles, wanted,
		0.15 * wanted);
	end(&bench);
}

/* The hips are scaled unevenly in no frame, in 6 of the 12, or in all. */
static void test_uneven_scale_costs_in_the_frames_that_have_it(void **state)
{
	static const float time_s[2] = {0.0f, 0.09f};
	static const float value[3][6] = {{1, 1, 1, 1, 1, 1},
		{1, 1, 1, 1, 1.5f, 1}, {1, 1.5f, 1, 1, 1.5f, 1}};
	double cycles[3];
	struct bench bench;

	(void)state;
	begin(&bench, "assets/walker.glb", "walk", "fixed");
	for (int i = 0; i < 3; i++) {
		struct model_channel channel = {
			.node = bench.model->skin[0].joint[0],
			.path = MODEL_SCALE,
			.interpolation = MODEL_STEP,
			.width = 3,
			.key_count = 2,
			.time_s = time_s,
			.value = value[i]};
		struct model_clip clip = {.name = "",
			.duration_s = 0.2f,
			.channel_count = 1,
			.channel = &channel};

		bench.clip = &clip;
		cycles[i] = predict(&bench, 0).matrices.cycles;
	}
	assert_true(cycles[2] > 1.01 * cycles[0]);
	assert_near(cycles[1], 0.5 * (cycles[0] + cycles[2]), 1.0);
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_own_clips_cost_what_the_model_counted),
		cmocka_unit_test(test_samples_cost_what_the_model_counted),
		cmocka_unit_test(test_the_joints_of_all_skins_count),
		cmocka_unit_test(test_nodes_cost_what_the_model_counted),
		cmocka_unit_test(test_key_frames_cost_what_the_model_counted),
		cmocka_unit_test(test_joints_of_uneven_scale_have_two_matrices),
		cmocka_unit_test(
			test_uneven_scale_costs_in_the_frames_that_have_it),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
