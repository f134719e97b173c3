#include "app/cmd/command.h"
#include "app/cmd/show/show.h"

#include <errno.h>
#include <string.h>

enum {
	PATH_ROOM = 1024
};

static const double default_rate_hz = 25.0;

static bool is_still(const char *file)
{
	const char *dot = strrchr(file, '.');

	return dot && strcmp(dot, ".png") == 0;
}

static int run(const struct options *options, const struct log *log)
{
	char path[PATH_ROOM];
	struct show_plan plan = {
		.display = "image",
		.clock = options->show.clock,
		.begin_s = options->motion.time_s,
		.frames = options->show.frames,
		.unattended = !options->input.script && !options->input.buttons,
		.progress = true,
	};
	int error;

	if (!options->screen.output) {
		log_error(log,
			"render: no file to write: add -o FILE.png, "
			".gif or .y4m");
		return EXIT_USAGE;
	}
	if (!options->model_path && !options->show.demo) {
		log_error(log,
			"render: nothing to show: name a model file or "
			"--demo walker, arm, face, crowd, duel or tuner");
		return EXIT_USAGE;
	}
	error = show_choose(options, log, &plan, path, sizeof(path));
	if (error) {
		return error == -EINVAL ? EXIT_USAGE : EXIT_FAILED;
	}
	if (!plan.clock.fixed) {
		plan.clock = clock_fixed(default_rate_hz, 0.0);
	}
	plan.clock.start_s = plan.begin_s;
	if (plan.frames == 0) {
		plan.frames = is_still(options->screen.output) ? 1 : -1;
	}
	return command_exit_code(show_run(&plan, options, log));
}

const struct command command_render = {
	.name = "render",
	.bit = FOR_RENDER,
	.usage = "MODEL|--demo NAME -o FILE",
	.summary = "write pictures: PNG, GIF or Y4M",
	.detail =
		"Draws a model or a demo into a file, by its ending: .png (one "
		"picture, or FILE-0001.png\nand so on with --frames), .gif or "
		".y4m (one period, or --frames). Time is fixed, 25 frames\na "
		"second unless --clock fixed:FPS says otherwise, so the same "
		"command always gives the\nsame pictures.\n\n"
		"  limber render robot.glb --time 1.5 -o robot.png\n"
		"  limber render --demo walker -o walker.gif --size 240x320\n"
		"  limber render --demo arm --script run.txt --frames 250 -o "
		"arm.y4m",
	.run = run,
};
