/*
 * What the fuzz targets of loaders share: a log that counts errors, and a check
 * that ends the program.
 */
#ifndef TESTS_FUZZ_FUZZ_EXPECT_H
#define TESTS_FUZZ_FUZZ_EXPECT_H

#include "platform/base/log.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* libFuzzer calls it with each input. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline void fuzz_count_error(
	void *user, enum log_level level, const char *message)
{
	int *errors = user;

	(void)message;
	*errors += level == LOG_ERROR;
}

/* A log that adds its errors to *errors. */
static inline struct log fuzz_log(int *errors)
{
	return (struct log){
		.write = fuzz_count_error,
		.user = errors,
		.threshold = LOG_NOTE,
	};
}

static inline void fuzz_expect(bool holds)
{
	if (!holds) {
		abort();
	}
}

#endif
