#include "app/cmd/command.h"
#include "app/cmd/show/show.h"

#include <string.h>
#include <strings.h>

static const double default_rate_hz = 25.0;

static bool is_still(const char *file)
{
	const char *dot = strrchr(file, '.');

	return dot && strcasecmp(dot, ".png") == 0;
}

static int run(const struct options *options, const struct log *log)
{
	const char *output = options->screen.output;
	struct show_plan plan = {
		.display = "image",
		.clock = options->show.clock,
		.begin_s = options->motion.time_s,
		.frames = options->show.frames,
		.unattended = !options->input.script && !options->input.buttons,
		.progress = true,
	};
	int status;

	if (!output) {
		log_error(log,
			"render: there is no file to write: add -o FILE.png, FILE.gif or FILE.y4m");
		return EXIT_USAGE;
	}
	if (!options->model_path && !options->show.demo) {
		log_error(log,
			"render: there is nothing to show: give a model file or --demo walker, arm, face, crowd, duel or tuner");
		return EXIT_USAGE;
	}
	status = show_choose(options, log, &plan);
	if (status != EXIT_OK) {
		return status;
	}
	if (!plan.clock.fixed) {
		plan.clock = clock_fixed(default_rate_hz, 0.0);
	}
	if (plan.frames == 0) {
		plan.frames = is_still(output) ? 1 : -1;
	}
	return show_run(&plan, options, log);
}

const struct command command_render = {
	.name = "render",
	.bit = FOR_RENDER,
	.usage = "MODEL|--demo NAME -o FILE",
	.summary = "write pictures: PNG, GIF or Y4M",
	.detail =
		"limber draws a model or a demo into a file. The end of the file's name chooses its kind:\n"
		".png is one picture, or FILE-0001.png and so on with --frames; .gif and .y4m are one period\n"
		"of the animation, or --frames. The clock is fixed at 25 frames a second, unless --clock\n"
		"fixed:FPS is given, so the same command always writes the same pictures.\n"
		"\n"
		"  limber render robot.glb --time 1.5 -o robot.png\n"
		"  limber render --demo walker -o walker.gif --size 240x320\n"
		"  limber render --demo duel robot.glb -o duel.png\n"
		"  limber render --demo arm --script run.txt --frames 250 -o arm.y4m",
	.run = run,
};
