/*
 * From the command line to a subcommand.
 */
#ifndef APP_CMD_DISPATCH_H
#define APP_CMD_DISPATCH_H

#include "app/cmd/command.h"

/*
 * Runs the subcommand that the first word names; without one, the first of the
 * table. Returns the exit code. commands ends with NULL.
 */
int dispatch(const struct command *const *commands, int argc, char **argv);

#endif
