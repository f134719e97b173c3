/*
 * Ending the program in order after Ctrl-C, kill or a closed terminal.
 *
 * Signal handlers belong to the process, so there is one flag for all of it.
 */
#ifndef PLATFORM_PROCESS_STOP_H
#define PLATFORM_PROCESS_STOP_H

#include <stdbool.h>

/*
 * Clears the flag. From now on SIGINT, SIGTERM and SIGHUP only set it. A
 * signal that the process ignores stays ignored, as nohup requires.
 */
void stop_catch(void);

/* Restores the handlers that were set before stop_catch(). */
void stop_release(void);

/* Whether one of the signals came since stop_catch(). */
bool stop_requested(void);

#endif
