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
 * Output vertices are in another order than the primitive's: sorted by number
 * of influences, then by joints. So no branch in a loop depends on a vertex,
 * and a joint's matrix is fetched once for many vertices. With FIXED_TIERS,
 * vertices are first sorted into tiers. Tier 0 has the vertices that the
 * coarsest levels of detail use, so a coarse level needs only the groups at the
 * beginning. The full level then takes about 5% longer, as runs are shorter.
 * order[] maps output vertices to the primitive's; at load, the code that draws
 * reorders indices and the other attributes.
 *
 * The positions of an influence are relative to the centre of the box around
 * the vertices that the joint moves, and fixed_palette_make() adds this centre
 * to the joint's translation. So the base vectors are small, and 16 bits are
 * enough for them.
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
	float middle[3]; /* centre of the box around the vertices that it moves,
			    in the bind pose */
	float half[3];   /* half the sides of this box */
};

/*
 * The morph targets of a skinned primitive. When their weights change, the base
 * vectors of the vertices that they move are rewritten; the other vertices and
 * the skinning loop are not affected.
 */
struct fixed_skin_targets {
	int moved_count;    /* vertices that any target moves; 0: none */
	uint16_t *moved;    /* [vertex_count]: 1 + the vertex's index among the
			       moved ones, or 0 if no target moves it */
	float (*extent)[3]; /* [moved_count]: how far targets may move the
			       vertex along each axis, with weights up to
			       deltas.weight_limit */
	struct fixed_vector *delta; /* [moved_count]: scratch for a frame */
	float *weight;              /* [target_count]: the weights that the base
				       vectors contain */

	/* For each attribute: the largest sum of all targets' |delta| in a
	   coordinate. */
	float largest[FIXED_ATTRIBUTES];
	struct model_primitive zero; /* as many vertices as are moved, all at
				      0 */
	struct fixed_morph deltas;   /* a morph of `zero`, whose results are the
					sums of deltas */

	int rebase_count;
	/* [rebase_count], or NULL */
	struct fixed_rebase *rebase[FIXED_ATTRIBUTES];
};

struct fixed_skin {
	const struct model_primitive *primitive;
	int max_influences;  /* the present cap on influences; 0: none */
	int vertex_count;    /* that of the primitive */
	int influence_count; /* of all vertices together, at this cap */

	/* [vertex_count]: order[i] is the primitive's vertex that becomes
	   output vertex i; inverse_order[] is the inverse. */
	uint32_t *order, *inverse_order;

	int group_count; /* groups of all tiers, in order */
	struct fixed_group group[FIXED_SKIN_TIERS_MAX * SKIN_INFLUENCES_MAX];
	int tier_count; /* at least 1 */
	/* [t]: how many groups and vertices tiers 0 to t have together. */
	int group_count_to[FIXED_SKIN_TIERS_MAX];
	int vertex_count_to[FIXED_SKIN_TIERS_MAX];
	/* [influence_count + 1], or NULL */
	struct fixed_base *base[FIXED_ATTRIBUTES];
	/* factor from floats to the numbers in base[] */
	float scale[FIXED_ATTRIBUTES];

	int joint_count;
	struct fixed_joint *joint; /* [joint_count], in the order of the
				      fixed_matrix array */
	struct fixed_skin_targets targets;

	/* Private to the layout. */
	int32_t *run;         /* the memory of all groups' runs */
	uint16_t *joint_slot; /* [joint of the model's skin]: index in
			       joint[] */
};

/*
 * streams (enum fixed_streams) says which directions to skin besides positions,
 * which the primitive must have, and whether to make tiers. The arena owns the
 * arrays; the primitive must outlive the skin. Returns 0, -ENOMEM, or -ERANGE
 * if positions are not finite or not below 1e18 or more than 2,048 joints move
 * vertices: the caller poses such a primitive in float.
 */
int fixed_skin_init(struct fixed_skin *skin,
	const struct model_primitive *primitive, unsigned streams,
	struct arena *arena);

/*
 * Adds the primitive's targets, for positions and the skin's directions, and
 * lays the streams out again. From then on the struct points into itself and
 * must not be moved. Returns 0, -ENOMEM, or -ERANGE if deltas are not finite or
 * not below 1e18 or move more than 65,535 vertices: the caller poses such a
 * primitive in float. After an error the skin must not be used.
 */
int fixed_skin_add_targets(
	struct fixed_skin *skin, int target_count, struct arena *arena);

/*
 * Lays the streams out again with the max_influences heaviest influences of
 * each vertex (0: all), whose weights are scaled to sum to 1. order[] stays.
 * Target weights become 0. This takes some hundred times as long as a frame's
 * loop, but nothing if the cap does not change. No memory is allocated.
 */
void fixed_skin_set_cap(struct fixed_skin *skin, int max_influences);

/*
 * Lays the streams out again after targets.deltas.weight_limit has grown from
 * old_limit. Target weights become 0.
 */
void fixed_skin_extend_weights(struct fixed_skin *skin, float old_limit);

/*
 * Returns how many groups to skin for a level of detail. They contain the
 * vertices that the triangle list of this level or a coarser one uses, and
 * those of shadow lists that model_lod_of_size() assigns to these levels. Level
 * 0, the full list, needs all groups.
 */
int fixed_skin_group_count(const struct fixed_skin *skin, int level);

/* Returns how many output vertices these groups have, the first ones. */
int fixed_skin_posed_count(const struct fixed_skin *skin, int level);

/* Bytes of streams, runs, order and joints, for reports. */
size_t fixed_skin_bytes(const struct fixed_skin *skin);

#endif
