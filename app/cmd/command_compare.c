#include "app/character/character_open.h"
#include "app/character/show/character_in_place.h"
#include "app/cmd/command.h"
#include "app/cmd/options/options_kernel.h"
#include "app/cmd/progress.h"
#include "app/compare/export/export.h"
#include "app/compare/report/report.h"
#include "platform/base/output_file.h"
#include "platform/base/output_path.h"
#include "platform/process/jobs.h"

#include <errno.h>

static int choose_clip(const struct model *model, const char *name,
	const struct log *log, int *out)
{
	if (model->clip_count == 0) {
		log_error(log,
			"%s: it has no clip to compare techniques with: give a model with an animation",
			model->path);
		return -ENOENT;
	}
	return model_choose_clip(model, name, -1, log, out);
}

static void show_progress(void *context, int done, int total)
{
	struct progress *progress = context;

	progress->total = total;
	progress_step(progress, done);
}

static int print(const struct comparison *comparison,
	const struct options *options, const struct log *log)
{
	int error = report_find(options->compare.format)
			    ->print(comparison,
				    output_path_report(options->compare.plot));

	if (error == -EINVAL) {
		log_error(log,
			"%s: this name is not UTF-8, which JSON requires: rename the file, or choose another --format",
			comparison->model->path);
	} else if (error) {
		log_error(log,
			"compare: there is not enough memory for the report");
	}
	if (!error && options->compare.plot) {
		error = report_plot(comparison, options->compare.plot, log);
	}
	if (!error && options->compare.export) {
		error = export_comparison(
			comparison, options->compare.export, log);
	}
	return error;
}

/* Checks that the outputs can be written, before the long comparison. */
static int check_outputs(
	const struct options_compare *wanted, const struct log *log)
{
	int error =
		wanted->plot ? output_file_try("--plot", wanted->plot, log) : 0;

	return error || !wanted->export
		? error
		: export_make_folder(wanted->export, log);
}

static int compare(const struct model *model, struct comparison_request *request,
	const struct log *log, struct comparison **out)
{
	struct progress progress = progress_begin(2, "steps", stderr);
	int error;

	request->progress = show_progress;
	request->progress_context = &progress;
	error = comparison_create(model, request, log, out);
	progress_end(&progress);
	request->progress = NULL;
	request->progress_context = NULL;
	return error;
}

/* Warns about the compared clips that have been changed to walk on the spot. */
static void tell_in_place(const struct model *model, int clip,
	const float *way_m, const struct log *log)
{
	int count = 0, first = 0;

	for (int i = 0; i < model->clip_count; i++) {
		if (way_m[i] > 0.0f && (clip < 0 || i == clip)) {
			first = count == 0 ? i : first;
			count++;
		}
	}
	if (count == 1) {
		log_warning(log,
			"%s: clip %d %s goes %.2g m over the ground: it is compared and exported on the spot, without this way, as limber play shows it",
			model->path, first, model->clip[first].name,
			(double)way_m[first]);
	} else if (count > 1) {
		log_warning(log,
			"%s: %d clips go over the ground: they are compared and exported in their place, as limber play shows them",
			model->path, count);
	}
}

/*
 * Opens the model's character, by which limber play changes clips. If it is
 * invalid, warns and leaves *out NULL: clips are compared as in the file.
 */
static int open_character(struct instance *instance, const struct log *log,
	struct character **out)
{
	const char *path = instance->model->path;
	const struct character_request request = {
		.model_path = path, .rate = 1.0f};
	struct log nowhere = log_to_nowhere();
	int error = character_open(&request, instance, &nowhere, out);

	if (error == -ENOMEM) {
		return memory_budget_fail(instance->model->budget, path, log);
	}
	if (error) {
		log_warning(log,
			"%s: limber play refuses its character file: clips that go over the ground are compared with their way over it, not on the spot",
			path);
	}
	return 0;
}

/*
 * Writes to *out the model as limber play shows it: a copy, whose changed clips
 * are in the arena.
 */
static int show_in_place(const struct model *model, int clip,
	const struct kernel *kernel, struct arena *arena, struct model *out,
	const struct log *log)
{
	float *way_m = ARENA_ARRAY(arena, float, model->clip_count);
	struct character *character = NULL;
	struct instance *instance;
	int error;

	if (!way_m) {
		return memory_budget_fail(model->budget, model->path, log);
	}
	error = instance_create(model, kernel, log, &instance);
	if (error) {
		return error;
	}
	*out = *model;
	error = open_character(instance, log, &character);
	if (character) {
		error = character_in_place(character, model, arena, out, way_m);
		if (error) {
			(void)memory_budget_fail(
				model->budget, model->path, log);
		} else {
			tell_in_place(model, clip, way_m, log);
		}
	}
	character_destroy(character);
	instance_destroy(instance);
	return error;
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	const struct options_compare *wanted = &options->compare;
	struct comparison_request request = {
		.rate_hz = wanted->fps,
		.bound_px = wanted->error_px,
		.board = wanted->board,
		.memory_bytes = wanted->ram_bytes,
		.frame_ms = (double)wanted->ms,
		.width = options->screen.size.width,
		.height = options->screen.size.height,
		.jobs = wanted->jobs > 0 ? wanted->jobs : jobs_processors(),
		.kernel = options_kernel(&options->vertices, log),
	};
	struct arena arena = arena_within(model->budget);
	struct comparison *comparison;
	struct model shown;
	int error = choose_clip(model, options->motion.clip, log, &request.clip);

	if (!error) {
		error = check_outputs(wanted, log);
	}
	if (!error) {
		error = show_in_place(model, request.clip, request.kernel,
			&arena, &shown, log);
	}
	if (!error) {
		error = compare(&shown, &request, log, &comparison);
	}
	if (!error) {
		error = print(comparison, options, log);
		comparison_destroy(comparison);
	}
	arena_release(&arena);
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	if (!options_kernel(&options->vertices, log)) {
		return EXIT_USAGE;
	}
	return command_run_with_model(
		&command_compare, options, log, run_with_model);
}

const struct command command_compare = {
	.name = "compare",
	.bit = FOR_COMPARE,
	.wants_levels = true,
	.usage = "MODEL",
	.summary = "compare the animation techniques on a model",
	.detail =
		"limber bakes the clips of a model as morph key frames, as rigid parts on pivots and as skins\n"
		"with fewer influences. It measures what each costs: the time of a frame, memory, the size of\n"
		"the file, and the error on the screen: of positions, outlines, normals and shades, between\n"
		"keys too. It also predicts the time on the board by a timing model of an ARM1136.\n"
		"\n"
		"Then it recommends one: of all that keep within --error, --ram and --ms, the one with the\n"
		"least sum of predicted time and memory, where 256 KiB count as 1% of the board's frame. --clip\n"
		"compares one clip; else all clips are compared, and what a technique shares is counted once.\n"
		"\n"
		"  limber compare robot.glb\n"
		"  limber compare robot.glb --clip walk --error 1 --ram 512k\n"
		"  limber compare robot.glb --plot techniques.svg --export baked",
	.run = run,
};
