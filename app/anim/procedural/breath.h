/*
 * A chest that heaves with the breath.
 */
#ifndef APP_ANIM_PROCEDURAL_BREATH_H
#define APP_ANIM_PROCEDURAL_BREATH_H

#include "app/anim/pose.h"

struct breath {
	int chest;          /* the node that moves */
	float rate_hz;      /* breaths a second */
	float inhale;       /* the part of a breath spent inhaling, 0..1 */
	float swell[3];     /* growth along the node's axes at full lungs */
	float lift_axis[3]; /* unit length, in the node's axes */
	float lift_rad;     /* rotation about lift_axis at full lungs */
	float weight;       /* 0 switches the breath off */
};

/*
 * A quiet breath, 15 a minute, inhaling for 2 of 5 parts. The chest grows by 5%
 * in depth, 2% in width and 1% in height and leans back by 1 degree, if the
 * node has +Y along the spine and +Z to the front.
 */
struct breath breath_default(int chest);

/* Returns how full the lungs are at a time, 0..1, eased at both ends. */
float breath_at(const struct breath *breath, double time_s);

/* Scales and rotates the chest of a pose. */
void breath_apply(const struct breath *breath, double time_s, struct pose *pose);

#endif
