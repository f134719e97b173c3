#include "platform/buttons/event_time.h"

#include <time.h>

static const int64_t oldest_ns = INT64_C(10000000000);

static int64_t read_clock(clockid_t id)
{
	struct timespec now = {0};

	(void)clock_gettime(id, &now);
	return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

struct event_clocks event_clocks_now(void)
{
	return (struct event_clocks){
		.monotonic_ns = read_clock(CLOCK_MONOTONIC),
		.real_ns = read_clock(CLOCK_REALTIME),
	};
}

/* The age of a stamp; -1 if the stamp is negative or later than the clock. */
static int64_t age_of(int64_t clock_ns, int64_t stamp_ns)
{
	return stamp_ns < 0 || stamp_ns > clock_ns ? -1 : clock_ns - stamp_ns;
}

int64_t event_time_ms(const struct event_clocks *clocks, int64_t stamp_ns,
	int64_t earliest_ms, int64_t now_ms)
{
	int64_t age_ns = age_of(clocks->monotonic_ns, stamp_ns);
	int64_t time_ms;

	if (age_ns < 0 || age_ns > oldest_ns) {
		age_ns = age_of(clocks->real_ns, stamp_ns);
	}
	if (age_ns < 0 || age_ns > oldest_ns) {
		age_ns = 0;
	}
	time_ms = now_ms - age_ns / 1000000;
	time_ms = time_ms < earliest_ms ? earliest_ms : time_ms;
	return time_ms > now_ms ? now_ms : time_ms;
}
