/*
 * The inside of the glTF loader, for gltf*.c alone.
 *
 *	gltf.c            the steps, in order
 *	gltf_container.c  bytes -> JSON, buffers and buffer views
 *	gltf_json.c       a place in the JSON, its values, sentences about it
 *	gltf_accessor.c   accessors: checked once, then read
 *	gltf_material.c   materials, textures, images
 *	gltf_mesh.c       meshes and primitives; gltf_target.c morph targets
 *	gltf_lod.c        coarser levels of meshes (MSFT_lod)
 *	gltf_node.c       nodes and scenes; gltf_camera.c cameras
 *	gltf_skin.c       skins, and influences of vertices
 *	gltf_animation.c  clips
 *
 * Functions that return int give 0 or -errno after one sentence. Everything
 * that a file states is checked before memory is taken for it, and all memory
 * comes from two arenas: the model's, and a scratch arena that ends with the
 * load. GLTF_BUDGET_BYTES limits both together.
 */
#ifndef APP_MODEL_GLTF_GLTF_INTERNAL_H
#define APP_MODEL_GLTF_GLTF_INTERNAL_H

#include "app/model/model_file.h"
#include "app/model/model_loader.h"

#include <jansson.h>

enum {
	GLTF_BUDGET_BYTES = 256 * 1024 * 1024,
	GLTF_JSON_BYTES_MAX = 64 * 1024 * 1024,
	GLTF_JSON_VALUES_MAX = 1024 * 1024,
};

/* Component types by their numbers in the file. */
enum gltf_component {
	GLTF_I8 = 5120,
	GLTF_U8 = 5121,
	GLTF_I16 = 5122,
	GLTF_U16 = 5123,
	GLTF_U32 = 5125,
	GLTF_F32 = 5126,
};

struct gltf_buffer {
	const uint8_t *data;
	size_t size; /* the file's byteLength, all of it there */
	struct model_file file;
};

struct gltf_view {
	const uint8_t *data;
	size_t size;
	size_t stride; /* 0 where the file gives none: packed */
};

/* Elements in memory; every one of count lies within its buffer view. */
struct gltf_elements {
	const uint8_t *data; /* NULL: zeros */
	size_t stride;
	enum gltf_component component;
};

struct gltf_accessor {
	struct gltf_elements base;
	int count;
	const char *type; /* "VEC3" */
	int width;        /* components of an element */
	bool normalized;

	int sparse_count;
	struct gltf_elements sparse_index; /* each below count */
	struct gltf_elements sparse_value;
};

/*
 * A place in the JSON. Places are made on the stack, each pointing up to the
 * one it was made from, so that a sentence can name the whole path.
 */
struct gltf_at {
	struct gltf *gltf;
	const struct gltf_at *up;
	const char *key; /* NULL: element index of an array */
	int index;
	const json_t *json; /* NULL: the file has nothing here */
};

/* What a KHR_texture_transform does to coordinates, two rows of a matrix. */
struct gltf_uv {
	int set; /* TEXCOORD_set */
	bool transformed;
	float row[2][3];
};

/* A mesh of the file that is a coarser level of another, or has levels. */
struct gltf_level {
	int of;          /* the other's number in the file, or -1: it is none */
	int first, next; /* its own levels: the first, that one's next; or -1 */
	int count;
	float error_m;  /* as the file states it, or 0 */
	float coverage; /* without it: the share of the screen below which this
			   level will do */
	bool shape;
};

struct gltf {
	const struct model_source *source;
	const struct log *log;
	struct arena scratch;
	struct model *model;
	json_t *json;
	struct gltf_at root;

	const uint8_t *binary; /* the BIN chunk of a .glb, or NULL */
	size_t binary_size;
	size_t file_bytes; /* of the files beside it */

	int warnings; /* said so far */

	int buffer_count;
	struct gltf_buffer *buffer;
	int view_count;
	struct gltf_view *view;
	int accessor_count;
	struct gltf_accessor *accessor;
	const float **times; /* [accessor_count]: already read as key times */

	struct gltf_uv *uv;   /* [material_count] */
	int *texture_place;   /* file's number -> model's, -1: not needed */
	int *image_place;     /* likewise */
	int default_material; /* -1: not needed so far */
	float **mesh_weights; /* of the model's meshes, NULL without */

	/* Numbers of the file; levels are no nodes and meshes of the model. */
	int mesh_count;
	struct gltf_level *level; /* [mesh_count] */
	int *mesh_place;          /* file's number -> model's, -1: a level */
	int *mesh_number;         /* model's -> file's */
	int node_count;
	bool *node_is_level; /* [node_count] */
	int *node_place;     /* file's number -> model's, -1: a level */
};

/* gltf.c */

/*
 * Reads all of the source into gltf->model, which is NULL after an error. In
 * any case gltf_end() has to follow; the model is the caller's to keep or to
 * destroy.
 */
int gltf_begin(struct gltf *gltf, const struct model_source *source,
	const struct log *log);
void gltf_end(struct gltf *gltf);

/* gltf_json.c */

/* Says "FILE: PATH: SENTENCE" and returns code. */
int gltf_fail(const struct gltf_at *at, int code, const char *format, ...)
	PRINTF_LIKE(3, 4);

/* The same as a warning, of which a file gets only so many. */
void gltf_warn(const struct gltf_at *at, const char *format, ...)
	PRINTF_LIKE(2, 3);

/* "FILE: PATH" into text, cut to fit. */
void gltf_where(const struct gltf_at *at, char *text, size_t size);

/* The member of an object; json is NULL where there is none. */
struct gltf_at gltf_member(const struct gltf_at *at, const char *key);

/* The element of an array, below its length. */
struct gltf_at gltf_element(const struct gltf_at *array, int index);

/* The element, which must be an object. */
int gltf_item(const struct gltf_at *array, int index, struct gltf_at *out);

/*
 * The functions below read a member of an object. Where it is absent they give
 * an empty value, or leave *out alone when its name says "maybe".
 */
int gltf_object(const struct gltf_at *at, const char *key, struct gltf_at *out);
int gltf_array(const struct gltf_at *at, const char *key, struct gltf_at *out,
	int *count);
int gltf_maybe_string(
	const struct gltf_at *at, const char *key, const char **out);
/* The place among count names of the one it is; another is -EINVAL. */
int gltf_maybe_choice(const struct gltf_at *at, const char *key,
	const char *const *names, int count, int *out);
int gltf_maybe_bool(const struct gltf_at *at, const char *key, bool *out);
int gltf_maybe_number(const struct gltf_at *at, const char *key, float *out);
int gltf_maybe_floats(
	const struct gltf_at *at, const char *key, float *out, int count);
int gltf_maybe_integer(const struct gltf_at *at, const char *key, int64_t min,
	int64_t max, int64_t *out);

/* A number of one of count things, called what; absent: *out stays. */
int gltf_maybe_index(const struct gltf_at *at, const char *key, int count,
	const char *what, int *out);

/* The same for a place that is itself the number. */
int gltf_index(const struct gltf_at *at, int count, const char *what, int *out);

/* Fails unless the object has this member. */
int gltf_need(const struct gltf_at *at, const char *key);

/* A copy of the string in the model. */
int gltf_keep_string(
	const struct gltf_at *at, const char *text, const char **out);

/* The name of an object, "" without one, copied into the model. */
int gltf_name(const struct gltf_at *at, const char **out);

/*
 * Zeroed room in one of the arenas within the budget, or NULL after a sentence
 * about the place that asked for it; callers return -ENOMEM.
 */
void *gltf_room(const struct gltf_at *at, struct arena *arena, size_t count,
	size_t size);

/* Whether the budget has it; otherwise a sentence about the place. */
bool gltf_has_room(const struct gltf_at *at, size_t count, size_t size);

#define GLTF_KEEP(at, type, count)                                           \
	((type *)gltf_room((at), &(at)->gltf->model->arena, (size_t)(count), \
		sizeof(type)))
#define GLTF_SCRATCH(at, type, count) \
	((type *)gltf_room(           \
		(at), &(at)->gltf->scratch, (size_t)(count), sizeof(type)))

/* gltf_container.c */

/* Finds JSON and binary data in the source and parses the JSON. */
int gltf_open(struct gltf *gltf);

/* Fills gltf->buffer and gltf->view. */
int gltf_read_buffers(struct gltf *gltf);

/*
 * The bytes that a "uri" names: decoded from a data URI into the scratch
 * arena, or read from a file, which the caller releases.
 */
int gltf_read_uri(const struct gltf_at *at, const char *uri,
	struct model_file *file, const uint8_t **data, size_t *size);

/* gltf_accessor.c */

/* Fills gltf->accessor; afterwards reading cannot go out of bounds. */
int gltf_read_accessors(struct gltf *gltf);

/*
 * The accessor's values as floats, scaled where it is normalised, in row of
 * accessor->width. out has room for count * width floats; all are finite.
 */
int gltf_unpack_floats(const struct gltf_at *at,
	const struct gltf_accessor *accessor, float *out);

/* Whether the components are plain unsigned integers. */
bool gltf_is_unsigned(const struct gltf_accessor *accessor);

/* The same as integers, for those. */
void gltf_unpack_uints(const struct gltf_accessor *accessor, uint32_t *out);

/*
 * The accessor that the member of an object names, NULL where it names none.
 * type is what it must be: "VEC3", or "VEC3 VEC4" for either.
 */
int gltf_maybe_accessor(const struct gltf_at *at, const char *key,
	const char *type, const struct gltf_accessor **out);

/* gltf_material.c */

/* Fills material, texture, image and gltf->uv. */
int gltf_read_materials(struct gltf *gltf);

/* The material of primitives that name none. */
int gltf_default_material(struct gltf *gltf);

/* gltf_mesh.c */
int gltf_read_meshes(struct gltf *gltf);

/* Unpacked values of an attribute; value is NULL where the file has none. */
struct gltf_values {
	int width;
	float *value;
};

/* An attribute of a primitive or target, one element a vertex. */
int gltf_read_attribute(const struct gltf_at *at, const char *key,
	const char *type, int vertex_count, struct arena *arena,
	struct gltf_values *out);

/* gltf_target.c */

/* Fills target_count, from the first primitive, and target_name. */
int gltf_read_target_names(const struct gltf_at *mesh,
	const struct gltf_at *primitives, struct model_mesh *out);

/* Fills target of a primitive, [mesh->target_count]. */
int gltf_read_targets(const struct gltf_at *primitive,
	const struct model_mesh *mesh, struct model_primitive *out);

/* The "weights" of a mesh or node, in scratch; NULL where it has none. */
int gltf_read_weights(const struct gltf_at *at, int target_count, float **out);

/*
 * The triangle list of a primitive with so many vertices, whatever its mode;
 * "indices" may be missing.
 */
int gltf_read_triangles(const struct gltf_at *primitive, int vertex_count,
	uint32_t **index, int *index_count);

/* gltf_lod.c */

/*
 * Finds the nodes and meshes that are but levels of others by MSFT_lod: they
 * have the attributes of the mesh they stand for, the same transform, say how
 * coarse they are, and nothing else names them. Other levels stay what they
 * are without the extension, which is no mistake of the file.
 */
int gltf_find_levels(struct gltf *gltf);

/* The lists of a mesh's levels, into its primitives. */
int gltf_read_levels(struct gltf *gltf, int mesh);

/* gltf_camera.c */
int gltf_read_cameras(struct gltf *gltf);

/* gltf_node.c: nodes, their order, scene and weights. */
int gltf_read_nodes(struct gltf *gltf);

/* The model's number for the node whose number stands at this place. */
int gltf_node(const struct gltf_at *at, int *out);

/* Makes a quaternion unit; fails on zero. */
int gltf_normalize_rotation(const struct gltf_at *at, float rotation[4]);

/* gltf_skin.c */

/* Fills joint and weight of a primitive that has them. */
int gltf_read_influences(
	const struct gltf_at *attributes, struct model_primitive *out);

/* Skins; then no joint of a mesh is beyond a skin that draws it. */
int gltf_read_skins(struct gltf *gltf);

/* gltf_animation.c */
int gltf_read_animations(struct gltf *gltf);

#endif
