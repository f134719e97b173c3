/*
 * Becoming a user with fewer rights, once the devices are open.
 */
#ifndef PLATFORM_PROCESS_USER_H
#define PLATFORM_PROCESS_USER_H

#include "platform/base/log.h"

/*
 * Makes this process and all its threads that user for good, with the user's
 * groups and without capabilities; open files stay open. Does nothing for a
 * process that is this user already. Returns 0, or -errno after logging an
 * error that names the option --user: -ENOENT if there is no such user, -EPERM
 * if the process is not root, -EMFILE if the list of users cannot be opened for
 * lack of descriptors. After an error the process must not go on.
 */
int user_become(const char *name, const struct log *log);

#endif
