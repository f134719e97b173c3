/*
 * Converts the kernel's time stamps to the program's time.
 *
 * Debouncing needs the time at which a contact moved, and frames are too far
 * apart for that, so it uses the kernel's time stamps. Old kernels stamp with
 * the real-time clock, newer ones with the monotonic clock (GPIO lines since
 * Linux 5.7), so both clocks are tried.
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
 * Converts the time stamp stamp_ns to the program's time in ms. clocks were
 * read at the program's time now_ms. The result is clamped to earliest_ms..
 * now_ms. A stamp that fits neither clock, because it is more than 10 s old or
 * in the future, gives now_ms.
 */
int64_t event_time_ms(const struct event_clocks *clocks, int64_t stamp_ns,
	int64_t earliest_ms, int64_t now_ms);

#endif
