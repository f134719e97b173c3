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
	bool wants_levels;   /* the model gets levels of detail, as in play */
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
 * Runs the command that argv[1] names or, if it names none, commands[0].
 * commands ends with NULL. Returns the program's exit code; every failure has
 * logged an error.
 */
int command_dispatch(
	const struct command *const *commands, int argc, char **argv);

/*
 * Returns EXIT_OK for 0, EXIT_FAILED for any -errno. A command checks its
 * options first and returns EXIT_USAGE itself if they are wrong: an -EINVAL
 * that comes later is about a file or a device.
 */
int command_exit_code(int error);

/*
 * Confines the process (confine.h): from here on it can only write the files
 * that the options name. A command calls this before it reads a model.
 */
void command_confine(const struct options *options, const struct log *log);

/*
 * Calls command_confine(), loads options->model_path, calls run() with the
 * model and releases it. run() returns 0, or -errno after logging an error.
 * This function returns an exit code: EXIT_USAGE, after logging the command's
 * usage, if no model was given.
 */
int command_run_with_model(const struct command *command,
	const struct options *options, const struct log *log,
	int (*run)(const struct model *model, const struct options *options,
		const struct log *log));

#endif
