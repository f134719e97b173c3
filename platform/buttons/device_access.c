#include "platform/buttons/device_access.h"

#include "platform/base/survey.h"

void device_access_report_denied(const struct log *log, const char *path)
{
	char group[64];

	if (survey_group_of(path, group, sizeof(group))) {
		log_warning(log,
			"%s: no permission: join the group %s (as root: adduser USER %s, then log in again)",
			path, group, group);
	} else {
		log_warning(log,
			"%s: no permission: only root may open it: run limber as root, or let a group open it",
			path);
	}
}
