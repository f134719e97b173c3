#include "app/cmd/command.h"

#include "app/cmd/options/config.h"
#include "app/cmd/options/options_files.h"
#include "app/cmd/version.h"
#include "app/model/levels/levels_file.h"
#include "platform/base/file.h"
#include "platform/base/output_file.h"
#include "platform/process/confine.h"
#include "platform/process/stop.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

enum {
	COMMANDS_MAX = 16
};

int command_exit_code(int error)
{
	return error ? EXIT_FAILED : EXIT_OK;
}

void command_confine(const struct options *options, const struct log *log)
{
	const char *const named[CONFINE_OUTPUTS_MAX] = {options->screen.output,
		options->compare.plot, options->compare.export,
		options->export.c};
	struct confine_request request = {.connects = false};
	int count = 0;

	for (int i = 0; i < CONFINE_OUTPUTS_MAX; i++) {
		if (named[i]) {
			request.output[count++] = named[i];
		}
	}
	(void)confine_process(&request, log);
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
	command_confine(options, log);
	error = model_load_within(
		options->model_path, options->common.memory_bytes, log, &model);
	if (!error && command->wants_levels) {
		error = levels_prepare(model, log);
		if (error) {
			model_destroy(model);
		}
	}
	if (!error) {
		error = run(model, options, log);
		model_destroy(model);
	}
	return command_exit_code(error);
}

static const struct command *find(
	const struct command *const *commands, const char *name)
{
	for (; *commands; commands++) {
		if (strcmp((*commands)->name, name) == 0) {
			return *commands;
		}
	}
	return NULL;
}

static void print_overview(const struct command *const *commands)
{
	puts("limber plays 3D character animation: morphing, hierarchical and skeletal.\n");
	for (int i = 0; commands[i]; i++) {
		printf("  limber %-9s %-26s %s\n", commands[i]->name,
			commands[i]->usage, commands[i]->summary);
	}
	puts("\nlimber COMMAND --help describes a command. Without a command, limber plays.");
}

static void print_help(const struct command *command)
{
	printf("limber %s %s\n\n%s\n\nOptions:\n", command->name,
		command->usage, command->detail);
	options_list(stdout, command->bit);
}

/* Refuses a first argument that is no command, no option and no file. */
static int refuse_unknown(const struct command *const *commands,
	const char *word, const struct log *log)
{
	const char *names[COMMANDS_MAX];
	int count = 0;

	for (; count < COMMANDS_MAX - 1 && commands[count]; count++) {
		names[count] = commands[count]->name;
	}
	names[count] = NULL;
	options_log_unknown(log,
		&(struct options_unknown){"", word, "command or file",
			"limber ", "limber --help lists the commands"},
		names);
	return EXIT_USAGE;
}

/*
 * Whether the word looks like a file, so that a missing model file is reported
 * as a file and not as an unknown command. An empty one is no command either.
 */
static bool looks_like_file(const char *word)
{
	return !word[0] || strchr(word, '.') || strchr(word, '/') ||
		file_exists(word);
}

static bool names_none(const char *file)
{
	return file && strcmp(file, "none") == 0;
}

/*
 * Reads limber.conf into new options and then the command line again, which
 * overrides limber.conf. A model or a demo on the command line also discards
 * the clip and the character file of limber.conf, which belong to another
 * model. path gets the name of limber.conf, or "" if there is none.
 */
static int configure(const struct command *command, int argc, char **argv,
	struct config *config, struct options *options, char path[PATH_MAX],
	const struct log *log)
{
	struct options merged = options_default();
	const char *model;
	int found, error;

	path[0] = '\0';
	if (command->reads_config || !options_takes(command->bit, "config")) {
		return 0;
	}
	found = config_find(options->common.config, command->bit == FOR_PLAY,
		path, PATH_MAX, log);
	if (found <= 0) {
		path[0] = '\0';
		return found;
	}
	log_note(log, "%s: limber reads options from this file", path);
	error = config_load(config, path, command->bit, &merged, log);
	if (error) {
		return error;
	}
	if (options->model_path || options->show.demo) {
		merged.model_path = NULL;
		merged.show.demo = NULL;
		merged.motion.clip = NULL;
		if (!names_none(merged.show.character)) {
			merged.show.character = NULL;
		}
	}
	model = merged.model_path;
	merged.model_path = NULL;
	error = options_parse(&merged, command->bit, argc, argv, log);
	merged.model_path = merged.model_path ? merged.model_path : model;
	*options = merged;
	return error;
}

/* Runs a command with the arguments that follow its name. */
static int run(const struct command *command, struct options *options, int argc,
	char **argv)
{
	const struct log log =
		log_to_stderr(options->common.verbose ? LOG_NOTE : LOG_WARNING);
	struct config config = {arena_empty()};
	char path[PATH_MAX];
	int status = EXIT_FAILED;

	if (configure(command, argc, argv, &config, options, path, &log) == 0) {
		status = options_read_dash(options, command->bit, &log) == 0 &&
				options_check_files(
					options, command->bit, &log) == 0
			? command->run(options, &log)
			: EXIT_USAGE;
		/* The message before names an option, as on the command line. */
		if (status == EXIT_USAGE && path[0]) {
			log_error(&log, "%s: it sets options, too", path);
		}
	}
	config_release(&config);
	return status;
}

static int run_command(
	const struct command *const *commands, int argc, char **argv)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct options options = options_default();
	const struct command *command = commands[0];
	int first = 1;

	if (argc > 1 && argv[1][0] != '-') {
		const struct command *named = find(commands, argv[1]);

		if (named) {
			command = named;
			first = 2;
		} else if (!looks_like_file(argv[1])) {
			return refuse_unknown(commands, argv[1], &log);
		}
	}
	argc -= first;
	argv += first;
	if (options_parse(&options, command->bit, argc, argv, &log) != 0) {
		return EXIT_USAGE;
	}
	if (options.common.help && first == 1) {
		print_overview(commands);
		return EXIT_OK;
	}
	if (options.common.help) {
		print_help(command);
		return EXIT_OK;
	}
	if (options.common.version) {
		version_print(stdout);
		return EXIT_OK;
	}
	return run(command, &options, argc, argv);
}

int command_dispatch(
	const struct command *const *commands, int argc, char **argv)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	int status;

	output_file_prepare_process();
	stop_unblock();
	status = run_command(commands, argc, argv);
	if (output_file_flush_stdout(&log) != 0 && status == EXIT_OK) {
		status = EXIT_FAILED;
	}
	return status;
}
