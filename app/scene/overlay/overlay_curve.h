/*
 * Graphs on the head-up display of how a value moves between key frames: the
 * interpolation function of a morph, as in AN4044's figure 4, or the curves of
 * a clip's channel. A running point marks the present moment.
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_CURVE_H
#define APP_SCENE_OVERLAY_OVERLAY_CURVE_H

#include "app/anim/clip.h"
#include "app/scene/hud/hud_group.h"

enum {
	OVERLAY_CURVE_EMS = 4, /* height of the graph */
	OVERLAY_CURVE_POINTS = 40,
	OVERLAY_CURVES_MAX = 4
};

/* Values at evenly spaced moments from 0 to 1. */
struct overlay_curve {
	int count; /* curves */
	float value[OVERLAY_CURVES_MAX][OVERLAY_CURVE_POINTS];
	float at; /* the present moment, 0..1 */
};

/* The way of a morph from source to destiny. */
struct overlay_way {
	float wave; /* height of a signal that is mounted on it, or 0 */
	float (*shape)(const void *user, float omega); /* NULL: straight */
	const void *user;
};

/*
 * Returns the way from source (0) to destiny (1) over Omega: the slope alone
 * or, if there is a signal, three curves: slope plus signal, signal, slope.
 */
struct overlay_curve overlay_curve_of_morph(
	const struct overlay_way *way, float omega);

/*
 * Returns the values of a channel over its clip: x, y and z of a rotation, or
 * those of up to four morph targets from number first on. value is scratch
 * memory for one value of the channel, of channel->width floats.
 */
struct overlay_curve overlay_curve_of_channel(const struct model_clip *clip,
	const struct model_channel *channel, int first, float time_s,
	enum clip_interpolation interpolation, float *value);

/* Adds a row with the graph to a group. */
void overlay_curve_show(
	const struct overlay_curve *curve, struct hud_group *group);

#endif
