/*
 * The data of an instance of a model: its pose and its output vertices.
 *
 * A model may have many instances. Each owns a pose, the world matrices and
 * palettes computed from the pose, and the arrays that the vertex kernels write.
 * instance_create() allocates all memory.
 *
 * Units: matrices reach GL in 16.16 fixed point, so lengths have to stay near 1.
 * A scene unit is a metre if the model is between 25 cm and 16 m large, else a
 * power of two of metres (unit_scale; exact in float). In the same way a rigid
 * or morphed primitive whose positions are far from 1 is scaled by a power of
 * two (vertex_scale), and the matrix that draws it divides by that again.
 *
 * With a kernel that has fixed-point loops, vertices are 16-bit numbers whose
 * scale and offset are part of the matrix that draws them. A primitive that 16
 * bits cannot represent stays in float. drawable_position() returns a vertex's
 * position in either case.
 */
#ifndef APP_SCENE_INSTANCE_INSTANCE_DATA_H
#define APP_SCENE_INSTANCE_INSTANCE_DATA_H

#include "app/anim/kernel/kernel.h"
#include "app/anim/kernel/layout/fixed_keys.h"
#include "app/anim/kernel/layout/fixed_morph.h"
#include "app/anim/kernel/layout/fixed_skin.h"
#include "app/anim/pose_normals.h"
#include "app/anim/skin.h"
#include "platform/base/fixed.h"

#include <string.h>

/* A coarser list of a batch's triangles, see lod.h. */
struct batch_lod {
	float error; /* in the unit of the model's positions */
	int index_count;
	int glow_from; /* the triangles before it emit nothing, see draw/glow.h */
	const uint16_t *index;
	/* of a list for shadows: the level whose vertices include its own */
	int posed_lod;
	/*
	 * In a gathered batch the list has vertices of its own: vertex_count
	 * from this one of the batch's arrays on, of which index counts.
	 * Elsewhere both are 0, and index counts all vertices.
	 */
	int first_vertex, vertex_count;
	bool flat; /* facets (facets.h) */
};

/*
 * Vertices that one GL call draws. The arrays are the drawable's own or copies
 * in another order, see batch.h.
 */
struct batch {
	int vertex_count; /* of the list of all triangles */
	/* In a gathered batch, vertices of coarser lists follow in all arrays. */
	int level_vertex_count;
	/*
	 * In a gathered batch, for each vertex: the primitive's vertex that it
	 * is a copy of. NULL if the batch uses the drawable's own arrays.
	 */
	const uint32_t *source;
	/*
	 * Only in a gathered batch of a primitive without normals, else NULL:
	 * the same for corners of the primitive's index, from whose triangles
	 * the vertices of coarser lists have their normals (model_lod.corner)
	 */
	const uint32_t *corner;
	const float (*position)[3]; /* NULL: fixed_position is used */
	const float (*normal)[3];   /* NULL: fixed_normal is used */
	const struct fixed_vector *fixed_position;
	const struct fixed_vector *fixed_normal;
	const float (*texcoord)[2]; /* or NULL */
	const uint8_t (*color)[4];  /* or NULL */

	int index_count;
	/*
	 * NULL: every three vertices are a triangle; a gathered batch with an
	 * index holds facets (facets.h)
	 */
	const uint16_t *index;
	int glow_from; /* within index, as in batch_lod */
	int lod_count;
	struct batch_lod *lod; /* [lod_count], finest first */
	/* Lists for shadows, finest first: nearly the same silhouette. */
	int shadow_count;
	struct batch_lod *shadow; /* [shadow_count] */

	/* The copies of a gathered batch, which each update writes. */
	float (*gathered_position)[3];
	float (*gathered_normal)[3];
	struct fixed_vector *gathered_fixed;
	struct fixed_vector *gathered_fixed_normal;
};

/* The vertices of a drawable in fixed point. */
struct drawable_fixed {
	const struct fixed_loops *loops;
	/*
	 * Scale and offset of the last update's positions, see fixed.h: to
	 * scene units if the drawable is skinned, else to local units.
	 */
	struct fixed_placement placement;
	struct fixed_vector *position; /* output */
	struct fixed_vector *normal;   /* output; NULL: flat shading */
	struct fixed_vector *tangent;  /* output; NULL: not bump-mapped */

	/*
	 * NULL if the arrays have the primitive's order. Otherwise order[i] is
	 * the primitive's vertex that is stored at i, and inverse_order[v] is
	 * where the primitive's vertex v is stored.
	 */
	const uint32_t *order, *inverse_order;

	struct fixed_skin skin;             /* if skinned */
	struct fixed_matrix *matrix;        /* [skin.joint_count] */
	struct fixed_matrix *normal_matrix; /* the same for normals, if these
					       have a palette of their own */
	struct fixed_morph morph; /* if not skinned; rigid: no targets */
	/* instead of morph, if the targets are key frames */
	struct fixed_keys *keys;
	/* The last pose did not fit 16 bits: the output is an earlier one's. */
	bool overflowed;
};

/* One primitive as one node shows it. */
struct drawable {
	int node;
	int primitive_index;
	const struct model_primitive *primitive;
	int skin;      /* -1: rigid, drawn by its node's matrix */
	bool morphed;  /* the mesh has targets */
	bool shared;   /* its vertices are those of an earlier drawable */
	bool external; /* shows the caller's arrays: instance_use_vertices() */
	bool hidden;
	/* the last update's joints reversed the winding of triangles */
	bool mirrored;
	int lod;         /* draws batch.lod[lod - 1]; 0: all triangles */
	int shadow_lod;  /* the same for the shadow, if that list is shorter
			    than batch.shadow[shadow_list] */
	int shadow_list; /* batch.shadow_count: none is good enough */
	/* the last update posed vertices of this and coarser levels; 0: all */
	int posed_lod;
	enum model_alpha alpha; /* see model_alpha_of() */
	float mean_alpha;       /* of the surface without its texture, 0..1 */
	bool unseen;            /* casts no shadow: see model_alpha_is_seen() */
	fx16_t color[4]; /* the material's base colour, sRGB-encoded, 16.16 */
	/* the light it emits, 16.16: see emission_color() */
	fx16_t emission[4];
	float vertex_scale;
	/*
	 * Only without a skin: the middle and the half sides of a box, in local
	 * units, around the vertices without morph targets and with each target
	 * alone at its full weight.
	 */
	float box_middle[3], box_half[3];

	const float (*base_position)[3]; /* the model's times vertex_scale */
	const float (*base_normal)[3];   /* NULL: flat shading */
	/*
	 * Output: in scene units if skinned, else in local units times
	 * vertex_scale.
	 */
	float (*position)[3];
	float (*normal)[3]; /* output; NULL: flat shading */

	/*
	 * If not NULL, the drawable is posed in fixed point: this replaces the
	 * two arrays above, and vertex_scale is 1.
	 */
	struct drawable_fixed *fixed;

	/* If bump-mapped (see bump.h), else NULL. */
	/* output: each vertex's direction to the light, see bump_encode() */
	uint8_t (*light)[4];
	/* texels of the normal map along a unit of the surface */
	float bump_texels;
	/* the drawable appears too small for bumps to be seen */
	bool bumps_hidden;
	bool bumped; /* the last update computed tangents and light */
	const float (*base_tangent)[3]; /* if not skinned, in float only */
	float (*tangent)[3];            /* output, in float only */
	float (*bitangent)[3];          /* output, in float only */

	struct skin_stream stream; /* in fixed point only its counts are set */
	struct morph_term *term;   /* [target_count] */

	int batch_count;
	struct batch *batch;
};

/* An entry of the list of blended drawables. */
struct blended_drawable {
	int drawable;
	float distance_squared; /* from the eye, see alpha_sort_blended() */
};

struct instance {
	const struct model *model;
	struct arena arena;
	const struct kernel *kernel;
	int max_influences; /* of a vertex; 0: all */

	/*
	 * If true, updates pose the positions of skinned vertices and keep their
	 * normals, which saves time where lighting need not follow closely.
	 */
	bool hold_normals;

	/*
	 * If true, updates pose the vertices but not the batches, from which
	 * an instance is drawn.
	 */
	bool undrawn;

	bool drawn_vertices_only; /* set by instance_create_for_drawing() */

	/*
	 * If true, updates pose and light the tangents of bump-mapped
	 * drawables, which are then drawn with their normal maps if
	 * texture_set.normal_mapping is true. May be changed before any update;
	 * true initially.
	 */
	bool normal_mapping;
	/* Unit vector to the light that bump mapping uses, in world space. */
	float towards_light[3];

	struct pose pose;
	mat4 *world;    /* [node_count], in the model's units */
	mat4 **palette; /* [skin_count][joint_count], times unit_scale */
	const mat4 **normal_palette; /* [skin_count]: palette[skin] unless the
					pose needs another for normals */
	struct pose_normals normals;
	float unit_scale; /* scene units a metre */
	/*
	 * The pixels a scene unit for which the drawables' levels of detail
	 * were chosen; 0 before the first choice.
	 */
	float lod_px_per_unit;

	int drawable_count;
	struct drawable *drawable;
	/* The blended drawables in the order of drawing, see alpha.h. */
	int blended_count;
	struct blended_drawable *blended; /* room for drawable_count */
	int float_count; /* drawables in float because 16 bits do not suffice */
};

/* Returns the length of a batch's arrays. */
static inline int batch_array_length(const struct batch *batch)
{
	return batch->vertex_count + batch->level_vertex_count;
}

/* Returns the list that draws a batch's surface, or NULL for all triangles. */
static inline const struct batch_lod *drawable_shaded(
	const struct drawable *drawable, const struct batch *batch)
{
	return drawable->lod > 0 ? &batch->lod[drawable->lod - 1] : NULL;
}

/* Returns the list that draws a batch's shadow, or NULL for all triangles. */
static inline const struct batch_lod *drawable_shadow(
	const struct drawable *drawable, const struct batch *batch)
{
	const struct batch_lod *lod = drawable->shadow_lod > 0
		? &batch->lod[drawable->shadow_lod - 1]
		: NULL;
	const struct batch_lod *own = drawable->shadow_list < batch->shadow_count
		? &batch->shadow[drawable->shadow_list]
		: NULL;

	return own && (!lod || own->index_count <= lod->index_count) ? own : lod;
}

/* Returns the number of morph targets of the drawable's mesh. */
static inline int drawable_target_count(
	const struct instance *instance, const struct drawable *drawable)
{
	const struct model *model = instance->model;

	return model->mesh[model->node[drawable->node].mesh].target_count;
}

/*
 * Returns the posed position of the primitive's vertex: in scene units if the
 * drawable is skinned, else in local units times vertex_scale.
 */
static inline void drawable_position(
	const struct drawable *drawable, int vertex, float out[3])
{
	const struct drawable_fixed *fixed = drawable->fixed;

	if (!fixed) {
		memcpy(out, drawable->position[vertex], sizeof(float[3]));
		return;
	}
	fixed_placement_apply(&fixed->placement,
		&fixed->position[fixed->inverse_order ? fixed->inverse_order[vertex]
						      : (uint32_t)vertex],
		out);
}

/* The same for a vertex of one of its batches, by its number in that batch. */
static inline void drawable_batch_position(const struct drawable *drawable,
	const struct batch *batch, int vertex, float out[3])
{
	if (batch->position) {
		memcpy(out, batch->position[vertex], sizeof(float[3]));
		return;
	}
	fixed_placement_apply(&drawable->fixed->placement,
		&batch->fixed_position[vertex], out);
}

#endif
