#include "platform/watchdog/watchdog.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum {
	WATCHDOGS_MAX = 8,
	PATH_BYTES = 256,
	VALUE_BYTES = 80
};

/* Reads an attribute from sysfs; "" if there is none. */
static void read_value(const struct survey *survey, int number,
	const char *name, char value[VALUE_BYTES])
{
	char path[PATH_BYTES];
	FILE *file;

	value[0] = '\0';
	if (snprintf(path, sizeof(path), "%s/class/watchdog/watchdog%d/%s",
		    survey->system, number, name) >= (int)sizeof(path)) {
		return;
	}
	file = fopen(path, "r");
	if (!file) {
		return;
	}
	if (!fgets(value, VALUE_BYTES, file)) {
		value[0] = '\0';
	}
	value[strcspn(value, "\n")] = '\0';
	fclose(file);
}

static void report_watchdog(
	const char *path, int number, const struct survey *survey)
{
	char identity[VALUE_BYTES], timeout_s[VALUE_BYTES], state[VALUE_BYTES];

	read_value(survey, number, "identity", identity);
	read_value(survey, number, "timeout", timeout_s);
	read_value(survey, number, "state", state);
	if (strcmp(state, "active") == 0) {
		survey_report(survey, SURVEY_TAKEN, path,
			"stop the program that uses it (systemd: RuntimeWatchdogSec=off), or leave --watchdog out",
			"%s, another program uses it", identity);
	} else if (access(path, W_OK) != 0) {
		survey_report_denied(survey, path);
	} else {
		survey_report(survey, SURVEY_WORKS, path, NULL,
			"%s%srestarts the board after %s seconds", identity,
			identity[0] ? ", " : "",
			timeout_s[0] ? timeout_s : "some");
	}
}

/* Reports the watchdog of that number; false when there is none. */
static bool report_number(
	const char *devices, int number, const struct survey *survey)
{
	char path[PATH_BYTES], entry[64];

	if (snprintf(path, sizeof(path), "%s/watchdog%d", devices, number) >=
		(int)sizeof(path)) {
		return false;
	}
	if (access(path, F_OK) == 0) {
		report_watchdog(path, number, survey);
		return true;
	}
	snprintf(entry, sizeof(entry), "class/watchdog/watchdog%d", number);
	return survey_report_no_node(survey, path, entry, -errno);
}

void watchdog_survey(const char *devices, const struct survey *survey)
{
	char path[PATH_BYTES];
	bool any = false;

	for (int i = 0; i < WATCHDOGS_MAX; i++) {
		any = report_number(devices, i, survey) || any;
	}
	/* Old kernels have only "watchdog", the name of the first one. */
	if (!any &&
		snprintf(path, sizeof(path), "%s/watchdog", devices) <
			(int)sizeof(path) &&
		access(path, F_OK) == 0) {
		report_watchdog(path, 0, survey);
		any = true;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "watchdog",
			"load its driver, or the software watchdog: sudo modprobe softdog",
			"there is no watchdog in %s", devices);
	}
}
