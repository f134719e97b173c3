/*
 * A struct survey that keeps its findings, for tests that look at them.
 */
#ifndef TESTS_SUPPORT_SURVEY_CAPTURE_H
#define TESTS_SUPPORT_SURVEY_CAPTURE_H

#include "platform/base/survey.h"

enum {
	SURVEY_CAPTURE_ROOM = 64
};

struct survey_captured {
	enum survey_state state;
	char subject[128], text[512], remedy[512]; /* remedy "": none */
};

struct survey_capture {
	int count;
	struct survey_captured finding[SURVEY_CAPTURE_ROOM];
};

/*
 * Empties the capture and returns a survey into it, which must not outlive it.
 * system: a folder that stands for /sys; NULL for one that is empty.
 */
struct survey survey_capture_begin(
	struct survey_capture *capture, const char *system);

/*
 * Fails the test unless the finding of that number has these parts; remedy
 * NULL: it must have none.
 */
void survey_capture_expect(const struct survey_capture *capture, int number,
	enum survey_state state, const char *subject, const char *text,
	const char *remedy);

#endif
