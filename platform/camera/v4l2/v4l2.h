/*
 * The V4L2 driver with system calls that tests can replace.
 */
#ifndef PLATFORM_CAMERA_V4L2_V4L2_H
#define PLATFORM_CAMERA_V4L2_V4L2_H

#include "platform/camera/camera.h"
#include "platform/camera/v4l2/v4l2_calls.h"

/* camera_driver.create(). calls must outlive the source and its thread. */
int v4l2_source_create(const struct camera_options *options,
	const struct v4l2_calls *calls, struct camera_source **out);

/* camera_driver.survey(). calls must outlive threads blocked in a driver. */
void v4l2_survey_on(const struct v4l2_calls *calls, const struct survey *survey);

#endif
