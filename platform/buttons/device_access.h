/*
 * Reporting a device that exists but may not be opened by this user.
 */
#ifndef PLATFORM_BUTTONS_DEVICE_ACCESS_H
#define PLATFORM_BUTTONS_DEVICE_ACCESS_H

#include "platform/base/log.h"

/* Logs a warning that names the group whose members may open the device. */
void device_access_report_denied(const struct log *log, const char *path);

#endif
