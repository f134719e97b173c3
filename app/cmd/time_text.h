/*
 * Times as people of different tools write them.
 */
#ifndef APP_CMD_TIME_TEXT_H
#define APP_CMD_TIME_TEXT_H

#include <stdbool.h>

/*
 * 3ds Max counts 4800 ticks a second: a multiple of 24, 25, 30, 50 and 60, so
 * that every frame of film and video begins on one.
 */
#define TIME_TICKS_PER_S 4800

/*
 * Reads seconds ("1.5"), frames at a rate ("45f@30") or ticks ("7200t").
 * False for anything else and for what is no finite number; *time_s may be
 * negative.
 */
bool time_text_parse(const char *text, double *time_s);

#endif
