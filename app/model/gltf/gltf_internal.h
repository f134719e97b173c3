/*
 * Declarations shared by the files of the glTF loader and of document/; nothing
 * else includes this header.
 *
 *	gltf.c            runs the steps of a load in order
 *	gltf_container.c  JSON and binary chunk, buffers, buffer views
 *	gltf_json.c       values of the JSON, messages, memory
 *	gltf_accessor.c   checks accessors; gltf_unpack.c reads their values
 *	gltf_material.c   materials; gltf_texture.c their textures and images
 *	gltf_mesh.c       meshes and primitives, which consist of
 *	                  gltf_attribute.c, gltf_triangles.c, gltf_target.c
 *	gltf_lod.c        finds levels of detail (MSFT_lod); gltf_lod_read.c
 *	                  reads them
 *	gltf_node.c       nodes and scenes; gltf_camera.c cameras
 *	gltf_skin.c       skins and the influences of vertices
 *	gltf_animation.c  clips
 *	gltf_examine.c    findings for limber doctor
 *
 * A function that returns int returns 0, or -errno after it has logged one
 * error. The loader checks every number of the file before it uses it as a size
 * or an index. What the model keeps comes from the model's arenas. Other memory
 * comes from a scratch arena, which is released at the end of the load, or from
 * arenas that are released earlier. All count against the model's budget.
 */
#ifndef APP_MODEL_GLTF_GLTF_INTERNAL_H
#define APP_MODEL_GLTF_GLTF_INTERNAL_H

#include "app/model/model_file.h"
#include "app/model/model_loader.h"
#include "platform/base/count.h"

#include <jansson.h>

enum {
	/* of an accessor unpacked to floats */
	GLTF_ACCESSOR_BYTES_MAX = 256 * 1024 * 1024,
	GLTF_JSON_BYTES_MAX = 64 * 1024 * 1024,
	GLTF_JSON_VALUES_MAX = 1024 * 1024,
};

/* The values of "componentType" in the file. */
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
	size_t size; /* the file's byteLength; data has at least as many */
	struct model_file file;
};

struct gltf_view {
	const uint8_t *data;
	size_t size;
	size_t stride; /* bytes; 0 means that elements are packed */
};

/*
 * The elements of an accessor in its buffer view. All of them have been checked
 * to lie in the view.
 */
struct gltf_elements {
	const uint8_t *data; /* NULL means that all values are 0 */
	size_t stride;       /* bytes */
	enum gltf_component component;
};

struct gltf_accessor {
	int index; /* number in the file, also of a copy of this struct */
	struct gltf_elements base;
	int count;
	const char *type; /* "VEC3" */
	int width;        /* components of an element */
	int rows;         /* components of a matrix's column, or width */
	bool normalized;

	int sparse_count;
	struct gltf_elements sparse_index; /* each index is below count */
	struct gltf_elements sparse_value;
};

/*
 * A value of the JSON and its location. `up` is the value that contains it, so
 * that a message can print the whole path. These structs live on the stack, so
 * one must not outlive the struct to which `up` points.
 */
struct gltf_at {
	struct gltf *gltf;
	const struct gltf_at *up;
	const char *key;    /* its key; NULL for an element of an array */
	int index;          /* number of an array's element */
	const json_t *json; /* NULL if the file does not have the value */
};

/*
 * KHR_texture_transform as the two rows of an affine matrix; the identity
 * without the extension.
 */
struct gltf_uv {
	int set; /* the number in TEXCOORD_set */
	bool transformed;
	float row[2][3];
};

/*
 * The part of a mesh of the file in MSFT_lod: as a level of another mesh, and
 * as a mesh with levels, which form a linked list.
 */
struct gltf_level {
	int of;        /* number in the file of the mesh whose level this is;
			  -1: not a level */
	int first;     /* the first level of this mesh, or -1 */
	int next;      /* as a level: the next level of the same mesh, or -1 */
	int count;     /* number of levels of this mesh */
	float error_m; /* as a level: metres; 0 if the file does not state it */
	float coverage;   /* if error_m is 0: this level is good enough if the
			     mesh covers less than this fraction of the
			     screen */
	bool shadow_only; /* see struct model_lod */
};

struct gltf {
	const struct model_source *source;
	const struct log *log;
	struct arena scratch;
	struct arena brief; /* see gltf_end_brief() */
	/*
	 * [channels]: an arena for the keys of each channel of the animation
	 * that is being read.
	 */
	int key_arena_count;
	struct arena *key_arena;
	json_t *nothing; /* see gltf_drop_element() */
	bool all_keys;   /* see gltf_read() */
	struct model *model;
	json_t *json;
	struct gltf_at root;

	const uint8_t *binary; /* the BIN chunk of a .glb, or NULL */
	size_t binary_size;
	/* Bytes that gltf_take() has taken from the budget. */
	size_t taken_bytes;

	int buffer_count;
	struct gltf_buffer *buffer;
	int view_count;
	struct gltf_view *view;
	int accessor_count;
	struct gltf_accessor *accessor;
	float **times; /* [accessor_count]: unpacked key times; NULL: not
			  unpacked */
	struct gltf_warning *warning; /* those not logged yet, or NULL */

	struct gltf_uv *uv;   /* [material_count] */
	int *texture_index;   /* file's number -> model's; gltf_texture.c */
	int *image_index;     /* file's number -> model's; gltf_texture.c */
	int default_material; /* index; -1 until a primitive needs it */
	float **mesh_weights; /* [model->mesh_count]; NULL if the file has
			       none */

	/*
	 * Numbers in the file and in the model differ, since a level of detail
	 * becomes neither a mesh nor a node of the model.
	 */
	int mesh_count;           /* of the file */
	struct gltf_level *level; /* [mesh_count] */
	int *mesh_index;          /* file's number -> model's; -1: a level */
	int *mesh_file_index;     /* model's number -> file's */
	int node_count;           /* of the file */
	double (*shift)[3];       /* NULL, or see model_origin_find() */
	bool *node_is_level;      /* [node_count] */
	int *node_index;          /* file's number -> model's; -1: a level */
	int *node_parent;         /* [node_count]: file's numbers, or -1 */
};

/* gltf.c */

/*
 * Reads the source into gltf->model, which is NULL after an error. The caller
 * calls gltf_release() in both cases, and owns the model. all_keys keeps all
 * keys of constant channels, which an examination needs; then the keys of all
 * clips are in scratch memory, which gltf_release() frees.
 */
int gltf_read(struct gltf *gltf, const struct model_source *source,
	bool all_keys, const struct log *log);
void gltf_release(struct gltf *gltf);

/* The same up to the accessors; the model stays empty. */
int gltf_read_document(struct gltf *gltf, const struct model_source *source,
	const struct log *log);

/* Whether limber supports the extension of this name. */
bool gltf_knows_extension(const char *name);

/* gltf_log.c */

/* Logs "FILE: PATH: MESSAGE" as an error and returns code. */
int gltf_fail(const struct gltf_at *at, int code, const char *format, ...)
	PRINTF_LIKE(3, 4);

/* Writes "FILE: PATH" into text, truncated to size bytes. */
void gltf_path(const struct gltf_at *at, char *text, size_t size);

/*
 * Logs the same as a warning, but later: warnings with the same format are of
 * one kind and become one sentence, which lists some of the places.
 */
void gltf_warn(const struct gltf_at *at, const char *format, ...)
	PRINTF_LIKE(2, 3);

/* Logs a warning at once and for this place alone. */
void gltf_warn_alone(const struct gltf_at *at, const char *format, ...)
	PRINTF_LIKE(2, 3);

/* Logs the warnings so far. An error and gltf_release() do so, too. */
void gltf_write_warnings(struct gltf *gltf);

/* gltf_json.c */

/* Returns a member of an object; its json is NULL if the object lacks it. */
struct gltf_at gltf_member(const struct gltf_at *at, const char *key);

/* Returns an element of an array; index is below the array's length. */
struct gltf_at gltf_element(const struct gltf_at *array, int index);

/* The same for an array of objects: -EINVAL if the element has another type. */
int gltf_item(const struct gltf_at *array, int index, struct gltf_at *out);

/* Calls read for the count objects of an array until one call fails. */
int gltf_for_each(const struct gltf_at *array, int count,
	int (*read)(const struct gltf_at *item));

/*
 * The functions below read a member of an object. If the object lacks the
 * member, gltf_object() and gltf_array() give a value whose json is NULL (count
 * 0), and the functions named "maybe" leave *out as it is. A member of the
 * wrong type is -EINVAL.
 */
int gltf_object(const struct gltf_at *at, const char *key, struct gltf_at *out);
int gltf_array(const struct gltf_at *at, const char *key, struct gltf_at *out,
	int *count);
int gltf_maybe_string(
	const struct gltf_at *at, const char *key, const char **out);

/* Finds a string in names[count]; -EINVAL for any other string. */
int gltf_maybe_choice(const struct gltf_at *at, const char *key,
	const char *const *names, int count, int *out);
int gltf_maybe_bool(const struct gltf_at *at, const char *key, bool *out);
int gltf_maybe_number(const struct gltf_at *at, const char *key, float *out);
int gltf_maybe_floats(
	const struct gltf_at *at, const char *key, float *out, int count);
int gltf_maybe_integer(const struct gltf_at *at, const char *key, int64_t min,
	int64_t max, int64_t *out);

/*
 * Reads an index, which must be below count. what names the indexed things in
 * messages: "mesh 3 does not exist".
 */
int gltf_maybe_index(const struct gltf_at *at, const char *key, int count,
	const char *what, int *out);

/* The same for an index into the root object's array of this name. */
int gltf_maybe_root_index(const struct gltf_at *at, const char *key,
	const char *array, const char *what, int *out);

/* The same for a value that is itself the index. */
int gltf_index(const struct gltf_at *at, int count, const char *what, int *out);

/* Fails if the object lacks this member. */
int gltf_require(const struct gltf_at *at, const char *key);

/* Copies a string into the model's arena. */
int gltf_copy_string(
	const struct gltf_at *at, const char *text, const char **out);

/* Copies the "name" of an object into the model's arena; "" if it has none. */
int gltf_name(const struct gltf_at *at, const char **out);

/*
 * Returns count * size zeroed bytes from one of the arenas. If the budget or
 * the memory is exhausted, it logs an error about the value that needs them and
 * returns NULL; then the caller returns -ENOMEM.
 */
void *gltf_alloc(const struct gltf_at *at, struct arena *arena, size_t count,
	size_t size);

/*
 * Takes count * size bytes, which are allocated elsewhere, from the model's
 * budget until gltf_release().
 */
int gltf_take(const struct gltf_at *at, size_t count, size_t size);

/* Gives bytes of gltf_take() back before gltf_release(). */
void gltf_give_back(struct gltf *gltf, size_t bytes);

/* Logs that there is not enough memory for the value; returns -ENOMEM. */
int gltf_no_memory(const struct gltf_at *at);

/* Allocate arrays in the model's arena and in the scratch arena. */
#define GLTF_KEEP(at, type, count)                                            \
	((type *)gltf_alloc((at), &(at)->gltf->model->arena, (size_t)(count), \
		sizeof(type)))
#define GLTF_SCRATCH(at, type, count) \
	((type *)gltf_alloc(          \
		(at), &(at)->gltf->scratch, (size_t)(count), sizeof(type)))

/* Allocates an array that lasts until gltf_end_brief(). */
#define GLTF_BRIEF(at, type, count) \
	((type *)gltf_alloc(        \
		(at), &(at)->gltf->brief, (size_t)(count), sizeof(type)))

/*
 * Frees the arrays of GLTF_BRIEF(). It is called after each attribute of a
 * mesh, since the arrays for all attributes together would be as large as the
 * model.
 */
void gltf_end_brief(struct gltf *gltf);

/*
 * Frees the JSON of an element of a root array, such as "meshes", after it has
 * been read. An empty object takes its place. In an examination (all_keys) it
 * does nothing, since that reads the JSON after the model.
 */
void gltf_drop_element(struct gltf *gltf, const char *array, int index);

/* gltf_container.c */

/* Finds the JSON and the BIN chunk in the source, and parses the JSON. */
int gltf_open(struct gltf *gltf);

/* Fills in gltf->buffer and gltf->view. */
int gltf_read_buffers(struct gltf *gltf);

/*
 * Finds the bytes that a "uri" names: those of a data URI are decoded into the
 * scratch arena, those of a file are read into *file, which the caller
 * releases.
 */
int gltf_read_uri(const struct gltf_at *at, const char *uri,
	struct model_file *file, const uint8_t **data, size_t *size);

/* gltf_accessor.c */

/* Fills in gltf->accessor; all elements lie in their buffer views. */
int gltf_read_accessors(struct gltf *gltf);

/*
 * The bytes of an element. Columns of a matrix are aligned to 4 bytes (glTF
 * 2.0, 3.6.2.4), vectors are not.
 */
size_t gltf_element_bytes(const struct gltf_accessor *accessor);

/* Whether the components are unsigned integers that are not normalised. */
bool gltf_is_unsigned(const struct gltf_accessor *accessor);

/*
 * Sets *out to the accessor that a member of an object names, or to NULL
 * without the member. type lists the allowed types: "VEC3", or "VEC3 VEC4".
 */
int gltf_maybe_accessor(const struct gltf_at *at, const char *key,
	const char *type, const struct gltf_accessor **out);

/* gltf_unpack.c */

/* Returns the size of a component in bytes; 0 for an unknown componentType. */
size_t gltf_component_bytes(enum gltf_component component);

/* Returns element number index of an array of unsigned integers. */
uint32_t gltf_get_uint(const struct gltf_elements *elements, int index);

/*
 * Unpacks count * width floats; normalised integers become -1..1 or 0..1. Fails
 * if a float is not finite or larger than MODEL_NUMBER_MAX.
 */
int gltf_unpack_floats(const struct gltf_at *at,
	const struct gltf_accessor *accessor, float *out);

/* The same as integers, for an accessor of unsigned components. */
void gltf_unpack_uints(const struct gltf_accessor *accessor, uint32_t *out);

/* gltf_material.c */

/* Fills in the model's materials, textures and images, and gltf->uv. */
int gltf_read_materials(struct gltf *gltf);

/* Returns the material for primitives that name none; adds it if needed. */
int gltf_default_material(struct gltf *gltf);

/* gltf_texture.c */

/* Allocates the textures and images of the model; reads none of them. */
int gltf_prepare_textures(struct gltf *gltf);

/*
 * Sets *out to the model's index of a texture, which is read when a material
 * first uses it; to -1, after a warning, if limber cannot read its image.
 */
int gltf_use_texture(struct gltf *gltf, int file_index, int *out);

/* gltf_attribute.c */

/*
 * Fails unless the accessor has vertex_count elements and another componentType
 * than GLTF_U32.
 */
int gltf_check_attribute(const struct gltf_at *at,
	const struct gltf_accessor *accessor, int vertex_count);

/*
 * Unpacks an attribute of a primitive or of a morph target into the arena; it
 * must have one element per vertex. *out becomes NULL if the file has none.
 */
int gltf_read_attribute(const struct gltf_at *at, const char *key,
	const char *type, int vertex_count, struct arena *arena, float **out);

/* gltf_triangles.c */

/* Whether a primitive consists of triangles; warns about lines and points. */
int gltf_has_triangles(const struct gltf_at *primitive, bool *out);

/*
 * Makes the triangle list of a primitive, in the model's arena, from triangles,
 * strips or fans, with or without "indices". Each index is below vertex_count.
 */
int gltf_read_triangles(const struct gltf_at *primitive, int vertex_count,
	uint32_t **index, int *index_count);

/* gltf_target.c */

/* Fills in target_count, target_name and key_frames of a mesh. */
int gltf_read_target_names(const struct gltf_at *mesh,
	const struct gltf_at *primitives, struct model_mesh *out);

/* Fills in the morph targets of a primitive, [mesh->target_count]. */
int gltf_read_targets(const struct gltf_at *primitive,
	const struct model_mesh *mesh, struct model_primitive *out);

/*
 * Moves all targets in integers from scratch memory to the model, as key frames
 * if the clips, which have been read, use them so.
 */
int gltf_keep_targets(struct gltf *gltf);

/* Reads "weights" of a mesh or node into scratch memory; NULL without. */
int gltf_read_weights(const struct gltf_at *at, int target_count, float **out);

/* gltf_lod.c */

/*
 * Finds the nodes and meshes that serve only as levels of detail (MSFT_lod) of
 * others. Such a level has the attributes of the full mesh and the transform of
 * its node, it states how coarse it is, and nothing else refers to it. If a
 * level does not meet these conditions, its node and mesh are treated as if the
 * extension did not exist.
 */
int gltf_find_levels(struct gltf *gltf);

/* gltf_lod_read.c */

/* Reads the levels of a mesh, given by its number in the file. */
int gltf_read_levels(struct gltf *gltf, int mesh);

/* gltf_mesh.c, gltf_camera.c, gltf_animation.c */
int gltf_read_meshes(struct gltf *gltf);
int gltf_read_cameras(struct gltf *gltf);
int gltf_read_animations(struct gltf *gltf);

/* gltf_node.c */

/* Reads the nodes, their order, the scene and the morph weights. */
int gltf_read_nodes(struct gltf *gltf);

/* Finds the model's node for this value, a number of a node in the file. */
int gltf_node(const struct gltf_at *at, int *out);

/* Gives a quaternion unit length; fails if its length is 0. */
int gltf_normalize_rotation(const struct gltf_at *at, float rotation[4]);

/* gltf_skin.c */

/* Fills in influences, joint and weight; 0 and NULL if there are none. */
int gltf_read_influences(
	const struct gltf_at *attributes, struct model_primitive *out);

/* Reads the skins, and checks the joints of each mesh against its skins. */
int gltf_read_skins(struct gltf *gltf);

#endif
