/*
 * Runs the command that the command line names.
 */
#ifndef APP_CMD_DISPATCH_H
#define APP_CMD_DISPATCH_H

#include "app/cmd/command.h"

/*
 * Runs the command that argv[1] names; when it names none, the first of
 * commands. commands ends with NULL. Returns the program's exit code; what is
 * wrong has been logged to standard error.
 */
int dispatch(const struct command *const *commands, int argc, char **argv);

#endif
