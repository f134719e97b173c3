/*
 * The program's entry point, and its table of commands.
 */
#include "app/cmd/command.h"

/* The first one runs if the command line names none. */
static const struct command *const commands[] = {
	&command_play,
	&command_render,
	&command_pose,
	&command_info,
	&command_bench,
	&command_compare,
	&command_doctor,
	&command_export,
	&command_optimize,
	&command_character,
	&command_levels,
	NULL,
};

int main(int argc, char **argv)
{
	return command_dispatch(commands, argc, argv);
}
