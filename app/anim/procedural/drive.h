/*
 * Flesh that follows: breathing chests and bulging muscles.
 */
#ifndef APP_ANIM_PROCEDURAL_DRIVE_H
#define APP_ANIM_PROCEDURAL_DRIVE_H

#include "app/anim/pose.h"

/*
 * Scales a node along its axes and takes the scale back from its children, so
 * that only what hangs on the node itself swells. Children that are turned
 * against it get the scale along their own axes back, which leaves a little
 * shear.
 */
void bone_swell(struct pose *pose, int node, const float factor[3]);

/* A chest that heaves. */
struct breath {
	int chest;
	float rate_hz;      /* breaths a second */
	float inhale;       /* the share of a breath spent drawing it, 0..1 */
	float swell[3];     /* growth along the bone's axes at full breath */
	float lift_axis[3]; /* unit, in the bone's axes */
	float lift_rad;     /* turn about it at full breath */
	float weight;       /* 0: none */
};

/*
 * A quiet breath, 15 a minute, 2 of 5 parts inhaling: depth 5%, width 2%,
 * height 1%, for a bone with +Y along the spine and +Z to the front; it leans
 * back by a degree about +X.
 */
struct breath breath_default(int chest);

/* How full the lungs are at a time: 0..1, at rest at both ends. */
float breath_at(const struct breath *breath, double time_s);

/* Swells and lifts the chest of a pose. */
void breath_apply(const struct breath *breath, double time_s, struct pose *pose);

/* A muscle that bulges as a joint bends. */
struct muscle {
	int joint;              /* the bone whose bend from rest drives it */
	float from_rad, to_rad; /* bend at which it begins, and is full */
	int node;               /* the bone that swells, or -1 */
	float swell[3];         /* its growth along its axes when full */
	int weight;   /* the pose's morph weight that it sets, or -1 */
	float amount; /* added to that weight when full */
};

/* The angle between the joint's rotation and its rest, 0..pi. */
float bend_rad(const struct pose *pose, int joint);

/* How far the muscle is drawn, 0..1, eased at both ends. */
float muscle_at(const struct muscle *muscle, const struct pose *pose);

/* Swells the bone and adds to the weight. */
void muscle_apply(const struct muscle *muscle, struct pose *pose);

#endif
