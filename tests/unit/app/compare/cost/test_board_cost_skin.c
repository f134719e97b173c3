/* What a skin of a few vertices costs, as fitted (app/compare/figures.md). */
#include "app/compare/cost/board_cost.h"
#include "app/model/model_deltas.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

#include <cglm/cglm.h>

enum {
	GRID_JOINTS = 3,
	VERTICES = 12
};

static const double rate_hz = 60.0;

/* A skin of a grid of 12 vertices, whose joints are all its one node. */
struct skinned_grid {
	struct model *model;
	mat4 bind[GRID_JOINTS];
	int joint[GRID_JOINTS];
	struct model_skin skin[2];
	uint16_t joints[VERTICES][4];
	float weights[VERTICES][4];
	float delta[VERTICES][3];
	struct model_target target;
	float rest_weight;
	float time_s[2], value[6];
	struct model_channel channel;
	struct model_clip clip;
};

/* Five vertices follow joint 0, four joint 1, and three the joints 1 and 2. */
static void begin(struct skinned_grid *grid, bool normals)
{
	struct model_primitive *primitive;

	memset(grid, 0, sizeof(*grid));
	grid->model = small_model_grid(3, 2, 1.0f, normals);
	primitive = grid->model->mesh->primitive;
	for (int v = 0; v < VERTICES; v++) {
		grid->joints[v][0] = v < 5 ? 0 : 1;
		grid->joints[v][1] = 2;
		grid->weights[v][0] = v < 9 ? 1.0f : 0.5f;
		grid->weights[v][1] = v < 9 ? 0.0f : 0.5f;
	}
	primitive->influences = 4;
	primitive->joint = grid->joints[0];
	primitive->weight = grid->weights[0];
	for (int j = 0; j < GRID_JOINTS; j++) {
		glm_mat4_identity(grid->bind[j]);
	}
	grid->skin[0] = grid->skin[1] = (struct model_skin){.name = "",
		.joint_count = GRID_JOINTS,
		.joint = grid->joint,
		.inverse_bind = grid->bind};
	grid->clip = (struct model_clip){
		.name = "", .duration_s = 1.0f, .channel = &grid->channel};
	grid->model->skin = grid->skin;
	grid->model->skin_count = 1;
	grid->model->node->skin = 0;
	grid->model->clip = &grid->clip;
	grid->model->clip_count = 1;
}

static void end(struct skinned_grid *grid)
{
	model_destroy(grid->model);
}

/* The clip has a value before the time and another one after it. */
static void step(struct skinned_grid *grid, enum model_path path, int width,
	float duration_s, float time_s)
{
	grid->time_s[1] = time_s;
	grid->channel = (struct model_channel){.path = path,
		.interpolation = MODEL_STEP,
		.width = width,
		.key_count = 2,
		.time_s = grid->time_s,
		.value = grid->value};
	grid->clip.channel_count = 1;
	grid->clip.duration_s = duration_s;
}

/* Only after that time, the node is scaled unevenly. */
static void scale_after(
	struct skinned_grid *grid, float duration_s, float time_s)
{
	static const float value[6] = {1, 1, 1, 1, 1.5f, 1};

	memcpy(grid->value, value, sizeof(value));
	step(grid, MODEL_SCALE, 3, duration_s, time_s);
}

/* The frame, and what its vertices cost beyond being gathered. */
static struct board_frame predict(struct skinned_grid *grid, int max_influences)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct arena arena = arena_empty();
	struct instance *instance;
	struct clip_cursor cursor;
	struct board_frame frame;
	struct board_cost gathered;

	assert_int_equal(instance_create(grid->model, kernel_find("fixed"),
				 &log, &instance),
		0);
	assert_int_equal(clip_cursor_init(&cursor, grid->model, &arena), 0);
	frame = board_cost_clip(
		&grid->clip, instance, &cursor, max_influences, rate_hz);
	gathered = board_cost_gather(&instance->drawable[0]);
	frame.vertices.cycles -= gathered.cycles;
	frame.vertices.instructions -= gathered.instructions;
	instance_destroy(instance);
	arena_release(&arena);
	return frame;
}

static void expect_cost(
	const struct board_cost *cost, double cycles, double instructions)
{
	assert_near(cost->cycles, cycles, 1e-6);
	assert_near(cost->instructions, instructions, 1e-6);
}

/* Three runs of vertices with the same joints: two of one joint, one of two. */
static void test_a_skin_costs_its_drawable_runs_and_vertices(void **state)
{
	struct skinned_grid grid;
	struct board_frame frame;
	struct board_cost skin;

	(void)state;
	begin(&grid, true);
	frame = predict(&grid, 0);
	skin = board_cost_skin(grid.model->mesh->primitive, 0);
	expect_cost(&frame.vertices, 0.88 * skin.cycles + 3200 + 2 * 60 + 200,
		0.96 * skin.instructions + 430 + 2 * 75 + 87);
	/* With one influence a vertex, vertices of joint 1 are one run. */
	frame = predict(&grid, 1);
	skin = board_cost_skin(grid.model->mesh->primitive, 1);
	expect_cost(&frame.vertices, 0.88 * skin.cycles + 3200 + 2 * 60,
		0.96 * skin.instructions + 430 + 2 * 75);
	end(&grid);
}

/*
 * In this share of the frames the node is looked at, and each of so many
 * joints has a matrix for normals, which a drawable with normals converts.
 */
static void expect_uneven(
	struct skinned_grid *grid, double share, int joints, int converted)
{
	struct board_cost even = board_cost_matrices(
		1, 1, GRID_JOINTS * grid->model->skin_count);
	struct board_frame frame = predict(grid, 0);

	expect_cost(&frame.matrices,
		even.cycles + share * (96.0 + joints * 660.0 + converted * 220.0),
		even.instructions +
			share * (10.0 + joints * 265.0 + converted * 59.0));
}

static void test_uneven_scale_costs_matrices_for_normals(void **state)
{
	(void)state;
	for (int normals = 0; normals < 2; normals++) {
		struct skinned_grid grid;

		begin(&grid, normals);
		expect_uneven(&grid, 0, 3, 3);
		grid.model->node->rest.scale[1] = 1.5f;
		expect_uneven(&grid, 1, 3, normals ? 3 : 0);
		/* No drawable shows the second skin. */
		grid.model->skin_count = 2;
		expect_uneven(&grid, 1, 6, normals ? 3 : 0);
		end(&grid);
	}
}

/* Then all joints of the skin have such matrices, in each pose. */
static void test_an_uneven_inverse_bind_matrix_costs_them_too(void **state)
{
	mat4 bind[GRID_JOINTS];
	struct skinned_grid grid;

	(void)state;
	begin(&grid, true);
	grid.model->skin_count = 2;
	memcpy(bind, grid.bind, sizeof(bind));
	bind[2][1][1] = 2.0f;
	grid.skin[1].inverse_bind = bind;
	expect_uneven(&grid, 1, 3, 0);
	grid.skin[0].inverse_bind = bind;
	expect_uneven(&grid, 1, 6, 3);
	end(&grid);
}

/* The frames are at multiples of 1/60 s from 0 on, before the clip's end. */
static void test_matrices_for_normals_count_in_frames_of_uneven_scale(
	void **state)
{
	static const struct {
		float duration_s, time_s;
		double share;
	} cases[] = {
		{0.2f, 0.001f, 11.0 / 12},
		{0.2f, 0.149f, 3.0 / 12},
		{0.2f, 0.19f, 0.0},
		{0.1f, 0.049f, 0.5},
		{1.0f, 0.7491f, 0.25},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct skinned_grid grid;

		begin(&grid, true);
		scale_after(&grid, cases[i].duration_s, cases[i].time_s);
		expect_uneven(&grid, cases[i].share, 3, 3);
		/* No other channel is looked at. */
		grid.channel.path = MODEL_TRANSLATION;
		expect_uneven(&grid, 0, 3, 3);
		end(&grid);
	}
}

/* Of a longer clip, the first 10,000 frames are enough. */
static void test_a_clip_has_1_to_10000_frames(void **state)
{
	struct skinned_grid grid;

	(void)state;
	begin(&grid, true);
	scale_after(&grid, 0.001f, 0.0009f);
	expect_uneven(&grid, 0, 3, 3);
	scale_after(&grid, 1000.0f, 9998.5f / 60.0f);
	expect_uneven(&grid, 1.0 / 10000, 3, 3);
	scale_after(&grid, 1000.0f, 9999.5f / 60.0f);
	expect_uneven(&grid, 0, 3, 3);
	end(&grid);
}

/* The target moves two vertices of one joint, and one of two. */
static void add_target(struct skinned_grid *grid)
{
	struct model_mesh *mesh = grid->model->mesh;

	grid->delta[0][0] = grid->delta[4][1] = grid->delta[10][2] = 0.5f;
	grid->target.position =
		model_deltas_view((const float(*)[3])grid->delta, VERTICES);
	mesh->target_count = 1;
	mesh->primitive->target = &grid->target;
	grid->model->rest_weights = &grid->rest_weight;
	grid->model->weight_count = 1;
}

/* In this share of the frames the weight is another one than before. */
static void expect_rebased(struct skinned_grid *grid, double share)
{
	const struct board_targets once = {.weights = share,
		.paired = 3 * share,
		.spans = share,
		.rebased = 4 * share};
	struct board_cost targets = board_cost_targets(&once);
	struct board_cost skin =
		board_cost_skin(grid->model->mesh->primitive, 0);
	struct board_frame frame = predict(grid, 0);

	expect_cost(&frame.vertices,
		0.88 * skin.cycles + 3200 + 2 * 60 + 200 + targets.cycles,
		0.96 * skin.instructions + 430 + 2 * 75 + 87 +
			targets.instructions);
}

/* Weights are 0 at first, and base vectors follow them. */
static void test_targets_of_a_skin_cost_when_weights_change(void **state)
{
	struct skinned_grid grid;

	(void)state;
	begin(&grid, false);
	add_target(&grid);
	expect_rebased(&grid, 0);
	step(&grid, MODEL_WEIGHTS, 1, 1.0f, 0.5f);
	expect_rebased(&grid, 0);
	grid.value[0] = grid.value[1] = 0.25f;
	expect_rebased(&grid, 1.0 / 60);
	grid.value[1] = 0.75f;
	expect_rebased(&grid, 2.0 / 60);
	grid.channel.interpolation = MODEL_LINEAR;
	grid.time_s[1] = 1.0f;
	expect_rebased(&grid, 1);
	grid.value[0] = 0.0f;
	expect_rebased(&grid, 59.0 / 60);
	end(&grid);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_skin_costs_its_drawable_runs_and_vertices),
		cmocka_unit_test(test_uneven_scale_costs_matrices_for_normals),
		cmocka_unit_test(
			test_an_uneven_inverse_bind_matrix_costs_them_too),
		cmocka_unit_test(
			test_matrices_for_normals_count_in_frames_of_uneven_scale),
		cmocka_unit_test(test_a_clip_has_1_to_10000_frames),
		cmocka_unit_test(test_targets_of_a_skin_cost_when_weights_change),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
