/*
 * Runs one kernel at one piece of work between the markers of the timing model
 * (tests/arm1136); arm11.py reads what the model says and makes a table of it.
 *
 *	arm11 list
 *	arm11 ROW KERNEL VERTICES|MODEL
 *
 * Region 1 is a pass right after others, region 2 one with all data in memory.
 * Prints "count N", the vertices of a pass. Exit status 3: the kernel has no
 * such loop.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/cmd/bench_rows.h"
#include "tests/arm1136/marker.h"

static const struct bench_row *find_row(const char *name)
{
	for (const struct bench_row *row = bench_rows; row->name; row++) {
		if (strcmp(row->name, name) == 0) {
			return row;
		}
	}
	return NULL;
}

static void list(void)
{
	for (const struct bench_row *row = bench_rows; row->name; row++) {
		printf("row\t%s\t%s\n", row->name, row->title);
	}
	for (int i = 0; kernel_registry[i]; i++) {
		printf("kernel\t%s\n", kernel_registry[i]->name);
	}
}

static void measure(const struct bench_job *job)
{
	/* The model wakes up with empty caches at the first marker. */
	MARKER_BEGIN(0);
	MARKER_END(0);
	job->run(job->state);
	job->run(job->state);
	MARKER_BEGIN(1);
	job->run(job->state);
	MARKER_END(1);
	MARKER_FLUSH(MARKER_DATA);
	MARKER_FLUSH(MARKER_PAGES);
	MARKER_BEGIN(2);
	job->run(job->state);
	MARKER_END(2);
}

static int measure_mesh(const struct bench_row *row, const char *kernel,
	const struct bench_mesh *mesh)
{
	struct arena arena = arena_empty();
	struct bench_job job;
	int error = bench_job_prepare(kernel, mesh, row->work, &arena, &job);

	if (!error) {
		printf("count %d\n", job.vertex_count);
		measure(&job);
	}
	arena_release(&arena);
	return error;
}

static int run(const struct bench_row *row, const char *kernel, const char *from)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct model *model = NULL;
	struct bench_mesh mesh;
	int error;

	if (atoi(from) > 0) {
		error = bench_mesh_make(
			&mesh, atoi(from), row->influences, row->joint_sets);
	} else {
		error = model_load(from, &log, &model);
		if (!error) {
			error = bench_mesh_of_model(&mesh, model);
		}
	}
	if (!error) {
		error = measure_mesh(row, kernel, &mesh);
		bench_mesh_release(&mesh);
	}
	model_destroy(model);
	if (error == -EINVAL || error == -ENOTSUP) {
		return 3;
	}
	if (error) {
		fprintf(stderr, "arm11: %s, %s, %s: %s\n", row->name, kernel,
			from, strerror(-error));
	}
	return error ? EXIT_FAILURE : EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
	const struct bench_row *row = argc == 4 ? find_row(argv[1]) : NULL;

	if (argc == 2 && strcmp(argv[1], "list") == 0) {
		list();
		return EXIT_SUCCESS;
	}
	if (!row) {
		fprintf(stderr, "usage: %s list | ROW KERNEL VERTICES|MODEL\n",
			argv[0]);
		return 2;
	}
	return run(row, argv[2], argv[3]);
}
