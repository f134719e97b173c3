/*
 * The reference: every vertex of a clip at any time.
 *
 * All techniques are compared with the reference, which the float kernel
 * computes with all influences and targets. Positions are in world space, in
 * the model's units. One moment is in memory at a time, so a clip of any length
 * takes the same memory.
 */
#ifndef APP_COMPARE_MEASURE_REFERENCE_H
#define APP_COMPARE_MEASURE_REFERENCE_H

#include "app/anim/clip.h"
#include "app/scene/instance/instance.h"

/* The vertices of one drawable. */
struct reference_part {
	int drawable; /* index in the instance */
	int first_vertex, vertex_count;
	bool normals;
};

struct reference {
	const struct model *model; /* not owned */
	const struct model_clip *clip;
	int clip_index;
	struct arena arena;

	struct instance *instance; /* computes the vertices */
	struct clip_cursor cursor;

	int part_count;
	struct reference_part *part;
	int vertex_count; /* of all parts */

	/* The result of the last reference_pose(): [vertex_count]. */
	float (*position)[3];
	float (*normal)[3]; /* unit vectors; zeros in parts without normals */
};

/*
 * Prepares a clip. The model must outlive the reference, which
 * reference_destroy() releases. Returns 0, or -errno after logging an error:
 * -EINVAL when the clip has no duration, -ENOMEM.
 */
int reference_create(const struct model *model, int clip, const struct log *log,
	struct reference **out);

/*
 * The same with the unit_scale of another reference's instance, so that a
 * reference for each clip does not pose all clips to find it; 0: not known.
 */
int reference_create_scaled(const struct model *model, int clip,
	float unit_scale, const struct log *log, struct reference **out);

/* NULL is fine. */
void reference_destroy(struct reference *reference);

/* Computes the positions at time_s, and the normals if wanted. */
void reference_pose(struct reference *reference, float time_s, bool normals);

/* Computes the rest pose, with normals. Call it before reference_pose(). */
void reference_rest(struct reference *reference);

#endif
