/*
 * What the doctor found, for people or as JSON.
 */
#ifndef APP_CMD_DOCTOR_DOCTOR_REPORT_H
#define APP_CMD_DOCTOR_DOCTOR_REPORT_H

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"

struct doctor_report {
	FILE *out;
	bool json;
	json_t *findings;    /* of all sections; NULL unless json */
	bool failed;         /* no memory for a finding */
	const char *section; /* the key in JSON */
	const char *driver;  /* whose findings come, or NULL */
	int works; /* findings of that state, set to 0 by whom counts */
};

/* 0, or -ENOMEM after a sentence. */
int doctor_report_begin(struct doctor_report *report, FILE *out, bool json,
	const struct log *log);

/* A heading, and the key it has in JSON. */
void doctor_report_section(
	struct doctor_report *report, const char *title, const char *key);

/* Where drivers put their findings; of the machine's own sysfs. */
struct survey doctor_report_survey(struct doctor_report *report);

/*
 * The verdict; display is the one that is taken unasked, the one to name, or
 * NULL when there is none. 0, or -errno after a sentence. Releases all.
 */
int doctor_report_end(struct doctor_report *report, bool plays,
	const char *display, bool unasked, const struct log *log);

#endif
