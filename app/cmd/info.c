#include "app/cmd/command.h"
#include "app/cmd/info_report.h"

#include <stdio.h>

static int run(const struct options *options, const struct log *log)
{
	struct info_report report;
	struct model *model;
	int error;

	if (!options->model_path) {
		log_error(log, "info: no model: limber info MODEL");
		return EXIT_USAGE;
	}
	if (model_load(options->model_path, log, &model) != 0) {
		return EXIT_FAILED;
	}
	error = info_measure(model, log, &report);
	if (!error) {
		error = options->json ? info_print_json(&report, log, stdout)
				      : info_print_text(&report, log, stdout);
	}
	model_destroy(model);
	return command_exit_code(error);
}

const struct command command_info = {
	.name = "info",
	.bit = FOR_INFO,
	.usage = "MODEL [--json]",
	.summary = "tell what a model holds",
	.detail = "Lists a model's meshes, joints, influences, morph targets "
		  "and clips, and the bytes that each\ntechnique needs to "
		  "animate it.\n\n"
		  "  limber info robot.glb\n"
		  "  limber info robot.glb --json | jq .clips",
	.run = run,
};
