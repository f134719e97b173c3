#include "platform/process/stop.h"

#include <signal.h>
#include <stddef.h>

enum {
	SIGNAL_COUNT = 3
};

static const int signals[SIGNAL_COUNT] = {SIGINT, SIGTERM, SIGHUP};

/* A signal handler can reach static variables only. */
static volatile sig_atomic_t wanted;
static struct sigaction before[SIGNAL_COUNT];

static void raise_flag(int number)
{
	(void)number;
	wanted = 1;
}

void stop_catch(void)
{
	struct sigaction action = {.sa_handler = raise_flag};

	wanted = 0;
	sigemptyset(&action.sa_mask);
	for (int i = 0; i < SIGNAL_COUNT; i++) {
		/* sigaction() cannot fail for these signals. */
		(void)sigaction(signals[i], NULL, &before[i]);
		if (before[i].sa_handler != SIG_IGN) {
			(void)sigaction(signals[i], &action, NULL);
		}
	}
}

void stop_release(void)
{
	for (int i = 0; i < SIGNAL_COUNT; i++) {
		(void)sigaction(signals[i], &before[i], NULL);
	}
}

bool stop_requested(void)
{
	return wanted != 0;
}
