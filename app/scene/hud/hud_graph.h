/*
 * How long frames take, as a graph over the picture.
 *
 * Each of the last frames is a bar whose colours are its stages; below it are
 * the stages' times and what the frame shows. Times come from the caller, so
 * a graph that is fed the same looks the same. It is drawn with the hud's one
 * call: about 260 rectangles of a pixel or three, and text.
 *
 * 1.7 million ARM instructions a frame with the soft driver at 480x640, beside
 * 16 of the walker's own: tests/bench/count.sh with `limber play --demo walker
 * --hud --gl soft --display null --format rgb565 --clock fixed:25 --no-labels
 * --frames FRAMES`.
 */
#ifndef APP_SCENE_HUD_HUD_GRAPH_H
#define APP_SCENE_HUD_HUD_GRAPH_H

#include "app/scene/hud/hud_group.h"

#include <stddef.h>

enum hud_stage {
	HUD_ANIMATE, /* poses and vertices */
	HUD_DRAW,    /* GL calls */
	HUD_PRESENT, /* from the driver to the screen */
	HUD_STAGES
};

enum {
	HUD_GRAPH_FRAMES = 48
};

/* What the texts say: means since they were last renewed. */
struct hud_graph_means {
	float stage_ms[HUD_STAGES];
	float interval_ms;
	int frames;
};

/* All zero: no frame yet. */
struct hud_graph {
	float ms[HUD_GRAPH_FRAMES][HUD_STAGES]; /* a ring */
	int next, count;
	struct hud_graph_means gathering, shown;
};

/* What is on the picture. */
struct hud_facts {
	const char *technique;
	const char *driver; /* who draws */
	long triangles;
	size_t memory_bytes;   /* of the process; 0: not known */
	const char *reduction; /* what is left out to keep a budget, or NULL */
};

/*
 * A frame's stages, and the time from the end of the frame before to its own.
 * Texts are renewed four times a second.
 */
void hud_graph_add(struct hud_graph *graph, const float stage_ms[HUD_STAGES],
	float interval_ms);

/* Frames a second by the last second's quarter; 0 when not known yet. */
float hud_graph_rate(const struct hud_graph *graph);

/*
 * The scale's upper end: milliseconds that the tallest of the last frames fits
 * under, one of a few steps.
 */
float hud_graph_scale_ms(const struct hud_graph *graph);

/* A group in the bottom left corner. */
void hud_graph_show(const struct hud_graph *graph,
	const struct hud_facts *facts, struct hud *hud);

#endif
