#include "app/cmd/command.h"
#include "app/cmd/info/info_report.h"

#include <stdio.h>

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	struct info_report report;
	int error = info_measure(model, log, &report);

	if (error) {
		return error;
	}
	if (options->common.json) {
		error = info_print_json(
			&report, options->common.nodes, log, stdout);
	} else {
		info_print_text(&report, stdout);
	}
	if (options->common.nodes && !options->common.json) {
		error = info_print_nodes(model, log, stdout);
	}
	info_release(&report);
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	return command_run_with_model(
		&command_info, options, log, run_with_model);
}

const struct command command_info = {
	.name = "info",
	.bit = FOR_INFO,
	.usage = "MODEL [--nodes] [--json]",
	.summary = "print what a model contains",
	.detail =
		"limber lists a model's meshes and their levels of detail, joints, influences, morph targets\n"
		"and clips, and the bytes that each technique needs to animate it.\n"
		"\n"
		"  limber info robot.glb\n"
		"  limber info robot.glb --nodes      # the names that a character file uses\n"
		"  limber info robot.glb --json | jq .clips",
	.run = run,
};
