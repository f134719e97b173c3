/*
 * Writing down what was pressed, as a script that --script plays again.
 */
#ifndef APP_CMD_SHOW_BUTTON_RECORD_H
#define APP_CMD_SHOW_BUTTON_RECORD_H

#include <stdbool.h>

#include "platform/base/output_file.h"
#include "platform/buttons/buttons.h"

/* Begins zeroed: records nothing. */
struct button_record {
	struct output_file *file;
	int64_t last_ms;
};

/* Begins to write the file. 0, or -errno after a sentence. */
int button_record_open(
	struct button_record *record, const char *path, const struct log *log);

/*
 * Adds an event; times never run backwards in the file. The line is in the file
 * when this returns, as the board may be switched off at any time: the first
 * event replaces the file that stood there before.
 */
void button_record_event(
	struct button_record *record, const struct button_event *event);

/*
 * Completes the file. After a run that failed (complete is false) before any
 * event, the file that stood there before stays. 0, or -errno after a sentence
 * when not all could be written.
 */
int button_record_close(struct button_record *record, bool complete);

#endif
