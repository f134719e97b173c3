#include "platform/base/survey.h"

#include "platform/base/printable.h"

#include <errno.h>
#include <grp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum {
	TEXT_BYTES = 512,
	SUBJECT_BYTES = 128,
	PATH_BYTES = 256
};

const char *survey_state_name(enum survey_state state)
{
	static const char *const names[] = {
		[SURVEY_WORKS] = "works",
		[SURVEY_UNUSED] = "unused",
		[SURVEY_TAKEN] = "taken",
		[SURVEY_MISSING] = "missing",
		[SURVEY_BROKEN] = "broken",
	};

	return names[state];
}

void survey_report(const struct survey *survey, enum survey_state state,
	const char *subject, const char *remedy, const char *format, ...)
{
	char name[SUBJECT_BYTES], text[TEXT_BYTES];
	va_list arguments;

	snprintf(name, sizeof(name), "%s", subject);
	va_start(arguments, format);
	vsnprintf(text, sizeof(text), format, arguments);
	va_end(arguments);
	printable_make(name);
	printable_make(text);
	survey->take(survey->user,
		&(struct survey_finding){state, name, text, remedy});
}

static void keep(void *user, enum log_level level, const char *text)
{
	struct survey_message *message = user;

	(void)level;
	if (!message->text[0]) {
		snprintf(message->text, sizeof(message->text), "%s", text);
	}
}

struct log survey_log(struct survey_message *message)
{
	message->text[0] = '\0';
	return (struct log){keep, message, LOG_WARNING};
}

void survey_report_message(const struct survey *survey, enum survey_state state,
	const char *subject, const struct survey_message *message,
	const char *remedy)
{
	const char *text = message->text, *last = NULL;

	for (const char *at = strstr(text, ": "); at; at = strstr(at + 2, ": ")) {
		last = at;
	}
	survey_report(survey, state, subject,
		remedy         ? remedy
			: last ? last + 2
			       : NULL,
		"%.*s", last ? (int)(last - text) : (int)strlen(text), text);
}

bool survey_group_of(const char *path, char *name, int size)
{
	const struct group *group = NULL;
	struct stat status;

	if (stat(path, &status) == 0 && (status.st_mode & S_IRGRP) &&
		status.st_gid != 0) {
		group = getgrgid(status.st_gid);
	}
	return group &&
		snprintf(name, (size_t)size, "%s", group->gr_name) < size;
}

void survey_report_denied(const struct survey *survey, const char *path)
{
	char group[64], remedy[TEXT_BYTES];

	if (survey_group_of(path, group, sizeof(group))) {
		snprintf(remedy, sizeof(remedy),
			"sudo usermod -aG %s $USER, then log in again", group);
	} else {
		snprintf(remedy, sizeof(remedy),
			"run limber as root, or let a group open it: sudo chgrp video %s && sudo chmod g+rw %s",
			path, path);
	}
	survey_report(survey, SURVEY_BROKEN, path, remedy,
		"you have no permission to open it");
}

/* Reads a device's major and minor number from sysfs. */
static bool read_numbers(const struct survey *survey, const char *entry,
	unsigned int *major, unsigned int *minor)
{
	char path[PATH_BYTES];
	FILE *file;
	bool fine;

	if (snprintf(path, sizeof(path), "%s/%s/dev", survey->system, entry) >=
		(int)sizeof(path)) {
		return false;
	}
	file = fopen(path, "r");
	if (!file) {
		return false;
	}
	fine = fscanf(file, "%u:%u", major, minor) == 2;
	fclose(file);
	return fine;
}

bool survey_report_no_node(const struct survey *survey, const char *path,
	const char *entry, int error)
{
	unsigned int major, minor;
	char remedy[TEXT_BYTES];

	if (error != -ENOENT || !read_numbers(survey, entry, &major, &minor)) {
		return false;
	}
	snprintf(remedy, sizeof(remedy), "sudo mknod -m 660 %s c %u %u", path,
		major, minor);
	survey_report(survey, SURVEY_MISSING, path, remedy,
		"the kernel has this device, but its device node does not exist");
	return true;
}
