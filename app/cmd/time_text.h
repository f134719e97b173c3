/*
 * Reads times in seconds, in frames at a rate, or in ticks.
 */
#ifndef APP_CMD_TIME_TEXT_H
#define APP_CMD_TIME_TEXT_H

/* 3ds Max counts time in ticks: 160 a frame at 30 frames a second. */
#define TICKS_PER_SECOND 4800

/*
 * Reads a time in seconds ("1.5"), in frames at a rate ("45f@30"; "45f" means
 * 30 frames a second) or in ticks ("7200t"). Returns 0, or -EINVAL, with *out_s
 * unchanged, for anything else, for a negative time and for more than a day.
 */
int time_parse(const char *text, double *out_s);

#endif
