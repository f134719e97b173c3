/*
 * Data to measure kernels with: a mesh, a palette, key frames and targets. They
 * are pseudo-random, the same on every machine, or taken from a model.
 */
#ifndef APP_CMD_BENCH_BENCH_MESH_H
#define APP_CMD_BENCH_BENCH_MESH_H

#include "app/model/model.h"

struct bench_mesh {
	struct arena arena; /* owns all data below that is not the model's */
	struct model_primitive primitive;
	int joint_count;
	mat4 *palette; /* [joint_count] */

	/* A second key frame, and two morph targets: [vertex_count]. */
	float (*destiny)[3];
	float (*destiny_normal)[3];
	float (*delta[2])[3];          /* position differences of the targets */
	struct model_target target[2]; /* the targets, with normals */

	bool is_model; /* jobs include converting the palette */
};

/*
 * Generates a mesh with normals and tangents within a sphere of radius 1. Each
 * vertex has the given number of influences (1 to 8) of 24 joints. Vertices use
 * joint_sets different combinations of joints, in random order; 0: each vertex
 * has random joints. Returns 0 or -ENOMEM.
 */
int bench_mesh_make(struct bench_mesh *mesh, int vertex_count, int influences,
	int joint_sets);

/*
 * Takes the largest skinned primitive of a model, posed in the middle of its
 * first clip. The model must outlive the mesh. Returns 0, -ENOENT if no mesh of
 * the model is skinned, or -ENOMEM.
 */
int bench_mesh_of_model(struct bench_mesh *mesh, const struct model *model);

void bench_mesh_release(struct bench_mesh *mesh);

#endif
