#include "app/character/character_open.h"
#include "app/cmd/command.h"
#include "app/cmd/options/options_kernel.h"
#include "app/cmd/show/show.h"
#include "app/cmd/show/show_screen.h"
#include "app/model/model_file.h"
#include "platform/base/file.h"

#include <limits.h>

static void log_unknown_demo(const char *name, const struct log *log)
{
	const char *names[16];
	int count = 0;

	for (; count < 15 && demo_registry[count]; count++) {
		names[count] = demo_registry[count]->name;
	}
	names[count] = NULL;
	options_log_unknown(log,
		&(struct options_unknown){"--demo ", name, "demo", "",
			"choose walker, arm, face, crowd, duel or tuner"},
		names);
}

/* Checks all options that do not depend on the machine. */
static bool are_valid(const struct options *options,
	const struct show_plan *plan, const struct log *log)
{
	if (!show_screen_check(&options->screen, plan->display, log) ||
		!options_kernel(&options->vertices, log) ||
		buttons_check(options->input.buttons, log) != 0) {
		return false;
	}
	if (!options->model_path && options->motion.clip) {
		log_error(log,
			"--clip %s: a demo chooses its own clips: give a model file instead of a demo",
			options->motion.clip);
		return false;
	}
	return true;
}

/* Only a model without a character file plays its clips as options say. */
static void warn_of_motion(const struct options *options,
	const struct show_plan *plan, const struct log *log)
{
	const struct character_request request = {.model_path = plan->model_path,
		.file = options->show.character,
		.clip = options->motion.clip};
	char path[PATH_MAX];

	if (options->motion.speed == 1.0f &&
		options->motion.repeat == CLIP_LOOP) {
		return;
	}
	if (plan->demo->any_model) {
		log_warning(log,
			"--speed and --repeat change nothing in the demo %s, which plays clips in its own way",
			plan->demo->name);
	} else if (character_open_path(&request, path, sizeof(path))) {
		log_warning(log,
			"--speed and --repeat change nothing, as %s says how clips play: give --character none or --clip to play the model without it",
			path);
	}
}

static int find_model(const struct options *options, const struct log *log,
	struct show_plan *plan)
{
	if (options->model_path) {
		plan->model_path = options->model_path;
		return command_exit_code(
			model_file_check(plan->model_path, log));
	}
	plan->model_path = plan->asset_path;
	return command_exit_code(file_find_asset(plan->demo->asset, log,
		plan->asset_path, sizeof(plan->asset_path)));
}

int show_check(const struct options *options, const struct log *log,
	struct show_plan *plan)
{
	const char *demo = options->show.demo;

	if (!are_valid(options, plan, log)) {
		return EXIT_USAGE;
	}
	plan->demo = demo             ? demo_find(demo)
		: options->model_path ? &demo_driver_viewer
				      : demo_registry[0];
	if (!plan->demo) {
		log_unknown_demo(demo, log);
		return EXIT_USAGE;
	}
	if (options->model_path && plan->demo->asset && !plan->demo->any_model) {
		log_error(log,
			"%s: the demo %s has a model of its own: leave out one of them, or choose --demo crowd, duel or tuner",
			options->model_path, demo);
		return EXIT_USAGE;
	}
	return EXIT_OK;
}

int show_choose(const struct options *options, const struct log *log,
	struct show_plan *plan)
{
	int status = show_check(options, log, plan);

	if (status == EXIT_OK) {
		status = find_model(options, log, plan);
	}
	if (status == EXIT_OK) {
		warn_of_motion(options, plan, log);
	}
	return status;
}
