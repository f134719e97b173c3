#include "platform/buttons/device_access.h"

#include <grp.h>
#include <stddef.h>
#include <sys/stat.h>

void device_say_denied(const struct log *log, const char *path)
{
	struct stat status;
	const struct group *group = NULL;

	if (stat(path, &status) == 0 && (status.st_mode & S_IRGRP) &&
		status.st_gid != 0) {
		group = getgrgid(status.st_gid);
	}
	if (group) {
		log_warning(log,
			"%s: no permission: join the group %s (as root: "
			"adduser USER %s, then log in again)",
			path, group->gr_name, group->gr_name);
	} else {
		log_warning(log,
			"%s: no permission: only root may open it: run as "
			"root or give it a group",
			path);
	}
}
