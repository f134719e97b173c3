/*
 * Writing a file completely or not at all. Every file that limber writes is
 * written through here.
 *
 * A regular file is written under a temporary name "NAME.XXXXXXXX.part" in its
 * own folder, and renamed when it is complete. Until then, and after every
 * failure, the old file stays in place; a failure also removes the temporary
 * file. For a symbolic link, the file that it leads to is replaced, not the
 * link. A new file has the permissions that the umask leaves. A replaced file
 * keeps its permissions, owner and group as far as the user may set them.
 *
 * A file that this process has read (file.h) is never replaced: neither when
 * the output begins, nor when it is read while the output is being written. The
 * first write fails then, so that a long work ends early.
 *
 * A process that is killed before it can clean up (by SIGKILL or a power cut)
 * leaves its temporary file behind; it is safe to delete.
 *
 * A device, a named pipe and an open descriptor (/dev/stdout, /dev/stderr,
 * /dev/fd/N) are opened and written directly. They are never removed, renamed
 * or truncated.
 */
#ifndef PLATFORM_BASE_OUTPUT_FILE_H
#define PLATFORM_BASE_OUTPUT_FILE_H

#include <stdio.h>

#include "platform/base/log.h"

struct output_file;

/*
 * Begins to write the file at path. Both path and *log are copied. Returns 0,
 * or -errno after logging an error; *out is then NULL and nothing has changed.
 * Opening a named pipe waits for its reader.
 */
int output_file_create(
	const char *path, const struct log *log, struct output_file **out);

/*
 * The same, but messages also name the option that asked for the file. The
 * string option must outlive the file.
 */
int output_file_create_for(const char *option, const char *path,
	const struct log *log, struct output_file **out);

/*
 * The same for a file that the program has read in order to change it. option
 * may be NULL.
 */
int output_file_edit(const char *option, const char *path,
	const struct log *log, struct output_file **out);

/*
 * Whether the file could be written now: begins and discards it, so that long
 * work is not done in vain, and a signal meanwhile leaves no temporary file
 * behind. Devices and pipes are not opened, as closing them would end their
 * reader. Returns 0, or -errno after logging an error. option may be NULL.
 */
int output_file_try(const char *option, const char *path, const struct log *log);

/*
 * The stream to write the content to. The file owns it. The caller need not
 * check for errors of the stream, because output_file_commit() reports the
 * first of them. A long write may check ferror() in order to end early.
 */
FILE *output_file_stream(const struct output_file *file);

/*
 * Logs why the content cannot be completed: the first write error or, if there
 * was none, the given reason. Returns -errno of that error, or -EIO. The file
 * stays open and must be discarded; committing it fails without logging again.
 */
int output_file_failed(struct output_file *file, const char *reason);

/*
 * Flushes the stream and renames the file to its own name before it is
 * complete, so that a reader sees what is written from now on. Only the first
 * call renames. Returns 0, or -errno without logging; the old file is then
 * still in place.
 */
int output_file_publish(struct output_file *file);

/*
 * Completes the file: writes its content to the disk, then renames it to its
 * own name. Returns 0, or -errno after logging an error; the content is then
 * discarded, unless it was published. Closes and releases the file in both
 * cases.
 */
int output_file_commit(struct output_file *file);

/*
 * Closes and releases the file. Removes what was written, unless it was
 * published. NULL is fine.
 */
void output_file_discard(struct output_file *file);

/*
 * A file in memory without a name, for content that is read again before it is
 * written. The caller closes it. Returns NULL and sets errno on failure.
 */
FILE *output_file_scratch(void);

/*
 * Prepares the process for writing files. Call it once, when the program starts.
 *
 * A write beyond the limit of `ulimit -f` then fails with EFBIG instead of ending
 * the process by SIGXFSZ. A standard stream that is closed gets a descriptor that
 * can be neither read nor written: otherwise the next file that is opened would
 * have its number, and messages would be written into that file.
 */
void output_file_prepare_process(void);

/*
 * Flushes standard output. Returns 0, or -errno after logging an error when
 * anything that the program printed could not be written.
 */
int output_file_flush_stdout(const struct log *log);

#endif
