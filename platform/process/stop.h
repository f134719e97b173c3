/*
 * The person's wish to stop, told by a signal: Ctrl-C, kill, a closed line.
 *
 * Signals belong to the process, so the flag behind this does too.
 */
#ifndef PLATFORM_PROCESS_STOP_H
#define PLATFORM_PROCESS_STOP_H

#include <stdbool.h>

/*
 * From now on SIGINT, SIGTERM and SIGHUP only raise a flag, which is lowered
 * first. One that was ignored stays ignored, as nohup wants it.
 */
void stop_catch(void);

/* What they did before stop_catch(). */
void stop_release(void);

/* Whether one came since stop_catch(). */
bool stop_requested(void);

#endif
