#define _DEFAULT_SOURCE /* MSG_NOSIGNAL */

#include "platform/display/console_guard.h"

#include <errno.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <signal.h>
#include <stdint.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
	DESCRIPTORS_MAX = 1024 /* limber has far fewer */
};

int console_request(const struct device_calls *calls, int console,
	enum console_request request)
{
	static const struct {
		unsigned long call;
		uintptr_t argument;
	} requests[CONSOLE_REQUESTS] = {
		[CONSOLE_TEXT_MODE] = {KDSETMODE, KD_TEXT},
		[CONSOLE_STAY] = {VT_RELDISP, 0},
		[CONSOLE_LEAVE] = {VT_RELDISP, 1},
		[CONSOLE_RETURN] = {VT_RELDISP, VT_ACKACQ},
		[CONSOLE_SWITCH_FREELY] = {VT_SETMODE, 0},
	};
	struct vt_mode freely = {.mode = VT_AUTO};
	void *argument = (void *)requests[request].argument;

	if (request == CONSOLE_SWITCH_FREELY) {
		argument = &freely;
	}
	return device_control(
		       calls, console, requests[request].call, argument) == 0
		? 0
		: -errno;
}

/* A descriptor that stays open would keep a card, or a pipe's reader waiting. */
static void close_others(int line, int console)
{
	for (int i = 0; i < DESCRIPTORS_MAX; i++) {
		if (i != line && i != console) {
			close(i);
		}
	}
}

/*
 * The guard. It is forked from a process that may have threads, and calls only
 * what a signal handler may call, too.
 */
static void guard_console(
	const struct device_calls *calls, int line, int console)
{
	const int ready = 0;
	unsigned char request;

	/* A signal to limber's session or terminal is not for the guard. */
	(void)setsid();
	(void)prctl(PR_SET_NAME, "limber-console", 0, 0, 0);
	close_others(line, console);
	(void)send(line, &ready, sizeof(ready), MSG_NOSIGNAL);
	while (recv(line, &request, 1, 0) == 1 && request < CONSOLE_REQUESTS) {
		int error = console_request(
			calls, console, (enum console_request)request);

		(void)send(line, &error, sizeof(error), MSG_NOSIGNAL);
	}
	(void)console_request(calls, console, CONSOLE_TEXT_MODE);
	/* A switch that waits for an answer takes place. */
	(void)console_request(calls, console, CONSOLE_LEAVE);
	(void)console_request(calls, console, CONSOLE_SWITCH_FREELY);
	_exit(0);
}

/* Waits for the guard's next answer: 0 or -errno; -EPERM if it was killed. */
static int await_answer(int line)
{
	ssize_t got;
	int answer;

	do {
		got = recv(line, &answer, sizeof(answer), 0);
	} while (got < 0 && errno == EINTR);
	return got == (ssize_t)sizeof(answer) ? answer : -EPERM;
}

int console_guard_begin(struct console_guard *guard,
	const struct device_calls *calls, int console)
{
	sigset_t all, before;
	int ends[2], error;
	pid_t process;

	*guard = (struct console_guard){.process = 0};
	if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
		return -errno;
	}
	/* The guard keeps all signals blocked. */
	sigfillset(&all);
	(void)sigprocmask(SIG_SETMASK, &all, &before);
	process = fork();
	if (process == 0) {
		guard_console(calls, ends[1], console);
	}
	error = process < 0 ? -errno : 0;
	(void)sigprocmask(SIG_SETMASK, &before, NULL);
	close(ends[1]);
	if (error) {
		close(ends[0]);
		return error;
	}
	*guard = (struct console_guard){.process = process, .line = ends[0]};
	/* From its first answer on it has a session of its own. */
	(void)await_answer(ends[0]);
	return 0;
}

int console_guard_request(
	const struct console_guard *guard, enum console_request request)
{
	unsigned char byte = (unsigned char)request;
	ssize_t sent;

	if (!guard->process) {
		return -EPERM;
	}
	do {
		sent = send(guard->line, &byte, 1, MSG_NOSIGNAL);
	} while (sent < 0 && errno == EINTR);
	return await_answer(guard->line);
}

void console_guard_end(struct console_guard *guard)
{
	if (!guard->process) {
		return;
	}
	close(guard->line);
	while (waitpid(guard->process, NULL, 0) < 0 && errno == EINTR) {
	}
	guard->process = 0;
}
