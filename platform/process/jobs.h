/*
 * Independent jobs that several threads do.
 */
#ifndef PLATFORM_PROCESS_JOBS_H
#define PLATFORM_PROCESS_JOBS_H

enum {
	JOBS_THREADS_MAX = 64
};

struct jobs;

/*
 * Calls run(jobs, job, context) once for each job from 0 to count - 1, in this
 * order, in up to threads threads, of which the caller's is one. Returns when
 * all are done. After a job returns an error, no further job begins. Returns 0
 * or the error that came first.
 */
int jobs_run(int count, int threads,
	int (*run)(struct jobs *jobs, int job, void *context), void *context);

/* A job calls these around code that only one job may run at a time. */
void jobs_lock(struct jobs *jobs);
void jobs_unlock(struct jobs *jobs);

/* The number of processors that may run threads now, at least 1. */
int jobs_processors(void);

#endif
