/*
 * The files that the options name: none is written that is also read, that
 * another option writes, or whose name is that of another kind of file.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_FILES_H
#define APP_CMD_OPTIONS_OPTIONS_FILES_H

#include "app/cmd/options/options.h"

/*
 * Compares the files that the command writes with each other and with those
 * that it reads, whatever their paths look like; devices and pipes may be named
 * twice. optimize may write over its model. pose, export, character and levels
 * write one kind of file each and refuse names that end like other kinds, such
 * as a.png. Returns 0, or -EINVAL after logging an error.
 */
int options_check_files(const struct options *options, enum command_bit command,
	const struct log *log);

#endif
