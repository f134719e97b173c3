/*
 * The contents of a .x file, checked but in the file's conventions:
 * left-handed, row-major matrices for row vectors, times in ticks, references
 * by name. The reader's scratch arena owns all of it.
 */
#ifndef APP_MODEL_XFILE_XFILE_SCENE_H
#define APP_MODEL_XFILE_XFILE_SCENE_H

#include "app/model/xfile/xfile_reader.h"

struct xfile_frame {
	struct xfile_frame *next; /* in the file's order: parents first */
	const char *name;
	int parent; /* index of the parent in this order, or -1 */
	float matrix[16];
	struct xfile_reference *references, *last_reference;
};

/* A frame's reference, by name, to a mesh that it draws. */
struct xfile_reference {
	struct xfile_reference *next;
	const char *name;
	size_t location;
};

struct xfile_material {
	struct xfile_material *next;
	const char *name;
	int index; /* number in the file's order, from 0 */
	float color[4];
	float power;
	float specular[3];
	float emissive[3];
	const char *texture; /* path as the file spells it, or NULL */
	size_t texture_location;
};

/* One of a mesh's materials, defined in the mesh or referred to by name. */
struct xfile_slot {
	struct xfile_slot *next;
	const struct xfile_material *material; /* NULL: named only */
	const char *name;
	size_t location;
};

/* The corners of all faces in one array. */
struct xfile_faces {
	uint32_t count;
	uint32_t *first;  /* [count + 1]: the first corner of each face */
	uint32_t *corner; /* [first[count]] */
};

struct xfile_bone {
	struct xfile_bone *next;
	const char *name;
	size_t location;
	uint32_t count;
	uint32_t *vertex; /* each below the mesh's vertex_count */
	float *weight;    /* not negative */
	float offset[16];
};

struct xfile_mesh {
	struct xfile_mesh *next;
	const char *name;
	size_t location;
	int frame; /* index of the frame that contains it, or -1 */
	uint32_t vertex_count;
	float (*position)[3];
	struct xfile_faces faces;
	uint32_t normal_count;
	float (*normal)[3];              /* or NULL */
	struct xfile_faces normal_faces; /* if normal is set: indices of
					    normals, with as many corners as
					    faces */
	float (*declared_normal)[3];     /* [vertex_count] or NULL */
	float (*texcoord)[2];            /* [vertex_count] or NULL */
	float (*color)[4];               /* [vertex_count] or NULL */
	uint32_t *face_slot;             /* [faces.count] or NULL: index of each
					    face's slot */
	struct xfile_slot *slots, *last_slot;
	struct xfile_bone *bones, *last_bone;
	uint32_t bone_count;
};

enum xfile_key_type {
	XFILE_KEY_ROTATION, /* w x y z of a quaternion */
	XFILE_KEY_SCALE,
	XFILE_KEY_POSITION,
	XFILE_KEY_MATRIX,
};

struct xfile_keys {
	struct xfile_keys *next;
	enum xfile_key_type type;
	int width;      /* 4, 3, 3, 16 */
	uint32_t count; /* at least 1 */
	double *tick;
	float *value; /* [count][width] */
};

struct xfile_animation {
	struct xfile_animation *next;
	const char *frame; /* name of the frame that it moves, or NULL */
	size_t location;
	struct xfile_keys *keys, *last_keys;
};

struct xfile_set {
	struct xfile_set *next;
	const char *name;
	size_t location;
	struct xfile_animation *animations, *last_animation;
};

struct xfile_scene {
	double ticks_per_second;
	bool has_ticks; /* whether the file gives them */
	int frame_count, mesh_count, material_count, set_count;
	struct xfile_frame *frames, *last_frame;
	struct xfile_mesh *meshes, *last_mesh;
	struct xfile_material *materials, *last_material;
	struct xfile_set *sets, *last_set;
};

/* The objects that contain the one that is being read; NULL if none. */
struct xfile_scope {
	struct xfile_scene *scene;
	struct xfile_frame *frame;
	int frame_index; /* -1 outside of frames */
	struct xfile_mesh *mesh;
	struct xfile_material *material;
	struct xfile_set *set;
	struct xfile_animation *animation;
};

/* Ticks per second if the file does not state them. */
#define XFILE_TICKS_PER_SECOND 4800.0

/*
 * Reads the whole body into a scene, which the caller has set to zeros. Returns
 * 0, or -errno after an error on the log.
 */
int xfile_parse(struct xfile_reader *reader, struct xfile_scene *scene);

/* Parsers of data objects; see xfile_kind.parse. */
int xfile_parse_mesh(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name);
int xfile_parse_material(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name);
int xfile_parse_decl_data(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name);
int xfile_parse_skin_weights(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name);
int xfile_parse_animation_set(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name);

/* Appends an element to a linked list. */
#define XFILE_APPEND(first, last, element)        \
	do {                                      \
		if (last) {                       \
			(last)->next = (element); \
		} else {                          \
			(first) = (element);      \
		}                                 \
		(last) = (element);               \
	} while (0)

#endif
