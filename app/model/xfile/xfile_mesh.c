#include "app/model/xfile/xfile_scene.h"

#include <limits.h>
#include <string.h>

struct index_list {
	uint32_t *item;
	size_t count;
	size_t capacity;
};

/*
 * Makes room for `more` items. Arrays that are replaced stay in the arena;
 * together they are no larger than the last one.
 */
static int grow(
	struct index_list *list, struct xfile_reader *reader, size_t more)
{
	size_t capacity = list->capacity ? list->capacity : 64;
	uint32_t *item;

	if (list->capacity - list->count >= more) {
		return 0;
	}
	while (capacity - list->count < more) {
		capacity *= 2;
	}
	item = ARENA_ARRAY(reader->scratch, uint32_t, capacity);
	if (!item) {
		return xfile_no_memory(&reader->context);
	}
	if (list->count) {
		memcpy(item, list->item, list->count * sizeof(*item));
	}
	list->item = item;
	list->capacity = capacity;
	return 0;
}

static int read_corner(struct xfile_reader *reader, const char *kind,
	uint32_t limit, uint32_t *out)
{
	size_t location = reader->token.location;
	int error = xfile_read_integer(reader, "a face's index", out);

	if (!error && *out >= limit) {
		return xfile_fail_at(&reader->context, location,
			"a face refers to %s %u, but there are only %u", kind,
			(unsigned)*out, (unsigned)limit);
	}
	return error;
}

static int read_face(struct xfile_reader *reader, const char *kind,
	uint32_t limit, struct index_list *corners)
{
	uint32_t count;
	int error = xfile_read_count(
		reader, "a face's number of corners", 1, &count);

	if (!error) {
		error = grow(corners, reader, count);
	}
	for (uint32_t i = 0; !error && i < count; i++) {
		error = read_corner(
			reader, kind, limit, &corners->item[corners->count]);
		corners->count++;
	}
	return error;
}

/*
 * Reads faces. Their indices must be below limit; kind names in messages what
 * they number.
 */
static int read_faces(struct xfile_reader *reader, const char *kind,
	uint32_t limit, struct xfile_faces *out)
{
	struct index_list corners = {0};
	size_t location = reader->token.location;
	int error = xfile_read_count(reader, "the face count", 1, &out->count);

	if (error) {
		return error;
	}
	out->first =
		ARENA_ARRAY(reader->scratch, uint32_t, (size_t)out->count + 1);
	if (!out->first) {
		return xfile_no_memory(&reader->context);
	}
	for (uint32_t i = 0; !error && i < out->count; i++) {
		error = read_face(reader, kind, limit, &corners);
		if (!error && corners.count > INT_MAX / 3) {
			error = xfile_fail_at(&reader->context, location,
				"the faces have more corners than limber supports");
		}
		out->first[i + 1] = (uint32_t)corners.count;
	}
	out->corner = corners.item;
	return error;
}

static int check_normal_faces(struct xfile_reader *reader, size_t location,
	const struct xfile_mesh *mesh)
{
	const struct xfile_faces *faces = &mesh->faces;
	const struct xfile_faces *normals = &mesh->normal_faces;

	if (normals->count != faces->count) {
		return xfile_fail_at(&reader->context, location,
			"MeshNormals has %u faces, but the mesh has %u",
			(unsigned)normals->count, (unsigned)faces->count);
	}
	for (uint32_t i = 0; i < faces->count; i++) {
		if (normals->first[i + 1] != faces->first[i + 1]) {
			return xfile_fail_at(&reader->context, location,
				"face %u has %u corners in MeshNormals, but %u in the mesh",
				(unsigned)i,
				(unsigned)(normals->first[i + 1] -
					normals->first[i]),
				(unsigned)(faces->first[i + 1] -
					faces->first[i]));
		}
	}
	return 0;
}

static int parse_normals(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_mesh *mesh = scope->mesh;
	size_t location = reader->token.location;
	float *normal;
	int error = xfile_read_vectors(reader, "the normals' count or element",
		3, &mesh->normal_count, &normal);

	(void)name;
	if (!error) {
		error = read_faces(reader, "normal", mesh->normal_count,
			&mesh->normal_faces);
	}
	if (!error) {
		error = check_normal_faces(reader, location, mesh);
	}
	if (error) {
		return error;
	}
	mesh->normal = (float(*)[3])normal;
	return xfile_skip_rest(reader);
}

static int parse_texcoords(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_mesh *mesh = scope->mesh;
	size_t location = reader->token.location;
	uint32_t count;
	float *texcoord;
	int error = xfile_read_vectors(reader,
		"the texture coordinates' count or element", 2, &count,
		&texcoord);

	(void)name;
	if (error) {
		return error;
	}
	if (count != mesh->vertex_count) {
		return xfile_fail_at(&reader->context, location,
			"MeshTextureCoords has %u entries, but the mesh has %u vertices",
			(unsigned)count, (unsigned)mesh->vertex_count);
	}
	if (!mesh->texcoord) {
		mesh->texcoord = (float(*)[2])texcoord;
	}
	return xfile_skip_rest(reader);
}

static int make_white(struct xfile_reader *reader, struct xfile_mesh *mesh)
{
	float *color;

	if (mesh->color) {
		return 0;
	}
	color = ARENA_ARRAY(
		reader->scratch, float, 4 * (size_t)mesh->vertex_count);
	if (!color) {
		return xfile_no_memory(&reader->context);
	}
	for (size_t i = 0; i < 4 * (size_t)mesh->vertex_count; i++) {
		color[i] = 1;
	}
	mesh->color = (float(*)[4])color;
	return 0;
}

static int parse_colors(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_mesh *mesh = scope->mesh;
	uint32_t count;
	int error = xfile_read_count(
		reader, "the count of vertex colours", 5, &count);

	(void)name;
	if (!error) {
		error = make_white(reader, mesh);
	}
	for (uint32_t i = 0; !error && i < count; i++) {
		size_t location = reader->token.location;
		uint32_t vertex;

		error = xfile_read_integer(
			reader, "the index of a coloured vertex", &vertex);
		if (!error && vertex >= mesh->vertex_count) {
			error = xfile_fail_at(&reader->context, location,
				"MeshVertexColors refers to vertex %u, but the mesh has %u vertices",
				(unsigned)vertex, (unsigned)mesh->vertex_count);
		}
		if (!error) {
			error = xfile_read_floats(reader, "a vertex colour", 4,
				mesh->color[vertex]);
		}
	}
	return error ? error : xfile_skip_rest(reader);
}

static int add_slot(struct xfile_reader *reader, struct xfile_mesh *mesh,
	const struct xfile_slot *from)
{
	struct xfile_slot *slot = ARENA_NEW(reader->scratch, struct xfile_slot);

	if (!slot) {
		return xfile_no_memory(&reader->context);
	}
	*slot = *from;
	XFILE_APPEND(mesh->slots, mesh->last_slot, slot);
	return 0;
}

static int parse_slot(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	size_t location = reader->token.location;
	int error = xfile_parse_material(reader, scope, name);

	return error ? error
		     : add_slot(reader, scope->mesh,
			       &(struct xfile_slot){
				       .material = scope->scene->last_material,
				       .name = name,
				       .location = location});
}

static int refer_to_material(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name, size_t location)
{
	return add_slot(reader, scope->mesh,
		&(struct xfile_slot){.name = name, .location = location});
}

static const struct xfile_grammar slot_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"Material", parse_slot},
			{0},
		},
	.reference = refer_to_material,
};

/* Reads faces' materials. Faces beyond the list get the last one listed. */
static int read_face_slots(struct xfile_reader *reader, struct xfile_mesh *mesh,
	uint32_t slots, uint32_t listed)
{
	uint32_t slot = 0;
	int error = 0;

	if (!mesh->face_slot) {
		mesh->face_slot = ARENA_ARRAY(
			reader->scratch, uint32_t, mesh->faces.count);
	}
	if (!mesh->face_slot) {
		return xfile_no_memory(&reader->context);
	}
	for (uint32_t i = 0; !error && i < mesh->faces.count; i++) {
		size_t location = reader->token.location;

		if (i < listed) {
			error = xfile_read_integer(
				reader, "a face's material", &slot);
		}
		if (!error && i < listed && slot >= slots) {
			error = xfile_fail_at(&reader->context, location,
				"face %u has material %u, but the mesh has %u materials",
				(unsigned)i, (unsigned)slot, (unsigned)slots);
		}
		mesh->face_slot[i] = slot;
	}
	return error;
}

static int parse_material_list(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_mesh *mesh = scope->mesh;
	size_t location;
	uint32_t slots;
	uint32_t listed;
	int error = xfile_read_integer(reader, "the count of materials", &slots);

	(void)name;
	location = reader->token.location;
	if (!error) {
		error = xfile_read_count(
			reader, "the count of face materials", 1, &listed);
	}
	if (!error && listed > mesh->faces.count) {
		error = xfile_fail_at(&reader->context, location,
			"MeshMaterialList has %u faces, but the mesh has %u",
			(unsigned)listed, (unsigned)mesh->faces.count);
	}
	if (!error) {
		error = read_face_slots(reader, mesh, slots, listed);
	}
	mesh->slots = NULL;
	mesh->last_slot = NULL;
	return error ? error : xfile_read_children(reader, &slot_grammar, scope);
}

static const struct xfile_grammar mesh_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"DeclData", xfile_parse_decl_data},
			{"MeshMaterialList", parse_material_list},
			{"MeshNormals", parse_normals},
			{"MeshTextureCoords", parse_texcoords},
			{"MeshVertexColors", parse_colors},
			{"SkinWeights", xfile_parse_skin_weights},
			{0},
		},
};

int xfile_parse_mesh(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_scope inner = *scope;
	struct xfile_scene *scene = scope->scene;
	struct xfile_mesh *mesh = ARENA_NEW(reader->scratch, struct xfile_mesh);
	float *position;
	int error;

	if (!mesh) {
		return xfile_no_memory(&reader->context);
	}
	inner.mesh = mesh;
	mesh->name = name;
	mesh->location = reader->token.location;
	mesh->frame = scope->frame_index;
	scene->mesh_count++;
	XFILE_APPEND(scene->meshes, scene->last_mesh, mesh);
	error = xfile_read_vectors(reader, "the vertices' count or element", 3,
		&mesh->vertex_count, &position);
	if (!error) {
		mesh->position = (float(*)[3])position;
		error = read_faces(
			reader, "vertex", mesh->vertex_count, &mesh->faces);
	}
	return error ? error
		     : xfile_read_children(reader, &mesh_grammar, &inner);
}
