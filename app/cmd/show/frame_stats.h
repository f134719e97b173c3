/*
 * How long frames took: counted while a run goes on, written at its end.
 *
 * Times are of the monotonic clock, whatever clock the animation follows.
 */
#ifndef APP_CMD_SHOW_FRAME_STATS_H
#define APP_CMD_SHOW_FRAME_STATS_H

#include <stdint.h>

#include "platform/base/log.h"

enum {
	FRAME_STATS_BUCKETS = 256 /* of a millisecond; the last has the rest */
};

struct frame_stats {
	int frames;
	int presses;
	int64_t begun_ns; /* of the frame under way */
	int64_t ended_ns; /* of the frame before */
	int64_t first_ns; /* when the first frame began */
	int64_t work_ns;  /* all frames, without waiting between them */
	int64_t work_max_ns;
	int64_t apart_max_ns; /* between the ends of two frames */
	int64_t pressed_ns;   /* the oldest press not yet on a picture, or 0 */
	int64_t latency_max_ns; /* from a press to the picture that shows it */
	int bucket[FRAME_STATS_BUCKETS]; /* frames by their work */
};

/* A frame begins. */
void frame_stats_begin(struct frame_stats *stats);

/* It shows a button that was pressed at pressed_ns. */
void frame_stats_press(struct frame_stats *stats, int64_t pressed_ns);

/* The frame is complete. */
void frame_stats_end(struct frame_stats *stats);

/* The work in milliseconds that this share (0 to 1) of frames stays within. */
int frame_stats_percentile_ms(const struct frame_stats *stats, double share);

/*
 * Writes it as JSON: frames, seconds, fps, work_ms {mean, p50, p95, max},
 * apart_ms_max, presses, latency_ms_max. 0, or -errno after a sentence.
 */
int frame_stats_write(const struct frame_stats *stats, const char *path,
	const struct log *log);

#endif
