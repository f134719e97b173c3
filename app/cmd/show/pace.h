/*
 * The pace of the frame loop on the real clock.
 *
 * The loop sleeps until moments at a fixed distance, which keeps frames evenly
 * spaced and lets the processor rest. A late frame delays the moments after it.
 */
#ifndef APP_CMD_SHOW_PACE_H
#define APP_CMD_SHOW_PACE_H

#include <stdint.h>

struct pace {
	int64_t period_ns; /* 0: never waits */
	int64_t next_ns;   /* of the monotonic clock */
};

/*
 * At most fps frames a second. With fps 0 the screen's rate screen_hz decides,
 * since showing a frame waits for the screen; 60 where that is 0 too.
 */
struct pace pace_begin(double fps, double screen_hz);

/* A pace that never waits. */
struct pace pace_none(void);

/*
 * Sleeps until the next moment, unless it has passed. A signal ends the sleep
 * early.
 */
void pace_wait(struct pace *pace);

#endif
