/*
 * Time as an input: from the machine, or counted in frames.
 *
 * With a fixed clock every run sees the same times, whatever the machine
 * does; tests, pictures and replays stand on that.
 */
#ifndef PLATFORM_PROCESS_CLOCK_H
#define PLATFORM_PROCESS_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

struct clock {
	bool fixed;
	double rate_hz;    /* fixed: frames a second */
	double start_s;    /* time of frame 0 */
	int64_t frame;     /* frames begun so far */
	int64_t origin_ns; /* real: the monotonic clock at frame 0 */
};

/* Nanoseconds of the clock that runs on whatever is set. */
int64_t clock_monotonic_ns(void);

/* Real time since now. */
struct clock clock_real(void);

/* Frame n is at start_s + n / rate_hz; rate_hz above 0. */
struct clock clock_fixed(double rate_hz, double start_s);

/* Begins the next frame (the first one is frame 0); its time in seconds. */
double clock_tick(struct clock *clock);

/* Processor time of this thread so far, in seconds: what work costs. */
double clock_thread_s(void);

/*
 * Reads "real" or "fixed:FPS" (0 < FPS <= 1000). 0, or -EINVAL for anything
 * else; says nothing.
 */
int clock_parse(const char *text, struct clock *out);

#endif
