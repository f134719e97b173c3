/*
 * How often the frame loop goes round on a real clock.
 *
 * The loop sleeps until moments a fixed time apart, so that the pictures keep
 * an even pace and the processor rests; a late frame moves the moments on.
 */
#ifndef APP_CMD_SHOW_PACE_H
#define APP_CMD_SHOW_PACE_H

#include <stdint.h>

struct pace {
	int64_t period_ns; /* 0: never waits */
	int64_t next_ns;   /* of the monotonic clock */
};

/*
 * At most fps frames a second; 0 leaves it to the screen, whose rate is
 * screen_hz and which makes the loop wait itself, or, where that is 0, means
 * 60.
 */
struct pace pace_begin(double fps, double screen_hz);

/* No waiting at all. */
struct pace pace_none(void);

/*
 * Sleeps until the next moment, or not at all when it is over. A signal ends
 * the sleep early.
 */
void pace_wait(struct pace *pace);

#endif
