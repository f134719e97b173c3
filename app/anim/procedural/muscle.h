/*
 * A muscle that bulges as a joint bends.
 */
#ifndef APP_ANIM_PROCEDURAL_MUSCLE_H
#define APP_ANIM_PROCEDURAL_MUSCLE_H

#include "app/anim/pose.h"

struct muscle {
	int joint;      /* the node whose rotation from rest drives it */
	float from_rad; /* the bend at which the muscle begins to contract */
	float to_rad;   /* the bend at which it is fully contracted */
	int node;       /* the node that swells, or -1 */
	float swell[3]; /* its growth along its axes at full contraction */
	int weight;     /* index in pose.weight of a morph weight to add to, or
			   -1 */
	float amount;   /* added to that weight at full contraction */
};

/* The angle between the joint's rotation and its rest rotation, 0..pi. */
float muscle_bend_rad(const struct pose *pose, int joint);

/* The contraction, 0..1, eased at both ends. */
float muscle_at(const struct muscle *muscle, const struct pose *pose);

/* Scales the node and adds to the morph weight. */
void muscle_apply(const struct muscle *muscle, struct pose *pose);

#endif
