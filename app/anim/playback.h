/*
 * Where a playback is in its clip, and what it passed.
 *
 * A playback is the moving position in one clip: speed of either sign, once,
 * loop or to and fro, and the marked times that it crossed in a step. It
 * samples nothing; clip_sample() takes its time_s.
 */
#ifndef APP_ANIM_TIMELINE_H
#define APP_ANIM_TIMELINE_H

#include "app/anim/clip.h"

/* A marked time of a clip. */
struct playback_event {
	float time_s; /* 0..the clip's duration */
	int id;       /* the caller's */
};

struct playback {
	float duration_s;
	float speed; /* clip seconds a second; negative plays backwards */
	enum clip_repeat repeat;

	float time_s;   /* position in the clip, 0..duration_s */
	bool returning; /* on the way back of a to-and-fro */
	bool finished;  /* once, and at the end it was heading for */

	bool begun; /* an advance has taken place */
};

/*
 * At the start, or at the end when speed is negative and it plays once. Speed
 * and repeat may be changed between steps.
 */
struct playback playback_begin(
	float duration_s, enum clip_repeat repeat, float speed);

/* Puts the playback at a time of the clip, as if it began there. */
void playback_seek(struct playback *playback, float time_s);

/*
 * Goes on by step_s of real time and notes the events it passed, in the order
 * of passing: the first room of their ids in passed (room 0: passed may be
 * NULL). Returns how many there were. event is sorted by time. Half-open: an
 * event exactly where a step ends counts in that step and not again in the
 * next; one where the playback begins counts in the first step. A step over
 * many loops reports the last few of them.
 */
int playback_advance(struct playback *playback, double step_s,
	const struct playback_event *event, int event_count, int *passed,
	int room);

#endif
