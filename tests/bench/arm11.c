/*
 * Runs one vertex loop of one kernel between markers of the timing model
 * (tests/arm1136). arm11.py runs it and reads the model's report.
 *
 *	arm11 ROW KERNEL VERTICES|MODEL
 *	arm11 update KERNEL MODEL
 *
 * ROW is one of app/cmd/bench/bench_rows.c; update is all that a posed model
 * needs before it is drawn, in the middle of its first clip.
 *
 * Region 1 is a pass with warm caches, region 2 one with all data in memory. It
 * prints "count N", the vertices of a pass, and ends with status 3 when the
 * kernel has no such loop.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

#include "app/anim/clip.h"
#include "app/cmd/bench/bench_rows.h"
#include "app/scene/instance/instance.h"
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

static void measure(const struct bench_job *job)
{
	/* The model starts with empty caches at the first marker. */
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

static void update(void *user)
{
	instance_update(user);
}

static int pose(struct instance *instance)
{
	const struct model *model = instance->model;
	struct clip_cursor cursor;
	int error = clip_cursor_init(&cursor, model, &instance->arena);

	if (!error && model->clip_count > 0) {
		const struct model_clip *clip = &model->clip[0];

		clip_sample(clip, clip->duration_s * 0.5f, &cursor,
			&instance->pose);
	}
	return error;
}

static int measure_update(const char *kernel_name, const struct model *model,
	const struct log *log)
{
	const struct kernel *kernel = kernel_find(kernel_name);
	struct instance *instance;
	struct bench_job job = {.run = update};
	int error;

	if (!kernel) {
		return -EINVAL;
	}
	error = instance_create(model, kernel, log, &instance);
	if (error) {
		return error;
	}
	error = pose(instance);
	if (!error) {
		job.state = instance;
		for (int i = 0; i < instance->drawable_count; i++) {
			job.vertex_count +=
				instance->drawable[i].primitive->vertex_count;
		}
		printf("count %d\n", job.vertex_count);
		measure(&job);
	}
	instance_destroy(instance);
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
		if (!error && row) {
			error = bench_mesh_of_model(&mesh, model);
		}
	}
	if (!error && !row) {
		error = measure_update(kernel, model, &log);
	} else if (!error) {
		error = measure_mesh(row, kernel, &mesh);
		bench_mesh_release(&mesh);
	}
	model_destroy(model);
	if (error == -EINVAL || error == -ENOTSUP) {
		return 3;
	}
	if (error) {
		fprintf(stderr, "arm11: %s, %s: %s\n", kernel, from,
			strerror(-error));
	}
	return error ? EXIT_FAILURE : EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
	const struct bench_row *row = argc == 4 ? find_row(argv[1]) : NULL;

	/* With a random seed, addresses would differ from run to run. */
	json_object_seed(1);
	if (!row && (argc != 4 || strcmp(argv[1], "update") != 0)) {
		fprintf(stderr,
			"usage: %s ROW KERNEL VERTICES|MODEL\n"
			"       %s update KERNEL MODEL\n",
			argv[0], argv[0]);
		return 2;
	}
	return run(row, argv[2], argv[3]);
}
