/*
 * A process that restores the text console for limber: if limber was killed, or
 * has given up its rights on it (--user).
 *
 * The kernel lets only root, or a process that the console is the controlling
 * terminal of, change a console's mode. The guard is forked before the rights
 * are given up. It reads no files and does nothing but wait: for one of the
 * requests below, and for the end of limber, however that comes about, even by
 * SIGKILL. Then it restores the console and ends.
 */
#ifndef PLATFORM_DISPLAY_CONSOLE_GUARD_H
#define PLATFORM_DISPLAY_CONSOLE_GUARD_H

#include <sys/types.h>

#include "platform/process/device_calls.h"

struct console_guard {
	pid_t process; /* 0: there is none */
	int line;      /* a socket to it */
};

enum console_request {
	CONSOLE_TEXT_MODE,     /* KDSETMODE with KD_TEXT */
	CONSOLE_STAY,          /* VT_RELDISP: refuses to switch */
	CONSOLE_LEAVE,         /* VT_RELDISP: lets the kernel switch */
	CONSOLE_RETURN,        /* VT_RELDISP with VT_ACKACQ */
	CONSOLE_SWITCH_FREELY, /* VT_SETMODE with VT_AUTO: the kernel asks nobody */
	CONSOLE_REQUESTS
};

/* Makes a request of the console, by this process. Returns 0 or -errno. */
int console_request(const struct device_calls *calls, int console,
	enum console_request request);

/* Starts a guard of the console that is open. Returns 0 or -errno. */
int console_guard_begin(struct console_guard *guard,
	const struct device_calls *calls, int console);

/* Lets the guard make a request. Returns 0, or -errno, also without a guard. */
int console_guard_request(
	const struct console_guard *guard, enum console_request request);

/* Ends the guard, which restores the console. Without a guard, does nothing. */
void console_guard_end(struct console_guard *guard);

#endif
