#include "app/cmd/command.h"
#include "app/cmd/progress.h"
#include "app/compare/optimize/optimize.h"
#include "platform/base/output_file.h"

#include <stdlib.h>
#include <string.h>

static void show_progress(void *context, int done, int total)
{
	struct progress *progress = context;

	progress->total = total;
	progress_step(progress, done);
}

static int write_file(const struct optimize_result *result, const char *path,
	const struct log *log)
{
	struct output_file *file;
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	fwrite(result->data, 1, result->after.file, output_file_stream(file));
	return output_file_commit(file);
}

static void print_row(const char *name, size_t before, size_t after)
{
	printf("  %-14s %10.1f %10.1f\n", name, (double)before / 1024.0,
		(double)after / 1024.0);
}

static void print_result(
	const struct optimize_result *result, const struct options *options)
{
	const struct optimize_sizes *before = &result->before;
	const struct optimize_sizes *after = &result->after;

	printf("  %-14s %10s %10s\n", "KiB", "before", "after");
	print_row("keys", before->keys, after->keys);
	print_row("vertices", before->vertices, after->vertices);
	print_row("indices", before->indices, after->indices);
	print_row("all else", before->rest, after->rest);
	print_row("the whole file", before->file, after->file);
	printf("%ld of %ld keys are left. No vertex moves by more than %.3f px in %dx%d.\n",
		after->key_count, before->key_count, (double)result->peak_px,
		options->screen.size.width, options->screen.size.height);
	if (result->earlier_px > 0.0f) {
		printf("An earlier run has used %g px of --error %g already.\n",
			(double)result->earlier_px,
			(double)options->compare.error_px);
	}
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	struct progress progress = progress_begin(2, "steps", stderr);
	const struct optimize_request request = {
		.bound_px = options->compare.error_px,
		.width = options->screen.size.width,
		.height = options->screen.size.height,
		.memory_bytes = options->common.memory_bytes,
		.progress = show_progress,
		.progress_context = &progress,
	};
	struct optimize_result result;
	const char *output = options->screen.output;
	int error = output_file_try(NULL, output, log);

	if (error) {
		return error;
	}
	error = optimize_model(model, &request, log, &result);
	progress_end(&progress);
	if (!error) {
		error = write_file(&result, output, log);
	}
	if (!error) {
		print_result(&result, options);
	}
	free(result.data);
	return error;
}

static bool is_glb(const char *path)
{
	size_t length = strlen(path);

	return strncmp(path, "/dev/", 5) == 0 ||
		(length > 4 && strcmp(path + length - 4, ".glb") == 0);
}

static int run(const struct options *options, const struct log *log)
{
	const char *output = options->screen.output;

	if (options->model_path && (!output || !is_glb(output))) {
		log_error(log,
			output ? "optimize: -o %s: the name of the file to write shall end in .glb"
			       : "optimize: there is no file to write: add -o FILE.glb",
			output);
		return EXIT_USAGE;
	}
	return command_run_with_model(
		&command_optimize, options, log, run_with_model);
}

const struct command command_optimize = {
	.name = "optimize",
	.bit = FOR_OPTIMIZE,
	.usage = "MODEL -o FILE.glb",
	.summary = "write a smaller glTF file",
	.detail =
		"limber leaves out keys that lie between others, stores numbers as integers where they suffice,\n"
		"puts vertices and triangles into the order that caches like, and removes what nothing uses. It\n"
		"plays the new file beside the old one: no vertex moves by more than --error pixels, between\n"
		"keys too. Names, materials, cameras, scenes and extras stay.\n"
		"\n"
		"The file states the error in asset.extras.limber_error_px, so that running limber optimize\n"
		"on it again with the same --error changes nothing.\n"
		"\n"
		"  limber optimize robot.glb -o small.glb\n"
		"  limber optimize robot.gltf --error 0.1 -o exact.glb",
	.run = run,
};
