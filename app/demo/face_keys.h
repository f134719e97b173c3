/*
 * The face's key frames, and the way from one to another.
 *
 * Each shape key of the model is a key frame: the base plus that target at
 * weight 1; key 0 is the base. In float each vertex goes straight from key to
 * key (AN4044, section 1). Which is the same as letting the targets' weights go
 * straight; and so it is done where vertices are in fixed point, because then
 * only those that a target moves need be looked at.
 */
#ifndef APP_DEMO_FACE_KEYS_H
#define APP_DEMO_FACE_KEYS_H

#include "app/anim/morph.h"
#include "app/scene/instance/instance.h"

enum {
	FACE_PARTS_MAX = 8
};

/* One primitive of the face, or all weights three by three. */
struct face_part {
	struct morph morph;
	struct morph_key *key; /* [key_count] */
};

struct face_keys {
	struct instance *instance;
	int node;
	int key_count;
	const char **target_name; /* [key_count - 1] */
	bool weighs;              /* part[0] are the weights */
	int part_count;
	struct face_part part[FACE_PARTS_MAX];
	float wave; /* where it weighs: how far it is off its way now */
	struct morph_motion motion; /* of the last face_keys_go() */
};

/*
 * The key frames of what the node shows, at key 0. Memory comes from the
 * instance's arena. 0 or -ENOMEM.
 */
int face_keys_init(struct face_keys *keys, struct instance *instance, int node);

/* From what is shown to a key frame. */
void face_keys_go(struct face_keys *keys, int key,
	const struct morph_motion *motion, double now_ms);

/* Holds what lies amount, 0..1, of the way from one key frame to another. */
void face_keys_hold(struct face_keys *keys, int from, int to, float amount);

/* One frame further. */
void face_keys_update(struct face_keys *keys, double now_ms);

/* How far it is, 0..1; 1 at rest. */
float face_keys_omega(const struct face_keys *keys, double now_ms);

/* Brings it into the instance's pose, which is otherwise made. */
void face_keys_apply(const struct face_keys *keys);

#endif
