/*
 * The reference: every vertex of a clip at every frame.
 *
 * All techniques are compared with it. The float kernel computes it with all
 * influences and targets. Positions are in world space, in the model's units.
 */
#ifndef APP_COMPARE_REFERENCE_H
#define APP_COMPARE_REFERENCE_H

#include "app/anim/clip.h"
#include "app/scene/instance/instance.h"

/* The vertices of one drawable. */
struct reference_part {
	int drawable; /* of the instance */
	int first_vertex, vertex_count;
	bool normals;
};

struct reference {
	const struct model *model; /* not owned */
	const struct model_clip *clip;
	int clip_index;
	double rate_hz;
	struct arena arena;

	struct instance *instance; /* what the frames are computed with */
	struct clip_cursor cursor;

	int part_count;
	struct reference_part *part;
	int vertex_count; /* of all parts */

	int frame_count;      /* at least 2 */
	float *time_s;        /* [frame_count], from 0 to the clip's end */
	float (*position)[3]; /* [frame_count][vertex_count] */
	float (*normal)[3];   /* likewise; zeros in parts without normals */
};

/*
 * Samples the clip rate_hz times a second and at its end. The model must
 * outlive the reference, which reference_destroy() releases. Returns 0, or
 * -errno after logging an error: -EINVAL when the clip has no duration, -E2BIG
 * when it has too many frames to keep, -ENOMEM.
 */
int reference_create(const struct model *model, int clip, double rate_hz,
	const struct log *log, struct reference **out);

/* NULL is fine. */
void reference_destroy(struct reference *reference);

/* The positions of a frame: [vertex_count]. */
const float (
	*reference_position(const struct reference *reference, int frame))[3];

/* The normals of a frame: [vertex_count]. */
const float (*reference_normal(const struct reference *reference, int frame))[3];

/* The last frame at or before time_s. */
int reference_frame_at(const struct reference *reference, float time_s);

#endif
