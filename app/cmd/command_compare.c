#include "app/cmd/command.h"
#include "app/cmd/options/options_kernel.h"
#include "app/compare/export/export.h"
#include "app/compare/report/report.h"

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
	return model_choose_clip(model, name, 0, log, out);
}

static int print(const struct comparison *comparison,
	const struct options *options, const struct log *log)
{
	int error =
		report_find(options->compare.format)->print(comparison, stdout);

	if (error) {
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

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	struct comparison_request request = {
		.rate_hz = options->compare.fps,
		.bound_px = options->compare.error_px,
		.memory_bytes = options->compare.ram_bytes,
		.width = options->screen.size.width,
		.height = options->screen.size.height,
		.kernel = options_kernel(&options->vertices, log),
	};
	struct comparison *comparison;
	int error = choose_clip(model, options->motion.clip, log, &request.clip);

	if (!error) {
		error = comparison_create(model, &request, log, &comparison);
	}
	if (error) {
		return error;
	}
	error = print(comparison, options, log);
	comparison_destroy(comparison);
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
	.usage = "MODEL",
	.summary = "compare the animation techniques on a model",
	.detail =
		"limber bakes a clip as morph key frames, as rigid parts on pivots and as skins with fewer\n"
		"influences. It measures what each costs: the time of a frame, memory, the size of the file,\n"
		"and the error on the screen in pixels. Then it recommends one: the one that costs least on an\n"
		"ARM1136, predicted by a timing model of that core, or measured where limber runs on the board.\n"
		"\n"
		"  limber compare robot.glb --clip walk --error 1 --ram 512k\n"
		"  limber compare robot.glb --plot techniques.svg --export baked",
	.run = run,
};
