/*
 * A progress bar on a terminal, for work that takes longer than a second.
 */
#ifndef APP_CMD_PROGRESS_H
#define APP_CMD_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct progress {
	FILE *out; /* NULL: no bar */
	int total;
	const char *unit; /* "frames" */
	int64_t start_ms, shown_ms;
	bool visible;
};

/* No bar if total is below 2 or out is no terminal. unit is not copied. */
struct progress progress_begin(int total, const char *unit, FILE *out);

/* Shows the bar once a second has passed, and at most ten times a second. */
void progress_step(struct progress *progress, int done);

/* Erases the bar. */
void progress_end(struct progress *progress);

#endif
