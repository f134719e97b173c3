#include "app/cmd/show/show.h"

#include "app/cmd/options/options_kernel.h"
#include "app/cmd/show/show_screen.h"
#include "app/model/model_file.h"
#include "platform/base/file.h"
#include "platform/buttons/buttons.h"

#include <errno.h>

static int say_unknown_demo(const char *name, const struct log *log)
{
	const char *names[16];
	const char *closest;
	int count = 0;

	for (; demo_registry[count] && count < 15; count++) {
		names[count] = demo_registry[count]->name;
	}
	names[count] = NULL;
	closest = options_closest(name, names);
	log_error(log, "--demo %s: no such demo: %s%s%s", name,
		closest ? "did you mean "
			: "choose walker, arm, face, crowd, duel or tuner",
		closest ? closest : "", closest ? "?" : "");
	return -EINVAL;
}

/* Names of drivers are wrong usage, whatever the machine has. */
static int check_names(const struct options *options, const struct log *log)
{
	int error = screen_check(options, log);

	if (!error && !options_kernel(&options->vertices, log)) {
		error = -EINVAL;
	}
	return error ? error : buttons_check(options->input.buttons, log);
}

int show_choose(const struct options *options, const struct log *log,
	struct show_plan *plan, char *path, size_t size)
{
	int error = check_names(options, log);

	if (error) {
		return error;
	}
	if (options->show.demo && options->model_path) {
		log_error(log,
			"%s: a demo brings its own model: give --demo "
			"or a file, not both",
			options->model_path);
		return -EINVAL;
	}
	if (options->model_path) {
		plan->demo = &demo_driver_viewer;
		plan->model_path = options->model_path;
		return model_file_check(plan->model_path, log);
	}
	if (options->motion.clip) {
		log_error(log,
			"--clip %s: a demo chooses its own clips: name "
			"a model file instead",
			options->motion.clip);
		return -EINVAL;
	}
	plan->demo = options->show.demo ? demo_find(options->show.demo)
					: demo_registry[0];
	if (!plan->demo) {
		return say_unknown_demo(options->show.demo, log);
	}
	plan->model_path = path;
	return file_find_asset(plan->demo->asset, log, path, size);
}
