/*
 * A stopwatch over the stages of a frame, and the graph that shows them.
 *
 * Times are of the monotonic clock, whatever clock the animation follows.
 */
#ifndef APP_CMD_SHOW_FRAME_WATCH_H
#define APP_CMD_SHOW_FRAME_WATCH_H

#include "app/demo/demo.h"
#include "app/scene/hud/hud_graph.h"

#include <stdint.h>

/* All zero: nothing watched yet, the graph not shown. */
struct frame_watch {
	bool shown;
	struct hud_graph graph;
	float stage_ms[HUD_STAGES]; /* of the frame under way or the last */
	int64_t mark_ns;            /* when the stage began */
	int64_t ended_ns;           /* when the frame before did; or 0 */
	size_t memory_bytes;
	int memory_age; /* frames since it was asked for */
};

/* A frame begins. */
void frame_watch_begin(struct frame_watch *watch);

/* What was done since the last call was of this stage. */
void frame_watch_stage(struct frame_watch *watch, enum hud_stage stage);

/* The frame is over. */
void frame_watch_end(struct frame_watch *watch);

/* Puts the graph on the picture if it is to be seen. */
void frame_watch_show(struct frame_watch *watch, const struct demo_facts *facts,
	const char *driver, const char *reduction, struct hud *hud);

#endif
