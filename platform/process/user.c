#define _DEFAULT_SOURCE /* initgroups() */

#include "platform/process/user.h"

#include "platform/process/shortage.h"

#include <errno.h>
#include <grp.h>
#include <pwd.h>
#include <stdbool.h>
#include <string.h>
#include <unistd.h>

static int refuse(const char *name, int error, const struct log *log)
{
	log_error(log, "--user %s: %s", name,
		error == EPERM
			? "only root can become another user: run as root, or leave --user out"
			: strerror(error));
	return -error;
}

/* Whether getpwnam() failed; the other errors say that there is no such user. */
static bool is_failure(int error)
{
	return shortage_is(error) || error == EIO;
}

int user_become(const char *name, const struct log *log)
{
	const struct passwd *user;

	errno = 0;
	user = getpwnam(name);
	if (!user && is_failure(errno)) {
		return refuse(name, errno, log);
	}
	if (!user) {
		log_error(log,
			"--user %s: there is no such user: see /etc/passwd",
			name);
		return -ENOENT;
	}
	if (user->pw_uid == getuid() && user->pw_uid == geteuid()) {
		return 0;
	}
	if (initgroups(name, user->pw_gid) != 0 || setgid(user->pw_gid) != 0 ||
		setuid(user->pw_uid) != 0) {
		return refuse(name, errno, log);
	}
	/*
	 * A process that can become root again has not given up its rights.
	 * Not counted: another user cannot write the counters of make coverage.
	 */
	if (user->pw_uid != 0 && setuid(0) == 0) {
		return refuse(name, EPERM, log);
	}
	return 0;
}
