#include "app/cmd/command.h"

int command_exit_code(int error)
{
	return error ? EXIT_FAILED : EXIT_OK;
}

int command_run_with_model(const struct command *command,
	const struct options *options, const struct log *log,
	int (*run)(const struct model *model, const struct options *options,
		const struct log *log))
{
	struct model *model;
	int error;

	if (!options->model_path) {
		log_error(log, "%s: no model is given: use limber %s %s",
			command->name, command->name, command->usage);
		return EXIT_USAGE;
	}
	error = model_load(options->model_path, log, &model);
	if (!error) {
		error = run(model, options, log);
		model_destroy(model);
	}
	return command_exit_code(error);
}
