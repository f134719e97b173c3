/*
 * Writing down what was pressed, as a script that --script plays again.
 */
#ifndef APP_CMD_SHOW_BUTTON_RECORD_H
#define APP_CMD_SHOW_BUTTON_RECORD_H

#include <stdio.h>

#include "platform/base/log.h"
#include "platform/buttons/buttons.h"

/* Begins zeroed: records nothing. */
struct button_record {
	FILE *file;
	const char *path;
	int64_t last_ms;
};

/* Creates the file. 0, or -errno after a sentence. The path stays argv's. */
int button_record_open(
	struct button_record *record, const char *path, const struct log *log);

/* Adds an event; times never run backwards in the file. */
void button_record_event(
	struct button_record *record, const struct button_event *event);

/* 0, or -errno after a sentence when not all could be written. */
int button_record_close(struct button_record *record, const struct log *log);

#endif
