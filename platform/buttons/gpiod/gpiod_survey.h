/*
 * The GPIO chips and lines that limber doctor reports.
 */
#ifndef PLATFORM_BUTTONS_GPIOD_GPIOD_SURVEY_H
#define PLATFORM_BUTTONS_GPIOD_GPIOD_SURVEY_H

#include "platform/base/survey.h"

/*
 * button_driver.survey(): reports each chip, then those of its lines that have
 * a name or are in use. Requests no line.
 */
void gpiod_survey(const struct survey *survey);

#endif
