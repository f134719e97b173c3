/*
 * What to say when a device is there and may not be opened.
 */
#ifndef PLATFORM_BUTTONS_DEVICE_ACCESS_H
#define PLATFORM_BUTTONS_DEVICE_ACCESS_H

#include "platform/base/log.h"

/* A warning that names the group whose members may open it. */
void device_access_report_denied(const struct log *log, const char *path);

#endif
