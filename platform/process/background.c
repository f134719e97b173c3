#define _XOPEN_SOURCE 700 /* nice() */
#include "platform/process/background.h"

#include <unistd.h>

/* On one core the task gets about a quarter of the processor's time, and the
 * frame loop the rest. */
static const int niceness = 5;

static void *run(void *context)
{
	struct background *background = context;

	/* On Linux this changes the priority of this thread only. */
	(void)!nice(niceness);
	background->work(background->context);
	return NULL;
}

void background_begin(struct background *background,
	void (*work)(void *context), void *context)
{
	background_wait(background);
	background->work = work;
	background->context = context;
	background->running =
		pthread_create(&background->thread, NULL, run, background) == 0;
	if (!background->running) {
		work(context);
	}
}

void background_wait(struct background *background)
{
	if (background->running) {
		(void)pthread_join(background->thread, NULL);
		background->running = false;
	}
}
