#include "app/cmd/command.h"
#include "app/cmd/show/show.h"

static int show(const struct options *options, struct failsafe *failsafe,
	const struct log *log)
{
	struct show_plan plan = {
		.failsafe = failsafe,
		.display = options->screen.display,
		.clock = options->show.clock,
		.begin_s = options->motion.time_s,
		.frames = options->show.frames,
		.print_keys = true,
		.follow_file = true,
		.may_save = true,
	};
	int status = show_choose(options, log, &plan);

	if (status != EXIT_OK) {
		return status;
	}
	return show_run(&plan, options, log);
}

static int run(const struct options *options, const struct log *log)
{
	struct options shown = *options;
	struct failsafe failsafe =
		failsafe_begin(&shown, clock_monotonic_ms(), log);
	int status = show(&shown, &failsafe, log);

	failsafe_end(&failsafe, status == EXIT_OK);
	return status;
}

const struct command command_play = {
	.name = "play",
	.bit = FOR_PLAY,
	.usage = "[MODEL] [--demo NAME]",
	.summary = "show a model or a demo until you quit",
	.detail =
		"limber shows a model or a demo in a window until you close it or press Esc. Without a\n"
		"desktop it shows it on the whole screen, through kms or fbdev, until you press Ctrl-C. The\n"
		"buttons are the arrow keys, Enter, F6, F8, F9 and F10, named as on the keypad of the\n"
		"i.MX31 PDK; limber prints what each of them does.\n"
		"\n"
		"  limber play robot.glb            show a model: .glb, .gltf or .x\n"
		"  limber play --demo face          show a built-in demo\n"
		"  limber play --demo crowd robot.glb\n"
		"                                   show a model as a crowd; also duel and tuner\n"
		"  limber --demo arm --script run.txt\n"
		"                                   leave out the word play, press buttons from a file\n"
		"  limber play --demo walker --display fbdev:/dev/fb1\n"
		"                                   fill a framebuffer; --size uses a part of it",
	.run = run,
};
