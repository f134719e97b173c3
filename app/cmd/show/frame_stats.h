/*
 * Measures how long the frames of a run take, and writes the results as JSON.
 *
 * Times are of the monotonic clock, whichever clock the animation follows.
 */
#ifndef APP_CMD_SHOW_FRAME_STATS_H
#define APP_CMD_SHOW_FRAME_STATS_H

#include <stdint.h>
#include <stdio.h>

enum {
	/* A bucket is 1 ms wide; the last one counts all longer frames. */
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
	int bucket[FRAME_STATS_BUCKETS]; /* frames by their work_ns */
};

/* Call this when a frame begins. */
void frame_stats_begin(struct frame_stats *stats);

/* Call this if the frame shows the effect of a press at pressed_ns. */
void frame_stats_press(struct frame_stats *stats, int64_t pressed_ns);

/* Call this when the frame has been shown. */
void frame_stats_end(struct frame_stats *stats);

/*
 * Returns the percentile of work, in ms, for a fraction of 0 to 1, which stands
 * for the longest frame; 0 if there were no frames.
 */
int frame_stats_percentile_ms(const struct frame_stats *stats, double fraction);

/*
 * Writes JSON: frames, seconds, fps, work_ms {mean, p50, p95, max},
 * apart_ms_max, presses, latency_ms_max.
 */
void frame_stats_write(const struct frame_stats *stats, FILE *out);

#endif
