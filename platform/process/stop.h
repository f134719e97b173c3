/*
 * Ending the program in order after Ctrl-C, kill or a closed terminal.
 *
 * Signal handlers belong to the process, so there is one flag for all of it.
 */
#ifndef PLATFORM_PROCESS_STOP_H
#define PLATFORM_PROCESS_STOP_H

#include <stdbool.h>

/*
 * Unblocks the signals below and SIGALRM, and lets SIGALRM end the process, which
 * inherits both from the program that started it. Call it once, at the start.
 */
void stop_unblock(void);

/*
 * Clears the flag. From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE only set it.
 * A signal that the process ignores stays ignored, as nohup requires. If the
 * program does not call stop_requested() within a second after the signal,
 * SIGALRM ends it.
 */
void stop_catch(void);

/*
 * Makes such a signal write "V" to a file descriptor at once: a watchdog whose
 * last byte was that does not reset the board when the process ends. -1: none.
 */
void stop_set_watchdog(int fd);

/* Restores the handlers that were set before stop_catch(). */
void stop_release(void);

/*
 * Whether one of the signals came since stop_catch(). The caller then ends in
 * order, for which it has any time.
 */
bool stop_requested(void);

#endif
