/*
 * A job: one loop of one kernel on one mesh, ready to run any number of times.
 * `limber bench` times jobs, and the timing model of the board's core counts
 * their cycles.
 */
#ifndef APP_CMD_BENCH_BENCH_JOB_H
#define APP_CMD_BENCH_BENCH_JOB_H

#include "app/anim/kernel/kernel.h"
#include "app/cmd/bench/bench_mesh.h"

enum bench_work {
	BENCH_SKIN,          /* positions */
	BENCH_SKIN_NORMALS,  /* and normals */
	BENCH_SKIN_TANGENTS, /* and tangents */
	BENCH_LERP,          /* between two key frames, positions */
	BENCH_LERP_NORMALS,  /* and normals */
	BENCH_TARGETS,       /* two weighted targets, positions */
	BENCH_BY_FRAMES,     /* AN4044's increment by frames, positions */
	BENCH_LERP_KEYS,     /* BENCH_LERP between struct fixed_key arrays */
	BENCH_WORKS
};

struct bench_job {
	int vertex_count;
	void *state;
	void (*run)(void *state);
};

/*
 * Converts the mesh to the layout of the kernel of that name. The arena owns
 * the job's memory; the mesh must outlive the job. Returns 0, -EINVAL if there
 * is no such kernel, -ENOTSUP if it has no such loop or the mesh exceeds the
 * range of its numbers, or -ENOMEM.
 */
int bench_job_prepare(const char *kernel, const struct bench_mesh *mesh,
	enum bench_work work, struct arena *arena, struct bench_job *out);

/* The loops of one kind of kernel; for bench_job.c. */
struct bench_loops {
	size_t state_size;
	/* Indexed by enum bench_work; NULL: there is no such loop. */
	void (*run[BENCH_WORKS])(void *state);
	/* Fills a zeroed state. Returns 0, -ENOTSUP or -ENOMEM. */
	int (*prepare)(void *state, const struct kernel *kernel,
		const struct bench_mesh *mesh, enum bench_work work,
		struct arena *arena);
};

/* The loops exactly as AN4044 prints them. */
extern const struct bench_loops bench_an4044_loops;

/* The loops of float kernels. */
extern const struct bench_loops bench_float_loops;

/* The loops of fixed-point kernels. */
extern const struct bench_loops bench_fixed_loops;

#endif
