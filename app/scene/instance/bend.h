/*
 * Bends the posed vertices of a node's mesh: lets a wave run through the part
 * that its morph targets move, and turns what is above a height about the
 * vertical axis, as a head turns on its neck.
 *
 * It applies after instance_update(), to drawables without a skin whose batches
 * have the drawable's own order; others stay as they are. Vertices in fixed
 * point are bent in fixed point, so that every machine gets the same bits.
 */
#ifndef APP_SCENE_INSTANCE_BEND_H
#define APP_SCENE_INSTANCE_BEND_H

#include "app/anim/morph_wave.h"
#include "app/scene/instance/instance.h"

enum {
	BEND_PARTS_MAX = 8,
	BEND_STEPS = 256 /* places along a wave's axis */
};

/* What of a vertex decides how far it moves. */
struct bend_vertex {
	int16_t turn_q14;  /* 0 below the neck to 1 above it */
	int16_t reach_q14; /* 0 where no target moves anything, to 1 */
	uint8_t place;     /* along the wave's axis */
};

struct bend_part {
	struct drawable *drawable;
	struct bend_vertex *vertex; /* [vertex_count], in the arrays' order */
	/* Output; float or fixed. */
	float (*position)[3], (*normal)[3];
	struct fixed_vector *fixed_position, *fixed_normal;
	/* Input in float; drawable->fixed has that in fixed point. */
	float (*from_position)[3], (*from_normal)[3];
};

/* Where a head turns: the neck's ends and its axis, in local units. */
struct bend_neck {
	float low, high; /* heights between which the turn begins and ends */
	float x, z;
};

struct bend {
	int part_count;
	struct bend_part part[BEND_PARTS_MAX];
	struct bend_neck neck;
	float low[3], high[3]; /* box of what the targets move */
	struct morph_wave wave;
};

/*
 * Makes the bend of the drawables of a node; they show its arrays from now on.
 * The instance's arena owns the memory. Returns 0 or -ENOMEM.
 */
int bend_init(struct bend *bend, struct instance *instance, int node,
	const struct bend_neck *neck);

/* Sets the wave, whose vectors have unit length, in local units. */
void bend_set_wave(struct bend *bend, const struct morph_wave *wave);

/*
 * Bends what the instance's last update made: turns by at most half a radian,
 * and the wave at omega; 0 and 1 leave it out.
 */
void bend_update(struct bend *bend, float turn_rad, float omega);

#endif
