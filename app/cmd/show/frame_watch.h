/*
 * Measures the stages of each frame, and draws the graph that shows them.
 *
 * Times are of the monotonic clock, whichever clock the animation follows.
 */
#ifndef APP_CMD_SHOW_FRAME_WATCH_H
#define APP_CMD_SHOW_FRAME_WATCH_H

#include "app/demo/demo.h"
#include "app/scene/hud/hud_graph.h"

#include <stdint.h>

/* All zero: there were no frames, the graph is hidden. */
struct frame_watch {
	bool shown; /* the graph */
	struct hud_graph graph;
	float stage_ms[HUD_STAGES]; /* of the current frame or the last one */
	int64_t mark_ns;            /* when the current stage began */
	int64_t ended_ns;           /* when the last frame ended, or 0 */
	size_t memory_bytes;
	int memory_wait; /* frames until memory_bytes is read again */
};

/* Call this when a frame begins. */
void frame_watch_begin(struct frame_watch *watch);

/* Adds the time since the last call of these functions to this stage. */
void frame_watch_stage(struct frame_watch *watch, enum hud_stage stage);

/* Call this when the frame is over: adds it to the graph. */
void frame_watch_end(struct frame_watch *watch);

/*
 * Draws the graph unless it is hidden, if possible beside the figures.
 * reduction: see governor_text().
 */
void frame_watch_show(struct frame_watch *watch, const struct demo_facts *facts,
	const char *driver, const char *reduction,
	const struct hud_place *beside, struct hud *hud);

#endif
