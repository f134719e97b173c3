/*
 * A graph of frame times on the head-up display.
 *
 * Each of the last frames is a bar, coloured by stage. Below the bars are the
 * stages' mean times and facts about the frame. All times come from the caller,
 * so equal times draw equal pictures. The graph adds about 260 rectangles to
 * the hud's single draw call; app/scene/figures.md lists what that costs.
 */
#ifndef APP_SCENE_HUD_HUD_GRAPH_H
#define APP_SCENE_HUD_HUD_GRAPH_H

#include "app/scene/hud/hud_group.h"

#include <stddef.h>

/* The stages of a frame. */
enum hud_stage {
	HUD_ANIMATE, /* computing poses and vertices */
	HUD_DRAW,    /* GL calls */
	HUD_PRESENT, /* moving the picture from the driver to the screen */
	HUD_STAGES
};

enum {
	HUD_GRAPH_FRAMES = 48,
	HUD_GRAPH_RATE = -1 /* number of stages: frames a second, no bars */
};

/* Sums or means over some frames. */
struct hud_graph_means {
	float stage_ms[HUD_STAGES];
	float interval_ms;
	int frames;
};

/* All zero before the first frame. */
struct hud_graph {
	float ms[HUD_GRAPH_FRAMES][HUD_STAGES]; /* ring buffer */
	int next, count;
	struct hud_graph_means sum;   /* since the texts were last updated */
	struct hud_graph_means shown; /* the means that the texts show now */
};

/* The facts below the times. */
struct hud_facts {
	const char *technique;
	const char *driver; /* the GL driver's name */
	long triangles;
	size_t memory_bytes;   /* of the process; 0 if unknown */
	const char *reduction; /* what the governor leaves out, or NULL */
};

/*
 * Adds a frame: the times of its stages, and the interval from the end of the
 * previous frame to its own end. The texts are updated four times a second.
 */
void hud_graph_add(struct hud_graph *graph, const float stage_ms[HUD_STAGES],
	float interval_ms);

/* Returns the frames a second that the texts show; 0 if not known yet. */
float hud_graph_rate(const struct hud_graph *graph);

/*
 * Returns the milliseconds at the graph's top: one of a few steps, such that
 * the longest of the last frames fits if it takes at most a second.
 */
float hud_graph_scale_ms(const struct hud_graph *graph);

/*
 * Returns what the graph with the times of this many stages takes of the height
 * of a picture of this size, in pixels from its lower edge. HUD_GRAPH_RATE is
 * the least.
 */
int hud_graph_room(int width, int height, int stage_count);

/*
 * Adds the graph as a group in the bottom left corner, or in the bottom right
 * one if the left has no room. If figures would be behind it and *beside, where
 * they are not, has room for frames a second at least, it goes there. What
 * would reach other groups or figures is left out: first the last facts, then
 * the stages' times, and at last the bars.
 */
void hud_graph_show(const struct hud_graph *graph, const struct hud_facts *facts,
	const struct hud_place *beside, struct hud *hud);

#endif
