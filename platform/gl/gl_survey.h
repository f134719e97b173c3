/*
 * What the GL drivers make of this machine.
 */
#ifndef PLATFORM_GL_GL_SURVEY_H
#define PLATFORM_GL_GL_SURVEY_H

#include "platform/base/survey.h"
#include "platform/gl/gl_context.h"

/*
 * Opens every driver for pixels, one after the other, and says who draws; then
 * which one "auto" takes. request->log is not used.
 */
void gl_survey(const struct gl_request *request, const struct survey *survey);

/* Whether a driver has a screen for displays of surfaces; subject: theirs. */
void gl_survey_screen(const struct gl_request *request, const char *subject,
	const struct survey *survey);

#endif
