/*
 * Ending the program in order after Ctrl-C, kill or a closed terminal.
 *
 * Signal handlers belong to the process, so there is one flag for all of it.
 * Long computations see it through base/interrupt.h.
 */
#ifndef PLATFORM_PROCESS_STOP_H
#define PLATFORM_PROCESS_STOP_H

#include <stdbool.h>

/*
 * Unblocks the signals of stop_catch() and SIGALRM, and makes SIGALRM end the
 * process: a process inherits blocked and ignored signals from the program that
 * started it. Call it once, at the start.
 */
void stop_unblock(void);

/*
 * Clears the flag. From now on SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXCPU
 * (the limit of `ulimit -St`) only set it.
 * A signal that the process ignores stays ignored, as nohup requires. If the
 * program does not call stop_requested() within a second after the signal,
 * SIGALRM ends it.
 */
void stop_catch(void);

/*
 * Makes these signals write "V" at once to fd, an open watchdog device. If "V"
 * was the last byte written, the watchdog does not reset the board when the
 * process ends. -1 stands for no watchdog.
 */
void stop_set_watchdog(int fd);

/* Restores the handlers that were set before stop_catch(), and clears the flag. */
void stop_release(void);

/*
 * Whether one of the signals came since stop_catch(). The caller should then
 * end the program in order; SIGALRM does not limit its time any more.
 */
bool stop_requested(void);

/*
 * Why the first of these signals is a failure: SIGPIPE and SIGXCPU are, and
 * what they ended is not complete. NULL for SIGINT, SIGTERM and SIGHUP, by
 * which a user or the system asks for the end, and before any signal.
 */
const char *stop_failure(void);

#endif
