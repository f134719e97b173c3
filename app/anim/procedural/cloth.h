/*
 * A cape: a grid of particles that hangs from bones.
 *
 * The first row is pinned to nodes; the rest falls, is blown about and keeps
 * out of capsules. Links hold neighbours, diagonals and every second particle
 * at their distance (position-based Verlet integration), and nothing gets
 * farther from its column's pin than the column is long, so that the cloth can
 * neither stretch much nor burst, whatever the frame time.
 *
 * Particles are in the world, row after row: particle (row, column) is number
 * row * columns + column. The caller draws position and normal with the
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
	float air;         /* how strongly air takes broadsides along, 1/s */
	float damping;     /* how fast any motion dies away, 1/s */
	float bend;        /* 0 folds freely, 1 hardly */
	float radius;      /* kept from capsules */
	int passes;        /* over all links in each part of a step */
};

/* A distance that is kept. */
struct cloth_link {
	uint16_t a, b;
	float length;
	float stiffness; /* 0..1 */
};

struct cloth {
	struct cloth_settings settings;
	int count; /* of particles */
	float (*position)[3];
	float (*normal)[3]; /* unit, to the side from which columns run right
			       and rows run down */

	/* Below: for the functions of this header. */
	float (*velocity)[3];
	float (*before)[3];
	float (*offset)[3]; /* at rest, in the frame of the column's node */
	float *hang;        /* length of the column above each particle */
	int *pin;           /* [columns]: nodes */
	float (*pin_from)[3];
	float (*pin_to)[3];
	int link_count;
	struct cloth_link *link;
	bool begun;
};

/* 8 columns, 10 rows, gravity, no wind, 4 passes. */
struct cloth_settings cloth_settings_default(void);

/*
 * A cloth at rest in the given shape (particles in the world, in order) while
 * the nodes stand as in world; pin gives each column's node. Memory is the
 * arena's. 0, -EINVAL for sides out of range, -ENOMEM.
 */
int cloth_init(struct cloth *cloth, const struct cloth_settings *settings,
	const float (*shape)[3], const int *pin, const mat4 *world,
	struct arena *arena);

/* Forgets the motion; the next update begins in the rest shape. */
void cloth_reset(struct cloth *cloth);

/*
 * Goes on by step_s; at most 0.2 s of it count. A jump of the pins by more
 * than four times the cloth's length begins anew.
 */
void cloth_update(struct cloth *cloth, float step_s,
	const struct capsule_world *capsule, int capsule_count,
	const mat4 *world);

/* 6 * (columns - 1) * (rows - 1): indices of the cloth's triangles. */
int cloth_triangles(const struct cloth_settings *settings, uint16_t *index);

#endif
