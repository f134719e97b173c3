/*
 * The text console, which must not draw over the pictures on a screen.
 *
 * A console in graphics mode stays dark until a program sets text mode again.
 * console_release() does that, and so does a handler for all signals that end
 * the process. A guard (console_guard.h) does it after SIGKILL, and for a process
 * that has given up its rights. Meanwhile Ctrl-Z and other stops by the terminal
 * do nothing: the screen of a stopped program would look frozen.
 *
 * The kernel asks by a signal before it switches to another console (Ctrl-Alt-F2,
 * chvt), and tells by another one when it has switched back. The display answers
 * between two frames, when it has given the screen back or taken it again.
 */
#ifndef PLATFORM_DISPLAY_CONSOLE_H
#define PLATFORM_DISPLAY_CONSOLE_H

#include <stdbool.h>

#include "platform/base/log.h"
#include "platform/display/console_guard.h"
#include "platform/process/device_calls.h"

struct display;

struct console {
	const struct device_calls *calls;
	struct log log;
	int fd;        /* -1: there is no console, or another program uses it */
	bool switches; /* the kernel asks before it switches */
	bool away;     /* another console is on the screen */
	struct console_guard guard;
};

/*
 * Whether another program draws on the console: the console is in graphics
 * mode, and a program other than limber handles its switching. A console that a
 * killed program left in graphics mode is not in use.
 */
bool console_is_in_use(const struct device_calls *calls);

/* The remedy for a console in use, for limber doctor. */
extern const char console_in_use_remedy[];

/*
 * Switches the console to graphics mode, if the machine has one, and starts its
 * guard. Logs a warning when another program uses it, or without a guard.
 * Acquire only one at a time, because signal handlers belong to the process.
 */
void console_acquire(struct console *console, const struct device_calls *calls,
	const struct log *log);

/*
 * Answers what the kernel has asked for, by one of two functions of the
 * display: give gives the screen back and calls console_leave(), or
 * console_refuse(); take takes the screen again and calls console_return(), or
 * is called again. Returns whether another console is on the screen. Call it
 * once a frame, between frames.
 */
bool console_follow(struct console *console, void (*give)(struct display *),
	void (*take)(struct display *), struct display *display);

/*
 * Lets the kernel switch. Nothing may be drawn until console_return(). Returns
 * 0, or -errno after logging a warning: the console stays, and the display
 * takes the screen again.
 */
int console_leave(struct console *console);

/* Refuses to leave: the screen cannot be given back. */
void console_refuse(struct console *console);

/* Goes on after the kernel has switched back. */
void console_return(struct console *console);

/*
 * Drops what was typed meanwhile and switches back to text mode, also for a
 * program in the background. Does nothing when no console was acquired.
 */
void console_release(struct console *console);

#endif
