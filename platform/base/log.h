/*
 * Sentences for the person at the terminal.
 *
 * A struct log is passed to whatever may have to say something; there is no
 * global one. A failure is logged once, where its cause is known, and names
 * the file, device or option and what to do; callers above only pass the
 * error code on. Shape of a sentence: "WHAT: WHY", without a final newline.
 */
#ifndef PLATFORM_BASE_LOG_H
#define PLATFORM_BASE_LOG_H

#include "platform/base/compiler.h"

enum log_level {
	LOG_ERROR,   /* the command fails */
	LOG_WARNING, /* it goes on with less */
	LOG_NOTE,    /* worth knowing; shown with --verbose */
};

struct log {
	/* Receives one formatted sentence; user is passed through. */
	void (*write)(void *user, enum log_level level, const char *sentence);
	void *user;
	enum log_level threshold; /* levels above it are dropped */
};

/* A log that writes "limber: SENTENCE" lines to standard error. */
struct log log_to_stderr(enum log_level threshold);

/* A log that drops everything, for tests and probes. */
struct log log_to_nowhere(void);

/* Formats one sentence (at most 1,023 bytes; the rest is cut). */
void log_write(const struct log *log, enum log_level level, const char *format,
	...) PRINTF_LIKE(3, 4);

#define log_error(log, ...)   log_write((log), LOG_ERROR, __VA_ARGS__)
#define log_warning(log, ...) log_write((log), LOG_WARNING, __VA_ARGS__)
#define log_note(log, ...)    log_write((log), LOG_NOTE, __VA_ARGS__)

#endif
