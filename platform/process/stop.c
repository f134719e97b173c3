#include "platform/process/stop.h"

#include "platform/base/interrupt.h"

#include <errno.h>
#include <signal.h>
#include <stddef.h>
#include <unistd.h>

static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};

enum {
	SIGNAL_COUNT = sizeof(signals) / sizeof(signals[0]),
	GRACE_S = 1
};

/* A signal handler can reach static variables only. */
static volatile sig_atomic_t watchdog_fd = -1;
static struct sigaction before[SIGNAL_COUNT];

static void raise_flag(int number)
{
	int kept = errno;

	if (!interrupt_pending()) {
		interrupt_set(number);
		(void)alarm(GRACE_S);
	}
	/* If this write fails, watchdog_close() reports it. */
	if (watchdog_fd >= 0 && write(watchdog_fd, "V", 1) < 0) {
		watchdog_fd = -1;
	}
	errno = kept;
}

/* A program that starts limber may leave these signals blocked by mistake. */
void stop_unblock(void)
{
	sigset_t ending;

	sigemptyset(&ending);
	sigaddset(&ending, SIGALRM);
	for (int i = 0; i < SIGNAL_COUNT; i++) {
		sigaddset(&ending, signals[i]);
	}
	(void)sigprocmask(SIG_UNBLOCK, &ending, NULL);
	signal(SIGALRM, SIG_DFL);
}

void stop_catch(void)
{
	struct sigaction action = {.sa_handler = raise_flag};

	interrupt_set(0);
	sigemptyset(&action.sa_mask);
	for (int i = 0; i < SIGNAL_COUNT; i++) {
		/* sigaction() cannot fail for these signals. */
		(void)sigaction(signals[i], NULL, &before[i]);
		if (before[i].sa_handler != SIG_IGN) {
			(void)sigaction(signals[i], &action, NULL);
		}
	}
}

void stop_set_watchdog(int fd)
{
	watchdog_fd = fd;
}

void stop_release(void)
{
	(void)alarm(0);
	interrupt_set(0);
	watchdog_fd = -1;
	for (int i = 0; i < SIGNAL_COUNT; i++) {
		(void)sigaction(signals[i], &before[i], NULL);
	}
}

bool stop_requested(void)
{
	bool pending = interrupt_pending();

	if (pending) {
		(void)alarm(0);
	}
	return pending;
}

const char *stop_failure(void)
{
	switch (interrupt_signal()) {
	case SIGPIPE:
		return "the program that read its output has ended (SIGPIPE)";
	case SIGXCPU:
		return "it has used up its processor time (SIGXCPU): allow more with ulimit -St";
	default:
		return NULL;
	}
}
