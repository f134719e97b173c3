/*
 * A piece of work beside the frame loop, in a thread of its own that leaves the
 * loop the larger share of the processor.
 *
 * What the work touches is its own until background_wait() returns. All zero:
 * nothing to wait for. Belongs to one thread.
 */
#ifndef PLATFORM_PROCESS_BACKGROUND_H
#define PLATFORM_PROCESS_BACKGROUND_H

#include <pthread.h>
#include <stdbool.h>

struct background {
	bool running;
	pthread_t thread;
	void (*work)(void *context);
	void *context;
};

/*
 * Begins work(context), after waiting for what was begun before. Where there
 * can be no thread it is done when this returns.
 */
void background_begin(struct background *background,
	void (*work)(void *context), void *context);

/* Until the work is done. */
void background_wait(struct background *background);

#endif
