/*
 * A task that runs in a thread of its own, with a lower priority than the frame
 * loop.
 *
 * The task owns the data that it uses until background_wait() returns. A
 * struct of zeros has no task. Only one thread may use the struct.
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
 * Waits for the task begun before, then begins work(context). If no thread can
 * be created, the task runs before this function returns.
 */
void background_begin(struct background *background,
	void (*work)(void *context), void *context);

/* Waits until the task is done. Does nothing when there is none. */
void background_wait(struct background *background);

#endif
