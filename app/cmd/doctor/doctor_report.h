/*
 * Prints the findings of `limber doctor` about the machine, as text or JSON.
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
	json_t *findings;    /* of all sections; NULL for text */
	bool failed;         /* there was no memory for a finding */
	const char *section; /* the section's key in JSON */
	const char *driver;  /* that reports the next findings, or NULL */
	int works;           /* number of SURVEY_WORKS; callers reset it */
};

/* Returns 0, or -ENOMEM after logging an error. */
int doctor_report_begin(struct doctor_report *report, FILE *out, bool json,
	const struct log *log);

/* Begins a section: its heading in text, its key in JSON. */
void doctor_report_section(
	struct doctor_report *report, const char *title, const char *key);

/* Returns the survey through which drivers report their findings. */
struct survey doctor_report_survey(struct doctor_report *report);

/*
 * Prints the verdict and releases the report. display is the display that
 * works, or NULL; automatic says that limber play chooses it without --display.
 * Returns 0, or -ENOMEM after logging an error.
 */
int doctor_report_end(struct doctor_report *report, bool plays,
	const char *display, bool automatic, const struct log *log);

#endif
