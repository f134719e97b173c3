/*
 * The text console under a picture: kept from drawing, and brought back.
 *
 * A console in graphics mode stays dark after its program, so every way out
 * must bring it back: the caller's own, and signals that end the process. The
 * kernel does it for nobody, so after SIGKILL the next run has to.
 */
#ifndef PLATFORM_DISPLAY_CONSOLE_H
#define PLATFORM_DISPLAY_CONSOLE_H

#include <stdbool.h>

#include "platform/base/log.h"
#include "platform/process/device_calls.h"

struct console {
	const struct device_calls *calls;
	int fd; /* -1: there is no console, or it is another program's */
};

/*
 * Whether another program shows its pictures on the console: one that is in
 * graphics mode and watched over. A console that a killed program left in
 * graphics mode is nobody's.
 */
bool console_is_in_use(const struct device_calls *calls);

/* What to do about it, for people. */
extern const char console_in_use_remedy[];

/*
 * Puts the machine's console in graphics mode, where it has one; a warning when
 * another program has it. Only one at a time: signal handlers belong to the
 * process.
 */
void console_acquire(struct console *console, const struct device_calls *calls,
	const struct log *log);

/* Text again. Fine when nothing was taken. */
void console_release(struct console *console);

#endif
