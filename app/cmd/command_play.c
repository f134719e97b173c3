#include "app/cmd/command.h"
#include "app/cmd/show/show.h"

#include <errno.h>
#include <stdio.h>

enum {
	PATH_ROOM = 1024
};

/* What the buttons do, for the person at the terminal. */
static void print_buttons(const struct demo_driver *demo, bool camera)
{
	printf("%s: %s\n", demo->name, demo->summary);
	for (const struct demo_action *action = demo->action; action->run;
		action++) {
		/* With a camera, F10 is the camera's. */
		if (!camera || action->button != BUTTON_F10) {
			printf("  %-6s %s\n", button_name(action->button),
				action->summary);
		}
	}
	if (camera) {
		puts("  F10    camera: background, screen, motion, off");
	}
	puts("  F9     held: how long frames take (H in a window)");
	puts("  F9+F8  keep the picture in a file (P in a window)");
	puts("  Esc    quit");
	fflush(stdout);
}

static int run(const struct options *options, const struct log *log)
{
	char path[PATH_ROOM];
	struct show_plan plan = {
		.display = options->screen.display,
		.clock = options->show.clock,
		.begin_s = options->motion.time_given ? options->motion.time_s
						      : 0.0,
		.frames = options->show.frames,
		.opened = print_buttons,
		.follow_file = true,
	};
	int error = show_choose(options, log, &plan, path, sizeof(path));

	if (error) {
		return error == -EINVAL ? EXIT_USAGE : EXIT_FAILED;
	}
	if (plan.clock.fixed) {
		plan.clock.start_s = plan.begin_s;
	}
	return command_exit_code(show_run(&plan, options, log));
}

const struct command command_play = {
	.name = "play",
	.bit = FOR_PLAY,
	.usage = "[MODEL | --demo NAME]",
	.summary = "show a model or a demo until you quit",
	.detail =
		"Shows a glTF model, or a demo, in a window until it is closed "
		"or Esc is pressed;\nwithout a desktop on the screen, through "
		"kms or fbdev, until Ctrl-C.\nButtons are the arrow keys, Enter, F6, "
		"F8, "
		"F9 and F10, named as on the i.MX31 PDK's\nkeypad; what they "
		"do "
		"is printed at the start.\n\n"
		"  limber play robot.glb            any glTF file\n"
		"  limber play --demo face          a built-in demo\n"
		"  limber --demo arm --script run.txt\n"
		"                                   the same without the word "
		"play, buttons from a file\n"
		"  limber play --demo walker --display fbdev:/dev/fb1\n"
		"                                   on a framebuffer, all of "
		"it; --size for less",
	.run = run,
};
