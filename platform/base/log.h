/*
 * Messages for the person at the terminal.
 *
 * There is no global log: a struct log is passed to every function that may
 * have to report something. A failure is logged once, where its cause is
 * known; callers only pass the error code on. A message has the form "WHAT:
 * WHY" or "WHAT: WHY: WHAT TO DO", where WHAT is the file, device or option.
 * It has no final newline.
 */
#ifndef PLATFORM_BASE_LOG_H
#define PLATFORM_BASE_LOG_H

#include "platform/base/compiler.h"

enum log_level {
	LOG_ERROR,   /* the command fails */
	LOG_WARNING, /* the command continues without something */
	LOG_NOTE,    /* shown with --verbose only */
};

struct log {
	/* Receives one formatted message, valid during the call. */
	void (*write)(void *user, enum log_level level, const char *message);
	void *user;               /* passed to write() */
	enum log_level threshold; /* messages of higher levels are dropped */
};

/* Returns a log that writes lines "limber: MESSAGE" to standard error. */
struct log log_to_stderr(enum log_level threshold);

/* Returns a log that drops every message, for tests and probes. */
struct log log_to_nowhere(void);

/*
 * Formats and writes one message. It is cut after 5,119 bytes; characters that
 * a terminal would execute are replaced (printable.h).
 */
void log_write(const struct log *log, enum log_level level, const char *format,
	...) PRINTF_LIKE(3, 4);

#define log_error(log, ...)   log_write((log), LOG_ERROR, __VA_ARGS__)
#define log_warning(log, ...) log_write((log), LOG_WARNING, __VA_ARGS__)
#define log_note(log, ...)    log_write((log), LOG_NOTE, __VA_ARGS__)

#endif
