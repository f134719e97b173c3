/*
 * Targets of a skinned primitive: it is morphed before it is skinned.
 *
 *   load:   fixed_skin_init(), fixed_skin_morph_init(&morph, &skin, ...)
 *   frame:  fixed_skin_morph_update(&morph, loops, weight),
 * fixed_palette_make() and the rest as for any other fixed_skin
 *
 * The base vectors of the vertices that targets move are rewritten when the
 * weights change. All others are as they were, and the skinning loop knows of
 * nothing. fixed_skin_set_cap() undoes all weights, so it goes before the
 * update.
 */
#ifndef APP_ANIM_KERNEL_FIXED_SKIN_MORPH_H
#define APP_ANIM_KERNEL_FIXED_SKIN_MORPH_H

#include "app/anim/kernel/fixed_morph.h"
#include "app/anim/kernel/fixed_skin.h"

struct fixed_skin_morph {
	struct fixed_skin *skin;
	int moved_count;
	uint16_t *moved; /* [vertex_count]: 1 + which of those that move, or 0 */
	float (*grow)[3]; /* [moved_count]: how far at most, at weights of 1 */

	/* Below: for fixed_skin_morph.c. */
	struct model_primitive still; /* the moved vertices, all at zero */
	struct fixed_morph deltas;    /* of which these are the targets */
	struct fixed_vector *delta;   /* [moved_count] */
	int rebase_count;
	struct fixed_rebase *rebase[FIXED_ATTRIBUTES];
	float *weight;                   /* that the base vectors are for */
	float largest[FIXED_ATTRIBUTES]; /* coordinate of base and deltas */
};

/*
 * Adds the targets to a skin that was just made, for the directions that it
 * has. The skin is laid out again, with room for them, and refers to *morph
 * from then on. 0; -ENOMEM; -ERANGE for what are not finite numbers of
 * sensible size, or more than 65535 moved vertices: it stays in float.
 */
int fixed_skin_morph_init(struct fixed_skin_morph *morph,
	struct fixed_skin *skin, int target_count, struct arena *arena);

/*
 * The frame's weights, before fixed_palette_make(). Costs nothing when they are
 * what they were; beyond -1..1 for the first time it lays the skin out again.
 * 0, or -ERANGE as fixed_morph_set_weights().
 */
int fixed_skin_morph_update(struct fixed_skin_morph *morph,
	const struct fixed_loops *loops, const float *weight);

/*
 * For fixed_skin.c: how far targets may move a vertex in each direction, what
 * the scale of an attribute's base vectors may be, laying out.
 */
const float *fixed_skin_growth(const struct fixed_skin *skin, uint32_t vertex);
float fixed_skin_scale_limit(
	const struct fixed_skin *skin, enum fixed_attribute attribute);
void fixed_skin_lay_out(struct fixed_skin *skin, int max_influences);
void fixed_skin_morph_lay_out(struct fixed_skin_morph *morph);

#endif
