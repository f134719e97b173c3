/*
 * The GL drivers that limber doctor reports.
 */
#ifndef PLATFORM_GL_GL_SURVEY_H
#define PLATFORM_GL_GL_SURVEY_H

#include "platform/base/survey.h"
#include "platform/gl/gl_context.h"

/*
 * Opens every driver for pixels, one after the other, and reports whether a
 * graphics processor draws; then reports which driver "auto" takes.
 * request->log is not used.
 */
void gl_survey(const struct gl_request *request, const struct survey *survey);

/*
 * Reports, for the display that subject names, whether drivers with .surface
 * find a screen.
 */
void gl_survey_screen(const struct gl_request *request, const char *subject,
	const struct survey *survey);

#endif
