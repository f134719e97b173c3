#include "app/cmd/show/pace.h"

#include "platform/process/clock.h"

#include <time.h>

static const double default_hz = 60.0;

/*
 * The loop must not be slower than the screen, which waits for its refresh. It
 * is only a little faster, as some screens claim to wait and do not.
 */
static const double headroom = 1.05;

struct pace pace_begin(double fps, double screen_hz)
{
	double rate_hz = fps > 0.0 ? fps
		: screen_hz > 0.0  ? screen_hz * headroom
				   : default_hz;
	int64_t period_ns = (int64_t)(1e9 / rate_hz);

	return (struct pace){
		.period_ns = period_ns,
		.next_ns = clock_monotonic_ns() + period_ns,
	};
}

struct pace pace_none(void)
{
	return (struct pace){0};
}

void pace_wait(struct pace *pace)
{
	int64_t now = pace->period_ns ? clock_monotonic_ns() : 0;
	struct timespec until = {
		.tv_sec = (time_t)(pace->next_ns / 1000000000),
		.tv_nsec = (long)(pace->next_ns % 1000000000),
	};

	if (pace->period_ns == 0) {
		return;
	}
	if (now < pace->next_ns) {
		(void)clock_nanosleep(
			CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
		pace->next_ns += pace->period_ns;
	} else {
		pace->next_ns = now + pace->period_ns;
	}
}
