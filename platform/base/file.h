/*
 * Files: reading whole ones, and finding what belongs to the program.
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
 * A regular file of at most limit_bytes as bytes, with a zero after the last
 * one. 0, or -errno after a sentence that names the file. The caller frees
 * *data.
 */
int file_read(const char *path, size_t limit_bytes, const struct log *log,
	uint8_t **data, size_t *size);

/*
 * The path of a file that comes with the program, such as "walker.glb":
 * looked for in $LIMBER_ASSETS, in assets/ above the program, and where it is
 * installed. 0, or -ENOENT after a sentence; at most size bytes.
 */
int file_find_asset(
	const char *name, const struct log *log, char *path, size_t size);

#endif
