/*
 * Where a confined process may write.
 */
#ifndef PLATFORM_PROCESS_CONFINE_FILES_H
#define PLATFORM_PROCESS_CONFINE_FILES_H

/*
 * From now on only the outputs, which NULL ends, can be written: a device or
 * pipe itself, else the folder of the file with what is in it. Reading is not
 * restricted; no file can be executed. The process has PR_SET_NO_NEW_PRIVS.
 * Returns 0 or -errno.
 */
int confine_files(const char *const *output);

#endif
