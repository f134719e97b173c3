#include "platform/display/console.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>

const char console_in_use_remedy[] =
	"use its desktop with --display window, or switch to a text console: sudo chvt 3";

enum {
	SIGNALS = 65, /* Linux numbers its signals from 1 to 64 */
	/* Of the kernel: no other program is likely to take this pair. */
	LEAVE_SIGNAL = 61,
	RETURN_SIGNAL = 62
};

/* A signal handler can reach static variables only. */
static struct {
	const struct device_calls *calls;
	volatile sig_atomic_t fd;
	volatile sig_atomic_t switches, leaves, returns;
	bool changed[SIGNALS];
	struct sigaction before[SIGNALS];
} taken;

/*
 * A program that handles another signal itself is expected to end in order and
 * to call console_release(), so others are caught only where they have their
 * default action.
 */
static bool is_fault(int number)
{
	return number == SIGSEGV || number == SIGBUS || number == SIGILL ||
		number == SIGFPE || number == SIGABRT || number == SIGSYS;
}

/* Ctrl-Z, and what a shell sends to a program in the background. */
static bool stops_process(int number)
{
	return number == SIGTSTP || number == SIGTTIN || number == SIGTTOU;
}

/* Whether a process that does not handle the signal ends. */
static bool ends_process(int number)
{
	switch (number) {
	case SIGKILL: /* cannot be caught */
	case SIGSTOP:
	case SIGCHLD:
	case SIGCONT:
	case SIGURG:
	case SIGWINCH:
		return false;
	default:
		return !stops_process(number);
	}
}

/* Returns 0, or -1 with errno set. */
static int set_graphics_mode(const struct console *console)
{
	return device_control(console->calls, console->fd, KDSETMODE,
		(void *)(uintptr_t)KD_GRAPHICS);
}

/* Lets this process answer when a switch is asked for. 0, or -1. */
static int take_switching(const struct console *console)
{
	struct vt_mode switching = {
		.mode = VT_PROCESS,
		.relsig = LEAVE_SIGNAL,
		.acqsig = RETURN_SIGNAL,
	};

	return device_control(
		console->calls, console->fd, VT_SETMODE, &switching);
}

/* Makes a request, with the guard's rights if limber has none. 0 or -errno. */
static int request(const struct console *console, enum console_request what)
{
	int error = console_request(console->calls, console->fd, what);

	return error == -EPERM && console->guard.process
		? console_guard_request(&console->guard, what)
		: error;
}

static void note_switch(int number)
{
	if (number == LEAVE_SIGNAL) {
		taken.leaves = 1;
	} else {
		taken.returns = 1;
	}
}

/*
 * The signal handler. It raises the signal again, which is delivered with its
 * former action when the handler returns.
 */
static void restore_text_mode(int number)
{
	/* Without rights this fails, and the guard does it after the end. */
	(void)console_request(taken.calls, taken.fd, CONSOLE_TEXT_MODE);
	if (taken.leaves) {
		(void)console_request(taken.calls, taken.fd, CONSOLE_LEAVE);
	}
	if (taken.switches) {
		(void)console_request(
			taken.calls, taken.fd, CONSOLE_SWITCH_FREELY);
	}
	sigaction(number, &taken.before[number], NULL);
	raise(number);
}

static bool switches_console(int number)
{
	return number == LEAVE_SIGNAL || number == RETURN_SIGNAL;
}

static struct sigaction action_of(int number)
{
	struct sigaction action = {.sa_handler = restore_text_mode};

	sigemptyset(&action.sa_mask);
	if (stops_process(number)) {
		action.sa_handler = SIG_IGN;
	} else if (switches_console(number)) {
		action.sa_handler = note_switch;
		action.sa_flags = SA_RESTART;
	}
	return action;
}

/*
 * Catches what ends the process and what switches consoles, and ignores what
 * stops it: a stopped program would keep the screen and its last picture, and a
 * watchdog would bite.
 */
static void change_signals(const struct console *console)
{
	sigset_t switching;

	taken.calls = console->calls;
	taken.fd = console->fd;
	taken.switches = taken.leaves = taken.returns = 0;
	for (int i = 1; i < SIGNALS; i++) {
		struct sigaction *before = &taken.before[i];
		const struct sigaction action = action_of(i);

		taken.changed[i] = false;
		/* It fails for the signals that the C library keeps. */
		if ((!ends_process(i) && !stops_process(i)) ||
			sigaction(i, NULL, before) != 0) {
			continue;
		}
		taken.changed[i] = before->sa_handler == SIG_DFL ||
			switches_console(i) ||
			(is_fault(i) && before->sa_handler != SIG_IGN);
		if (taken.changed[i]) {
			(void)sigaction(i, &action, NULL);
		}
	}
	/* The kernel waits for answers to them for ever. */
	sigemptyset(&switching);
	sigaddset(&switching, LEAVE_SIGNAL);
	sigaddset(&switching, RETURN_SIGNAL);
	(void)sigprocmask(SIG_UNBLOCK, &switching, NULL);
}

static void restore_signals(void)
{
	for (int i = 1; i < SIGNALS; i++) {
		if (taken.changed[i]) {
			(void)sigaction(i, &taken.before[i], NULL);
		}
	}
}

/*
 * Whether another program handles the switching. A limber that was killed is
 * not noticed by the kernel before the next switch.
 */
static bool is_anothers(const struct vt_mode *mode)
{
	return mode->mode != VT_AUTO &&
		(mode->relsig != LEAVE_SIGNAL || mode->acqsig != RETURN_SIGNAL);
}

/*
 * Opens the current console: /dev/tty0 or, if that is no console, /dev/tty.
 * *in_use is what console_is_in_use() promises. Returns the descriptor, or -1
 * when there is no console.
 */
static int open_console(
	const struct device_calls *calls, const struct log *log, bool *in_use)
{
	static const char *const paths[] = {"/dev/tty0", "/dev/tty", NULL};

	*in_use = false;
	for (int i = 0; paths[i]; i++) {
		int fd = calls->open(paths[i], O_RDWR | O_CLOEXEC | O_NOCTTY);
		struct vt_mode watch = {0};
		int mode = KD_TEXT;

		if (fd < 0) {
			if (errno == EACCES || errno == EPERM) {
				log_note(log,
					"%s: no permission: the console may draw over the picture",
					paths[i]);
			}
			continue;
		}
		if (device_control(calls, fd, KDGETMODE, &mode) == 0) {
			*in_use = mode != KD_TEXT &&
				device_control(calls, fd, VT_GETMODE, &watch) ==
					0 &&
				is_anothers(&watch);
			return fd;
		}
		calls->close(fd);
	}
	return -1;
}

bool console_is_in_use(const struct device_calls *calls)
{
	struct log nowhere = log_to_nowhere();
	bool in_use;
	int fd = open_console(calls, &nowhere, &in_use);

	if (fd >= 0) {
		calls->close(fd);
	}
	return in_use;
}

static void begin_guard(struct console *console)
{
	int error = console_guard_begin(
		&console->guard, console->calls, console->fd);

	if (error) {
		log_warning(&console->log,
			"console: no process can be started that restores it: %s: it may stay dark when limber ends",
			strerror(-error));
	}
}

void console_acquire(struct console *console, const struct device_calls *calls,
	const struct log *log)
{
	bool in_use;

	*console = (struct console){.calls = calls, .log = *log};
	console->fd = open_console(calls, log, &in_use);
	if (console->fd < 0) {
		return;
	}
	if (!in_use) {
		change_signals(console);
		if (set_graphics_mode(console) == 0) {
			/* If this fails, the kernel switches to no console. */
			console->switches = take_switching(console) == 0;
			taken.switches = console->switches;
			begin_guard(console);
			return;
		}
		restore_signals();
	}
	log_warning(log,
		in_use ? "console: another program (X or Wayland) draws on this screen, too: switch to a text console first"
		       : "console: it has no graphics mode: it may draw over the picture");
	calls->close(console->fd);
	console->fd = -1;
}

bool console_follow(struct console *console, void (*give)(struct display *),
	void (*take)(struct display *), struct display *display)
{
	if (console->fd < 0 || !console->switches) {
		return false;
	}
	if (console->away && taken.returns) {
		take(display);
	} else if (!console->away && taken.leaves) {
		give(display);
	}
	return console->away;
}

/* Answers need rights that a process may have given up (--user). */
int console_leave(struct console *console)
{
	int error;

	taken.leaves = taken.returns = 0;
	error = request(console, CONSOLE_LEAVE);
	console->away = !error;
	if (error) {
		log_warning(&console->log,
			"console: limber may not let the kernel switch to another one: %s: start it on a terminal of this console, or leave --user out",
			strerror(-error));
	}
	return error;
}

void console_refuse(struct console *console)
{
	taken.leaves = 0;
	(void)request(console, CONSOLE_STAY);
}

void console_return(struct console *console)
{
	console->away = false;
	taken.returns = 0;
	(void)request(console, CONSOLE_RETURN);
}

void console_release(struct console *console)
{
	if (console->fd < 0) {
		return;
	}
	/* The shell must not read the keys that were pressed as buttons. */
	(void)device_control(console->calls, console->fd, TCFLSH,
		(void *)(uintptr_t)TCIFLUSH);
	(void)request(console, CONSOLE_TEXT_MODE);
	/* A switch that waits for an answer takes place. */
	if (taken.leaves) {
		(void)request(console, CONSOLE_LEAVE);
	}
	if (taken.switches) {
		(void)request(console, CONSOLE_SWITCH_FREELY);
	}
	console_guard_end(&console->guard);
	restore_signals();
	console->calls->close(console->fd);
	console->fd = -1;
}
