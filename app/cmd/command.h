/*
 * The interface of a command ("limber play", "limber info" and so on).
 *
 * Each command fills one struct command; main.c lists them, and
 * command_dispatch() runs the one that the command line names.
 */
#ifndef APP_CMD_COMMAND_H
#define APP_CMD_COMMAND_H

#include "app/cmd/options/options.h"
#include "app/model/model.h"

enum exit_code {
	EXIT_OK = 0,
	EXIT_FAILED = 1, /* a file, a device or memory failed */
	EXIT_USAGE = 2,  /* the command line is wrong */
};

struct command {
	const char *name;
	enum command_bit bit;
	const char *usage;   /* its arguments: "MODEL -o FILE" and the like */
	const char *summary; /* one line */
	const char *detail;  /* paragraphs and examples for --help */
	bool reads_config;   /* run() reads limber.conf itself */
	bool wants_levels;   /* its model gets levels of detail, as played */
	/* Returns one of enum exit_code; every failure has logged an error. */
	int (*run)(const struct options *options, const struct log *log);
};

extern const struct command command_play;
extern const struct command command_render;
extern const struct command command_pose;
extern const struct command command_info;
extern const struct command command_bench;
extern const struct command command_compare;
extern const struct command command_doctor;
extern const struct command command_export;
extern const struct command command_character;
extern const struct command command_optimize;
extern const struct command command_levels;

/*
 * Runs the command that argv[1] names; when it names none, the first of
 * commands, which ends with NULL. Returns the program's exit code; every
 * failure has logged an error.
 */
int command_dispatch(
	const struct command *const *commands, int argc, char **argv);

/*
 * EXIT_OK for 0, EXIT_FAILED for any -errno. A command checks its options
 * before it does anything else and returns EXIT_USAGE itself where they are
 * wrong: an -EINVAL that comes later is about a file or a device.
 */
int command_exit_code(int error);

/*
 * Confines the process (confine.h): from here on only the files that the
 * options name can be written. A command calls this before it reads a model.
 */
void command_confine(const struct options *options, const struct log *log);

/*
 * Confines the process (confine.h) to the outputs that the options name, loads
 * options->model_path, calls run() with it and releases it. run() returns
 * 0, or -errno after logging an error. This function returns an exit code: it
 * is EXIT_USAGE, after an error that shows the command's usage, when no model
 * was given.
 */
int command_run_with_model(const struct command *command,
	const struct options *options, const struct log *log,
	int (*run)(const struct model *model, const struct options *options,
		const struct log *log));

#endif
