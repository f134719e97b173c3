/*
 * From what a .x file says to a struct model: the parts share this.
 */
#ifndef APP_MODEL_XFILE_XFILE_BUILD_H
#define APP_MODEL_XFILE_XFILE_BUILD_H

#include "app/model/model_loader.h"
#include "app/model/xfile/xfile_names.h"
#include "app/model/xfile/xfile_scene.h"

/* A mesh at its place: every node that draws is one of these. */
struct xfile_instance {
	int mesh;  /* in the file's order */
	int frame; /* or -1 */
	int node;  /* in the order below */
};

/*
 * Nodes are counted in the order frames, then instances that share a frame
 * with another or have none; place[] leads from there to the model's order,
 * which has each subtree in one piece.
 */
struct xfile_build {
	const struct model_source *source; /* for files beside it */
	const struct xfile_source *where;  /* for sentences */
	const struct log *log;
	struct arena *scratch;
	const struct xfile_scene *scene;
	struct model *model;

	struct xfile_names frame_names;
	struct xfile_names mesh_names;
	struct xfile_names material_names;
	const struct xfile_mesh **mesh; /* [scene->mesh_count] */

	int instance_count;
	struct xfile_instance *instance;
	int *place;
	int *mesh_place; /* [scene->mesh_count]: in the model, or -1 */
	int *mesh_skin;  /* [scene->mesh_count], or -1 */
	int *mesh_node;  /* [scene->mesh_count]: its first instance's place */
	bool *moved;     /* by a clip, in the model's order */
};

/*
 * The joints and weights of a mesh's vertices, width each, strongest first;
 * width 0 without a skin.
 */
struct xfile_influences {
	int width; /* 0, 4 or 8 */
	uint16_t (*joint)[8];
	float (*weight)[8];
};

/* Fills an empty model. 0 or -errno after a sentence. */
int xfile_build(struct xfile_build *build);

/* Its steps; each may use what the ones before it have made. */
int xfile_build_materials(struct xfile_build *build);
int xfile_build_meshes(struct xfile_build *build);
int xfile_build_clips(struct xfile_build *build);

/*
 * The skin of one mesh and what its primitives need of it. Bones that name no
 * frame, and vertices without a bone, stay with the mesh's own node.
 */
int xfile_build_skin(struct xfile_build *build, const struct xfile_mesh *mesh,
	int mesh_index, struct xfile_influences *out);

#endif
