/*
 * The clock of the frame loop: real time, or time counted in frames.
 *
 * With a fixed clock every run gets the same times on every machine. Tests,
 * rendered pictures and replays depend on that.
 */
#ifndef PLATFORM_PROCESS_CLOCK_H
#define PLATFORM_PROCESS_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

/* The rates of a fixed clock that a user may choose. At the lowest, the time of
 * frame INT_MAX is still below 2^53 ms. */
#define CLOCK_RATE_MIN_HZ 0.001
#define CLOCK_RATE_MAX_HZ 1000.0

struct clock {
	bool fixed;
	double rate_hz;    /* fixed clock: frames a second */
	double start_s;    /* fixed clock: time of frame 0 */
	int64_t frame;     /* frames begun so far */
	int64_t origin_ns; /* real clock: the monotonic time of its time 0 */
};

/* The monotonic clock in nanoseconds. Setting the time does not change it. */
int64_t clock_monotonic_ns(void);

/* The same in whole milliseconds. */
int64_t clock_monotonic_ms(void);

/* Returns a clock of real time that starts now. */
struct clock clock_real(void);

/*
 * Returns a clock that counts frames: frame n is at start_s + n / rate_hz.
 * rate_hz must be above 0.
 */
struct clock clock_fixed(double rate_hz, double start_s);

/* Lets the clock begin now: the next frame is frame 0 and at start_s. */
void clock_begin(struct clock *clock, double start_s);

/* Begins the next frame, the first of which is 0. Returns its time in seconds. */
double clock_tick(struct clock *clock);

/* The processor time that this thread has used so far, in seconds. */
double clock_thread_s(void);

/*
 * Reads "real" or "fixed:FPS", with a rate between the limits above. Returns 0,
 * or -EINVAL for anything else without logging.
 */
int clock_parse(const char *text, struct clock *out);

#endif
