/*
 * The findings of `limber doctor`: which devices each driver found, and why
 * one cannot be used. A driver's survey function reports findings; it starts
 * no device, changes nothing and does not wait. A finding is a short line and,
 * when something is wrong, the command that repairs it.
 */
#ifndef PLATFORM_BASE_SURVEY_H
#define PLATFORM_BASE_SURVEY_H

#include <stdbool.h>

#include "platform/base/compiler.h"
#include "platform/base/log.h"

enum survey_state {
	SURVEY_WORKS,
	SURVEY_UNUSED,  /* it works, but limber has no use for it */
	SURVEY_TAKEN,   /* another program uses it */
	SURVEY_MISSING, /* the machine has no such device, or no device node */
	SURVEY_BROKEN,  /* it does not work, or this user may not open it */
};

/* The strings are valid during the call of take() only. */
struct survey_finding {
	enum survey_state state;
	const char *subject; /* the device, such as "/dev/fb0" */
	const char *text;    /* such as "480x640, 16 bits, 2 pages" */
	const char *remedy;  /* a command or an instruction, or NULL */
};

struct survey {
	void (*take)(void *user, const struct survey_finding *finding);
	void *user;         /* passed to take() */
	const char *system; /* where sysfs is mounted; tests use a copy */
};

/* The state in lower case: "works", "unused" and so on. */
const char *survey_state_name(enum survey_state state);

/*
 * Reports a finding with a formatted text, cut after 511 bytes. Subject and
 * text may contain names that devices chose, so bytes that are not printable
 * UTF-8 are replaced by '?'. remedy may be NULL.
 */
void survey_report(const struct survey *survey, enum survey_state state,
	const char *subject, const char *remedy, const char *format, ...)
	PRINTF_LIKE(5, 6);

/* The first error or warning that a driver logged. */
struct survey_message {
	char text[512]; /* "" when nothing was logged */
};

/* Returns a log that keeps the first error or warning in *message. */
struct log survey_log(struct survey_message *message);

/*
 * Reports a logged message of the form "WHAT: WHY: WHAT TO DO". Its last part
 * becomes the remedy when remedy is NULL.
 */
void survey_report_message(const struct survey *survey, enum survey_state state,
	const char *subject, const struct survey_message *message,
	const char *remedy);

/*
 * Reports SURVEY_BROKEN: this user may not open the device. The remedy names
 * the group that may open it, or root.
 */
void survey_report_denied(const struct survey *survey, const char *path);

/*
 * Reports SURVEY_MISSING, with the mknod command as remedy, when the kernel
 * has a device but its node does not exist. entry is the device's folder below
 * sysfs, such as "class/graphics/fb0". Returns whether it reported that; it
 * does nothing unless error is -ENOENT.
 */
bool survey_report_no_node(const struct survey *survey, const char *path,
	const char *entry, int error);

/*
 * Writes the name of the group whose members may read the file, at most size
 * bytes. Returns false when there is no such group other than root.
 */
bool survey_group_of(const char *path, char *name, int size);

#endif
