/*
 * A struct log that keeps its sentences, so that a test can look at them.
 *
 *	struct log_capture capture;
 *	struct log log = log_capture_begin(&capture);
 *
 *	assert_int_equal(model_load(path, &log, &model), -EINVAL);
 *	assert_int_equal(capture.count, 1);
 *	assert_contains(capture.sentence[0], "meshes[0]");
 */
#ifndef TESTS_SUPPORT_LOG_CAPTURE_H
#define TESTS_SUPPORT_LOG_CAPTURE_H

#include "platform/base/log.h"

#include <stdbool.h>

enum {
	LOG_CAPTURE_CAPACITY = 16,
	LOG_CAPTURE_LENGTH = 1024
};

struct log_capture {
	int count; /* sentences logged; only the first CAPACITY are kept */
	enum log_level level[LOG_CAPTURE_CAPACITY];
	char sentence[LOG_CAPTURE_CAPACITY][LOG_CAPTURE_LENGTH];
};

/*
 * Empties the capture and returns a log that writes into it, from notes to
 * errors. The capture must outlive the log.
 */
struct log log_capture_begin(struct log_capture *capture);

/* Whether a kept sentence of that level contains the part. */
bool log_capture_has(const struct log_capture *capture, enum log_level level,
	const char *part);

/* The number of kept sentences of that level. */
int log_capture_count(const struct log_capture *capture, enum log_level level);

#endif
