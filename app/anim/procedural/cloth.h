/*
 * A cape: a grid of particles that hangs from bones.
 *
 * The first row is pinned to nodes. Gravity, wind and capsules move the other
 * rows. Links keep the distance of neighbours, of diagonals and of every second
 * particle (position-based dynamics), and no particle gets farther from its
 * column's pin than the column is long. So the cloth can neither stretch much
 * nor become unstable, whatever the frame time.
 *
 * Particles are in the world, row after row: particle (row, column) has the
 * index row * columns + column. The caller draws position and normal with the
 * triangles of cloth_triangles().
 */
#ifndef APP_ANIM_PROCEDURAL_CLOTH_H
#define APP_ANIM_PROCEDURAL_CLOTH_H

#include "app/anim/procedural/capsule.h"

enum {
	CLOTH_SIDE_MIN = 2,
	CLOTH_SIDE_MAX = 64,
};

struct cloth_settings {
	int columns, rows; /* particles; CLOTH_SIDE_MIN..CLOTH_SIDE_MAX */
	float gravity[3];  /* the world's units a second squared */
	float wind[3];     /* the world's units a second */
	float air;         /* air resistance along the normal, 1/s */
	float damping;     /* damping of any motion, 1/s */
	float bend;        /* stiffness against folding, 0..1 */
	float radius;      /* distance kept from capsules */
	float fastest;     /* limit of a particle's speed, the world's units a
			      second */
	int passes;        /* passes over all links in each part of a step */
};

/* Two particles whose distance is kept. */
struct cloth_link {
	uint16_t a, b;
	float length;
	float stiffness; /* 0..1 */
};

struct cloth {
	struct cloth_settings settings;
	int count; /* of particles */
	float (*position)[3];
	float (*normal)[3]; /* unit length, towards a viewer for whom columns
			       run to the right and rows downwards */

	/* Private. */
	float (*velocity)[3];
	float (*before)[3];
	float (*offset)[3]; /* rest position in the frame of the column's
			     node */
	float *hang;        /* [count]: length of the column from the pin to the
			       particle */
	int *pin;           /* [columns]: the node that holds each column */
	float (*pin_from)[3];
	float (*pin_to)[3];
	int link_count;
	struct cloth_link *link;
	bool begun;
};

/* 8 columns, 10 rows, gravity, no wind, 4 passes. */
struct cloth_settings cloth_settings_default(void);

/*
 * Makes a cloth whose rest shape is given by shape[columns * rows], the
 * particles' positions in the world while the nodes have the matrices of world.
 * pin[columns] has the node of each column. Copies settings, shape and pin; the
 * arena owns the arrays. Returns 0, -EINVAL for columns or rows out of range,
 * or -ENOMEM.
 */
int cloth_init(struct cloth *cloth, const struct cloth_settings *settings,
	const float (*shape)[3], const int *pin, const mat4 *world,
	struct arena *arena);

/* Stops the motion; the next update begins in the rest shape. */
void cloth_reset(struct cloth *cloth);

/*
 * Advances by step_s, at most 0.2 s. If the first pin has moved by more than
 * four times the length of the last column since the last update, the cloth
 * begins anew in its rest shape.
 */
void cloth_update(struct cloth *cloth, float step_s,
	const struct capsule_world *capsule, int capsule_count,
	const mat4 *world);

/*
 * Writes the indices of the cloth's triangles, three each, and returns their
 * number, 6 * (columns - 1) * (rows - 1).
 */
int cloth_triangles(const struct cloth_settings *settings, uint16_t *index);

#endif
