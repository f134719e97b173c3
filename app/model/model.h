/*
 * What a model file holds, as plain data.
 *
 * Every loader fills the same struct model; nothing here knows a file format,
 * an animation or a picture on a screen. A model is immutable once loaded and
 * all of it, strings included, lives in its own arena.
 *
 * Conventions are glTF 2.0's: right-handed, +Y up, metres, radians, seconds,
 * quaternions as x y z w, matrices as four columns. Loaders convert.
 */
#ifndef APP_MODEL_MODEL_H
#define APP_MODEL_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/base/arena.h"
#include "platform/base/log.h"

#include <cglm/types.h>

/* Translation, rotation, scale: applied to a point in the order S, R, T. */
struct transform {
	float translation[3];
	float rotation[4]; /* unit quaternion x y z w */
	float scale[3];
};

/* Additions to a primitive's base arrays at weight 1; NULL where unchanged. */
struct model_target {
	float (*position)[3];
	float (*normal)[3];
	float (*tangent)[3];
};

/*
 * A coarser list of triangles over the vertices of a primitive, for pictures in
 * which the full one's are too small to see.
 */
struct model_lod {
	float error_m;   /* how far its surface is from the full one's, in the
			    unit of the positions */
	bool shape;      /* for shadows: only where it is looks right */
	int index_count; /* as the primitive's own */
	uint32_t *index;
};

/* A triangle list and its vertices. */
struct model_primitive {
	int file_index; /* the file's own number for it in its mesh */
	int material;   /* index, never -1: loaders add a default material */

	int vertex_count;
	float (*position)[3];
	float (*normal)[3];   /* NULL: flat normals of the posed triangles */
	float (*tangent)[4];  /* or NULL; w is the sign of the bitangent */
	float (*texcoord)[2]; /* or NULL; v runs down, as in glTF */
	uint8_t (*color)[4];  /* or NULL; sRGB-encoded, as a screen shows it */

	/*
	 * influences per vertex: 0 without a skin, else 4 or 8. Joint numbers
	 * count in the skin's joint list and are checked against every skin
	 * that draws this mesh. Weights are not negative and sum to 1.
	 */
	int influences;
	uint16_t *joint; /* [vertex_count][influences] */
	float *weight;   /* [vertex_count][influences] */

	struct model_target *target; /* [mesh.target_count] */

	int index_count; /* a multiple of 3 */
	uint32_t *index; /* each below vertex_count */

	/* The finest first, those for shapes last; mostly there are none. */
	int lod_count;
	struct model_lod *lod;
};

struct model_mesh {
	const char *name; /* never NULL; "" where the file gives none */
	int primitive_count;
	struct model_primitive *primitive;
	int target_count;         /* shared by all primitives */
	const char **target_name; /* [target_count], never NULL strings */
};

struct model_node {
	const char *name;
	int file_index; /* the file's own number for it */
	int parent;     /* below this node's own index, or -1 */
	bool in_scene;  /* drawn only when true */

	struct transform rest;
	const float (*matrix)[4]; /* replaces rest where no T R S can say it
				     (shear) and no clip moves the node */

	int mesh, skin, camera; /* or -1 */

	/* This node's morph weights in a pose: mesh.target_count floats. */
	int weight_offset;
};

struct model_skin {
	const char *name;
	int joint_count;
	int *joint;         /* node indices */
	mat4 *inverse_bind; /* identity where the file gives none */
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
			      out-tangents; tangents are per second */
};

struct model_channel {
	int node;
	enum model_path path;
	enum model_interpolation interpolation;
	bool constant;       /* the first key's value will do at any time: no
				other differs by more than 2e-6 of the largest
				one that the clip has on this path */
	bool unit;           /* a rotation whose keys are unit length to 1e-6 */
	int width;           /* floats of one value */
	int key_count;       /* at least 1 */
	const float *time_s; /* strictly increasing */
	const float *value;  /* [key_count * width], times 3 if cubic */
};

struct model_clip {
	const char *name;
	float duration_s; /* the last key's time; a clip starts at 0 */
	int channel_count;
	struct model_channel *channel;
};

struct model_image {
	const char *name;
	int width, height;
	bool opaque;   /* every alpha is 255 */
	uint8_t *rgba; /* [height][width][4], top row first, sRGB */
};

enum model_wrap {
	MODEL_REPEAT,
	MODEL_CLAMP,
	MODEL_MIRROR,
};

struct model_texture {
	int image;
	enum model_wrap wrap_s, wrap_t;
	bool nearest; /* magnify without smoothing */
	bool mipmap;
};

enum model_alpha {
	MODEL_OPAQUE,
	MODEL_MASK,
	MODEL_BLEND,
};

struct model_material {
	const char *name;
	float base_color[4]; /* linear RGB and alpha */
	int texture;         /* base colour, or -1 */
	int normal_texture;  /* tangent-space normal map, or -1 */
	float roughness;     /* 0..1 */
	enum model_alpha alpha;
	float alpha_cutoff;
	bool double_sided;
	bool unlit;
};

/* Of what has none: white, rough, opaque. */
extern const struct model_material model_plain_material;

struct model_camera {
	const char *name;
	bool perspective;
	float yfov_rad, aspect; /* perspective; aspect 0: the viewport's */
	float xmag, ymag;       /* orthographic half-sizes */
	float znear, zfar;      /* zfar 0: infinite */
};

struct model {
	struct arena arena;
	const char *path;
	const char *format; /* "glTF 2.0" and the like, for people */

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

	int weight_count;    /* morph weights of all nodes together */
	float *rest_weights; /* [weight_count]: node's, else mesh's, else 0 */
};

/*
 * Loads a file by its content (glTF's magic or JSON), not by its name.
 * 0, or -errno after one sentence that names the file, the place in it and
 * the reason; -ENOENT for a missing file, -EINVAL for a malformed one,
 * -ENOTSUP for what limber cannot play, -ENOMEM. The caller releases *out
 * with model_destroy().
 */
int model_load(const char *path, const struct log *log, struct model **out);

/*
 * The same from memory, of which nothing is kept. name stands for the file in
 * sentences and in model.path; a model that names other files is refused.
 */
int model_load_memory(const void *data, size_t size, const char *name,
	const struct log *log, struct model **out);

/* Releases a model; NULL is fine. */
void model_destroy(struct model *model);

/* Index of the node, clip or mesh of that name, or -1. */
int model_find_node(const struct model *model, const char *name);
int model_find_mesh(const struct model *model, const char *name);

/*
 * Index of a clip given by name or, where no clip has that name, by number.
 * -1 when there is none.
 */
int model_find_clip(const struct model *model, const char *name_or_index);

/*
 * The clip that --clip names into *out, or unasked where wanted is NULL. 0, or
 * -ENOENT after a sentence.
 */
int model_choose_clip(const struct model *model, const char *wanted,
	int unasked, const struct log *log, int *out);

#endif
