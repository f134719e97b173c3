/*
 * The fbdev driver with system calls that tests can replace.
 */
#ifndef PLATFORM_DISPLAY_FBDEV_FBDEV_H
#define PLATFORM_DISPLAY_FBDEV_FBDEV_H

#include "platform/display/display.h"
#include "platform/process/device_calls.h"

/* The driver's create() with other system calls, which must outlive *out. */
int fbdev_create_on(const struct device_calls *calls,
	const struct display_options *options, struct display **out);

/* The driver's survey() with other system calls. */
void fbdev_survey_on(
	const struct device_calls *calls, const struct survey *survey);

#endif
