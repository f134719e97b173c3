/*
 * Comparisons whose figures tests of the advice make up.
 */
#ifndef TESTS_UNIT_APP_COMPARE_ADVICE_BENCH_H
#define TESTS_UNIT_APP_COMPARE_ADVICE_BENCH_H

#include "app/anim/kernel/arm11_cost.h"
#include "app/compare/comparison.h"

#include <stdio.h>

enum {
	CLIPS = 2,
	CLIPS_MOST = 4,
	ROWS = 6
};

/* 100 us are a hundredth of the frame, and so are 1024 bytes. */
static const struct board_profile board = {
	.name = "test",
	.ram_bytes = 900000,
	.taken_bytes = 500000,
	.frame_ms = 10.0,
	.bytes_per_percent = 1024,
};

struct bench {
	struct comparison comparison;
	struct comparison_clip clip[CLIPS_MOST];
	struct comparison_cell cell[ROWS][CLIPS_MOST];
};

static inline void begin(struct bench *bench)
{
	*bench = (struct bench){
		.comparison = {.request = {.clip = -1,
				       .bound_px = 2.0f,
				       .board = &board},
			.clip_count = CLIPS,
			.clip = bench->clip},
	};
}

/* Measured costs contradict the predicted ones, which have to count. */
static inline void set_cell(struct comparison_cell *cell, double us)
{
	cell->time.frame_us = 1e6 / us;
	cell->time.instructions = 1e9 / us;
	cell->board.vertices.cycles = (double)ARM11_MHZ * us;
}

/* Adds a row that is listed, whose clips all cost the same. */
static inline struct comparison_row *add(
	struct bench *bench, double us, double kib, float peak_px)
{
	struct comparison *comparison = &bench->comparison;
	int number = comparison->row_count++;
	struct comparison_row *row = &comparison->row[number];

	snprintf(row->name, sizeof(row->name), "row %d", number);
	row->listed = true;
	row->cell = bench->cell[number];
	row->total = (struct comparison_total){
		.peak_px = peak_px,
		.frame_us = 1e6 / us,
		.instructions = 1e9 / us,
		.board = {.cycles = (double)ARM11_MHZ * us},
		.memory_bytes = (size_t)(1024.0 * kib + 0.5),
	};
	for (int c = 0; c < CLIPS; c++) {
		set_cell(&row->cell[c], us);
		row->cell[c].error.peak_px = peak_px;
		row->cell[c].bytes.own = row->total.memory_bytes / CLIPS;
	}
	return row;
}

#endif
