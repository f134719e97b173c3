/*
 * The position of a playback in its clip, and the events that it passes.
 *
 * A playback has a speed of either sign and plays its clip once, in a loop or
 * forward and backward. It samples nothing: clip_sample() takes its time_s.
 */
#ifndef APP_ANIM_PLAYBACK_H
#define APP_ANIM_PLAYBACK_H

#include "app/anim/clip.h"

/* A marked time of a clip. */
struct playback_event {
	float time_s; /* 0..the clip's duration */
	int id;       /* chosen by the caller */
};

struct playback {
	float duration_s;
	float speed; /* clip seconds a second; negative plays backwards */
	enum clip_repeat repeat;

	double time_s;  /* position in the clip, 0..duration_s: a sum of steps,
			 * which double keeps exact for months */
	bool returning; /* CLIP_PING_PONG: in the second half */
	bool finished;  /* CLIP_ONCE: at the end */

	bool begun; /* it has advanced since its start or seek */
};

/*
 * A playback at the clip's start; or at its end if it plays once and backwards.
 * Speed and repeat may be changed between steps.
 */
struct playback playback_begin(
	float duration_s, enum clip_repeat repeat, float speed);

/* Moves the playback to a time of the clip, as if it began there. */
void playback_seek(struct playback *playback, double time_s);

/*
 * Advances by step_s of real time and returns the number of events passed. The
 * ids of the first capacity of them go into passed, in the order of passing;
 * passed may be NULL if capacity is 0. event is sorted by time.
 *
 * An event exactly at the end of a step counts in that step and not in the
 * next. One at the position where the playback begins counts in the first step.
 * A step over many loops passes the events of the last few loops only.
 */
int playback_advance(struct playback *playback, double step_s,
	const struct playback_event *event, int event_count, int *passed,
	int capacity);

#endif
