/*
 * Times as people write them: in seconds, in frames at a rate, in ticks.
 */
#ifndef PLATFORM_BASE_TIME_TEXT_H
#define PLATFORM_BASE_TIME_TEXT_H

#include <stddef.h>

/* 3ds Max counts in ticks: 160 a frame at 30 a second, 200 at 24. */
#define TICKS_PER_SECOND 4800

/*
 * Reads a time in seconds ("1.5"), in frames at a rate ("45f@30"; "45f" is at
 * 30 a second) or in ticks ("7200t"). 0, or -EINVAL for anything else, for a
 * negative time and for one above a day; *out_s is then left alone.
 */
int time_parse(const char *text, double *out_s);

enum time_unit {
	TIME_SECONDS,
	TIME_FRAMES,
	TIME_TICKS,
};

enum {
	TIME_TEXT_BYTES = 48
};

/*
 * Writes a time of up to a day as time_parse() reads it: "1.500", "45f@30",
 * "7200t". Frames and ticks are rounded to whole ones; rate_hz is for frames.
 */
void time_format(double time_s, enum time_unit unit, double rate_hz,
	char text[TIME_TEXT_BYTES]);

#endif
