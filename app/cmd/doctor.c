#include "app/cmd/command.h"
#include "app/model/examine.h"

#include <stdio.h>

/* Counts what is said on its way to the user. */
struct findings {
	int count;
};

static void print_finding(void *context, const char *sentence)
{
	struct findings *findings = context;

	findings->count++;
	printf("- %s\n", sentence);
}

static int examine_model(const char *path, const struct log *log)
{
	struct findings findings = {0};
	const struct examiner examiner = {print_finding, &findings};
	int error = model_examine(path, &examiner, log);
	if (!error && findings.count == 0) {
		printf("%s: nothing in it that players get wrong\n", path);
	}
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	if (options->model_path) {
		return command_exit_code(
			examine_model(options->model_path, log));
	}
	log_error(log, "doctor: no model: limber doctor MODEL");
	return EXIT_USAGE;
}

const struct command command_doctor = {
	.name = "doctor",
	.bit = FOR_DOCTOR,
	.usage = "[MODEL]",
	.summary = "tell what players get wrong about a model",
	.detail = "Lists each thing in the file that players are known to get "
		  "wrong, with what limber does\nthere.\n\n"
		  "  limber doctor robot.glb",
	.run = run,
};
