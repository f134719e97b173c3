/*
 * Shows a demo or a model, for the commands play and render.
 */
#ifndef APP_CMD_SHOW_SHOW_H
#define APP_CMD_SHOW_SHOW_H

#include "app/cmd/options/options.h"
#include "app/cmd/show/failsafe.h"
#include "app/demo/demo.h"

#include <limits.h>

/* The settings that differ between play and render. */
struct show_plan {
	const struct demo_driver *demo;
	const char *model_path;
	char asset_path[PATH_MAX]; /* storage for model_path of a demo */
	const char *display;       /* its name, or NULL for auto */
	struct clock clock;
	double begin_s;  /* seconds; earlier frames are not drawn */
	int frames;      /* 0: until closed; -1: one period, by a fixed clock */
	bool unattended; /* no user will press a button */
	bool print_keys; /* print what the buttons do */
	bool follow_file;          /* reload the model when its file changes */
	bool may_save;             /* a button may write a file */
	bool progress;             /* show a progress bar on a terminal */
	struct failsafe *failsafe; /* to be fed, or NULL */
};

/*
 * Checks the options without looking for a model's file, and sets plan->demo.
 * The caller has set plan->display. Returns an exit code; a failure has logged
 * an error.
 */
int show_check(const struct options *options, const struct log *log,
	struct show_plan *plan);

/*
 * Checks the options in the same way, and sets plan->model_path, too: a file
 * that exists. Without a demo and a model in the options, the default demo is
 * chosen. *plan must not be copied afterwards, because model_path may point
 * into it. Returns an exit code; every failure has logged an error.
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
