/*
 * Where a file that is to be written really lies, and what its temporary file
 * is called. Parts of output_file.c; nothing else needs them.
 */
#ifndef PLATFORM_BASE_OUTPUT_PATH_H
#define PLATFORM_BASE_OUTPUT_PATH_H

/*
 * Follows the symbolic links at the end of path, as opening it would. *target
 * is where they lead, whether there is a file or not; the caller frees it.
 * *descriptor is the number of an open descriptor of this process when they
 * lead to one (/dev/stdout, /dev/stderr, /dev/fd/N, /proc/self/fd/N), else -1.
 * 0, or -errno and *target is NULL.
 */
int output_path_follow(const char *path, char **target, int *descriptor);

/*
 * A name for a temporary file in target's folder. It differs from one call,
 * attempt and process to the next. NULL without memory; the caller frees it.
 */
char *output_path_temporary(const char *target, unsigned attempt);

#endif
