/*
 * The desktop that limber doctor reports.
 */
#ifndef PLATFORM_DISPLAY_WINDOW_WINDOW_SURVEY_H
#define PLATFORM_DISPLAY_WINDOW_WINDOW_SURVEY_H

#include "platform/base/survey.h"

/* display_driver.survey(): reports whether the desktop's server accepts a
 * connection. */
void window_survey(const struct survey *survey);

#endif
