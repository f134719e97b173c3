/*
 * Opens a file of any bytes as a button script and plays it to its end.
 */
#include "platform/buttons/buttons.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void play(const char *path)
{
	struct log log = log_to_nowhere();
	struct buttons buttons;
	struct button_event event;
	char spec[64];

	snprintf(spec, sizeof(spec), "script:%s", path);
	if (buttons_open(&buttons, spec, &log)) {
		return;
	}
	for (int64_t now_ms = 0; now_ms < INT64_MAX / 4;
		now_ms = 2 * now_ms + 1) {
		buttons_poll(&buttons, now_ms);
		while (button_queue_pop(&buttons.queue, &event)) {
			if (event.button >= BUTTON_COUNT ||
				event.time_ms > now_ms) {
				abort();
			}
		}
	}
	buttons_close(&buttons);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	char path[] = "/tmp/limber-fuzz-script-XXXXXX";
	int file = mkstemp(path);

	if (file < 0) {
		return 0;
	}
	if (write(file, data, size) == (ssize_t)size) {
		play(path);
	}
	close(file);
	unlink(path);
	return 0;
}
