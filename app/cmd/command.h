/*
 * The subcommands: one file each, all with the same shape.
 */
#ifndef APP_CMD_COMMAND_H
#define APP_CMD_COMMAND_H

#include "app/cmd/options/options.h"
#include "app/model/model.h"

enum exit_code {
	EXIT_OK = 0,
	EXIT_FAILED = 1, /* a file, a device, memory */
	EXIT_USAGE = 2,  /* the words of the command line */
};

struct command {
	const char *name;
	enum command_bit bit;
	const char *usage;   /* "MODEL -o FILE" and the like */
	const char *summary; /* one line */
	const char *detail;  /* a paragraph for --help, and examples */
	bool reads_config;   /* by itself: dispatch leaves limber.conf alone */
	/* One of enum exit_code. */
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

/* All of them, NULL at the end. */
extern const struct command *const command_registry[];

/* EXIT_OK for 0, EXIT_USAGE for -EINVAL of an option, else EXIT_FAILED. */
int command_exit_code(int error);

/*
 * Loads the model that the options name, runs on it and releases it; the exit
 * code of run, which gives 0 or -errno after a sentence.
 */
int command_with_model(const struct options *options, const struct log *log,
	int (*run)(const struct model *model, const struct options *options,
		const struct log *log));

#endif
