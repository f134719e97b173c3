#include "platform/process/jobs.h"

#include "platform/process/background.h"

#include <unistd.h>

struct jobs {
	pthread_mutex_t lock;       /* for jobs_lock() */
	pthread_mutex_t count_lock; /* protects next and error */
	int count, next;
	int error;
	int (*run)(struct jobs *jobs, int job, void *context);
	void *context;
};

/* Returns the number of the next job, or -1 at the end or after an error. */
static int take(struct jobs *jobs)
{
	int job = -1;

	pthread_mutex_lock(&jobs->count_lock);
	if (!jobs->error && jobs->next < jobs->count) {
		job = jobs->next++;
	}
	pthread_mutex_unlock(&jobs->count_lock);
	return job;
}

static void keep_error(struct jobs *jobs, int error)
{
	pthread_mutex_lock(&jobs->count_lock);
	jobs->error = jobs->error ? jobs->error : error;
	pthread_mutex_unlock(&jobs->count_lock);
}

static void work(void *context)
{
	struct jobs *jobs = context;

	for (int job = take(jobs); job >= 0; job = take(jobs)) {
		int error = jobs->run(jobs, job, jobs->context);

		if (error) {
			keep_error(jobs, error);
		}
	}
}

int jobs_run(int count, int threads,
	int (*run)(struct jobs *jobs, int job, void *context), void *context)
{
	struct background background[JOBS_THREADS_MAX] = {{0}};
	struct jobs jobs = {.count = count, .run = run, .context = context};

	pthread_mutex_init(&jobs.lock, NULL);
	pthread_mutex_init(&jobs.count_lock, NULL);
	threads = threads < JOBS_THREADS_MAX ? threads : JOBS_THREADS_MAX;
	threads = threads < count ? threads : count;
	for (int i = 1; i < threads; i++) {
		background_begin(&background[i], work, &jobs);
	}
	work(&jobs);
	for (int i = 1; i < threads; i++) {
		background_wait(&background[i]);
	}
	pthread_mutex_destroy(&jobs.count_lock);
	pthread_mutex_destroy(&jobs.lock);
	return jobs.error;
}

void jobs_lock(struct jobs *jobs)
{
	pthread_mutex_lock(&jobs->lock);
}

void jobs_unlock(struct jobs *jobs)
{
	pthread_mutex_unlock(&jobs->lock);
}

int jobs_processors(void)
{
	long count = sysconf(_SC_NPROCESSORS_ONLN);

	if (count > JOBS_THREADS_MAX) {
		/* Not counted: a machine with so many processors. */
		return JOBS_THREADS_MAX;
	}
	return count > 1 ? (int)count : 1;
}
