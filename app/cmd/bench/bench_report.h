/*
 * What `limber bench` found out, and how it is told.
 */
#ifndef APP_CMD_BENCH_BENCH_REPORT_H
#define APP_CMD_BENCH_BENCH_REPORT_H

#include <stdio.h>

#include "app/cmd/bench/bench_rows.h"
#include "app/cmd/bench/bench_time.h"

enum {
	BENCH_SIZES_MAX = 3,
	BENCH_RESULTS_MAX = 256
};

/* A kernel at a piece of work, in all sizes. */
struct bench_result {
	const struct bench_row *row;
	const struct kernel *kernel;
	struct bench_time time[BENCH_SIZES_MAX];
};

struct bench_report {
	const char *mesh; /* a model's path, or NULL for made ones */
	int runs;
	int size_count;
	int vertex_count[BENCH_SIZES_MAX];
	int result_count;
	struct bench_result result[BENCH_RESULTS_MAX];
};

void bench_print_text(const struct bench_report *report, FILE *out);

/* 0, or -EINVAL after a sentence when it cannot be told in JSON. */
int bench_print_json(
	const struct bench_report *report, const struct log *log, FILE *out);

#endif
