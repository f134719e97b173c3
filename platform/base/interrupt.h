/*
 * The signal that asks for the end of the program, as long computations see it.
 * process/stop.h catches signals and sets it; a signal handler can reach static
 * variables only.
 */
#ifndef PLATFORM_BASE_INTERRUPT_H
#define PLATFORM_BASE_INTERRUPT_H

#include <stdbool.h>

/*
 * Whether the program shall end. A computation that may take longer than a
 * fraction of a second asks this again and again, and then gives up with
 * -EINTR, without a message; what it has computed is not used.
 */
bool interrupt_pending(void);

/* The number of the signal, or 0. Signal handlers may call this. */
int interrupt_signal(void);

/* Sets the signal; 0 for none. Signal handlers may call this. */
void interrupt_set(int signal);

#endif
