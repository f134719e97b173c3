#include "platform/display/console.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "platform/base/compiler.h"

/*
 * What ends a process. Whoever handles the last ones, ends in order and gives
 * the console back itself.
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
	{SIGINT, true},
	{SIGTERM, true},
	{SIGHUP, true},
};

enum {
	ENDING_COUNT = ARRAY_COUNT(endings)
};

/* A handler has nothing but the process's own memory to look at. */
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

/* The signal comes again, blocked until the handler is left. */
static void end_in_text(int number)
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
	struct sigaction action = {.sa_handler = end_in_text};

	taken.calls = console->calls;
	taken.fd = console->fd;
	sigemptyset(&action.sa_mask);
	for (int i = 0; i < ENDING_COUNT; i++) {
		struct sigaction *before = &taken.before[i];

		/* Fails for no signal of the list. */
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

static int open_console(const struct device_calls *calls, const struct log *log)
{
	/* The one that is seen; a name for it where there are no numbers. */
	static const char *const paths[] = {"/dev/tty0", "/dev/tty", NULL};

	for (int i = 0; paths[i]; i++) {
		int fd = calls->open(paths[i], O_RDWR | O_CLOEXEC | O_NOCTTY);
		int mode = 0;

		if (fd < 0) {
			if (errno == EACCES || errno == EPERM) {
				log_note(log,
					"%s: no permission: the console may "
					"write over the picture",
					paths[i]);
			}
			continue;
		}
		/* A console that shows graphics is another program's matter. */
		if (device_control(calls, fd, KDGETMODE, &mode) == 0 &&
			mode == KD_TEXT) {
			return fd;
		}
		calls->close(fd);
	}
	return -1;
}

void console_take(struct console *console, const struct device_calls *calls,
	const struct log *log)
{
	*console = (struct console){.calls = calls, .fd = -1};
	console->fd = open_console(calls, log);
	if (console->fd < 0) {
		return;
	}
	catch_endings(console);
	if (set_mode(calls, console->fd, KD_GRAPHICS) < 0) {
		log_note(log,
			"console: no graphics mode (%s): it may write over the "
			"picture",
			strerror(errno));
		release_endings();
		calls->close(console->fd);
		console->fd = -1;
	}
}

void console_give_back(struct console *console)
{
	if (console->fd < 0) {
		return;
	}
	set_mode(console->calls, console->fd, KD_TEXT);
	release_endings();
	console->calls->close(console->fd);
	console->fd = -1;
}
