#include "app/cmd/show/button_record.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

int button_record_open(
	struct button_record *record, const char *path, const struct log *log)
{
	int error;

	*record = (struct button_record){.path = path};
	record->file = fopen(path, "w");
	if (!record->file) {
		error = -errno;
		log_error(log, "%s: cannot be written: %s", path,
			strerror(-error));
		return error;
	}
	/* A line is there as soon as the button is: the board may be
	 * switched off at any time. */
	setvbuf(record->file, NULL, _IOLBF, BUFSIZ);
	return 0;
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
	fprintf(record->file, "%" PRId64 " %s %s\n", record->last_ms,
		button_name(event->button), event->down ? "down" : "up");
}

int button_record_close(struct button_record *record, const struct log *log)
{
	bool failed;

	if (!record->file) {
		return 0;
	}
	failed = ferror(record->file);
	failed = fclose(record->file) != 0 || failed;
	record->file = NULL;
	if (failed) {
		log_error(log, "%s: could not be written to its end: %s",
			record->path, "is the disk full?");
		return -EIO;
	}
	return 0;
}
