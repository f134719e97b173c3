/* What drawing is predicted to cost, without measuring a comparison before. */
#include "app/compare/comparison_draw.h"
#include "app/compare/cost/board_cost.h"
#include "app/model/levels/levels.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	ROWS = 3, /* the model itself and two morphs, which draw the model */
	CLIPS = 2
};

struct bench {
	struct model *model;
	struct comparison comparison;
	struct comparison_clip clip[CLIPS];
	struct comparison_cell cell[ROWS][CLIPS];
};

/*
 * The walker, with flat normals, in a small picture in which a level of detail
 * is drawn.
 */
static void begin(struct bench *bench)
{
	static const enum comparison_kind kinds[ROWS] = {
		COMPARISON_ORIGINAL, COMPARISON_MORPH, COMPARISON_MORPH_EVEN};
	struct log log = log_to_stderr(LOG_WARNING);

	*bench = (struct bench){.comparison = {
					.request = {.width = 48, .height = 64},
					.box = {{-1, 0, -1}, {1, 2, 1}},
					.clip_count = CLIPS,
					.sampling = {.drawn_frames = 2},
					.row_count = ROWS,
				}};
	assert_int_equal(
		model_load("assets/walker.glb", &log, &bench->model), 0);
	for (int m = 0; m < bench->model->mesh_count; m++) {
		const struct model_mesh *mesh = &bench->model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			mesh->primitive[p].normal = NULL;
		}
	}
	assert_int_equal(levels_make(bench->model), 0);
	assert_true(bench->model->clip_count >= CLIPS);
	bench->comparison.model = bench->model;
	bench->comparison.clip = bench->clip;
	for (int i = 0; i < ROWS; i++) {
		bench->comparison.row[i] = (struct comparison_row){
			.kind = kinds[i], .listed = true, .cell = bench->cell[i]};
	}
	for (int i = 0; i < CLIPS; i++) {
		bench->clip[i].clip = i;
	}
}

static void end(struct bench *bench)
{
	model_destroy(bench->model);
}

/* Posing takes 1e9 cycles, of which what is saved is taken. */
static const struct board_frame *predict(struct bench *bench, int row, int clip)
{
	struct log log = log_to_stderr(LOG_WARNING);

	memset(bench->cell, 0, sizeof(bench->cell));
	for (int i = 0; i < ROWS * CLIPS; i++) {
		struct board_cost *posing =
			&bench->cell[i / CLIPS][i % CLIPS].board.vertices;

		posing->cycles = 1e9;
		posing->instructions = 1e9;
	}
	assert_int_equal(comparison_draw_predict(&bench->comparison, &log), 0);
	return &bench->cell[row][clip].board;
}

static void expect_cost(
	const struct board_cost *cost, const struct board_cost *wanted)
{
	assert_near(cost->cycles, wanted->cycles, 1e-9 * wanted->cycles);
	assert_near(cost->instructions, wanted->instructions,
		1e-9 * wanted->instructions);
}

/* All frames of the model's clip that lasts no time show the same. */
static void test_costs_are_means_of_a_frame(void **state)
{
	static const int frames[] = {1, 2, 6};
	struct board_frame one = {0};
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.model->clip[0].duration_s = 0;
	bench.comparison.row_count = 1; /* such a clip has no key frames */
	for (int i = 0; i < 3; i++) {
		const struct board_frame *frame;

		bench.comparison.sampling.drawn_frames = frames[i];
		frame = predict(&bench, 0, 0);
		one = i == 0 ? *frame : one;
		expect_cost(&frame->draw, &one.draw);
		expect_cost(&frame->vertices, &one.vertices);
	}
	assert_true(one.draw.cycles > one.draw.instructions);
	assert_true(one.draw.instructions > 1000);
	end(&bench);
}

/*
 * The level of detail has fewer vertices to gather, however it is posed: the
 * model's posing has all of them, that of key frames none.
 */
static void test_a_level_of_detail_saves_posing(void **state)
{
	struct board_cost small[ROWS];
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.clip_count = 1;
	bench.clip[0].clip = 1;
	bench.comparison.sampling.drawn_frames = 1;
	predict(&bench, 0, 0);
	for (int row = 0; row < ROWS; row++) {
		small[row] = bench.cell[row][0].board.vertices;
	}
	assert_in_range(small[0].cycles, 1, 1e9 - 1000);
	assert_in_range(small[0].instructions, small[0].cycles, 1e9 - 1000);
	assert_true(small[1].cycles > 1e9 + 1000);
	assert_true(small[1].instructions > 1e9 + 1000);
	expect_cost(&small[2], &small[1]);
	bench.comparison.request.width = 900; /* finer ones are drawn */
	bench.comparison.request.height = 1200;
	predict(&bench, 0, 0);
	assert_true(bench.cell[0][0].board.vertices.cycles >
		small[0].cycles + 1000);
	assert_true(bench.cell[1][0].board.vertices.cycles - 1e9 >
		1.2 * (small[1].cycles - 1e9));
	end(&bench);
}

/* Each pixel is cleared, whether or not anything is drawn there. */
static void test_more_pixels_cost_more(void **state)
{
	struct gl_counts nothing = {0};
	double before = 0;
	struct bench bench;

	(void)state;
	begin(&bench);
	for (int times = 1; times <= 4; times *= 2) {
		struct board_cost cleared =
			board_cost_draw(&nothing, 48.0 * times * 64.0 * times);
		const struct board_frame *frame;

		bench.comparison.request.width = 48 * times;
		bench.comparison.request.height = 64 * times;
		frame = predict(&bench, 0, 0);
		assert_true(frame->draw.cycles > cleared.cycles);
		assert_true(frame->draw.cycles > 1.2 * before);
		before = frame->draw.cycles;
	}
	end(&bench);
}

/* Parts that only move with their nodes are not copied, so nothing is saved. */
static void test_nothing_is_saved_where_no_vertex_is_posed(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.row_count = 1;
	for (int n = 0; n < bench.model->node_count; n++) {
		struct model_node *node = &bench.model->node[n];

		node->skin = -1;
		if (node->mesh >= 0 &&
			bench.model->mesh[node->mesh].target_count > 0) {
			node->mesh = -1;
		}
	}
	assert_near(predict(&bench, 0, 0)->vertices.cycles, 1e9, 0.0);
	end(&bench);
}

/* Of the model's clip that is compared, and not of the clip of that index. */
static void test_the_compared_clip_is_drawn(void **state)
{
	struct board_cost both[CLIPS];
	struct bench bench;

	(void)state;
	begin(&bench);
	for (int c = 0; c < CLIPS; c++) {
		both[c] = predict(&bench, 0, c)->draw;
	}
	assert_true(both[0].cycles != both[1].cycles);
	bench.comparison.clip_count = 1;
	bench.clip[0].clip = 1;
	expect_cost(&predict(&bench, 0, 0)->draw, &both[1]);
	expect_cost(&predict(&bench, 1, 0)->draw, &bench.cell[2][0].board.draw);
	end(&bench);
}

/* No clip, no motion: the rest pose is drawn. */
static void test_without_such_a_clip_the_rest_pose_is_drawn(void **state)
{
	struct board_cost rest, moved;
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.row_count = 1; /* nor are there key frames */
	moved = predict(&bench, 0, 0)->draw;
	bench.clip[0].clip = bench.model->clip_count;
	rest = predict(&bench, 0, 0)->draw;
	assert_true(rest.cycles > 0);
	assert_true(rest.cycles != moved.cycles);
	bench.model->clip_count = 0;
	expect_cost(&predict(&bench, 0, 0)->draw, &rest);
	end(&bench);
}

/* Whichever clip of the model it is, and whatever was drawn before it. */
static void test_a_clip_costs_the_same_at_any_place(void **state)
{
	struct board_frame wanted[CLIPS];
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.sampling.drawn_frames = 1;
	bench.comparison.row_count = 1;
	(void)predict(&bench, 0, 0);
	wanted[0] = bench.cell[0][0].board;
	wanted[1] = bench.cell[0][1].board;
	bench.clip[0].clip = 1;
	bench.clip[1].clip = 0;
	(void)predict(&bench, 0, 0);
	for (int c = 0; c < CLIPS; c++) {
		const struct board_frame *found = &bench.cell[0][1 - c].board;

		expect_cost(&found->draw, &wanted[c].draw);
		expect_cost(&found->vertices, &wanted[c].vertices);
	}
	/* The model's second clip becomes its first one. */
	bench.model->clip++;
	bench.model->clip_count--;
	bench.comparison.clip_count = 1;
	bench.clip[0].clip = 0;
	expect_cost(&predict(&bench, 0, 0)->draw, &wanted[1].draw);
	bench.model->clip--;
	bench.model->clip_count++;
	end(&bench);
}

/* The picture shows a clip, and not all that was compared, from edge to edge. */
static void test_a_clip_fills_the_picture_that_is_drawn(void **state)
{
	struct board_cost wanted;
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.sampling.drawn_frames = 1;
	bench.comparison.row_count = 1;
	bench.comparison.clip_count = 1;
	wanted = predict(&bench, 0, 0)->draw;
	for (int axis = 0; axis < 3; axis++) {
		bench.comparison.box.low[axis] *= 3.0f;
		bench.comparison.box.high[axis] *= 3.0f;
	}
	/* The ground is as large as what was compared. */
	assert_near(predict(&bench, 0, 0)->draw.cycles, wanted.cycles,
		0.02 * wanted.cycles);
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_costs_are_means_of_a_frame),
		cmocka_unit_test(test_a_level_of_detail_saves_posing),
		cmocka_unit_test(test_more_pixels_cost_more),
		cmocka_unit_test(test_nothing_is_saved_where_no_vertex_is_posed),
		cmocka_unit_test(test_the_compared_clip_is_drawn),
		cmocka_unit_test(test_without_such_a_clip_the_rest_pose_is_drawn),
		cmocka_unit_test(test_a_clip_costs_the_same_at_any_place),
		cmocka_unit_test(test_a_clip_fills_the_picture_that_is_drawn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
