/*
 * One kernel at one piece of work, ready to be run over and over: what
 * `limber bench` times here, and what the timing model counts for the board.
 */
#ifndef APP_CMD_BENCH_BENCH_JOB_H
#define APP_CMD_BENCH_BENCH_JOB_H

#include "app/anim/kernel/kernel.h"
#include "app/cmd/bench/bench_mesh.h"

enum bench_work {
	BENCH_SKIN,          /* positions */
	BENCH_SKIN_NORMALS,  /* and normals */
	BENCH_SKIN_TANGENTS, /* and tangents */
	BENCH_LERP,          /* two key frames, positions */
	BENCH_LERP_NORMALS,  /* and normals */
	BENCH_TARGETS,       /* two weighted targets, positions */
	BENCH_BY_FRAMES,     /* the increment by frames, positions */
	BENCH_WORKS
};

struct bench_job {
	int vertex_count;
	void *state;
	void (*run)(void *state);
};

/*
 * Lays the mesh out as the kernel of that name wants it; all memory is the
 * arena's, and the mesh must outlive it. 0, -EINVAL when there is no such
 * kernel, -ENOTSUP when it has no such loop, or -ENOMEM.
 */
int bench_job_prepare(const char *kernel, const struct bench_mesh *mesh,
	enum bench_work work, struct arena *arena, struct bench_job *out);

/* One kind of loops, for bench_job.c. */
struct bench_loops {
	size_t state_size;
	/* In the order of enum bench_work; NULL: there is no such loop. */
	void (*run[BENCH_WORKS])(void *state);
	/* Fills a state of zeros; errors as bench_job_prepare(). */
	int (*prepare)(void *state, const struct kernel *kernel,
		const struct bench_mesh *mesh, enum bench_work work,
		struct arena *arena);
};

/* "an4044": the document's loops alone, nothing of limber around them. */
extern const struct bench_loops bench_an4044_loops;

/* Of kernels in fixed point. */
extern const struct bench_loops bench_fixed_loops;

#endif
