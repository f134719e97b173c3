/*
 * What the camera follows in a clip that goes far: a figure whose whole way
 * were in the picture would be a dot.
 *
 * The camera follows one node, which stays nearest to the middle of the model,
 * along each axis on which the model goes many times its size. A clip that goes
 * less far is shown as a whole.
 */
#ifndef APP_CHARACTER_SHOW_CHARACTER_FOLLOW_H
#define APP_CHARACTER_SHOW_CHARACTER_FOLLOW_H

#include "app/character/character_data.h"
#include "app/scene/instance/bounds.h"

/* In scene units. */
struct character_follow {
	bool axis[3];    /* along which the model goes far */
	int node;        /* that the camera follows; -1: none */
	float start[3];  /* where the node is at the clip's start */
	float offset[3]; /* from there to the box's middle */
	float half[3];   /* half the box's sides along the followed axes */
};

/*
 * Arrays that character_follow_find() fills; clip and follow are [clip_count].
 */
struct character_boxes {
	struct bounds *rest, *clip;
	struct character_follow *follow;
};

/*
 * Finds the boxes of the rest pose and of each clip as it is shown, without its
 * travel, and what to follow in it. The box of a clip that goes far is that of
 * the model in the place of the rest pose, but as low as the clip goes. Leaves
 * the instance in any pose. Returns 0 or -ENOMEM.
 */
int character_follow_find(
	const struct character *character, const struct character_boxes *out);

/* Computes how far the node is from its start; 0 on axes not followed. */
void character_follow_way(const struct character_follow *follow,
	const struct instance *instance, float out[3]);

/* Moves the box of a clip to where the model is after this way. */
void character_follow_box(const struct character_follow *follow,
	const float way[3], struct bounds *box);

#endif
