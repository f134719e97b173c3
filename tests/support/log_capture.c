#include "tests/support/log_capture.h"

#include <stdio.h>
#include <string.h>

static void keep_sentence(void *user, enum log_level level, const char *sentence)
{
	struct log_capture *capture = user;
	int at = capture->count++;

	if (at < LOG_CAPTURE_CAPACITY) {
		capture->level[at] = level;
		snprintf(capture->sentence[at], LOG_CAPTURE_LENGTH, "%s",
			sentence);
	}
}

static int kept(const struct log_capture *capture)
{
	return capture->count < LOG_CAPTURE_CAPACITY ? capture->count
						     : LOG_CAPTURE_CAPACITY;
}

struct log log_capture_begin(struct log_capture *capture)
{
	memset(capture, 0, sizeof(*capture));
	return (struct log){
		.write = keep_sentence,
		.user = capture,
		.threshold = LOG_NOTE,
	};
}

bool log_capture_has(const struct log_capture *capture, enum log_level level,
	const char *part)
{
	for (int i = 0; i < kept(capture); i++) {
		if (capture->level[i] == level &&
			strstr(capture->sentence[i], part)) {
			return true;
		}
	}
	return false;
}

int log_capture_count(const struct log_capture *capture, enum log_level level)
{
	int count = 0;

	for (int i = 0; i < kept(capture); i++) {
		count += capture->level[i] == level;
	}
	return count;
}
