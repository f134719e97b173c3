/*
 * The data that kernels are measured with: a mesh, a palette and key frames. It
 * is generated from pseudo-random numbers, the same on every machine, or taken
 * from a model.
 */
#ifndef APP_CMD_BENCH_BENCH_MESH_H
#define APP_CMD_BENCH_BENCH_MESH_H

#include "app/model/model.h"

struct bench_mesh {
	struct arena arena; /* owns everything below that is not the model's */
	struct model_primitive primitive;
	int joint_count;
	mat4 *palette; /* [joint_count] */

	/* A second key frame, and two morph targets. */
	float (*destiny)[3];
	float (*destiny_normal)[3];
	float (*delta[2])[3];          /* of the targets' positions */
	struct model_target target[2]; /* with normals too */

	bool is_model; /* jobs include what a model needs once a frame */
};

/*
 * Generates a mesh with normals and tangents within a sphere of radius 1. Each
 * vertex has that many influences (1 to 4) of 24 joints. joint_sets is how many
 * different sets of joints the vertices have, in random order; 0: each vertex
 * has random joints. Returns 0 or -ENOMEM.
 */
int bench_mesh_make(struct bench_mesh *mesh, int vertex_count, int influences,
	int joint_sets);

/*
 * Takes the largest skinned primitive of a model, posed in the middle of its
 * first clip. The model must outlive the mesh. Returns 0, -ENOENT when nothing
 * of the model is skinned, or -ENOMEM.
 */
int bench_mesh_of_model(struct bench_mesh *mesh, const struct model *model);

void bench_mesh_release(struct bench_mesh *mesh);

#endif
