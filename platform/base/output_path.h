/*
 * The paths of output_file.c: the file behind symbolic links, and the name of
 * the temporary file.
 */
#ifndef PLATFORM_BASE_OUTPUT_PATH_H
#define PLATFORM_BASE_OUTPUT_PATH_H

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
