#include "platform/base/log.h"

#include "platform/base/printable.h"

#include <stdarg.h>
#include <stdio.h>

static void write_stderr(void *user, enum log_level level, const char *sentence)
{
	(void)user;
	(void)level;
	fprintf(stderr, "limber: %s\n", sentence);
}

static void write_nowhere(void *user, enum log_level level, const char *sentence)
{
	(void)user;
	(void)level;
	(void)sentence;
}

struct log log_to_stderr(enum log_level threshold)
{
	return (struct log){.write = write_stderr, .threshold = threshold};
}

struct log log_to_nowhere(void)
{
	return (struct log){.write = write_nowhere, .threshold = LOG_ERROR};
}

void log_write(
	const struct log *log, enum log_level level, const char *format, ...)
{
	char sentence[5 * 1024]; /* fits a path of 4 KiB and the reason */
	va_list arguments;

	if (level > log->threshold) {
		return;
	}
	va_start(arguments, format);
	vsnprintf(sentence, sizeof(sentence), format, arguments);
	va_end(arguments);
	printable_make(sentence);
	log->write(log->user, level, sentence);
}
