/*
 * The steps that make up the layout of a skinned primitive, for fixed_skin.c
 * alone. None of them calls fixed_skin.c.
 *
 *   fixed_skin_joints.c    which joints move vertices, their boxes, the scale
 *   fixed_skin_streams.c   the order of vertices, the runs, the base vectors
 *   fixed_skin_targets.c   the vertices that targets move, and their deltas
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_SKIN_PARTS_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_SKIN_PARTS_H

#include "app/anim/kernel/layout/fixed_influences.h"
#include "app/anim/kernel/layout/fixed_skin.h"

/*
 * Allocates joint[] and joint_slot[] and lists the joints that move vertices.
 * Returns 0, -ENOMEM or -ERANGE as fixed_skin_init() does.
 */
int fixed_skin_list_joints(struct fixed_skin *skin, struct arena *arena);

/* Computes the joints' boxes and scale[FIXED_POSITION] for the present cap. */
void fixed_skin_measure_joints(struct fixed_skin *skin);

/*
 * Allocates the streams, sorts the vertices into order[] and inverse_order[]
 * and allocates memory for the runs of any cap. Returns 0 or -ENOMEM.
 */
int fixed_skin_init_streams(
	struct fixed_skin *skin, unsigned streams, struct arena *arena);

/* Returns the last tier that is needed to draw a level of detail. */
int fixed_skin_tier_of(const struct fixed_skin *skin, int level);

/* Writes groups, runs and base vectors for the present cap and scales. */
void fixed_skin_write_streams(struct fixed_skin *skin);

/*
 * Fills in skin->targets, except for the contents of the rebase records.
 * Returns 0, -ENOMEM or -ERANGE as fixed_skin_add_targets() does.
 */
int fixed_skin_init_targets(
	struct fixed_skin *skin, int target_count, struct arena *arena);

/*
 * Writes the rebase records for the present base vectors, which contain no
 * targets. All target weights become 0.
 */
void fixed_skin_write_rebase(struct fixed_skin *skin);

/*
 * The largest scale that an attribute's base vectors may have. Directions with
 * all their deltas must fit 16 bits. If there are targets, the scale is at most
 * half the unit of the deltas, since fixed_rebase.weight_q16 is at most a half.
 */
float fixed_skin_scale_limit(
	const struct fixed_skin *skin, enum fixed_attribute attribute);

/* Returns how far targets may move a vertex along each axis (three floats). */
static inline const float *fixed_skin_extent(
	const struct fixed_skin *skin, uint32_t vertex)
{
	static const float zero[3] = {0, 0, 0};
	const struct fixed_skin_targets *targets = &skin->targets;

	return targets->moved_count > 0 && targets->moved[vertex]
		? targets->extent[targets->moved[vertex] - 1]
		: zero;
}

#endif
