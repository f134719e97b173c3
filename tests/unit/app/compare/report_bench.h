/*
 * A comparison whose figures tests of the reports make up.
 */
#ifndef TESTS_UNIT_APP_COMPARE_REPORT_BENCH_H
#define TESTS_UNIT_APP_COMPARE_REPORT_BENCH_H

#include "app/compare/comparison.h"
#include "app/compare/report/report.h"
#include "tests/support/test.h"

#include <stdio.h>

enum {
	CLIPS = 2,
	ROWS = 3
};

static const struct board_profile board = {
	.name = "desk",
	.summary = "a test",
	.frame_ms = 20.0,
	.bytes_per_percent = 4096,
};

struct bench {
	struct model model;
	struct model_clip clip[3];
	float time_s[3];
	struct comparison comparison;
	struct comparison_clip compared[CLIPS];
	struct comparison_cell cell[ROWS][CLIPS];
	char *text;
	size_t size;
};

/* 532 cycles are a microsecond on the board. */
static inline struct board_cost us(double microseconds)
{
	return (struct board_cost){532.0 * microseconds, 7.0 * microseconds};
}

static inline void add_row(struct bench *bench, const char *name,
	enum technique technique, double unit)
{
	struct comparison *comparison = &bench->comparison;
	int number = comparison->row_count++;
	struct comparison_row *row = &comparison->row[number];

	snprintf(row->name, sizeof(row->name), "%s", name);
	row->technique = technique;
	row->listed = true;
	row->front = number != 1;
	row->cell = bench->cell[number];
	row->total = (struct comparison_total){
		.peak_px = (float)(1.25 * unit),
		.mean_px = (float)(0.125 * unit),
		.outline_px = (float)(0.5 * unit),
		.normal_deg = (float)(2.5 * unit),
		.shade_steps = (float)(3.5 * unit),
		.frame_us = 11.5 * unit,
		.instructions = number == 1 ? -1.0 : 45000.0 * unit,
		.board = us(900.0 * unit),
		.draw = us(600.0 * unit),
		.memory_bytes = (size_t)(2048.0 * unit),
		.file_bytes = (size_t)(3072.0 * unit),
		.key_count = 9,
	};
	for (int c = 0; c < CLIPS; c++) {
		double by = unit * (c + 1);
		struct comparison_cell *cell = &row->cell[c];

		cell->error = (struct candidate_error){
			.peak_px = (float)by, .peak_s = 0.5f, .samples = 10 + c};
		cell->time =
			(struct candidate_time){by, row->total.instructions};
		cell->board = (struct board_frame){us(10.0 * by), us(20.0 * by),
			us(30.0 * by), us(40.0 * by)};
		cell->bytes = (struct candidate_bytes){.shared = 1, .own = 2};
		cell->vertex_count = 321;
	}
}

static inline void begin(struct bench *bench)
{
	struct comparison *comparison = &bench->comparison;

	*bench = (struct bench){
		.clip = {{.name = "idle", .duration_s = 9.0f},
			{.name = "walk\tfast", .duration_s = 1.5f},
			{.name = "", .duration_s = 2.25f}},
		.time_s = {0.0f, 0.75f, 1.5f},
	};
	bench->model = (struct model){.path = "dog.glb",
		.clip_count = 3,
		.clip = bench->clip,
		.node_count = 1};
	*comparison = (struct comparison){
		.sampling = {.share = 1.0},
		.request = {.clip = -1,
			.rate_hz = 30.0,
			.bound_px = 1.5f,
			.board = &board,
			.width = 480,
			.height = 640,
			.kernel = &kernel_float},
		.model = &bench->model,
		.vertex_count = 321,
		.clip_count = CLIPS,
		.clip = bench->compared,
		.memory_limit_bytes = 50 * 1024,
		.time_limit_us = 12500.0,
		.advised = 2,
		.mixed_us = 777.0,
		.mixed_bytes = 5 * 1024,
		.reason = "it is the test",
	};
	for (int c = 0; c < CLIPS; c++) {
		bench->compared[c].clip = c + 1;
		bench->compared[c].row = c;
		bench->compared[c].grid =
			(struct time_grid){3, bench->time_s, false};
	}
	add_row(bench, "skin", TECHNIQUE_SKELETAL, 1.0);
	add_row(bench, "morph, 9 keys", TECHNIQUE_MORPHING, 2.0);
	add_row(bench, "rigid parts", TECHNIQUE_HIERARCHICAL, 4.0);
	/* A row beyond the last one, which no report may show. */
	comparison->row[ROWS] = comparison->row[0];
}

/* What a format prints; the caller frees bench->text. */
static inline const char *print(struct bench *bench, const char *format)
{
	FILE *out = open_memstream(&bench->text, &bench->size);

	assert_non_null(out);
	assert_int_equal(report_find(format)->print(&bench->comparison, out), 0);
	fclose(out);
	return bench->text;
}

#endif
