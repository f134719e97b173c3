/*
 * The contents of a model file as plain data, and the functions that load one.
 *
 * Loaders of all file formats fill the same struct model. The struct does not
 * depend on the format and contains no state of an animation. After the load a
 * model does not change. Its arena owns all of it, including strings.
 *
 * The conventions are those of glTF 2.0: right-handed, +Y up, metres, radians,
 * seconds, quaternions as x y z w, matrices as four columns. Loaders convert.
 */
#ifndef APP_MODEL_MODEL_H
#define APP_MODEL_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/base/arena.h"
#include "platform/base/log.h"
#include "platform/base/memory_budget.h"

#include <cglm/types.h>

/* The matrix T * R * S: a point is scaled, then rotated, then translated. */
struct transform {
	float translation[3];
	float rotation[4]; /* unit quaternion x y z w */
	float scale[3];
};

enum model_number {
	MODEL_FLOAT,
	MODEL_INT16,
	MODEL_INT8,
};

/*
 * Consecutive vertices of a primitive. Their displacements are elements `at`
 * and following of model_deltas.value.
 */
struct model_span {
	int first, count;
	int at;
};

/*
 * Displacements of one attribute of a primitive's vertices, packed without
 * loss: in the file's type of numbers and, if few vertices move, only of these.
 * Read them with the functions of model_deltas.h.
 */
struct model_deltas {
	int vertex_count; /* of the primitive; 0: no displacements */
	enum model_number number;
	float unit; /* the stored number that stands for 1 */
	int span_count;
	const struct model_span *span; /* ascending; NULL: all vertices */
	const void *value;             /* x, y, z of each vertex in the spans */
	const int16_t (*base)[3];      /* NULL, or [vertex_count]: to subtract
					  from value; only for MODEL_INT16
					  without spans */
};

/* A morph target: the displacements of a primitive's vertices at weight 1. */
struct model_target {
	struct model_deltas position, normal, tangent;
};

/*
 * Morph targets that are key frames (model_keys.h), stored as displaced
 * vertices. Key 0 is the primitive without targets, key 1 + t is target t at
 * weight 1. Numbers have the format of struct fixed_key
 * (app/anim/kernel/fixed.h), number = -2 * n: a position is n * scale + offset,
 * and a direction of length 1 has an n of length 16383.
 */
struct model_keys {
	int stride; /* vertices from one key to the next, an even number */
	float scale, offset[3];
	/* Of positions, normals, tangents: [(1 + targets) * stride] or NULL. */
	const int16_t (*key[3])[3];
};

/* A level of detail: a coarser triangle list over a primitive's vertices. */
struct model_lod {
	float error_m;    /* distance of its surface from that of the full list,
			     in the unit of the positions */
	bool shadow_only; /* good enough for shadows only: the shape is right,
			     not the shading */
	int index_count;  /* a multiple of 3 */
	uint32_t *index;  /* each below the primitive's vertex_count */
	/*
	 * Only in a level that limber makes of a primitive without normals:
	 * [index_count]: where the primitive's index has this vertex as a
	 * corner of the triangle whose plane has the normal for it. If it is
	 * NULL, such a primitive's triangles are flat.
	 */
	uint32_t *corner;
};

/* Vertices and a list of triangles. */
struct model_primitive {
	int file_index; /* the primitive's number in the file's mesh */
	/*
	 * A primitive of the file with many vertices is divided into several of
	 * these, one after the other (split/split.h). Then
	 * file_vertex[vertex_count] has the vertices' numbers in the file's
	 * primitive, else it is NULL. The first repeated_count vertices are
	 * repeated from earlier parts.
	 */
	const uint32_t *file_vertex;
	int repeated_count;
	int material; /* index into model.material; loaders add a default one */

	int vertex_count;
	float (*position)[3];
	float (*normal)[3];   /* or NULL: drawn with flat normals of the posed
				 triangles */
	float (*tangent)[4];  /* or NULL; w is the sign of the bitangent */
	float (*texcoord)[2]; /* or NULL; v runs down, as in glTF */
	uint8_t (*color)[4]; /* or NULL; sRGB-encoded red, green, blue; alpha */

	/*
	 * Influences per vertex: 0 without a skin, else 4 or 8. A joint number
	 * is an index into model_skin.joint, in range for every skin with which
	 * a node draws this mesh. Weights are at least 0 and sum to 1.
	 */
	int influences;
	uint16_t *joint; /* [vertex_count][influences] */
	float *weight;   /* [vertex_count][influences] */

	struct model_target *target; /* [mesh.target_count] */
	/*
	 * NULL, or the targets as key frames; then the deltas of target[] point
	 * into the same memory.
	 */
	const struct model_keys *keys;

	int index_count; /* a multiple of 3 */
	uint32_t *index; /* each below vertex_count */

	/* [lod_count]: the finest level first; shadow_only levels come last. */
	int lod_count;
	struct model_lod *lod;
};

struct model_mesh {
	const char *name; /* all names are "" where the file has none */
	int primitive_count;
	struct model_primitive *primitive;
	int target_count; /* morph targets, the same for all primitives */
	const char **target_name; /* [target_count] */
	bool key_frames; /* the file says that the targets are key frames
			    (model_keys.h) */
};

struct model_node {
	const char *name;
	int file_index; /* its number in the file */
	int parent;     /* index less than the node's own, or -1 */
	bool in_scene;  /* whether the node belongs to the scene; others are not
			   drawn */
	bool hidden;    /* the file hides the node or an ancestor */

	struct transform rest;
	const float (*matrix)[4]; /* NULL, or four columns of a matrix that
				     replaces rest: the file's matrix with
				     shear, for a node that no clip moves */

	int mesh, skin, camera; /* indices, or -1 */

	/*
	 * Index in pose.weight of this node's first morph weight; there are
	 * mesh.target_count of them.
	 */
	int weight_offset;
};

struct model_skin {
	const char *name;
	int joint_count;
	int *joint;         /* node indices */
	mat4 *inverse_bind; /* [joint_count]; identity where the file has
			     none */
};

enum model_path {
	MODEL_TRANSLATION, /* 3 floats a key */
	MODEL_ROTATION,    /* 4 */
	MODEL_SCALE,       /* 3 */
	MODEL_WEIGHTS,     /* the mesh's target_count */
};

enum model_interpolation {
	MODEL_STEP,
	MODEL_LINEAR,
	MODEL_CUBICSPLINE, /* a key is width in-tangents, width values, width
			      out-tangents; tangents are per second
			      (glTF 2.0, appendix C) */
};

struct model_channel {
	int node;
	enum model_path path;
	enum model_interpolation interpolation;
	/* no value differs from the first one by more than 2e-6 of the clip's
	   largest value on this path; never true for MODEL_CUBICSPLINE. The
	   glTF loader keeps only the first key of such a channel */
	bool constant;
	bool unit;           /* rotation keys have unit length to 1e-6; never
				true for MODEL_CUBICSPLINE */
	int width;           /* floats of a value */
	int key_count;       /* at least 1 */
	const float *time_s; /* strictly increasing */
	const float *value;  /* [key_count * width], three times as many if
				cubic; NULL if packed is set */
	/*
	 * NULL, or [key_count][4]: the keys of a linear rotation in shorts, as
	 * the file stores them. MODEL_PACKED_UNIT stands for 1. The keys'
	 * length is 1 to within 4e-5, and consecutive keys have a dot product
	 * of at least 0.
	 */
	const int16_t (*packed)[4];
};

enum {
	MODEL_PACKED_UNIT = 32767
};

struct model_clip {
	const char *name;
	float duration_s; /* the time of the last key; a clip starts at 0 */
	/* when the first key of a channel that is not constant comes, if that
	   is within 0.1 s and before the end; else 0. Blender's clips begin at
	   frame 1 */
	float lead_s;
	int channel_count;
	struct model_channel *channel;
};

struct model_image {
	const char *name;
	int width, height;
	int file_width, file_height; /* before it was halved, see image.h */
	bool opaque;                 /* every alpha is 255 */
	uint8_t *rgba; /* [height][width][4], top row first, sRGB, alpha */
};

enum model_wrap {
	MODEL_REPEAT,
	MODEL_CLAMP,
	MODEL_MIRROR,
};

struct model_texture {
	int image;
	enum model_wrap wrap_s, wrap_t;
	bool nearest; /* magnification filter GL_NEAREST, else GL_LINEAR */
	bool mipmap;  /* minification uses mipmaps */
};

enum model_alpha {
	MODEL_OPAQUE,
	MODEL_MASK,
	MODEL_BLEND,
};

struct model_material {
	const char *name;
	float base_color[4];  /* linear RGB and alpha */
	int texture;          /* index of the base colour's texture, or -1 */
	int normal_texture;   /* index of a tangent-space normal map, or -1 */
	float roughness;      /* 0..1 */
	float emissive[3];    /* linear RGB, 0..1: light that the surface
			       emits */
	int emissive_texture; /* index of a texture that multiplies it, or -1 */
	enum model_alpha alpha;
	float alpha_cutoff;
	bool double_sided;
	bool unlit;
};

/* The default material: white, rough, opaque. */
extern const struct model_material model_plain_material;

/*
 * Sets the sRGB-encoded colour of a material in light of all directions: its
 * base colour without a texture, and what it mirrors (color_mirrored()) unless
 * it is unlit or all of it emits light.
 */
void model_material_shown(
	const struct model_material *material, float out_srgb[3]);

struct model_camera {
	const char *name;
	bool perspective;
	float yfov_rad, aspect; /* perspective; aspect 0 means the viewport's */
	float xmag, ymag;       /* orthographic: half the width and height */
	float znear, zfar;      /* zfar 0 means infinite */
};

struct model {
	struct arena arena;
	struct arena targets; /* owns the morph targets' displacements in
			       floats */
	/*
	 * Limits the memory of the model and of all its instances. The arena
	 * owns the budget. NULL (no limit) only in a model that no loader made.
	 */
	struct memory_budget *budget;
	const char *path;
	const char *format; /* for display: "glTF 2.0" */

	/*
	 * Where the model's origin is in the file, metres: not 0 if the file's
	 * model is far from the file's (origin/model_origin.h).
	 */
	double origin[3];

	int node_count;
	struct model_node *node; /* parents before children */
	int mesh_count;
	struct model_mesh *mesh;
	int skin_count;
	struct model_skin *skin;
	int clip_count;
	struct model_clip *clip;
	int material_count;
	struct model_material *material;
	int texture_count;
	struct model_texture *texture;
	int image_count;
	struct model_image *image;
	int camera_count;
	struct model_camera *camera;

	int weight_count;    /* morph weights of all nodes in total */
	float *rest_weights; /* [weight_count]: from the file's node, else from
				its mesh, else 0 */
};

/*
 * Loaders refuse a position, a length, a time or any other number of an array
 * that is larger than this, so that sums of a few squares of them stay finite.
 */
#define MODEL_NUMBER_MAX 1e9f

enum {
	MODEL_MEMORY_BYTES = 256 * 1024 * 1024 /* the default budget */
};

/*
 * Loads a file. Its content, not its name, decides which loader reads it.
 * Returns 0, and the caller releases *out with model_destroy(); or returns
 * -errno, sets *out to NULL, and logs one error that names the file, the
 * location in it and the reason: -ENOENT for a missing file, -EINVAL for a
 * malformed one, -ENOTSUP for what limber cannot play, -EFBIG beyond a limit,
 * -EACCES for a reference outside the file's folder, -ENOMEM.
 */
int model_load(const char *path, const struct log *log, struct model **out);

/*
 * The same with a budget of memory_bytes instead of MODEL_MEMORY_BYTES. The
 * budget limits the memory of the load, the model and the model's instances.
 */
int model_load_within(const char *path, size_t memory_bytes,
	const struct log *log, struct model **out);

/*
 * The same from bytes in memory, to which the model keeps no pointer. name
 * serves as the path in messages and in model.path. Returns -EACCES if the
 * model refers to other files.
 */
int model_load_memory(const void *data, size_t size, const char *name,
	const struct log *log, struct model **out);

/* Releases a model; NULL is allowed. */
void model_destroy(struct model *model);

/* Returns the index of the first node of that name, or -1. */
int model_find_node(const struct model *model, const char *name);

/* Whether the node has a mesh that the scene shows. */
bool model_node_shows_mesh(const struct model_node *node);

/* Whether a node is the one at the top or one of its descendants. */
bool model_is_below(const struct model *model, int node, int top);

/*
 * Returns the lowest node that two nodes are below, or one of the two if the
 * other one is below it; -1 if they have no such node.
 */
int model_find_common(const struct model *model, int a, int b);

/*
 * Returns the lowest node on which all that is shown hangs: meshes on their
 * nodes, skins on their joints. -1 if there is none.
 */
int model_find_carrier(const struct model *model);

/*
 * Returns the coarsest level of detail, counted from 1, whose triangle list has
 * at least index_count indices, or 0, the full list, if there is none. Lists
 * for shadows do not count.
 */
int model_lod_of_size(const struct model_primitive *primitive, int index_count);

/*
 * Returns the index of the clip that has this name or, if none has it, this
 * number. Returns -1 if there is none either.
 */
int model_find_clip(const struct model *model, const char *name_or_index);

/* Whether a clip moves the weights of a node's morph targets. */
bool model_clip_moves_weights(const struct model_clip *clip, int node);

/* Sets moved, [node_count], to true for each node that a clip moves. */
void model_clip_mark_moved(const struct model_clip *clip, bool *moved);

/*
 * Lists clips of which no two move the same node, beginning with first, in
 * list, [clip_count]. moved, [node_count], is scratch memory of zeros. Returns
 * how many clips it lists.
 */
int model_clips_apart(
	const struct model *model, int first, bool *moved, int *list);

/*
 * Writes the value of one key, channel->width floats, of a channel that is not
 * MODEL_CUBICSPLINE. Packed rotations are normalised.
 */
void model_channel_key(const struct model_channel *channel, int key, float *out);

/* Whether a surface of this material shows light that it emits. */
bool model_material_emits(const struct model_material *material);

/* Whether any node has a mesh with triangles. */
bool model_has_triangles(const struct model *model);

/*
 * Returns [node_count]: whether a skin lists the node as a joint. The arena
 * owns the array. NULL if there is not enough memory.
 */
bool *model_find_joints(const struct model *model, struct arena *arena);

/* Returns the first shown node whose mesh has morph targets, or -1. */
int model_find_morphed(const struct model *model);

/*
 * Sets *out to the index of the clip that the option --clip names (wanted, see
 * model_find_clip()), or to fallback if wanted is NULL. Returns 0, or -ENOENT
 * after an error on the log if there is no such clip.
 */
int model_choose_clip(const struct model *model, const char *wanted,
	int fallback, const struct log *log, int *out);

#endif
