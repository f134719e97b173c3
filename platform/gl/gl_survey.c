#include "platform/gl/gl_survey.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/*
 * Reports why a driver failed. If its library is missing, the remedy is to
 * install the driver's packages.
 */
static void report_failed(const struct gl_driver *driver, int error,
	const char *subject, const struct survey_message *sentence,
	const struct survey *survey)
{
	char remedy[256];
	bool install = error == -ENOENT && driver->packages &&
		strstr(sentence->text, "install ");

	if (install) {
		snprintf(remedy, sizeof(remedy), "sudo apt install %s",
			driver->packages);
	}
	survey_report_message(survey, install ? SURVEY_MISSING : SURVEY_BROKEN,
		subject, sentence, install ? remedy : NULL);
}

static void report_driver(const struct gl_driver *driver,
	const struct gl_request *request, const struct survey *survey)
{
	struct survey_message sentence;
	struct log log = survey_log(&sentence);
	struct gl_request own = *request;
	struct gl_context *context;
	int error;

	own.log = &log;
	error = driver->create(&own, &context);
	if (error) {
		report_failed(driver, error, driver->name, &sentence, survey);
		return;
	}
	survey_report(survey, SURVEY_WORKS, driver->name, NULL, "%s; %s draws",
		context->description,
		context->accelerated ? "a graphics processor" : "the processor");
	driver->destroy(context);
}

static void report_auto(
	const struct gl_request *request, const struct survey *survey)
{
	struct survey_message sentence;
	struct log log = survey_log(&sentence);
	struct gl_request own = *request;
	struct gl_context *context;

	own.log = &log;
	if (gl_open("auto", &own, &context) != 0) {
		survey_report_message(
			survey, SURVEY_BROKEN, "auto", &sentence, NULL);
		return;
	}
	survey_report(survey, SURVEY_WORKS, "auto", NULL, "takes %s",
		context->driver->name);
	context->driver->destroy(context);
}

void gl_survey(const struct gl_request *request, const struct survey *survey)
{
	for (int i = 0; gl_registry[i]; i++) {
		report_driver(gl_registry[i], request, survey);
	}
	report_auto(request, survey);
}

static void report_screen(const struct gl_driver *driver,
	const struct gl_request *request, const char *subject,
	const struct survey *survey)
{
	struct survey_message sentence;
	struct log log = survey_log(&sentence);
	struct gl_request own = *request;
	int error;

	own.log = &log;
	error = driver->find_screen(&own);
	if (!error) {
		survey_report(survey, SURVEY_WORKS, subject, NULL,
			"--gl %s has a screen or windows", driver->name);
	} else if (error == -ENOENT) {
		report_failed(driver, error, subject, &sentence, survey);
	} else {
		survey_report_message(survey, SURVEY_MISSING, subject, &sentence,
			"use --display kms or fbdev, or name the vendor's libraries: --egl-library FILE --gles-library FILE");
	}
}

void gl_survey_screen(const struct gl_request *request, const char *subject,
	const struct survey *survey)
{
	for (int i = 0; gl_registry[i]; i++) {
		if (gl_registry[i]->surface) {
			report_screen(gl_registry[i], request, subject, survey);
		}
	}
}
