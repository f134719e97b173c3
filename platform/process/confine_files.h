/*
 * Where a confined process may write.
 */
#ifndef PLATFORM_PROCESS_CONFINE_FILES_H
#define PLATFORM_PROCESS_CONFINE_FILES_H

/*
 * From now on only the outputs, a list that NULL ends, can be written: for a
 * device or pipe only itself, for another file its folder and everything in it.
 * Reading is not restricted; no file can be executed. PR_SET_NO_NEW_PRIVS must
 * be set before. Returns 0 or -errno.
 */
int confine_files(const char *const *output);

#endif
