/*
 * One clip of one model as it is meant to look: every vertex at every frame.
 *
 * All techniques are held against this. Positions are in world space and the
 * model's own units, computed by the float kernel with all influences and
 * targets.
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

	struct instance *instance; /* posed anew for each frame */
	struct clip_cursor cursor;

	int part_count;
	struct reference_part *part;
	int vertex_count; /* of all parts */

	int frame_count;      /* at least 2 */
	float *time_s;        /* [frame_count], from 0 to the clip's end */
	float (*position)[3]; /* [frame_count][vertex_count] */
	float (*normal)[3];   /* likewise; zeros where a part has none */
};

/*
 * Samples the clip rate_hz times a second, its end included. 0, or -errno
 * after a sentence: -EINVAL where the clip does not move in time, -E2BIG when
 * it is too long for that rate, -ENOMEM. The model must outlive it; release
 * it with reference_destroy().
 */
int reference_create(const struct model *model, int clip, double rate_hz,
	const struct log *log, struct reference **out);

/* NULL is fine. */
void reference_destroy(struct reference *reference);

/* The vertices of a frame; normals likewise. */
const float (
	*reference_position(const struct reference *reference, int frame))[3];
const float (*reference_normal(const struct reference *reference, int frame))[3];

/* The last frame whose time is not after time_s. */
int reference_frame_at(const struct reference *reference, float time_s);

#endif
