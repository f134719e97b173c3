/*
 * Records button events as a script, which --script plays back.
 */
#ifndef APP_CMD_SHOW_BUTTON_RECORD_H
#define APP_CMD_SHOW_BUTTON_RECORD_H

#include <stdbool.h>

#include "platform/base/output_file.h"
#include "platform/buttons/buttons.h"

/* All zero: nothing is recorded. */
struct button_record {
	struct output_file *file;
	int64_t last_ms;
};

/* Begins to write the file. Returns 0, or -errno after logging an error. */
int button_record_open(
	struct button_record *record, const char *path, const struct log *log);

/*
 * Adds an event; times never decrease in the file. The line is in the file when
 * this returns, since a board may be switched off at any time. The first event
 * replaces the file that stood there before.
 */
void button_record_event(
	struct button_record *record, const struct button_event *event);

/*
 * Completes the file. If complete is false and there was no event, the file
 * that stood there before stays. Returns 0, or -errno after logging an error
 * when the file could not be written.
 */
int button_record_close(struct button_record *record, bool complete);

#endif
