/*
 * The face's key frames and the morph between them.
 *
 * Each morph target of the model is a key frame: the base plus that target at
 * weight 1; key 0 is the base. In float each vertex moves on a straight line
 * from key to key (AN4044, section 1). Interpolating the targets' weights
 * linearly gives the same result; this is done with vertices in fixed point,
 * because only vertices that a target moves are then computed.
 */
#ifndef APP_DEMO_FACE_KEYS_H
#define APP_DEMO_FACE_KEYS_H

#include "app/anim/morph.h"
#include "app/scene/instance/instance.h"

enum {
	FACE_PARTS_MAX = 8
};

/* The vertices of one primitive, or all weights in groups of three. */
struct face_part {
	struct morph morph;
	struct morph_key *key; /* [key_count] */
};

struct face_keys {
	struct instance *instance;
	int node;
	int key_count;
	const char **target_name; /* [key_count - 1] */
	bool weighs;              /* part[0] is the weights */
	int part_count;
	struct face_part part[FACE_PARTS_MAX];
};

/*
 * Makes the key frames of the node's mesh and shows key 0. Memory comes from
 * the instance's arena. Returns 0 or -ENOMEM.
 */
int face_keys_init(struct face_keys *keys, struct instance *instance, int node);

/*
 * Starts a linear morph from what is shown to a key frame, with the motion's
 * timing.
 */
void face_keys_go(struct face_keys *keys, int key,
	const struct morph_motion *motion, double now_ms);

/* Shows the blend of two key frames; amount 0 is from, 1 is to. */
void face_keys_hold(struct face_keys *keys, int from, int to, float amount);

/* Moves the morph on to now_ms. */
void face_keys_update(struct face_keys *keys, double now_ms);

/* Returns the morph's Omega: 0 at the source, 1 at the destiny and at rest. */
float face_keys_omega(const struct face_keys *keys, double now_ms);

/* Applies the morph to the instance's pose, whose other parts are set. */
void face_keys_apply(const struct face_keys *keys);

#endif
