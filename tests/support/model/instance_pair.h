/*
 * Two instances of one model in the same pose: one in float, one in fixed point.
 */
#ifndef TESTS_SUPPORT_MODEL_INSTANCE_PAIR_H
#define TESTS_SUPPORT_MODEL_INSTANCE_PAIR_H

#include "app/anim/clip.h"
#include "app/scene/instance/instance.h"

struct instance_pair {
	struct model *model;
	struct instance *exact, *fixed;
	struct clip_cursor cursor;
};

/* Begins a pair, which then owns the model. End with instance_pair_end(). */
void instance_pair_begin(struct instance_pair *pair, struct model *model);

/* Loads the model from a file, which must be valid. */
void instance_pair_load(struct instance_pair *pair, const char *path);

void instance_pair_end(struct instance_pair *pair);

/* Updates both at a clip's time; clip -1 keeps the float instance's pose. */
void instance_pair_pose(struct instance_pair *pair, int clip, float time_s);

#endif
