/*
 * Shows a demo or a model: what play and render have in common.
 */
#ifndef APP_CMD_SHOW_SHOW_H
#define APP_CMD_SHOW_SHOW_H

#include "app/cmd/options/options.h"
#include "app/cmd/show/failsafe.h"
#include "app/demo/demo.h"

#include <limits.h>

/* What differs between the commands. */
struct show_plan {
	const struct demo_driver *demo;
	const char *model_path;
	char asset_path[PATH_MAX]; /* model_path of a demo */
	const char *display;       /* its name, or NULL for auto */
	struct clock clock;
	double begin_s;   /* earlier frames are not drawn */
	int frames;       /* 0: until closed; -1: one period of the demo */
	bool unattended;  /* no user will press a button */
	bool print_keys;  /* print what the buttons do */
	bool follow_file; /* show the model anew when its file changes */
	bool may_save;    /* a button may write a file */
	bool progress;    /* show a progress bar on a terminal */
	struct failsafe *failsafe; /* to be fed, or NULL */
};

/*
 * Checks the options, and sets the plan's demo and model, which has to exist;
 * plan->display is set already. Without a demo and a model in the options it
 * chooses the default demo. The plan must not be copied afterwards. Returns an
 * exit code; every failure has logged an error.
 */
int show_choose(const struct options *options, const struct log *log,
	struct show_plan *plan);

/*
 * Opens everything, runs the plan and closes everything. Returns an exit code;
 * every failure has logged an error.
 */
int show_run(const struct show_plan *plan, const struct options *options,
	const struct log *log);

#endif
