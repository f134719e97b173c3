/* Which rows a model gets, and their sums over its clips. */
#include "app/compare/comparison_rows.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	CLIPS = 2
};

/* A node with a mesh of one vertex; two clips of one channel each. */
struct fixture {
	struct bones bones;
	float position[1][3], weight[8];
	uint16_t joint[8];
	struct model_target target[3];
	struct model_primitive primitive;
	struct model_skin skin;
	struct model_channel channel[CLIPS];
	struct model_clip clip[CLIPS];
	struct comparison_clip compared[CLIPS];
	struct comparison comparison;
};

static void begin(struct fixture *f, int influences, int targets)
{
	memset(f, 0, sizeof(*f));
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 0, 0, 0);
	f->bones.node[0].mesh = 0;
	f->primitive = (struct model_primitive){.vertex_count = 1,
		.position = f->position,
		.influences = influences > 0 ? 8 : 0,
		.joint = f->joint,
		.weight = f->weight,
		.target = f->target};
	for (int i = 0; i < influences; i++) {
		f->weight[i] = 1.0f / (float)influences;
	}
	f->bones.mesh[0] = (struct model_mesh){.primitive_count = 1,
		.primitive = &f->primitive,
		.target_count = targets};
	f->bones.model.skin = &f->skin;
	f->bones.model.skin_count = influences > 0;
	f->bones.model.clip = f->clip;
	f->bones.model.clip_count = CLIPS;
	for (int i = 0; i < CLIPS; i++) {
		f->channel[i].path = MODEL_WEIGHTS;
		f->clip[i] = (struct model_clip){
			.channel_count = 1, .channel = &f->channel[i]};
		f->compared[i].clip = i;
	}
	f->comparison = (struct comparison){.model = &f->bones.model,
		.clip = f->compared,
		.clip_count = CLIPS,
		.sampling = {.share = 1.0},
		.request = {.bound_px = 0.5f}};
}

static void end(struct fixture *f)
{
	for (int i = 0; i < f->comparison.row_count; i++) {
		free(f->comparison.row[i].cell);
	}
	bones_end(&f->bones);
}

/* The names of the listed rows, each followed by a bar. */
static void expect_rows(struct fixture *f, const char *wanted)
{
	const struct comparison *comparison = &f->comparison;
	char names[400] = "";
	int listed = 0;

	assert_int_equal(comparison_rows_choose(&f->comparison), 0);
	for (int i = 0; i < comparison->row_count; i++) {
		const struct comparison_row *row = &comparison->row[i];

		assert_non_null(row->cell);
		if (row->listed) {
			assert_int_equal(i, listed);
			listed++;
			strcat(strcat(names, row->name), "|");
		}
	}
	assert_string_equal(names, wanted);
	/* Four others are in the plot alone. */
	assert_int_equal(comparison->row_count, listed + 4);
	for (int i = 0; i < 4; i++) {
		static const float bound_px[] = {0.125f, 0.25f, 1.0f, 2.0f};
		const struct comparison_row *row = &comparison->row[listed + i];

		assert_int_equal(row->kind, COMPARISON_MORPH);
		assert_int_equal(row->technique, TECHNIQUE_MORPHING);
		assert_near(row->bound_px, bound_px[i], 0);
	}
}

static const struct comparison_row *row_named(
	const struct fixture *f, const char *name)
{
	for (int i = 0; i < f->comparison.row_count; i++) {
		if (strcmp(f->comparison.row[i].name, name) == 0) {
			return &f->comparison.row[i];
		}
	}
	fail_msg("no row %s", name);
	return NULL;
}

static void test_a_skin_with_targets_has_rows_without_each(void **state)
{
	const struct comparison_row *row;
	struct fixture f;

	(void)state;
	begin(&f, 5, 3);
	f.channel[1].path = MODEL_ROTATION;
	expect_rows(&f,
		"skin + morph|skin|skin + morph, 4 influences|"
		"skin + morph, 2 influences|skin + morph, 1 influence|morph|"
		"morph|rigid parts|");
	row = row_named(&f, "skin");
	assert_int_equal(row->kind, COMPARISON_ORIGINAL);
	assert_int_equal(row->technique, TECHNIQUE_SKELETAL);
	assert_int_equal(row->max_influences, 0);
	assert_false(row->targets);
	row = row_named(&f, "skin + morph, 2 influences");
	assert_int_equal(row->technique, TECHNIQUE_COMBINED);
	assert_int_equal(row->max_influences, 2);
	assert_true(row->targets);
	row = row_named(&f, "rigid parts");
	assert_int_equal(row->kind, COMPARISON_RIGID);
	assert_int_equal(row->technique, TECHNIQUE_HIERARCHICAL);
	row = row_named(&f, "morph");
	assert_int_equal(row->kind, COMPARISON_MORPH);
	assert_near(row->bound_px, 0.5, 0);
	assert_int_equal(row[1].kind, COMPARISON_MORPH_EVEN);
	end(&f);
}

/* No cap above what the model has anyway. */
static void test_caps_are_below_the_most_influences(void **state)
{
	static const char *const wanted[] = {"skin|morph|morph|",
		"skin|skin, 1 influence|morph|morph|",
		"skin|skin, 2 influences|skin, 1 influence|morph|morph|",
		"skin|skin, 2 influences|skin, 1 influence|morph|morph|"};

	(void)state;
	for (int influences = 1; influences <= 4; influences++) {
		struct fixture f;

		begin(&f, influences, 0);
		expect_rows(&f, wanted[influences - 1]);
		end(&f);
	}
}

static void test_models_without_skins_are_nodes_or_targets(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 0, 0);
	f.channel[0].path = MODEL_SCALE;
	expect_rows(&f, "nodes as they are|morph|morph|");
	assert_int_equal(f.comparison.row[0].technique, TECHNIQUE_HIERARCHICAL);
	end(&f);
	begin(&f, 0, 1);
	f.channel[0].path = MODEL_SCALE;
	expect_rows(&f, "morph targets|morph|morph|rigid parts|");
	assert_int_equal(f.comparison.row[0].technique, TECHNIQUE_MORPHING);
	end(&f);
}

/* Rigid parts need a node that moves in a clip that is compared. */
static void test_rigid_parts_need_a_node_that_moves(void **state)
{
	struct fixture f;

	(void)state;
	for (int clips = 1; clips <= CLIPS; clips++) {
		for (int constant = 0; constant < 2; constant++) {
			begin(&f, 1, 0);
			f.comparison.clip_count = clips;
			f.channel[1].path = MODEL_ROTATION;
			f.channel[1].constant = constant;
			expect_rows(&f,
				clips == 2 && !constant
					? "skin|morph|morph|rigid parts|"
					: "skin|morph|morph|");
			end(&f);
		}
	}
}

static struct comparison_cell cell_of(float error, double cost, size_t bytes)
{
	return (struct comparison_cell){
		.error = {.peak_px = error,
			.mean_px = error / 2,
			.outline_px = error / 4,
			.normal_deg = error * 2,
			.shade_steps = error * 4},
		.time = {.frame_us = cost, .instructions = cost * 2},
		.board = {.sample = {cost, 1},
			.matrices = {cost * 2, 2},
			.vertices = {cost * 4, 4},
			.draw = {cost * 8, 8}},
		.bytes = {bytes, bytes * 10, bytes * 100, bytes * 1000},
	};
}

/* Errors are the largest or the mean, costs the mean, bytes the sum. */
static void test_clips_are_summed_up(void **state)
{
	struct comparison_cell cells[CLIPS] = {
		cell_of(1.0f, 100.0, 7), cell_of(0.5f, 300.0, 9)};
	struct comparison comparison = {.clip_count = CLIPS, .row_count = 1};
	const struct comparison_total *total = &comparison.row[0].total;

	(void)state;
	comparison.row[0] =
		(struct comparison_row){.name = "skin", .cell = cells};
	for (int larger = 0; larger < CLIPS; larger++) {
		comparison_rows_sum_up(&comparison);
		assert_int_equal(total->peak_clip, larger);
		assert_near(total->peak_px, 1, 0);
		assert_near(total->mean_px, 0.375, 1e-6);
		assert_near(total->outline_px, 0.25, 0);
		assert_near(total->normal_deg, 2, 0);
		assert_near(total->shade_steps, 4, 0);
		assert_near(total->frame_us, 200, 1e-3);
		assert_near(total->instructions, 400, 1e-3);
		assert_near(total->board.cycles, 15 * 200, 1e-3);
		assert_near(total->board.instructions, 15, 1e-6);
		assert_near(total->draw.cycles, 8 * 200, 1e-3);
		assert_near(total->draw.instructions, 8, 1e-6);
		/* What clips share is counted once. */
		assert_int_equal(
			total->memory_bytes, larger ? 9 + 160 : 7 + 160);
		assert_int_equal(
			total->file_bytes, larger ? 900 + 16000 : 700 + 16000);
		assert_int_equal(total->key_count, 0);
		assert_string_equal(comparison.row[0].name, "skin");
		cells[0] = cell_of(0.5f, 300.0, 9);
		cells[1] = cell_of(1.0f, 100.0, 7);
	}
}

/* Each key of each clip has a weight for each of all keys. */
static void test_morphs_are_named_by_their_keys(void **state)
{
	static const struct {
		enum comparison_kind kind;
		bool listed;
		float bound_px;
		const char *name;
	} cases[] = {
		{COMPARISON_MORPH, true, 1.0f, "morph, 8 keys fitted"},
		{COMPARISON_MORPH, true, 0.9f, "morph, 8 keys"},
		{COMPARISON_MORPH, false, 1.0f, "morph, 8 keys"},
		{COMPARISON_MORPH_EVEN, true, 1.0f, "morph, 8 keys"},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct comparison_cell cells[CLIPS] = {
			cell_of(1.0f, 1.0, 1), cell_of(0.5f, 1.0, 1)};
		struct comparison comparison = {
			.clip_count = CLIPS, .row_count = 1};
		struct comparison_row *row = &comparison.row[0];

		cells[0].keys.count = 3;
		cells[1].keys.count = 5;
		*row = (struct comparison_row){.kind = cases[i].kind,
			.listed = cases[i].listed,
			.bound_px = cases[i].bound_px,
			.cell = cells};
		comparison_rows_sum_up(&comparison);
		assert_int_equal(row->total.key_count, 8);
		assert_string_equal(row->name, cases[i].name);
		/* 4 bytes each in memory, 5 of those that are not 0 in the file */
		assert_int_equal(row->total.memory_bytes, 21 + 8 * 8 * 4);
		assert_int_equal(row->total.file_bytes, 2100 + 8 * 5);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_skin_with_targets_has_rows_without_each),
		cmocka_unit_test(test_caps_are_below_the_most_influences),
		cmocka_unit_test(test_models_without_skins_are_nodes_or_targets),
		cmocka_unit_test(test_rigid_parts_need_a_node_that_moves),
		cmocka_unit_test(test_clips_are_summed_up),
		cmocka_unit_test(test_morphs_are_named_by_their_keys),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
