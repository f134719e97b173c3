#include "app/cmd/bench/bench_time.h"

#include "platform/process/clock.h"

#include <errno.h>
#include <stdlib.h>

enum {
	/* Larger than the caches of ARM11 boards and of most PCs. */
	EVICT_BYTES = 32 * 1024 * 1024,
	/* The ARM11 has the shortest cache lines of these: 32 bytes. */
	LINE_WORDS = 4
};

/* Long enough for the clock's resolution and overhead not to matter. */
static const double shortest_s = 20e-6;

int bench_evictor_init(struct bench_evictor *evictor)
{
	*evictor = (struct bench_evictor){
		.arena = arena_empty(),
		.count = EVICT_BYTES / sizeof(uint64_t),
	};
	evictor->data = ARENA_ARRAY(&evictor->arena, uint64_t, evictor->count);
	return evictor->data ? 0 : -ENOMEM;
}

void bench_evictor_release(struct bench_evictor *evictor)
{
	arena_release(&evictor->arena);
}

/* Writing makes every cache line belong to this buffer. */
static void evict(struct bench_evictor *evictor)
{
	for (size_t i = 0; i < evictor->count; i += LINE_WORDS) {
		evictor->data[i]++;
	}
}

static double run_seconds(const struct bench_job *job, int times)
{
	struct clock clock = clock_real();

	for (int i = 0; i < times; i++) {
		job->run(job->state);
	}
	return clock_tick(&clock);
}

static int compare(const void *a, const void *b)
{
	double left = *(const double *)a;
	double right = *(const double *)b;

	return left < right ? -1 : left > right;
}

static double median(double *value, int count)
{
	qsort(value, (size_t)count, sizeof(*value), compare);
	return count % 2 ? value[count / 2]
			 : (value[count / 2 - 1] + value[count / 2]) / 2;
}

/* Finds how often a job must run to take shortest_s, and warms the caches. */
static int repeats(const struct bench_job *job)
{
	int times = 1;

	while (times < 1 << 20 && run_seconds(job, times) < shortest_s) {
		times *= 2;
	}
	return times;
}

struct bench_time bench_time_job(
	const struct bench_job *job, struct bench_evictor *evictor, int runs)
{
	double warm_s[BENCH_RUNS_MAX], cold_s[BENCH_RUNS_MAX];
	double to_ns = 1e9 / job->vertex_count;
	int times = repeats(job);

	for (int i = 0; i < runs; i++) {
		warm_s[i] = run_seconds(job, times) / times;
	}
	for (int i = 0; i < runs; i++) {
		evict(evictor);
		cold_s[i] = run_seconds(job, 1);
	}
	return (struct bench_time){
		.warm_ns = median(warm_s, runs) * to_ns,
		.cold_ns = median(cold_s, runs) * to_ns,
	};
}
