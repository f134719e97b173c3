/*
 * All clips of a model in a row, each blended into the next one by the overlap
 * of the second document's four frames.
 */
#ifndef APP_DEMO_VIEWER_VIEWER_JOIN_H
#define APP_DEMO_VIEWER_VIEWER_JOIN_H

#include "app/anim/clip_join.h"
#include "app/demo/actor.h"

struct viewer_join {
	bool running;
	struct clip_join clips;
	double time_s;
	struct clip_cursor next_cursor;
	struct pose scratch;
};

/* Takes memory for the actor. Returns 0, or -ENOMEM after logging an error. */
int viewer_join_init(
	struct viewer_join *join, struct actor *actor, const struct log *log);

/* Starts at a time of this clip, which the next one follows. */
void viewer_join_begin(struct viewer_join *join, const struct actor *actor,
	int clip, double time_s);

/* Moves on by step_s and poses the actor. *clip becomes the present one. */
void viewer_join_run(
	struct viewer_join *join, struct actor *actor, int *clip, float step_s);

#endif
