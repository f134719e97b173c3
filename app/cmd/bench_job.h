/*
 * One kernel at one piece of work, ready to be run over and over: what
 * `limber bench` times here, and what the timing model counts for the board.
 */
#ifndef APP_CMD_BENCH_JOB_H
#define APP_CMD_BENCH_JOB_H

#include "app/anim/kernel/kernel.h"
#include "app/cmd/bench_mesh.h"

enum bench_work {
	BENCH_SKIN,          /* positions */
	BENCH_SKIN_NORMALS,  /* and normals */
	BENCH_SKIN_TANGENTS, /* and tangents */
	BENCH_LERP,          /* two key frames, positions */
	BENCH_LERP_NORMALS,  /* and normals */
	BENCH_TARGETS,       /* two weighted targets, positions */
	BENCH_BY_FRAMES,     /* the increment by frames, positions */
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

/* "an4044": the document's loops alone, nothing of limber around them. */
int bench_an4044_prepare(const struct bench_mesh *mesh, enum bench_work work,
	struct arena *arena, struct bench_job *out);

/* For kernels with loops in fixed point. */
int bench_fixed_prepare(const struct fixed_loops *loops,
	const struct bench_mesh *mesh, enum bench_work work,
	struct arena *arena, struct bench_job *out);

#endif
