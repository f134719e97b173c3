/*
 * Finding the files that belong to the program.
 */
#ifndef PLATFORM_BASE_FILE_H
#define PLATFORM_BASE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/base/log.h"

/* True for anything there is at that path. */
bool file_exists(const char *path);

/*
 * A number that is another one when the file has been written or replaced
 * since, by its time, size and place on the disk; 0 where there is none.
 */
uint64_t file_stamp(const char *path);

/*
 * The path of a file that comes with the program, such as "walker.glb":
 * looked for in $LIMBER_ASSETS, in assets/ above the program, and where it is
 * installed. 0, or -ENOENT after a sentence; at most size bytes.
 */
int file_find_asset(
	const char *name, const struct log *log, char *path, size_t size);

#endif
