#include "app/cmd/time_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool time_text_parse(const char *text, double *time_s)
{
	char *end;
	double value = strtod(text, &end);

	if (end == text || !isfinite(value)) {
		return false;
	}
	if (strcmp(end, "t") == 0) {
		value /= TIME_TICKS_PER_S;
	} else if (strncmp(end, "f@", 2) == 0) {
		const char *rate_text = end + 2;
		double rate_hz = strtod(rate_text, &end);

		if (end == rate_text || *end || !(rate_hz > 0.0) ||
			!isfinite(rate_hz)) {
			return false;
		}
		value /= rate_hz;
	} else if (*end) {
		return false;
	}
	*time_s = value;
	return isfinite(value);
}
