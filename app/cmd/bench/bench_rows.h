/*
 * What is measured: a line a row, for the host and for the timing model.
 */
#ifndef APP_CMD_BENCH_BENCH_ROWS_H
#define APP_CMD_BENCH_BENCH_ROWS_H

#include "app/cmd/bench/bench_job.h"

struct bench_row {
	const char *name;  /* for files and the command line */
	const char *title; /* for people */
	enum bench_work work;
	int influences; /* a vertex, of a made mesh, */
	int joint_sets; /* and how many sets of joints it has; 0: any */
};

/* All of them; the last has no name. */
extern const struct bench_row bench_rows[];

/* The same for a model's mesh. */
extern const struct bench_row bench_model_rows[];

#endif
