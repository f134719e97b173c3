/*
 * The bones that the tuner shakes, and how many levels below them each node is.
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
	bool *moves; /* [node_count]: whether any vertex follows the node */
	int8_t *level; /* [node_count]: below a shaken bone (0), or TUNER_OFF_CHAIN */
	int deepest; /* largest level of a node that moves vertices */

	int chosen; /* a node, or -1: the default bones */
	int count;
	int node[MOTION_BONES_MAX]; /* [count]: the shaken bones */
};

/*
 * Chooses the bones that the model's character file shakes, else the shoulders,
 * else the first bone of the longest limb. Memory comes from the instance's
 * arena. Returns 0 or -ENOMEM.
 */
int tuner_bones_init(struct tuner_bones *bones, struct instance *instance,
	const struct motions *motions);

/* Returns the node that moves a vertex most. */
int tuner_bones_mover(const struct tuner_bones *bones, int drawable, int vertex);

/* Chooses the next (step 1) or previous (-1) bone; the default is one step. */
void tuner_bones_step(struct tuner_bones *bones, int step);

/* Writes the first shaken bone's name and the number of others. */
void tuner_bones_name(const struct tuner_bones *bones, char *text, size_t size);

#endif
