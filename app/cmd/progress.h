/*
 * A bar on a terminal, for work that takes longer than a second.
 */
#ifndef APP_CMD_PROGRESS_H
#define APP_CMD_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct progress {
	FILE *out; /* NULL: nothing is shown */
	int total;
	int64_t start_ms, shown_ms;
	bool visible;
};

/* total 0, or an out that is no terminal: shows nothing. */
struct progress progress_begin(int total, FILE *out);

/* Shows the bar a second after the beginning, then ten times a second. */
void progress_step(struct progress *progress, int done);

/* Wipes the bar. */
void progress_end(struct progress *progress);

#endif
