/*
 * Paths that output is written to: what is there, the file behind symbolic
 * links, and the name of the temporary file.
 */
#ifndef PLATFORM_BASE_OUTPUT_PATH_H
#define PLATFORM_BASE_OUTPUT_PATH_H

#include <stdbool.h>
#include <stdio.h>

enum output_kind {
	OUTPUT_NEW,    /* nothing is there, or the path cannot be reached */
	OUTPUT_FILE,   /* a regular file, which would be replaced */
	OUTPUT_FOLDER, /* which cannot be written to */
	/* A device, a pipe or an open descriptor: nothing is replaced, */
	OUTPUT_STREAM,
	OUTPUT_STDOUT, /* and the same for the program's standard output. */
};

/*
 * What writing to path would write to, with links followed. Standard output is
 * OUTPUT_STDOUT whatever the shell has redirected it to. Every option that
 * names an output goes by this.
 */
enum output_kind output_path_kind(const char *path);

/* Whether the output is a stream, whose name need not tell its format. */
bool output_path_is_stream(const char *path);

/*
 * Where a command prints what it says about its output: stdout, or stderr if
 * the output itself goes to stdout and must contain nothing else. path may be
 * NULL for no output.
 */
FILE *output_path_report(const char *path);

/*
 * Follows the symbolic links at the end of path, as open() does. *target is
 * the path that they lead to, whether a file exists there or not; the caller
 * frees it. *descriptor is the descriptor that the path names (/dev/stdout,
 * /dev/stderr, /dev/fd/N, /proc/self/fd/N), or -1. Returns 0, or -errno with
 * *target NULL.
 */
int output_path_follow(const char *path, char **target, int *descriptor);

/*
 * Returns a path for a temporary file in target's folder, another one for every
 * call, attempt and process. NULL when memory is short. The caller frees it.
 */
char *output_path_temporary(const char *target, unsigned attempt);

#endif
