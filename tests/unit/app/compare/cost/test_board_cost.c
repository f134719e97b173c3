/* Compares predicted costs with what the timing model counted. */
#include "app/anim/kernel/arm11_cost.h"
#include "app/compare/cost/board_cost.h"
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char figures_path[] = "tests/bench/arm11.figures";

/* Reads one figure of the board's kernel or of posing. */
static double recorded(const char *row, const char *figure)
{
	FILE *file = fopen(figures_path, "r");
	char line[160], name[40], kernel[16], kind[16];
	double value = -1.0, at;

	assert_non_null(file);
	while (fgets(line, sizeof(line), file)) {
		if (sscanf(line, "%39s %15s %15s %lf", name, kernel, kind,
			    &at) == 4 &&
			strcmp(name, row) == 0 && strcmp(kind, figure) == 0 &&
			(strcmp(kernel, "armv6") == 0 ||
				strcmp(kernel, "pose") == 0)) {
			value = at;
		}
	}
	fclose(file);
	if (value < 0.0) {
		fail_msg("%s: no %s %s", figures_path, row, figure);
	}
	return value;
}

static void assert_copied(const char *row, double got, double wanted)
{
	if (fabs(got - wanted) > 0.0051) {
		fail_msg("%s is %.2f, but %s has %.2f: make bench-arm11-table renews app/anim/kernel/arm11_cost.c",
			row, got, figures_path, wanted);
	}
}

static void test_the_table_has_the_recorded_figures(void **state)
{
	(void)state;
	for (int i = 0; i < ARM11_WORKS; i++) {
		const struct arm11_cost *cost = &arm11_cost[i];

		assert_non_null(cost->row);
		assert_copied(cost->row, (double)cost->cycles,
			recorded(cost->row, "cold"));
		assert_copied(cost->row, (double)cost->instructions,
			recorded(cost->row, "instructions"));
	}
}

/* Finds the largest skinned primitive, which limber bench also uses. */
static const struct model_primitive *body_of(const struct model *model)
{
	const struct model_primitive *best = NULL;

	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			const struct model_primitive *primitive =
				&model->mesh[m].primitive[p];

			if (primitive->influences > 0 &&
				(!best ||
					primitive->vertex_count >
						best->vertex_count)) {
				best = primitive;
			}
		}
	}
	assert_non_null(best);
	return best;
}

static void assert_within_5_percent(double got, double wanted, const char *what)
{
	if (fabs(got / wanted - 1.0) > 0.05) {
		fail_msg("%s: %.2f a vertex, the model counted %.2f", what, got,
			wanted);
	}
}

static void expect_row(const char *path, const char *row)
{
	struct log log = log_to_stderr(LOG_WARNING);
	const struct model_primitive *body;
	struct board_cost cost;
	struct model *model;

	assert_int_equal(model_load(path, &log, &model), 0);
	body = body_of(model);
	cost = board_cost_skin(body, 0);
	assert_within_5_percent(
		cost.cycles / body->vertex_count, recorded(row, "cold"), row);
	assert_within_5_percent(cost.instructions / body->vertex_count,
		recorded(row, "instructions"), row);
	model_destroy(model);
}

static void test_the_walkers_body_costs_what_the_model_counted(void **state)
{
	(void)state;
	expect_row("assets/walker.glb", "walker-normals");
}

static void test_cesium_man_costs_what_the_model_counted(void **state)
{
	(void)state;
	samples_require("CesiumMan.glb");
	expect_row(samples_path("CesiumMan.glb").text, "cesium-normals");
}

/* The cost of a vertex that count joints move with equal weights. */
static double vertex_cycles(int count, int cap, bool normals)
{
	float position[1][3] = {{0}}, weight[8] = {0};
	uint16_t joint[8] = {0};
	const struct model_primitive primitive = {
		.vertex_count = 1,
		.position = position,
		.normal = normals ? position : NULL,
		.influences = 8,
		.joint = joint,
		.weight = weight,
	};

	for (int i = 0; i < count; i++) {
		weight[i] = 1.0f / (float)count;
	}
	return board_cost_skin(&primitive, cap).cycles;
}

static void test_each_influence_costs_more_and_caps_cost_less(void **state)
{
	(void)state;
	for (int i = 2; i <= 8; i++) {
		for (int normals = 0; normals < 2; normals++) {
			assert_true(vertex_cycles(i, 0, normals) >
				vertex_cycles(i - 1, 0, normals));
			assert_near(vertex_cycles(i, i - 1, normals),
				vertex_cycles(i - 1, 0, normals), 1e-9);
		}
	}
	assert_true(vertex_cycles(2, 0, true) > vertex_cycles(2, 0, false));
}

static void test_time_is_cycles_at_532_mhz(void **state)
{
	const struct board_cost cost = {.cycles = 532000.0};

	(void)state;
	assert_near(board_cost_us(&cost), 1000.0, 1e-9);
}

/* What a sample costs of a clip that turns one node about an axis. */
static struct board_cost sample_turn(int axis, float from_rad, float angle_rad)
{
	static const float time_s[2] = {0, 1};
	float value[8] = {0};
	struct model_channel channel = {.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.key_count = 2,
		.width = 4,
		.unit = true,
		.time_s = time_s,
		.value = value};
	const struct model_clip clip = {
		.duration_s = 1, .channel_count = 1, .channel = &channel};

	for (int k = 0; k < 2; k++) {
		float half = 0.5f * (from_rad + (k ? angle_rad : 0));

		value[4 * k + axis] = sinf(half);
		value[4 * k + 3] = cosf(half);
	}
	return board_cost_sample(&clip, 1);
}

static void test_turns_cost_as_much_about_any_axis(void **state)
{
	static const float angles_rad[] = {0.1f, 0.4f, 1.0f};
	double last = 0;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(angles_rad); i++) {
		double wanted = sample_turn(0, 0, angles_rad[i]).cycles;

		assert_true(wanted > last);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(
				sample_turn(axis, 1.2f, angles_rad[i]).cycles,
				wanted, 1e-6);
		}
		last = wanted;
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_table_has_the_recorded_figures),
		cmocka_unit_test(
			test_the_walkers_body_costs_what_the_model_counted),
		cmocka_unit_test(test_cesium_man_costs_what_the_model_counted),
		cmocka_unit_test(
			test_each_influence_costs_more_and_caps_cost_less),
		cmocka_unit_test(test_time_is_cycles_at_532_mhz),
		cmocka_unit_test(test_turns_cost_as_much_about_any_axis),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
