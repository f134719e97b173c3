/*
 * Giving way to the built-in demo, for boards that start limber by themselves.
 *
 * A file counts the starts of a model, or of another demo, that ended with an
 * error, a crash or a signal of the watchdog's within a minute. After two of
 * them the built-in demo is shown instead, until the model's file changes, or
 * the counting file is gone, as one in memory is after a reset.
 */
#ifndef APP_CMD_SHOW_FAILSAFE_H
#define APP_CMD_SHOW_FAILSAFE_H

#include "app/cmd/options/options.h"

#include <stdbool.h>
#include <stdint.h>

enum {
	FAILSAFE_STARTS = 2,
	FAILSAFE_MS = 60000,
	FAILSAFE_NAME_BYTES = 48
};

struct failsafe {
	const char *path; /* of the counting file; NULL: it counts nothing */
	const struct log *log;
	int64_t began_ms;
	bool gives_way;
	char name[FAILSAFE_NAME_BYTES]; /* of what ended limber, if so */
};

/*
 * Counts this start of what the options show at now_ms, unless that is the
 * built-in demo. If it has ended limber too often, it is not counted any more,
 * and options, which are a copy, show the built-in demo. A file that cannot be
 * written or that holds something else stays as it is, which is logged.
 */
struct failsafe failsafe_begin(
	struct options *options, int64_t now_ms, const struct log *log);

/* Forgets the counted starts when the run is a minute old. Cheap. */
void failsafe_feed(struct failsafe *failsafe, int64_t now_ms);

/* Ends the run; one that ended in order is not counted. */
void failsafe_end(struct failsafe *failsafe, bool in_order);

#endif
