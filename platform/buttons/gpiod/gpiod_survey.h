/*
 * What there is to be seen of GPIO chips and lines.
 */
#ifndef PLATFORM_BUTTONS_GPIOD_GPIOD_SURVEY_H
#define PLATFORM_BUTTONS_GPIOD_GPIOD_SURVEY_H

#include "platform/base/survey.h"

/*
 * button_driver.survey(): each chip, then those of its lines that have a name
 * or a user. No line is taken.
 */
void gpiod_survey(const struct survey *survey);

#endif
