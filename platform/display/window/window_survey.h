/*
 * Whether there is a desktop to open a window on.
 */
#ifndef PLATFORM_DISPLAY_WINDOW_WINDOW_SURVEY_H
#define PLATFORM_DISPLAY_WINDOW_WINDOW_SURVEY_H

#include "platform/base/survey.h"

/* display_driver.survey(): asks whether the desktop's server listens. */
void window_survey(const struct survey *survey);

#endif
