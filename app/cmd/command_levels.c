#include "app/cmd/command.h"
#include "app/model/levels/levels_file.h"
#include "platform/base/output_file.h"

static int write_levels(
	struct model *model, const char *path, const struct log *log)
{
	struct output_file *file;
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	error = levels_write(model, output_file_stream(file));
	if (error) {
		output_file_discard(file);
		return memory_budget_fail(model->budget, model->path, log);
	}
	return output_file_commit(file);
}

static int run(const struct options *options, const struct log *log)
{
	struct model *model;
	int error;

	if (!options->model_path || !options->screen.output) {
		log_error(log,
			"levels: the model or the file to write is missing: use limber levels %s",
			command_levels.usage);
		return EXIT_USAGE;
	}
	command_confine(options, log);
	error = model_load_within(
		options->model_path, options->common.memory_bytes, log, &model);
	if (!error) {
		error = write_levels(model, options->screen.output, log);
		model_destroy(model);
	}
	return command_exit_code(error);
}

const struct command command_levels = {
	.name = "levels",
	.bit = FOR_LEVELS,
	.usage = "MODEL -o FILE",
	.summary = "write a model's levels of detail",
	.detail =
		"Whatever is small on the screen is drawn from coarser triangle lists. limber makes them when\n"
		"it loads a model, which takes the board a third of a second for 4,000 triangles. It reads them\n"
		"instead from a file beside the model: robot.levels for robot.glb. The pictures are the same.\n"
		"After a change of the model, limber warns and makes the levels until the file is written anew.\n"
		"\n"
		"  limber levels robot.glb -o robot.levels",
	.run = run,
};
