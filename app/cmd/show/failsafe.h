/*
 * Shows the built-in demo instead of a model that keeps ending limber, for
 * boards that start limber by themselves.
 *
 * A file counts the starts of a model, or of another demo, that ended within a
 * minute by an error, a crash or the watchdog's signal. After two of them the
 * built-in demo is shown instead, until the model's file changes or the
 * counting file is gone. A counting file in a RAM file system is gone after a
 * reset.
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
	const char *path; /* of the counting file; NULL: not counting */
	const struct log *log;
	int64_t began_ms;
	bool gives_way;
	char name[FAILSAFE_NAME_BYTES]; /* of the model or demo, if gives_way */
};

/*
 * Counts a start, at now_ms, of the model or demo that the options show, unless
 * it is the built-in demo. If it has ended limber too often, changes *options
 * to show the built-in demo, and counts no more. Logs a warning and counts
 * nothing if the counting file cannot be written or has other content.
 */
struct failsafe failsafe_begin(
	struct options *options, int64_t now_ms, const struct log *log);

/* Resets the count once the run is a minute old. Cheap, for every frame. */
void failsafe_feed(struct failsafe *failsafe, int64_t now_ms);

/* Ends the run; resets the count if it ended in order. */
void failsafe_end(struct failsafe *failsafe, bool in_order);

#endif
