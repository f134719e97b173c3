#include "platform/display/console.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <sys/ioctl.h>
#include <termios.h>

#include "platform/base/compiler.h"

const char console_in_use_remedy[] =
	"use its desktop with --display window, or switch to a text console: sudo chvt 3";

/*
 * The signals that end a process. A program that handles one of the last six
 * itself is expected to end in order and to call console_release(), so these
 * are caught only where they have their default action.
 */
static const struct {
	int number;
	bool only_default;
} endings[] = {
	{SIGSEGV, false},
	{SIGBUS, false},
	{SIGILL, false},
	{SIGFPE, false},
	{SIGABRT, false},
	{SIGSYS, false},
	{SIGQUIT, true},
	{SIGPIPE, true},
	{SIGALRM, true},
	{SIGINT, true},
	{SIGTERM, true},
	{SIGHUP, true},
};

enum {
	ENDING_COUNT = ARRAY_COUNT(endings)
};

/* A signal handler can reach static variables only. */
static struct {
	const struct device_calls *calls;
	volatile sig_atomic_t fd;
	bool caught[ENDING_COUNT];
	struct sigaction before[ENDING_COUNT];
} taken;

static int set_mode(const struct device_calls *calls, int fd, uintptr_t mode)
{
	return device_control(calls, fd, KDSETMODE, (void *)mode);
}

/*
 * The signal handler. It raises the signal again, which is delivered with its
 * former action when the handler returns.
 */
static void restore_text_mode(int number)
{
	set_mode(taken.calls, taken.fd, KD_TEXT);
	for (int i = 0; i < ENDING_COUNT; i++) {
		if (endings[i].number == number) {
			sigaction(number, &taken.before[i], NULL);
		}
	}
	raise(number);
}

static void catch_endings(const struct console *console)
{
	struct sigaction action = {.sa_handler = restore_text_mode};

	taken.calls = console->calls;
	taken.fd = console->fd;
	sigemptyset(&action.sa_mask);
	for (int i = 0; i < ENDING_COUNT; i++) {
		struct sigaction *before = &taken.before[i];

		/* sigaction() cannot fail for these signals. */
		(void)sigaction(endings[i].number, NULL, before);
		taken.caught[i] = before->sa_handler == SIG_DFL ||
			(!endings[i].only_default &&
				before->sa_handler != SIG_IGN);
		if (taken.caught[i]) {
			(void)sigaction(endings[i].number, &action, NULL);
		}
	}
}

static void release_endings(void)
{
	for (int i = 0; i < ENDING_COUNT; i++) {
		if (taken.caught[i]) {
			(void)sigaction(
				endings[i].number, &taken.before[i], NULL);
		}
	}
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
				watch.mode != VT_AUTO;
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

void console_acquire(struct console *console, const struct device_calls *calls,
	const struct log *log)
{
	bool in_use;

	*console = (struct console){.calls = calls};
	console->fd = open_console(calls, log, &in_use);
	if (console->fd < 0) {
		return;
	}
	if (!in_use) {
		catch_endings(console);
		if (set_mode(calls, console->fd, KD_GRAPHICS) == 0) {
			return;
		}
		release_endings();
	}
	log_warning(log,
		in_use ? "console: another program (X or Wayland) draws on this screen, too: switch to a text console first"
		       : "console: it has no graphics mode: it may draw over the picture");
	calls->close(console->fd);
	console->fd = -1;
}

void console_release(struct console *console)
{
	if (console->fd < 0) {
		return;
	}
	/* The shell must not read the keys that were pressed as buttons. */
	(void)device_control(console->calls, console->fd, TCFLSH,
		(void *)(uintptr_t)TCIFLUSH);
	set_mode(console->calls, console->fd, KD_TEXT);
	release_endings();
	console->calls->close(console->fd);
	console->fd = -1;
}
