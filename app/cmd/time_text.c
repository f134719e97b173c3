#include "app/cmd/time_text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const double DAY_S = 86400;
static const double DEFAULT_RATE_HZ = 30;

/* strtod() that refuses signs, spaces, infinity and NaN. */
static int parse_number(const char *text, const char **end, double *out)
{
	char *after;

	if (!strchr("0123456789.", *text) || !*text) {
		return -EINVAL;
	}
	*out = strtod(text, &after);
	*end = after;
	return after == text ? -EINVAL : 0;
}

/* Reads the unit; *rate_hz is how many of it make one second. */
static int parse_unit(const char *text, double *rate_hz)
{
	const char *end;

	*rate_hz = 1;
	if (!*text) {
		return 0;
	}
	if (strcmp(text, "t") == 0) {
		*rate_hz = TICKS_PER_SECOND;
		return 0;
	}
	*rate_hz = DEFAULT_RATE_HZ;
	if (strcmp(text, "f") == 0) {
		return 0;
	}
	if (strncmp(text, "f@", 2) != 0 ||
		parse_number(text + 2, &end, rate_hz)) {
		return -EINVAL;
	}
	return !*end && *rate_hz > 0 ? 0 : -EINVAL;
}

int time_parse(const char *text, double *out_s)
{
	const char *unit;
	double value, rate_hz;

	if (parse_number(text, &unit, &value) || parse_unit(unit, &rate_hz)) {
		return -EINVAL;
	}
	value /= rate_hz;
	if (!(value <= DAY_S)) {
		return -EINVAL;
	}
	*out_s = value;
	return 0;
}
