/*
 * What is measured: a line a row, for the host and for the timing model.
 */
#ifndef APP_CMD_BENCH_ROWS_H
#define APP_CMD_BENCH_ROWS_H

#include "app/cmd/bench_job.h"

struct bench_row {
	const char *name;  /* for files and the command line */
	const char *title; /* for people */
	enum bench_work work;
	int influences; /* a vertex, of a made mesh */
};

/* All of them; the last has no name. */
extern const struct bench_row bench_rows[];

#endif
