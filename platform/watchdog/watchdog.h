/*
 * The machine's watchdog: what is not fed in time restarts the board.
 *
 * Feed it from the frame loop alone, so that it starves when pictures stop.
 * Its time is the kernel's matter (imx2_wdt.timeout=SECONDS on the command
 * line) and is never set here: setting it stops the i.MX31's in emulation.
 */
#ifndef PLATFORM_WATCHDOG_WATCHDOG_H
#define PLATFORM_WATCHDOG_WATCHDOG_H

#include <stdint.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"
#include "platform/process/device_calls.h"

struct watchdog {
	const struct device_calls *calls;
	struct log log;
	const char *path;
	int fd; /* -1: there is none */
	int64_t period_ms;
	int64_t fed_ms;
};

/* One that is not there; feeding and closing it does nothing. */
struct watchdog watchdog_none(void);

/*
 * Starts the watchdog of that device; it counts from now on. path stays the
 * caller's and outlives it. 0, or -errno after a warning, and *out is none.
 */
int watchdog_open(struct watchdog *out, const char *path,
	const struct device_calls *calls, const struct log *log);

/*
 * Feeds it, once a second at most, or four times as often where its time is
 * a second. now_ms: of any clock that runs on.
 */
void watchdog_feed(struct watchdog *watchdog, int64_t now_ms);

/*
 * Says which watchdogs there are below the folder of devices ("/dev"), by
 * sysfs alone: opening one would start it.
 */
void watchdog_survey(const char *devices, const struct survey *survey);

/* An orderly end: stops it where the kernel allows. */
void watchdog_close(struct watchdog *watchdog);

#endif
