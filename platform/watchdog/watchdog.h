/*
 * The machine's watchdog, which restarts the board unless it is fed in time.
 *
 * Feed it from the frame loop only, so that the board restarts when pictures
 * stop. The kernel sets its timeout (imx2_wdt.timeout=SECONDS on the kernel's
 * command line). limber does not set it, because in emulation that stops the
 * i.MX31's watchdog.
 *
 * Two seconds before the device would restart the board, a process that does
 * not feed it is ended by SIGALRM, so that init can start it again. That does
 * not help a process which the kernel has stopped, and there is no time for it
 * with a timeout below five seconds.
 */
#ifndef PLATFORM_WATCHDOG_WATCHDOG_H
#define PLATFORM_WATCHDOG_WATCHDOG_H

#include <stdint.h>
#include <time.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"
#include "platform/process/device_calls.h"

struct watchdog {
	const struct device_calls *calls;
	struct log log;
	const char *path;
	int fd;            /* -1: no watchdog */
	int64_t period_ms; /* shortest time between two writes */
	int64_t fed_ms;    /* time of the last write */
	int error;         /* of the last write, an errno; 0: it was fed */
	int limit_s;       /* of timer; 0: there is no timer */
	timer_t timer;     /* ends the process unless it is fed in time */
};

/* Returns a watchdog without a device; feeding and closing it does nothing. */
struct watchdog watchdog_none(void);

/*
 * Opens the watchdog device, which starts its timer. path must outlive *out.
 * A block device or a file that is not empty is refused with -EEXIST, as
 * feeding it would destroy what it holds. Returns 0, or -errno after logging a
 * warning; *out is then watchdog_none().
 */
int watchdog_open(struct watchdog *out, const char *path,
	const struct device_calls *calls, const struct log *log);

/*
 * Feeds the watchdog, but at most once a second, or four times a second when
 * its timeout is one second. now_ms is the time of any monotonic clock. If that
 * fails, a warning is logged once, and again when the reason changes or ends.
 */
void watchdog_feed(struct watchdog *watchdog, int64_t now_ms);

/* Stops the watchdog, where the kernel allows that, and closes it. */
void watchdog_close(struct watchdog *watchdog);

/*
 * Reports the watchdogs in the folder of devices ("/dev"). It reads sysfs only,
 * because opening a watchdog starts it.
 */
void watchdog_survey(const char *devices, const struct survey *survey);

#endif
