/*
 * Looking for files, opening them, and finding those that come with the program.
 *
 * Which files the process has read is known to the process as a whole, as those
 * are that it has open: whatever reads a file notes it here, so that no output
 * replaces it (output_file.h).
 */
#ifndef PLATFORM_BASE_FILE_H
#define PLATFORM_BASE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "platform/base/log.h"

/* Whether anything exists at that path: a file, a folder, a device. */
bool file_exists(const char *path);

/*
 * Opens a file for reading, as fopen() does, but never waits for another
 * program to open a named pipe: one that no program writes to is refused.
 * Returns NULL with errno set; EPIPE for such a pipe. The caller closes it.
 * Notes the file as read.
 */
FILE *file_open(const char *path);

/*
 * What the user may do about a file that could not be opened for reading, by
 * errno: ": " and a demand, such as ": check the name and its folder", or "".
 */
const char *file_open_advice(int error);

/*
 * Opens a file for reading, as file_open() does. If it cannot be opened, logs
 * an error that says so, and what to do; errno stays set.
 */
FILE *file_open_logged(const char *path, const struct log *log);

enum {
	FILES_NOTED = 4096
};

/*
 * Notes the open file as one that this process reads. It is known by its device,
 * inode and time of birth, whatever links lead to it. Threads may call this at once.
 */
void file_note_read(int fd);

/* Whether the path leads to one of the last FILES_NOTED files that were noted. */
bool file_was_read(const char *path);

/*
 * A number that changes when the file is written or replaced: a hash of its
 * modification time, size and inode. 0 when there is no file.
 */
uint64_t file_stamp(const char *path);

/*
 * Finds a file that comes with the program, such as "walker.glb": in
 * $LIMBER_ASSETS, then in assets/ and share/limber/ of every folder above the
 * executable. Writes its path, at most size bytes. Returns 0, or -ENOENT after
 * logging an error.
 */
int file_find_asset(
	const char *name, const struct log *log, char *path, size_t size);

#endif
