/*
 * The bones that the tuner shakes, and how deep below them each vertex is.
 */
#ifndef APP_DEMO_TUNER_TUNER_BONES_H
#define APP_DEMO_TUNER_TUNER_BONES_H

#include "app/character/motions/motions.h"

enum {
	TUNER_LEVELS_MAX = 16,
	TUNER_OFF_CHAIN = -1
};

struct tuner_bones {
	const struct instance *instance; /* not owned */
	int default_count;
	int by_default[MOTION_BONES_MAX];
	bool *moves;   /* [node_count]: whether a vertex moves with the node */
	int8_t *level; /* [node_count]: below a shaken bone, or OFF_CHAIN */
	int deepest;   /* of the levels */

	int chosen; /* a node, or -1: those by default */
	int count;
	int node[MOTION_BONES_MAX]; /* that are shaken */
};

/*
 * Chooses the bones that the model's character file shakes, else the shoulders,
 * else the bone with which the longest limb begins. Memory comes from the
 * instance's arena. Returns 0 or -ENOMEM.
 */
int tuner_bones_init(struct tuner_bones *bones, struct instance *instance,
	const struct motions *motions);

/* The bone that moves a vertex most. */
int tuner_bones_mover(const struct tuner_bones *bones, int drawable, int vertex);

/* Chooses the next bone, or the one before with step -1. */
void tuner_bones_step(struct tuner_bones *bones, int step);

/* Writes the names of what is shaken. */
void tuner_bones_name(const struct tuner_bones *bones, char *text, size_t size);

#endif
