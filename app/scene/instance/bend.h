/*
 * Bends the posed vertices of a node's mesh: lets a wave run through the part
 * that its morph targets move, and turns what is above a height about the
 * vertical axis, as a head turns on its neck.
 *
 * It is applied after instance_update(). Only drawables without a skin, whose
 * one batch is not gathered (batch.h), are bent. Vertices in fixed point are
 * bent in fixed point, so that every machine gets the same bits.
 */
#ifndef APP_SCENE_INSTANCE_BEND_H
#define APP_SCENE_INSTANCE_BEND_H

#include "app/anim/morph_wave.h"
#include "app/scene/instance/instance.h"

enum {
	BEND_PARTS_MAX = 8,
	BEND_STEPS = 256 /* places at which a wave is computed along its axis */
};

/* How far a turn and a wave move a vertex. */
struct bend_vertex {
	int16_t turn_q14;  /* 0 below the neck, 1 above it */
	int16_t reach_q14; /* 0 far from the part that targets move, 1 in it */
	uint8_t place;     /* 0 to BEND_STEPS - 1 along the wave's axis */
};

struct bend_part {
	struct drawable *drawable;
	struct bend_vertex *vertex; /* [vertex_count], in the arrays' order */
	/*
	 * Output, owned by the instance's arena: either the two float arrays or
	 * the two fixed ones; the others are NULL.
	 */
	float (*position)[3], (*normal)[3];
	struct fixed_vector *fixed_position, *fixed_normal;
	/* Input in float. The input in fixed point is in drawable->fixed. */
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
	float low[3], high[3]; /* box around the vertices that targets move */
	struct morph_wave wave;
};

/*
 * Prepares the drawables of a node that can be bent, at most BEND_PARTS_MAX;
 * from now on they draw the bend's output arrays. The instance's arena owns the
 * memory. Returns 0 or -ENOMEM.
 */
int bend_init(struct bend *bend, struct instance *instance, int node,
	const struct bend_neck *neck);

/*
 * Sets the wave. Its vectors have unit length, its amplitude is in local units.
 */
void bend_set_wave(struct bend *bend, const struct morph_wave *wave);

/*
 * Bends the vertices that the instance's last update posed. turn_rad is at most
 * half a radian to either side. omega is the progress of the morph, 0 to 1, at
 * which the wave is taken; at 0 and 1 there is no wave.
 */
void bend_update(struct bend *bend, float turn_rad, float omega);

#endif
