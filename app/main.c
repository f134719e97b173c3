/*
 * The table of subcommands, nothing else.
 */
#include "app/cmd/command.h"
#include "app/cmd/dispatch.h"

const struct command *const command_registry[] = {
	&command_play,
	&command_render,
	&command_pose,
	&command_info,
	&command_bench,
	&command_compare,
	&command_doctor,
	&command_export,
	NULL,
};

int main(int argc, char **argv)
{
	return dispatch(command_registry, argc, argv);
}
