/*
 * The files that the options name: none is written that is also read or that
 * another option writes.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_FILES_H
#define APP_CMD_OPTIONS_OPTIONS_FILES_H

#include "app/cmd/options/options.h"

/*
 * Compares the files that the command writes with each other and with those
 * that it reads, whatever their paths look like; devices and pipes may be named
 * twice. optimize and levels may write over their model. Returns 0, or -EINVAL
 * after logging an error.
 */
int options_check_files(const struct options *options, enum command_bit command,
	const struct log *log);

#endif
