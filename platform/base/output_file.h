/*
 * Writing files so that a failure harms nothing. Every file that limber writes
 * is written through here.
 *
 * A regular file is written under a temporary name in its own folder, as
 * "NAME.XXXXXXXX.part", and renamed to its own name when it is whole. Until
 * then, and after every failure, what stood at the path before stands there
 * still, and the temporary file is removed. A symbolic link is followed: the
 * file that it leads to is replaced, not the link. A new file has the
 * permissions that the umask leaves; a replaced one keeps its permissions, its
 * owner and its group as far as the user may set them.
 *
 * Everything else is opened as it is and written directly: a device, a named
 * pipe, or a descriptor that is open already (/dev/stdout, /dev/stderr,
 * /dev/fd/N). It is never removed, renamed or truncated.
 */
#ifndef PLATFORM_BASE_OUTPUT_FILE_H
#define PLATFORM_BASE_OUTPUT_FILE_H

#include <stdio.h>

#include "platform/base/log.h"

struct output_file;

/*
 * Begins to write the file at path, which is copied, as is *log. 0, or -errno
 * after a sentence: then *out is NULL and nothing has changed. Opening a named
 * pipe waits for its reader.
 */
int output_file_create(
	const char *path, const struct log *log, struct output_file **out);

/* The same, and sentences name the option that asked for the file as well. */
int output_file_create_for(const char *option, const char *path,
	const struct log *log, struct output_file **out);

/*
 * Where the content goes. It belongs to the file. Its errors need not be looked
 * at: output_file_commit() reports the first of them. A writer that goes on for
 * long looks at ferror() to end early.
 */
FILE *output_file_stream(const struct output_file *file);

/*
 * Says why the content cannot be completed: the first error of writing, or,
 * when there was none, the reason given. Returns -errno, or -EIO with the
 * reason. The file stays open, to be discarded; committing it fails without
 * another sentence.
 */
int output_file_failed(struct output_file *file, const char *reason);

/*
 * Writes out what is buffered and puts the file in its place before it is
 * complete, so that what is written from now on is seen there at once. Does
 * nothing when that has happened before. 0, or -errno without a sentence: then
 * what stood at the path stands there still.
 */
int output_file_publish(struct output_file *file);

/*
 * Completes the file: its content is on the disk, then it takes its place. 0,
 * or -errno after a sentence: then the content is discarded, unless it was
 * published. The file is closed and released in both cases.
 */
int output_file_commit(struct output_file *file);

/*
 * Closes and releases the file and removes what was written of it, unless that
 * was published. NULL is fine.
 */
void output_file_discard(struct output_file *file);

/*
 * Makes a write beyond the size that `ulimit -f` allows fail as other writes
 * do, where it would end the process. Once, when the program begins.
 */
void output_file_survive_limits(void);

/*
 * Writes out what standard output buffers. 0, or -errno after a sentence when
 * anything that the program printed could not be written.
 */
int output_file_flush_stdout(const struct log *log);

#endif
