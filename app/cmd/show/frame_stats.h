/*
 * Measures how long frames take in a run, and writes the figures at its end.
 *
 * Times are of the monotonic clock, whichever clock the animation follows.
 */
#ifndef APP_CMD_SHOW_FRAME_STATS_H
#define APP_CMD_SHOW_FRAME_STATS_H

#include <stdint.h>
#include <stdio.h>

enum {
	/* Of one millisecond each; the last one holds all longer frames. */
	FRAME_STATS_BUCKETS = 256
};

/* All zero: there were no frames. */
struct frame_stats {
	int frames;
	int presses;
	int64_t begun_ns; /* when the current frame began */
	int64_t ended_ns; /* when the last frame ended */
	int64_t first_ns; /* when the first frame began */
	int64_t work_ns;  /* sum over all frames, without waiting */
	int64_t work_max_ns;
	int64_t apart_max_ns;   /* between the ends of two frames */
	int64_t pressed_ns;     /* the oldest press not yet shown, or 0 */
	int64_t latency_max_ns; /* from a press to the frame that shows it */
	int bucket[FRAME_STATS_BUCKETS]; /* number of frames, by their work */
};

/* A frame begins. */
void frame_stats_begin(struct frame_stats *stats);

/* The frame shows a press that happened at pressed_ns. */
void frame_stats_press(struct frame_stats *stats, int64_t pressed_ns);

/* The frame is complete. */
void frame_stats_end(struct frame_stats *stats);

/*
 * The work in milliseconds that this fraction (0 to 1) of frames stays within.
 */
int frame_stats_percentile_ms(const struct frame_stats *stats, double fraction);

/*
 * Writes JSON: frames, seconds, fps, work_ms {mean, p50, p95, max},
 * apart_ms_max, presses, latency_ms_max.
 */
void frame_stats_write(const struct frame_stats *stats, FILE *out);

#endif
