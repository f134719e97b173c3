/*
 * A skinned primitive laid out for the fixed-point loops.
 *
 *   load:   fixed_skin_init(&skin, primitive, FIXED_NORMALS, &arena)
 *           fixed_skin_add_targets(&skin, target_count, &arena), if it has any
 *           the caller allocates skin.joint_count matrices and
 *           skin.vertex_count vectors of output
 *   frame:  fixed_skin_set_cap(&skin, cap), which does work on a change only
 *           run/fixed_skin_run.h and run/fixed_palette.h, then loops->skin()
 *
 * Vertices come out in another order than the primitive's: sorted by number of
 * influences, then by joints. So no branch in a loop depends on a vertex, and a
 * joint's matrix is fetched once for many vertices. On request (FIXED_TIERS)
 * they are sorted into tiers before that, those that the coarsest levels of
 * detail use first, so that a coarse level needs only the groups at the
 * beginning. The full level takes about 5% longer then, as runs are shorter.
 * order[] maps output vertices to the primitive's; whoever draws reorders
 * indices and the other attributes at load.
 *
 * Positions are relative to the centre of the box around the vertices that a
 * joint moves, which the joint's matrix accounts for. So the base vectors are
 * small, and 16 bits are enough for them.
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_SKIN_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_SKIN_H

#include "app/anim/kernel/fixed.h"
#include "app/anim/kernel/layout/fixed_morph.h"
#include "app/anim/skin.h"

enum {
	FIXED_SKIN_TIERS_MAX = 8
};

/* A joint that moves vertices of the primitive. */
struct fixed_joint {
	int joint;       /* its index in the model's skin */
	bool used;       /* whether it moves vertices at the present cap */
	float middle[3]; /* centre of the vertices it moves, in the bind pose */
	float half[3];   /* half the size of the box around them */
};

/*
 * The morph targets of a skinned primitive. They rewrite the base vectors of
 * the vertices that they move, when weights change; the other vertices and the
 * skinning loop are not affected.
 */
struct fixed_skin_targets {
	int moved_count;    /* vertices that any target moves; 0: none */
	uint16_t *moved;    /* [vertex_count]: 1 + index among them, or 0 */
	float (*extent)[3]; /* [moved_count]: how far each may move along each
			       axis, at the weight limit of deltas */
	struct fixed_vector *delta; /* [moved_count]: scratch for a frame */
	float *weight;              /* those in the base vectors */

	/* Positions, normals, tangents: the largest sum of deltas of a
	   coordinate at weights of 1. */
	float largest[FIXED_ATTRIBUTES];
	struct model_primitive zero; /* the moved vertices, all of them 0 */
	struct fixed_morph deltas;   /* a morph of zero, which gives deltas */

	int rebase_count;
	struct fixed_rebase *rebase[FIXED_ATTRIBUTES]; /* or NULL */
};

struct fixed_skin {
	const struct model_primitive *primitive;
	int max_influences;  /* the cap of this layout; 0: none */
	int vertex_count;    /* the primitive's */
	int influence_count; /* of all vertices together, at this cap */

	/* [vertex_count]: the primitive's vertex that becomes output vertex i,
	   and the output vertex that vertex i of the primitive becomes. */
	uint32_t *order, *inverse_order;

	int group_count; /* of all tiers */
	struct fixed_group group[FIXED_SKIN_TIERS_MAX * SKIN_INFLUENCES_MAX];
	int tier_count; /* at least 1 */
	/* The groups and the vertices of the tiers 0 to t together, by t. */
	int group_count_to[FIXED_SKIN_TIERS_MAX];
	int vertex_count_to[FIXED_SKIN_TIERS_MAX];
	struct fixed_base *base[FIXED_ATTRIBUTES]; /* a stream, or NULL */
	float scale[FIXED_ATTRIBUTES];             /* of its vectors */

	int joint_count;
	struct fixed_joint *joint; /* [joint_count]: the palette's matrices */
	struct fixed_skin_targets targets;

	/* For the layout alone. */
	int32_t *run;         /* the memory of all groups' runs */
	uint16_t *joint_slot; /* a joint's index in joint[], by skin index */
};

/*
 * streams (enum fixed_streams) says which directions to skin besides
 * positions, which the primitive must have, and whether to make tiers. 0;
 * -ENOMEM; -ERANGE if positions are not finite or more than 2,048 joints move
 * vertices: such a primitive is posed in float.
 */
int fixed_skin_init(struct fixed_skin *skin,
	const struct model_primitive *primitive, unsigned streams,
	struct arena *arena);

/*
 * Adds the primitive's targets, for the skin's directions, and lays the streams
 * out again. The skin refers to itself from then on and may not be moved. 0;
 * -ENOMEM; -ERANGE if deltas are not finite numbers of sensible size or move
 * more than 65,535 vertices: such a primitive is posed in float. After an error
 * the skin may not be used.
 */
int fixed_skin_add_targets(
	struct fixed_skin *skin, int target_count, struct arena *arena);

/*
 * Lays the streams out again for at most max_influences a vertex, the heaviest
 * (0: all), whose weights are scaled to sum to 1. order[] stays. Target weights
 * become 0. It costs some hundred times a frame's loop and does nothing if the
 * cap is the present one. It allocates nothing.
 */
void fixed_skin_set_cap(struct fixed_skin *skin, int max_influences);

/*
 * Lays the streams out again after the weight limit of targets.deltas has grown
 * from old_limit. Target weights become 0.
 */
void fixed_skin_extend_weights(struct fixed_skin *skin, float old_limit);

/*
 * The groups to skin for a level of detail: those of the vertices that the
 * list of that level uses, or any coarser one, or a list for shadows that
 * model_lod_of_size() finds there. level 0 needs all groups.
 */
int fixed_skin_group_count(const struct fixed_skin *skin, int level);

/* Bytes of streams, runs, order and joints, for reports. */
size_t fixed_skin_bytes(const struct fixed_skin *skin);

#endif
