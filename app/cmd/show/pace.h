/*
 * The pace of the frame loop on the real clock.
 *
 * The loop sleeps until the next multiple of a period, which keeps frames
 * evenly spaced and lets the processor rest. A late frame delays all later
 * ones.
 */
#ifndef APP_CMD_SHOW_PACE_H
#define APP_CMD_SHOW_PACE_H

#include <stdint.h>

struct pace {
	int64_t period_ns; /* 0: never waits */
	int64_t next_ns;   /* time to wait for, of the monotonic clock */
};

/*
 * A pace of at most fps frames a second. If fps is 0, it is 5% above the
 * screen's rate screen_hz, since showing a frame waits for the screen, or 60 if
 * screen_hz is 0, too.
 */
struct pace pace_begin(double fps, double screen_hz);

/* A pace that never waits. */
struct pace pace_none(void);

/* Sleeps until next_ns, unless it has passed. A signal ends the sleep early. */
void pace_wait(struct pace *pace);

#endif
