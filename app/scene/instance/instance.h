/*
 * One model on stage: its state and its output vertices.
 *
 * A model may have many instances. Each owns a pose, the world matrices and
 * palettes computed from it, and what the vertex loops write. All memory is
 * taken in instance_create(); posing and drawing take none.
 *
 * Numbers: matrices go to GL in 16.16, so lengths have to stay near 1. Scene
 * units are metres where the model is between 25 cm and 16 m large, else a
 * power of two of them (unit_scale, exact in float). Likewise the positions of
 * a rigid or morphed primitive are multiplied by a power of two (vertex_scale)
 * when they are far from 1, and the matrix that draws them divides again.
 *
 * Where the kernel has fixed-point loops, vertices are 16-bit numbers, and the
 * matrix that draws them has their scale and offset. A primitive that cannot be
 * had so stays in float. Whoever wants to know where a vertex is asks
 * drawable_position() and need not care.
 */
#ifndef APP_SCENE_INSTANCE_INSTANCE_H
#define APP_SCENE_INSTANCE_INSTANCE_H

#include "app/anim/kernel/fixed_skin_morph.h"
#include "app/anim/kernel/kernel.h"
#include "app/anim/pose.h"
#include "app/anim/skin.h"
#include "platform/base/fixed.h"

#include <string.h>

/* A coarser list of a batch's triangles, see lod.h. */
struct batch_lod {
	float error; /* in the unit of the model's positions */
	int index_count;
	const uint16_t *index;
};

/*
 * A run of vertices that one GL call draws. Attributes are either the
 * drawable's own arrays or copies in another order, see batch.h.
 */
struct batch {
	int vertex_count;
	const uint32_t *source;     /* the primitive's vertex for each of the
				       batch's, or NULL: the drawable's order */
	const float (*position)[3]; /* NULL: fixed_position, and so on */
	const float (*normal)[3];
	const struct fixed_vector *fixed_position;
	const struct fixed_vector *fixed_normal;
	const float (*texcoord)[2]; /* or NULL */
	const uint8_t (*color)[4];  /* or NULL */

	int index_count;
	const uint16_t *index; /* or NULL: every three vertices in turn */
	int lod_count;
	struct batch_lod *lod; /* the finest first */
	/* Fewer triangles with the same outline, or NULL */
	const uint16_t *proxy;
	int proxy_count;

	float (*gathered_position)[3]; /* with source: written each update */
	float (*gathered_normal)[3];
	struct fixed_vector *gathered_fixed; /* the same in fixed point */
	struct fixed_vector *gathered_fixed_normal;
};

/* The vertices of a drawable in fixed point. */
struct drawable_fixed {
	const struct fixed_loops *loops;
	struct fixed_placement placement; /* what positions mean, see fixed.h:
					     in scene units if skinned, else
					     local ones; by the last update */
	struct fixed_vector *position;    /* output */
	struct fixed_vector *normal;      /* output, or NULL: flat */
	struct fixed_vector *tangent;     /* output, or NULL: no relief */

	/*
	 * Vertices are in an order of their own where these are not NULL:
	 * place says where the primitive's vertex is, order which one is here.
	 */
	const uint32_t *slot, *order;

	struct fixed_skin skin;             /* of a skinned one */
	struct fixed_matrix *matrix;        /* [skin.joint_count] */
	struct fixed_skin_morph skin_morph; /* if it is morphed, too */
	struct fixed_morph morph; /* of another; rigid: without targets */
	bool overflowed; /* the last pose has no place in 16 bits; the output is
			an earlier one's */
};

/* One primitive as one node shows it. */
struct drawable {
	int node;
	int primitive_index;
	const struct model_primitive *primitive;
	int skin;      /* or -1: rigid, drawn by its node's matrix */
	bool morphed;  /* has targets */
	bool external; /* shows what instance_use_vertices() gave it */
	bool hidden;
	int lod; /* drawn by the batch's lod[lod - 1]; 0: by all triangles */
	fx16_t color[4]; /* the material's, sRGB-encoded */
	float vertex_scale;

	const float (*base_position)[3]; /* times vertex_scale */
	const float (*base_normal)[3];   /* or NULL: flat */
	float (*position)[3];            /* output, in scene units if skinned,
					    else local times vertex_scale */
	float (*normal)[3];              /* output, or NULL: flat */

	/* Output in place of the two above; vertex_scale is 1. Or NULL. */
	struct drawable_fixed *fixed;

	/* With relief (see bump.h), else NULL. Output like normal. */
	uint8_t (*light)[4]; /* towards the light, for the combiner */
	const float (*base_tangent)[3]; /* of a rigid one */
	float (*tangent)[3];            /* these three: in float alone */
	float (*bitangent)[3];

	struct skin_stream stream; /* in fixed point: its counts alone */
	struct morph_term *term;   /* [target_count] */

	int batch_count;
	struct batch *batch;
};

struct instance {
	const struct model *model;
	struct arena arena;
	const struct kernel *kernel;
	int max_influences; /* 0: all */

	/*
	 * Updates move skinned vertices and leave their normals as they were,
	 * which saves much where light need not follow closely.
	 */
	bool hold_normals;

	/*
	 * Normal maps count: tangents are posed and lit at each update, and
	 * drawn where texture_set.normal_mapping says the driver can. May be
	 * changed before any update; true at first.
	 */
	bool normal_mapping;
	float towards_light[3]; /* unit vector, world space; light.h's at first:
				   what relief is lit from */

	struct pose pose;
	mat4 *world;    /* [node_count], in the model's own units */
	mat4 **palette; /* [skin_count][joint_count], times unit_scale */
	float unit_scale;
	float lod_px_per_unit; /* what drawables' lods were chosen for; 0:
				     nothing so far */

	int drawable_count;
	struct drawable *drawable;
	int float_count; /* drawables in float because 16 bits will not do */
};

/*
 * An instance at rest. The model must outlive it. 0, or -ENOMEM after a
 * sentence. The caller releases it with instance_destroy().
 */
int instance_create(const struct model *model, const struct kernel *kernel,
	const struct log *log, struct instance **out);

/* NULL is fine. */
void instance_destroy(struct instance *instance);

/* Whether an update left out what has no place in 16 bits. */
bool instance_overflowed(const struct instance *instance);

/*
 * The frame's work: from the pose to world matrices, palettes and output
 * vertices. Allocates nothing.
 */
void instance_update(struct instance *instance);

/*
 * Shows a rigid drawable in a shape that the caller keeps: vertex_count
 * positions in local units times vertex_scale, and normals where the primitive
 * has them. The arrays are read at each draw, not copied.
 */
void instance_use_vertices(
	struct drawable *drawable, float (*position)[3], float (*normal)[3]);

/* World matrices alone, for whoever only needs to know where nodes are. */
void instance_update_nodes(struct instance *instance);

/*
 * Where a node's origin is, in scene units, after the last update.
 */
void instance_node_position(
	const struct instance *instance, int node, float out[3]);

/*
 * The matrix that carries a rigid drawable's positions, as drawable_position()
 * tells them, to scene units.
 */
void instance_drawable_matrix(const struct instance *instance,
	const struct drawable *drawable, mat4 out);

/* Morph targets of the mesh that a drawable is of. */
static inline int drawable_target_count(
	const struct instance *instance, const struct drawable *drawable)
{
	const struct model *model = instance->model;

	return model->mesh[model->node[drawable->node].mesh].target_count;
}

/* Where the primitive's vertex is: in scene units if skinned, else local ones
   times vertex_scale. */
static inline void drawable_position(
	const struct drawable *drawable, int vertex, float out[3])
{
	const struct drawable_fixed *fixed = drawable->fixed;
	const struct fixed_placement *placement;
	const struct fixed_vector *v;

	if (!fixed) {
		memcpy(out, drawable->position[vertex], sizeof(float[3]));
		return;
	}
	placement = &fixed->placement;
	v = &fixed->position[fixed->slot ? fixed->slot[vertex] : (uint32_t)vertex];
	out[0] = (float)v->x * placement->scale + placement->offset[0];
	out[1] = (float)v->y * placement->scale + placement->offset[1];
	out[2] = (float)v->z * placement->scale + placement->offset[2];
}

/* A vertex in world space and the model's own units, after the last update. */
void instance_world_vertex(const struct instance *instance,
	const struct drawable *drawable, int vertex, float out[3]);

#endif
