/*
 * A skinned primitive made ready for the fixed-point loops, and its palette.
 *
 *   load:   fixed_skin_init(&skin, primitive, FIXED_NORMALS, &arena)
 *           room for skin.joint_count matrices and vertex_count vectors
 *   frame:  fixed_palette_make(&skin, palette, matrix, &placement)
 *           loops->skin(skin.group, skin.group_count, skin.position, matrix,
 *               position)
 *           loops->skin(skin.group, skin.group_count, skin.normal, matrix,
 *               normal)
 *
 * Vertices come out in another order than the primitive's: sorted by number
 * of influences, then by joints, so that no branch in a loop depends on a
 * vertex and a joint's matrix is found once for many. order[] leads back;
 * whoever draws carries indices and the other attributes over at load.
 *
 * Each joint counts positions from the middle of the box around the vertices
 * that it moves, which its matrix takes into account. So the base vectors are
 * small, and 16 bits are fine for them.
 */
#ifndef APP_ANIM_KERNEL_FIXED_SKIN_H
#define APP_ANIM_KERNEL_FIXED_SKIN_H

#include "app/anim/kernel/fixed.h"
#include "app/anim/skin.h"

/* A joint that moves vertices. */
struct fixed_joint {
	int joint;       /* its number in the model's skin */
	bool used;       /* at the present cap */
	float middle[3]; /* of the vertices it moves, in the bind pose */
	float half[3];   /* half the size of the box around them */
};

struct fixed_skin {
	const struct model_primitive *primitive;
	int max_influences;  /* the cap that it is laid out for; 0: none */
	int vertex_count;    /* the primitive's */
	int influence_count; /* at this cap */
	/* [vertex_count]: the primitive's vertex that becomes output vertex i,
	   and the output vertex that vertex i of the primitive becomes. */
	uint32_t *order, *inverse_order;

	int group_count;
	struct fixed_group group[SKIN_INFLUENCES_MAX];
	struct fixed_base *position;
	struct fixed_base *normal;  /* or NULL */
	struct fixed_base *tangent; /* or NULL */

	int joint_count;
	struct fixed_joint *joint; /* [joint_count]: the palette's matrices */
	float position_scale;      /* of positions in the base vectors */
	float normal_scale, tangent_scale;

	struct fixed_skin_morph *morph; /* or NULL: fixed_skin_morph.h */

	/* Below: for fixed_skin.c. */
	int32_t *run;
	uint16_t *slot; /* of a joint: its place in joint[] */
};

/*
 * streams says which of the primitive's directions are wanted; it must have
 * them. 0; -ENOMEM; -ERANGE for what 16 bits cannot hold: positions that are
 * not finite numbers, or more than 2048 joints. Such a primitive stays in
 * float.
 */
int fixed_skin_init(struct fixed_skin *skin,
	const struct model_primitive *primitive, unsigned streams,
	struct arena *arena);

/*
 * Lays the streams out again for at most that many influences a vertex, the
 * heaviest (0: all); their weights are scaled up to sum to one. Order stays.
 * Costs some hundred times a frame's loop, so wants to be rare; does nothing
 * when the cap is what it was. No allocation.
 */
void fixed_skin_set_cap(struct fixed_skin *skin, int max_influences);

/*
 * A frame's matrices: from the float palette of the model's skin, in any unit
 * and with anything multiplied on from the left (a model-view matrix, say),
 * into matrix[skin->joint_count], and what the loops' positions will mean.
 *
 * 0, or -ERANGE when the palette has infinities or NaNs, or scales that no
 * exponent brings into 16 bits; the output is not usable then.
 */
int fixed_palette_make(const struct fixed_skin *skin, const mat4 *palette,
	struct fixed_matrix *matrix, struct fixed_placement *placement);

/* Bytes of streams, runs and order, for reports. */
size_t fixed_skin_bytes(const struct fixed_skin *skin);

#endif
