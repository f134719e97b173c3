/*
 * What kernels are measured with: a mesh, a palette and key frames. Made from
 * numbers that come out the same everywhere, or taken from a model.
 */
#ifndef APP_CMD_BENCH_BENCH_MESH_H
#define APP_CMD_BENCH_BENCH_MESH_H

#include "app/model/model.h"

struct bench_mesh {
	struct arena arena; /* holds all below, but not what a model lent */
	struct model_primitive primitive;
	int joint_count;
	mat4 *palette; /* [joint_count] */

	/* Another key frame, and what leads to two more. */
	float (*destiny)[3];
	float (*destiny_normal)[3];
	struct model_target target[2];

	bool is_whole; /* a model's: jobs include what comes once a frame */
};

/*
 * A mesh within a sphere of radius 1, with normals and tangents; each vertex
 * has that many influences, 1 to 4, of 24 joints. joint_sets says how many
 * different sets of joints vertices have, in no order; 0: as chance has it.
 * 0 or -ENOMEM.
 */
int bench_mesh_make(struct bench_mesh *mesh, int vertex_count, int influences,
	int joint_sets);

/*
 * The largest skinned primitive of a model, in the middle of its first clip;
 * destiny is that pose. The model must outlive it. 0, -ENOENT when nothing of
 * the model is skinned, or -ENOMEM.
 */
int bench_mesh_of_model(struct bench_mesh *mesh, const struct model *model);

void bench_mesh_release(struct bench_mesh *mesh);

#endif
