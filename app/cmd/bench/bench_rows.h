/*
 * The measurements of `limber bench` and of the timing model.
 */
#ifndef APP_CMD_BENCH_BENCH_ROWS_H
#define APP_CMD_BENCH_BENCH_ROWS_H

#include "app/cmd/bench/bench_job.h"

struct bench_row {
	const char *name;  /* in files and on the command line */
	const char *title; /* in tables */
	enum bench_work work;
	/* Of a generated mesh, see bench_mesh_make(). */
	int influences;
	int joint_sets;
};

/* The rows for generated meshes; the last one has no name. */
extern const struct bench_row bench_rows[];

/* The rows for a model's mesh; the last one has no name. */
extern const struct bench_row bench_model_rows[];

#endif
