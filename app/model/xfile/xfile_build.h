/*
 * Conversion of struct xfile_scene into struct model. Only xfile_build*.c and
 * xfile.c include this header.
 */
#ifndef APP_MODEL_XFILE_XFILE_BUILD_H
#define APP_MODEL_XFILE_XFILE_BUILD_H

#include "app/model/model_loader.h"
#include "app/model/xfile/xfile_names.h"
#include "app/model/xfile/xfile_scene.h"

/* A node that draws a mesh. */
struct xfile_instance {
	int mesh;  /* index in xfile_build.mesh */
	int frame; /* index of the frame with the mesh, or -1 */
	int node;  /* number of the node, as struct xfile_build defines it */
};

/*
 * The state of xfile_build(). Nodes are numbered in this order: all frames,
 * then all instances that need a node of their own, since they are not the
 * first in their frame or have no frame. node_index[] maps these numbers to the
 * model's node indices.
 */
struct xfile_build {
	const struct model_source *source;   /* for files beside the model */
	const struct xfile_context *context; /* for messages */
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
	int *node_index;
	int *mesh_index; /* [scene->mesh_count]: index in the model; set if the
			    mesh has an instance */
	int *mesh_skin;  /* [scene->mesh_count]: index of the skin in the model,
			    or -1 */
	int *mesh_node;  /* [scene->mesh_count]: the model's node of the first
			    instance, or -1 */
	bool *mirrors;   /* [scene->frame_count]: whether the frame mirrors what
			    is below it */
	bool *moved;     /* [model->node_count]: whether a clip moves the
			  node */
	int (*channel)[MODEL_WEIGHTS]; /* [model->node_count][path]: index of
			  the clip's channel; see xfile_build_clip.c */
};

/*
 * Joints and weights of a mesh's vertices, [vertex_count], the largest weights
 * first. width is the number of influences per vertex, 0 without a skin.
 */
struct xfile_influences {
	int width; /* 0, 4 or 8 */
	uint16_t (*joint)[8];
	float (*weight)[8];
};

/* Fills an empty model. Returns 0, or -errno after an error on the log. */
int xfile_build(struct xfile_build *build);

/* Steps of xfile_build(), in the order in which they run. */
int xfile_build_materials(struct xfile_build *build);
int xfile_build_meshes(struct xfile_build *build);
int xfile_build_clips(struct xfile_build *build);

/*
 * Adds the skin of a mesh to the model and fills *out; a mesh without bones
 * gets no skin. Bones without a frame, and vertices without a bone, follow the
 * mesh's own node.
 */
int xfile_build_skin(struct xfile_build *build, const struct xfile_mesh *mesh,
	int mesh_index, struct xfile_influences *out);

#endif
