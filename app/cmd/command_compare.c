#include "app/cmd/command.h"
#include "app/cmd/show/kernel_choice.h"
#include "app/compare/export/export.h"
#include "app/compare/report/report.h"

#include <errno.h>

static int choose_clip(const struct model *model, const char *name,
	const struct log *log, int *out)
{
	if (model->clip_count == 0) {
		log_error(log,
			"%s: it has no clip, and techniques are compared by "
			"how a clip looks: give a model with an animation",
			model->path);
		return -ENOENT;
	}
	return model_choose_clip(model, name, 0, log, out);
}

static int print(const struct comparison *comparison,
	const struct options *options, const struct log *log)
{
	int error = report_find(options->report)->print(comparison, stdout);

	if (error) {
		log_error(log, "compare: out of memory for the report");
	}
	if (!error && options->plot) {
		error = report_plot(comparison, options->plot, log);
	}
	if (!error && options->export_folder) {
		error = comparison_export(
			comparison, options->export_folder, log);
	}
	return error;
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	struct comparison_request request = {
		.rate_hz = options->rate_hz,
		.bound_px = options->bound_px,
		.memory_bytes = options->memory_bytes,
		.width = options->width,
		.height = options->height,
		.kernel = kernel_choose(options, log),
	};
	struct comparison *comparison;
	int error = choose_clip(model, options->clip, log, &request.clip);

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
	if (!options->model_path) {
		log_error(log, "compare: no model: limber compare MODEL");
		return EXIT_USAGE;
	}
	if (!kernel_choose(options, log)) {
		return EXIT_USAGE;
	}
	return command_with_model(options, log, run_with_model);
}

const struct command command_compare = {
	.name = "compare",
	.bit = FOR_COMPARE,
	.usage = "MODEL",
	.summary = "say what each animation technique costs for a model",
	.detail =
		"Turns a clip into morph key frames, rigid parts on pivots and "
		"skins of fewer influences,\nmeasures what each costs a frame, "
		"in memory and in the file, and how many pixels it is\noff, "
		"and names the one to take. Elsewhere than on the board that "
		"is the cheapest one on an\nARM1136, predicted by the timing "
		"model of its core.\n\n"
		"  limber compare robot.glb --clip walk --error 1 --ram 512k\n"
		"  limber compare robot.glb --plot techniques.svg --export "
		"baked",
	.run = run,
};
