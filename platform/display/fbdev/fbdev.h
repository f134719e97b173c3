/*
 * Linux framebuffers, for tests that stand in for one.
 */
#ifndef PLATFORM_DISPLAY_FBDEV_FBDEV_H
#define PLATFORM_DISPLAY_FBDEV_FBDEV_H

#include "platform/display/display.h"
#include "platform/process/device_calls.h"

/* The driver's create(), on a system of the caller's. */
int fbdev_create_on(const struct device_calls *calls,
	const struct display_options *options, struct display **out);

/* The driver's survey(), likewise. */
void fbdev_survey_on(
	const struct device_calls *calls, const struct survey *survey);

#endif
