/*
 * A struct survey that keeps its findings, so that a test can look at them.
 */
#ifndef TESTS_SUPPORT_SURVEY_CAPTURE_H
#define TESTS_SUPPORT_SURVEY_CAPTURE_H

#include "platform/base/survey.h"

enum {
	SURVEY_CAPTURE_CAPACITY = 64
};

struct survey_captured {
	enum survey_state state;
	char subject[128], text[512];
	char remedy[512]; /* empty where there is none */
};

struct survey_capture {
	int count;
	struct survey_captured finding[SURVEY_CAPTURE_CAPACITY];
};

/*
 * Empties the capture and returns a survey that writes into it. The capture
 * must outlive the survey. system is the folder that stands for /sys; NULL
 * stands for a folder that does not exist.
 */
struct survey survey_capture_begin(
	struct survey_capture *capture, const char *system);

/*
 * Fails the test unless the finding of that number has this state and contains
 * these parts. remedy NULL asks for a finding without a remedy.
 */
void survey_capture_expect(const struct survey_capture *capture, int number,
	enum survey_state state, const char *subject, const char *text,
	const char *remedy);

#endif
