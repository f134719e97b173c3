/* What drawing is predicted to cost, without measuring a comparison before. */
#include "app/compare/comparison_draw.h"
#include "app/compare/cost/board_cost.h"
#include "app/compare/cost/drawing.h"
#include "app/model/levels/levels.h"
#include "app/scene/instance/instance_play.h"
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

static void remove_normals(const struct model *model)
{
	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			mesh->primitive[p].normal = NULL;
		}
	}
}

/* The walker in a small picture, in which a level of detail is drawn. */
static void begin_walker(struct bench *bench, bool flat)
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
	if (flat) {
		remove_normals(bench->model);
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

/* The same with flat normals, for which key frames have a file of their own. */
static void begin(struct bench *bench)
{
	begin_walker(bench, true);
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

/* What the model's posing takes less as not all of its vertices are drawn. */
static void add_saved(const struct instance *instance, bool keys, double share,
	struct board_cost *saved)
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		struct board_cost parts[3] = {{0, 0}};
		static const double signs[3] = {1, -1, 1};

		if (keys || drawable->morphed || drawable->skin >= 0) {
			parts[1] = board_cost_gather_drawn(drawable);
		}
		if (!keys && (drawable->morphed || drawable->skin >= 0)) {
			parts[0] = board_cost_gather(drawable);
		}
		if (!keys && drawable->skin >= 0) {
			parts[2] = board_cost_skin_left_out(drawable);
		}
		for (int k = 0; k < 3; k++) {
			saved->cycles += share * signs[k] * parts[k].cycles;
			saved->instructions +=
				share * signs[k] * parts[k].instructions;
		}
	}
}

/* A player of the test's own. */
struct player {
	struct instance *instance;
	struct drawing *drawing;
	struct clip_cursor cursor;
	float extent;
};

static void begin_player(
	struct player *player, const struct bench *bench, bool keys)
{
	const struct comparison *comparison = &bench->comparison;
	struct log log = log_to_stderr(LOG_WARNING);
	struct bounds box = comparison->box;

	assert_int_equal(instance_create_to_play(bench->model,
				 kernel_find("fixed"), &log, &player->instance),
		0);
	assert_int_equal(clip_cursor_init(&player->cursor, bench->model,
				 &player->instance->arena),
		0);
	for (int axis = 0; axis < 3; axis++) {
		box.low[axis] *= player->instance->unit_scale;
		box.high[axis] *= player->instance->unit_scale;
	}
	player->instance->normal_mapping = false;
	player->extent = drawing_extent(player->instance);
	assert_int_equal(
		drawing_create(player->instance, &box, comparison->request.width,
			comparison->request.height, &log, &player->drawing),
		0);
	if (keys) {
		drawing_show_keys(player->drawing);
	}
}

/* Shows the moment after a share of a clip. */
static void show(
	struct player *player, const struct model_clip *clip, double share)
{
	struct instance *instance = player->instance;

	clip_pose(clip, (float)(share * (double)clip->duration_s), CLIP_AUTO,
		&player->cursor, &instance->pose);
	instance_update(instance);
	drawing_draw(player->drawing, instance, player->extent);
}

/* The mean of frames in the middle of equal parts of a clip. */
static void play(struct player *player, const struct bench *bench, int index,
	bool keys, struct board_cost *draw, struct board_cost *saved)
{
	const struct comparison *comparison = &bench->comparison;
	int frames = comparison->sampling.drawn_frames;
	const struct model_clip *clip =
		&bench->model->clip[bench->clip[index].clip];
	struct bounds box =
		bounds_of_clip(player->instance, bench->clip[index].clip);
	struct gl_counts counts = {0};
	struct drawing_shadow shadow = {0};
	struct board_cost laid;

	*saved = (struct board_cost){0, 0};
	drawing_frame(player->drawing, &box);
	player->instance->lod_px_per_unit = 0.0f;
	show(player, clip, 0.0); /* chooses levels of detail */
	drawing_count(player->drawing, &counts, &shadow);
	for (int i = 0; i < frames; i++) {
		show(player, clip, (i + 0.5) / frames);
		add_saved(player->instance, keys, 1.0 / frames, saved);
	}
	drawing_count(player->drawing, NULL, NULL);
	gl_counts_scale(&counts, 1.0 / frames);
	*draw = board_cost_draw(&counts,
		(double)(comparison->request.width * comparison->request.height));
	laid = board_cost_lay(shadow.points / frames, shadow.rays / frames);
	draw->cycles += laid.cycles;
	draw->instructions += laid.instructions;
}

/* Posing was 1e9, so that its difference has fewer digits. */
static void expect_played(
	const struct bench *bench, int row, int clip, struct player *player)
{
	const struct board_frame *found = &bench->cell[row][clip].board;
	struct board_cost draw, saved;

	play(player, bench, clip, row > 0, &draw, &saved);
	assert_near(found->draw.cycles, draw.cycles, 1e-6 * draw.cycles);
	assert_near(found->draw.instructions, draw.instructions,
		1e-6 * draw.instructions);
	assert_near(1e9 - found->vertices.cycles, saved.cycles, 0.1);
	assert_near(1e9 - found->vertices.instructions, saved.instructions, 0.1);
}

/* Key frames, all alike, choose other levels of detail than the model. */
static void test_costs_are_those_of_a_player(void **state)
{
	struct bench bench;

	(void)state;
	begin_walker(&bench, false);
	predict(&bench, 0, 0);
	for (int keys = 0; keys < 2; keys++) {
		struct player player;

		begin_player(&player, &bench, keys);
		for (int c = 0; c < CLIPS; c++) {
			expect_played(&bench, keys, c, &player);
			expect_cost(&bench.cell[2][c].board.draw,
				&bench.cell[1][c].board.draw);
			expect_cost(&bench.cell[2][c].board.vertices,
				&bench.cell[1][c].board.vertices);
		}
		drawing_destroy(player.drawing);
		instance_destroy(player.instance);
	}
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_costs_are_those_of_a_player),
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
