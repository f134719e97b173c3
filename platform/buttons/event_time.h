/*
 * From the kernel's time stamps to the program's time.
 *
 * The kernel says when a contact moved, which is finer than when a frame came
 * to ask: debouncing goes by it. Which clock it stamps with depends on its age
 * (GPIO lines: real time before Linux 5.7), so both are tried.
 */
#ifndef PLATFORM_BUTTONS_EVENT_TIME_H
#define PLATFORM_BUTTONS_EVENT_TIME_H

#include <stdint.h>

/* Both clocks at one moment. */
struct event_clocks {
	int64_t monotonic_ns, real_ns;
};

struct event_clocks event_clocks_now(void);

/*
 * The program's time of what was stamped stamp_ns, in ms. The clocks were read
 * when it was now_ms. Never before earliest_ms nor after now_ms; a stamp that
 * fits neither clock (more than 10 s old, or to come) counts as now.
 */
int64_t event_time_ms(const struct event_clocks *clocks, int64_t stamp_ns,
	int64_t earliest_ms, int64_t now_ms);

#endif
