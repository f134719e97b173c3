/*
 * The results of `limber bench`, printed as text or JSON.
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

/* The times of one kernel at one row. */
struct bench_result {
	const struct bench_row *row;
	const struct kernel *kernel;
	struct bench_time time[BENCH_SIZES_MAX];
};

struct bench_report {
	const char *mesh; /* the model's path, or NULL for generated meshes */
	int runs;
	int size_count;
	int vertex_count[BENCH_SIZES_MAX];
	int result_count;
	struct bench_result result[BENCH_RESULTS_MAX];
};

void bench_print_text(const struct bench_report *report, FILE *out);

/* Returns 0; or logs an error: -EINVAL if the path is not UTF-8, or -ENOMEM. */
int bench_print_json(
	const struct bench_report *report, const struct log *log, FILE *out);

#endif
