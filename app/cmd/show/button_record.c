#include "app/cmd/show/button_record.h"

#include <inttypes.h>
#include <stdio.h>

int button_record_open(
	struct button_record *record, const char *path, const struct log *log)
{
	*record = (struct button_record){NULL, 0};
	return output_file_create(path, log, &record->file);
}

void button_record_event(
	struct button_record *record, const struct button_event *event)
{
	if (!record->file) {
		return;
	}
	if (event->time_ms > record->last_ms) {
		record->last_ms = event->time_ms;
	}
	fprintf(output_file_stream(record->file), "%" PRId64 " %s %s\n",
		record->last_ms, button_name(event->button),
		event->down ? "down" : "up");
	/* button_record_close() reports what could not be written. */
	(void)output_file_publish(record->file);
}

int button_record_close(struct button_record *record, bool complete)
{
	struct output_file *file = record->file;

	record->file = NULL;
	if (!file) {
		return 0;
	}
	if (!complete) {
		output_file_discard(file);
		return 0;
	}
	return output_file_commit(file);
}
