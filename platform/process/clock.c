#include "platform/process/clock.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

int64_t clock_monotonic_ns(void)
{
	struct timespec now = {0};

	/* If the system has no such clock, the result is 0 every time. */
	(void)clock_gettime(CLOCK_MONOTONIC, &now);
	return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

int64_t clock_monotonic_ms(void)
{
	return clock_monotonic_ns() / 1000000;
}

struct clock clock_real(void)
{
	return (struct clock){.origin_ns = clock_monotonic_ns()};
}

struct clock clock_fixed(double rate_hz, double start_s)
{
	return (struct clock){
		.fixed = true,
		.rate_hz = rate_hz,
		.start_s = start_s,
	};
}

void clock_begin(struct clock *clock, double start_s)
{
	clock->frame = 0;
	clock->start_s = start_s;
	clock->origin_ns = clock_monotonic_ns() - (int64_t)(start_s * 1e9);
}

double clock_tick(struct clock *clock)
{
	int64_t frame = clock->frame++;

	if (clock->fixed) {
		return clock->start_s + (double)frame / clock->rate_hz;
	}
	return (double)(clock_monotonic_ns() - clock->origin_ns) * 1e-9;
}

double clock_thread_s(void)
{
	struct timespec spent = {0};

	(void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
	return (double)spent.tv_sec + (double)spent.tv_nsec * 1e-9;
}

int clock_parse(const char *text, struct clock *out)
{
	static const char prefix[] = "fixed:";
	const char *number = text + sizeof(prefix) - 1;
	char *end;
	double rate_hz;

	if (strcmp(text, "real") == 0) {
		*out = clock_real();
		return 0;
	}
	if (strncmp(text, prefix, sizeof(prefix) - 1) != 0) {
		return -EINVAL;
	}
	rate_hz = strtod(number, &end);
	if (end == number || *end ||
		!(rate_hz >= CLOCK_RATE_MIN_HZ && rate_hz <= CLOCK_RATE_MAX_HZ)) {
		return -EINVAL;
	}
	*out = clock_fixed(rate_hz, 0);
	return 0;
}
