#include "app/cmd/bench/bench_report.h"
#include "app/cmd/command.h"
#include "app/cmd/options/options_kernel.h"

#include <errno.h>

/*
 * Vertices of meshes whose data fit a first-level cache, a second-level cache,
 * or neither.
 */
static const int made_sizes[] = {256, 4096, 65536};

struct bench {
	const struct options *options;
	const struct log *log;
	const struct model *model; /* or NULL */
	struct bench_evictor evictor;
	struct bench_report report;
};

static int make_mesh(const struct bench *bench, const struct bench_row *row,
	int size, struct bench_mesh *mesh)
{
	return bench->model ? bench_mesh_of_model(mesh, bench->model)
			    : bench_mesh_make(mesh, made_sizes[size],
				      row->influences, row->joint_sets);
}

/*
 * Times one job. Returns 0, -ENOTSUP if the kernel has no such loop or the mesh
 * exceeds the range of its numbers, or -ENOMEM.
 */
static int measure(struct bench *bench, const struct bench_mesh *mesh,
	const struct bench_row *row, const struct kernel *kernel,
	struct bench_time *out)
{
	struct arena arena = arena_empty();
	struct bench_job job;
	int error =
		bench_job_prepare(kernel->name, mesh, row->work, &arena, &job);

	if (!error) {
		*out = bench_time_job(
			&job, &bench->evictor, bench->options->bench.runs);
	}
	arena_release(&arena);
	return error;
}

/*
 * Measures all kernels at one row and size; their results begin at index first.
 */
static int measure_kernels(struct bench *bench, const struct bench_row *row,
	int size, const struct bench_mesh *mesh, int first)
{
	struct bench_report *report = &bench->report;
	const char *only = bench->options->vertices.kernel;

	report->result_count = first;
	for (int k = 0; kernel_registry[k]; k++) {
		const struct kernel *kernel = kernel_registry[k];
		struct bench_result *result =
			&report->result[report->result_count];
		int error;

		if (only && kernel != kernel_find(only)) {
			continue;
		}
		if (report->result_count == BENCH_RESULTS_MAX) {
			break;
		}
		result->row = row;
		result->kernel = kernel;
		error = measure(bench, mesh, row, kernel, &result->time[size]);
		if (!error) {
			report->result_count++;
		} else if (error != -ENOTSUP) {
			return error;
		}
	}
	return 0;
}

static int measure_row(struct bench *bench, const struct bench_row *row)
{
	int first = bench->report.result_count;

	for (int s = 0; s < bench->report.size_count; s++) {
		struct bench_mesh mesh;
		int error = make_mesh(bench, row, s, &mesh);

		if (error) {
			return error;
		}
		bench->report.vertex_count[s] = mesh.primitive.vertex_count;
		if (row->work != BENCH_SKIN_TANGENTS || mesh.primitive.tangent) {
			error = measure_kernels(bench, row, s, &mesh, first);
		}
		bench_mesh_release(&mesh);
		if (error) {
			return error;
		}
	}
	return 0;
}

static int measure_all(struct bench *bench)
{
	const struct bench_row *row =
		bench->model ? bench_model_rows : bench_rows;
	int error = 0;

	bench->report.runs = bench->options->bench.runs;
	bench->report.size_count =
		bench->model ? 1 : (int)ARRAY_COUNT(made_sizes);
	for (; row->name && !error; row++) {
		error = measure_row(bench, row);
	}
	if (error == -ENOENT) {
		log_error(bench->log,
			"%s: nothing in it is skinned: give a model with a skinned mesh",
			bench->model->path);
	} else if (error) {
		log_error(bench->log, "bench: there is not enough memory");
	}
	return error;
}

static int bench_run(struct bench *bench)
{
	int error = bench_evictor_init(&bench->evictor);

	if (error) {
		log_error(bench->log, "bench: there is not enough memory");
	} else {
		error = measure_all(bench);
	}
	if (!error && bench->options->common.json) {
		error = bench_print_json(&bench->report, bench->log, stdout);
	} else if (!error) {
		bench_print_text(&bench->report, stdout);
	}
	bench_evictor_release(&bench->evictor);
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	struct bench bench = {.options = options, .log = log};
	struct model *model = NULL;
	int error = 0;

	if (options->vertices.kernel &&
		!options_kernel(&options->vertices, log)) {
		return EXIT_USAGE;
	}
	if (options->model_path) {
		command_confine(options, log);
		error = model_load_within(options->model_path,
			options->common.memory_bytes, log, &model);
	}
	if (!error) {
		bench.model = model;
		bench.report.mesh = options->model_path;
		error = bench_run(&bench);
	}
	model_destroy(model);
	return command_exit_code(error);
}

const struct command command_bench = {
	.name = "bench",
	.bit = FOR_BENCH,
	.usage = "[MODEL] [--json]",
	.summary = "time the vertex loops on this machine",
	.detail =
		"limber times the skinning and morphing loops of every kernel, on generated meshes of three\n"
		"sizes or on the largest skinned mesh of a model. It needs no display.\n"
		"\n"
		"  limber bench\n"
		"  limber bench robot.glb --kernel float\n"
		"  limber bench --json | jq .results",
	.run = run,
};
