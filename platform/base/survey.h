/*
 * A survey of the machine: what drivers find, for a person who wonders why
 * something does not play. Surveying starts nothing, changes nothing and does
 * not wait; each finding is a short line, with the command that mends it where
 * something is wrong.
 */
#ifndef PLATFORM_BASE_SURVEY_H
#define PLATFORM_BASE_SURVEY_H

#include <stdbool.h>

#include "platform/base/compiler.h"
#include "platform/base/log.h"

enum survey_state {
	SURVEY_WORKS,
	SURVEY_UNUSED,  /* sound, and nothing that limber could use */
	SURVEY_TAKEN,   /* another program has it */
	SURVEY_MISSING, /* not there */
	SURVEY_BROKEN,  /* there, and it does not work, or not for this user */
};

/* Borrowed for the call. */
struct survey_finding {
	enum survey_state state;
	const char *subject; /* "/dev/fb0" */
	const char *text;    /* "480x640, 16 bits, 2 pages" */
	const char *remedy;  /* a command, or a sentence with one; or NULL */
};

struct survey {
	void (*take)(void *user, const struct survey_finding *finding);
	void *user;
	const char *system; /* where sysfs is: "/sys", another for tests */
};

/* "works" and so on. */
const char *survey_state_name(enum survey_state state);

/*
 * Hands a finding on, its text formatted (at most 511 bytes, the rest is cut).
 * Devices name themselves: what is no printable UTF-8 in subject or text
 * becomes '?'. remedy may be NULL.
 */
void survey_report(const struct survey *survey, enum survey_state state,
	const char *subject, const char *remedy, const char *format, ...)
	PRINTF_LIKE(5, 6);

/* What a driver said, for a finding. */
struct survey_message {
	char text[512]; /* "" when it said nothing */
};

/* A log that keeps the first sentence; notes are dropped. */
struct log survey_log(struct survey_message *sentence);

/*
 * A finding from a sentence "WHAT: WHY: WHAT TO DO", whose last part is the
 * remedy unless there is another.
 */
void survey_report_message(const struct survey *survey, enum survey_state state,
	const char *subject, const struct survey_message *sentence,
	const char *remedy);

/* BROKEN: may not be opened; the remedy is the group that may, or root. */
void survey_report_denied(const struct survey *survey, const char *path);

/*
 * Whether the kernel has a device whose node is not there, and if so says
 * MISSING, with the mknod that makes it. Unless the error is -ENOENT it looks
 * at nothing. entry: below sysfs, such as "class/graphics/fb0".
 */
bool survey_report_no_node(const struct survey *survey, const char *path,
	const char *entry, int error);

/*
 * The name of the group whose members may read the file, at most size bytes;
 * false when there is none but root.
 */
bool survey_group_of(const char *path, char *name, int size);

#endif
