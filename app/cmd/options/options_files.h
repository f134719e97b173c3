/*
 * Checks the files that the options name: a file to write must not be a file to
 * read, or the file of another option, or have another kind's ending.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_FILES_H
#define APP_CMD_OPTIONS_OPTIONS_FILES_H

#include "app/cmd/options/options.h"

/*
 * Lets "-" stand for standard output where a command prints nothing but its
 * file: --output of pose and character. Returns 0, or -EINVAL after logging an
 * error for any other file to write.
 */
int options_read_dash(struct options *options, enum command_bit command,
	const struct log *log);

/*
 * Compares the files to write with each other and with the files to read, by
 * device and inode instead of by path; devices and pipes may be named twice.
 * No file of --export may be the model. pose, export, character and levels
 * write one kind of file each and refuse endings of other kinds, such as a.png.
 * Returns 0, or -EINVAL after logging an error.
 */
int options_check_files(const struct options *options, enum command_bit command,
	const struct log *log);

#endif
