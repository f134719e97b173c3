/*
 * Times a job on the machine that limber runs on.
 */
#ifndef APP_CMD_BENCH_BENCH_TIME_H
#define APP_CMD_BENCH_BENCH_TIME_H

#include "app/cmd/bench/bench_job.h"

/* Nanoseconds a vertex, the median of all runs. */
struct bench_time {
	double warm_ns; /* run after run */
	double cold_ns; /* after the caches were filled with other data */
};

/* A buffer that replaces a job's data in the caches. */
struct bench_evictor {
	struct arena arena;
	size_t count;
	uint64_t *data; /* [count] */
};

/* Returns 0 or -ENOMEM. */
int bench_evictor_init(struct bench_evictor *evictor);
void bench_evictor_release(struct bench_evictor *evictor);

enum {
	BENCH_RUNS_MAX = 1001
};

/* Times the job; runs is 1 to BENCH_RUNS_MAX. */
struct bench_time bench_time_job(
	const struct bench_job *job, struct bench_evictor *evictor, int runs);

#endif
