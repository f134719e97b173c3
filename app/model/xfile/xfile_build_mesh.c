#include "app/model/xfile/xfile_build.h"
#include "app/model/xfile/xfile_convert.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * One corner of a face. Equal material, position and normal make one vertex;
 * equal materials one primitive.
 */
struct corner {
	uint32_t material;
	uint32_t position;
	uint32_t normal;
	uint32_t order; /* among all corners of the mesh */
};

/* A mesh on its way. */
struct shaping {
	struct xfile_build *build;
	const struct xfile_mesh *from;
	struct xfile_influences influences;
	uint32_t *slot_material; /* of each of the mesh's slots */
	uint32_t slot_count;
	struct corner *corner; /* sorted */
	size_t corner_count;
	uint32_t *vertex_of; /* corner -> vertex within its primitive */
	int *primitive_of;   /* corner -> primitive */
	struct model_mesh *mesh;
};

static uint32_t default_material(struct xfile_build *build)
{
	int index = build->scene->material_count;

	build->model->material_count = index + 1;
	return (uint32_t)index;
}

static uint32_t resolve_slot(
	struct xfile_build *build, const struct xfile_slot *slot)
{
	int index;

	if (slot->material) {
		return (uint32_t)slot->material->index;
	}
	index = xfile_names_find(&build->material_names, slot->name);
	if (index >= 0) {
		return (uint32_t)index;
	}
	xfile_warn_at(build->where, slot->place,
		"there is no material \"%.200s\"", slot->name);
	return default_material(build);
}

static int resolve_slots(struct shaping *shaping)
{
	const struct xfile_slot *slot = shaping->from->slots;

	for (; slot; slot = slot->next) {
		shaping->slot_count++;
	}
	shaping->slot_material = ARENA_ARRAY(
		shaping->build->scratch, uint32_t, shaping->slot_count);
	if (!shaping->slot_material) {
		return xfile_no_memory(shaping->build->where);
	}
	slot = shaping->from->slots;
	for (uint32_t i = 0; slot; slot = slot->next, i++) {
		shaping->slot_material[i] = resolve_slot(shaping->build, slot);
	}
	return 0;
}

static uint32_t face_material(const struct shaping *shaping, uint32_t face)
{
	const struct xfile_mesh *from = shaping->from;
	uint32_t slot = from->face_slot ? from->face_slot[face] : 0;

	return slot < shaping->slot_count ? shaping->slot_material[slot]
					  : default_material(shaping->build);
}

static uint32_t face_corners(const struct xfile_faces *faces, uint32_t face)
{
	return faces->first[face + 1] - faces->first[face];
}

static int compare_numbers(uint32_t a, uint32_t b)
{
	return (a > b) - (a < b);
}

static int compare_corners(const void *a, const void *b)
{
	const struct corner *left = a;
	const struct corner *right = b;
	int order = compare_numbers(left->material, right->material);

	if (!order) {
		order = compare_numbers(left->position, right->position);
	}
	if (!order) {
		order = compare_numbers(left->normal, right->normal);
	}
	return order ? order : compare_numbers(left->order, right->order);
}

/* Lines and points, faces of fewer than three corners, are left out. */
static int sort_corners(struct shaping *shaping)
{
	const struct xfile_mesh *from = shaping->from;
	const struct xfile_faces *faces = &from->faces;
	size_t total = faces->first[faces->count];

	shaping->corner =
		ARENA_ARRAY(shaping->build->scratch, struct corner, total);
	shaping->vertex_of =
		ARENA_ARRAY(shaping->build->scratch, uint32_t, total);
	shaping->primitive_of = ARENA_ARRAY(shaping->build->scratch, int, total);
	if (!shaping->corner || !shaping->vertex_of || !shaping->primitive_of) {
		return xfile_no_memory(shaping->build->where);
	}
	for (uint32_t face = 0; face < faces->count; face++) {
		uint32_t material;

		if (face_corners(faces, face) < 3) {
			continue;
		}
		material = face_material(shaping, face);
		for (uint32_t i = faces->first[face];
			i < faces->first[face + 1]; i++) {
			shaping->corner[shaping->corner_count++] =
				(struct corner){
					.material = material,
					.position = faces->corner[i],
					.normal = from->normal
						? from->normal_faces.corner[i]
						: 0,
					.order = i,
				};
		}
	}
	qsort(shaping->corner, shaping->corner_count, sizeof(*shaping->corner),
		compare_corners);
	return 0;
}

static bool is_same_vertex(const struct corner *a, const struct corner *b)
{
	return a->material == b->material && a->position == b->position &&
		a->normal == b->normal;
}

static int count_primitives(struct shaping *shaping)
{
	struct arena *arena = &shaping->build->model->arena;
	const struct corner *corner = shaping->corner;
	int count = 0;

	for (size_t i = 0; i < shaping->corner_count; i++) {
		count += i == 0 || corner[i].material != corner[i - 1].material;
	}
	shaping->mesh->primitive =
		ARENA_ARRAY(arena, struct model_primitive, count);
	shaping->mesh->primitive_count = count;
	return shaping->mesh->primitive ? 0
					: xfile_no_memory(shaping->build->where);
}

/* Gives every corner its primitive and its vertex there. */
static void number_vertices(struct shaping *shaping)
{
	const struct corner *corner = shaping->corner;
	struct model_primitive *primitive = NULL;

	for (size_t i = 0; i < shaping->corner_count; i++) {
		const struct corner *at = &corner[i];

		if (i == 0 || at->material != at[-1].material) {
			primitive = primitive ? primitive + 1
					      : shaping->mesh->primitive;
			primitive->file_index =
				(int)(primitive - shaping->mesh->primitive);
			primitive->material = (int)at->material;
		}
		if (i == 0 || !is_same_vertex(at, at - 1)) {
			primitive->vertex_count++;
		}
		shaping->vertex_of[at->order] =
			(uint32_t)primitive->vertex_count - 1;
		shaping->primitive_of[at->order] = primitive->file_index;
	}
}

static int make_room(struct shaping *shaping, struct model_primitive *primitive)
{
	const struct xfile_mesh *from = shaping->from;
	struct arena *arena = &shaping->build->model->arena;
	size_t count = (size_t)primitive->vertex_count;
	size_t influences = count * (size_t)shaping->influences.width;

	primitive->influences = shaping->influences.width;
	primitive->position = arena_alloc(arena, count, 3 * sizeof(float));
	primitive->normal = from->normal || from->declared_normal
		? arena_alloc(arena, count, 3 * sizeof(float))
		: NULL;
	primitive->texcoord = from->texcoord
		? arena_alloc(arena, count, 2 * sizeof(float))
		: NULL;
	primitive->color = from->color ? arena_alloc(arena, count, 4) : NULL;
	if (influences) {
		primitive->joint = ARENA_ARRAY(arena, uint16_t, influences);
		primitive->weight = ARENA_ARRAY(arena, float, influences);
	}
	primitive->index =
		ARENA_ARRAY(arena, uint32_t, (size_t)primitive->index_count);
	if (!primitive->position || !primitive->index ||
		(!primitive->normal && (from->normal || from->declared_normal)) ||
		(!primitive->texcoord && from->texcoord) ||
		(!primitive->color && from->color) ||
		(influences && (!primitive->joint || !primitive->weight))) {
		return xfile_no_memory(shaping->build->where);
	}
	primitive->index_count = 0;
	return 0;
}

static void convert_normal(const float in[3], float out[3])
{
	double length = sqrt((double)in[0] * in[0] + (double)in[1] * in[1] +
		(double)in[2] * in[2]);

	if (!(length > 0)) {
		out[2] = 1;
		return;
	}
	out[0] = (float)(in[0] / length);
	out[1] = (float)(in[1] / length);
	out[2] = (float)(-in[2] / length);
}

static uint8_t to_byte(float value)
{
	return (uint8_t)(fminf(fmaxf(value, 0), 1) * 255 + 0.5f);
}

static void fill_vertex(const struct shaping *shaping,
	const struct corner *corner, struct model_primitive *to, size_t vertex)
{
	const struct xfile_mesh *from = shaping->from;
	size_t position = corner->position;
	size_t width = (size_t)to->influences;

	xfile_convert_vector(from->position[position], to->position[vertex]);
	if (to->normal) {
		convert_normal(from->normal ? from->normal[corner->normal]
					    : from->declared_normal[position],
			to->normal[vertex]);
	}
	if (to->texcoord) {
		memcpy(to->texcoord[vertex], from->texcoord[position],
			sizeof(to->texcoord[vertex]));
	}
	if (to->color) {
		for (int i = 0; i < 4; i++) {
			to->color[vertex][i] = to_byte(from->color[position][i]);
		}
	}
	if (width) {
		memcpy(to->joint + vertex * width,
			shaping->influences.joint[position],
			width * sizeof(*to->joint));
		memcpy(to->weight + vertex * width,
			shaping->influences.weight[position],
			width * sizeof(*to->weight));
	}
}

static void fill_vertices(struct shaping *shaping)
{
	struct model_primitive *primitive = shaping->mesh->primitive;

	for (size_t i = 0; i < shaping->corner_count; i++) {
		const struct corner *corner = &shaping->corner[i];
		uint32_t order = corner->order;

		fill_vertex(shaping, corner,
			&primitive[shaping->primitive_of[order]],
			shaping->vertex_of[order]);
	}
}

/* Corners go backwards, since the mirroring turned the faces over. */
static void fill_triangles(struct shaping *shaping)
{
	const struct xfile_faces *faces = &shaping->from->faces;

	for (uint32_t face = 0; face < faces->count; face++) {
		uint32_t corners = face_corners(faces, face);
		uint32_t first = faces->first[face];
		struct model_primitive *primitive;

		if (corners < 3) {
			continue;
		}
		primitive =
			&shaping->mesh->primitive[shaping->primitive_of[first]];
		for (uint32_t i = 1; i + 1 < corners; i++) {
			uint32_t *index =
				primitive->index + primitive->index_count;

			index[0] = shaping->vertex_of[first];
			index[1] = shaping->vertex_of[first + i + 1];
			index[2] = shaping->vertex_of[first + i];
			primitive->index_count += 3;
		}
	}
}

/* read_faces() keeps 3 * corners within an int. */
static void count_triangles(struct shaping *shaping)
{
	const struct xfile_faces *faces = &shaping->from->faces;

	for (uint32_t face = 0; face < faces->count; face++) {
		uint32_t corners = face_corners(faces, face);

		if (corners >= 3) {
			int primitive =
				shaping->primitive_of[faces->first[face]];

			shaping->mesh->primitive[primitive].index_count +=
				3 * (int)(corners - 2);
		}
	}
}

static int fill_mesh(struct shaping *shaping)
{
	struct model_mesh *mesh = shaping->mesh;
	int error = count_primitives(shaping);

	if (error) {
		return error;
	}
	number_vertices(shaping);
	count_triangles(shaping);
	for (int i = 0; i < mesh->primitive_count; i++) {
		error = make_room(shaping, &mesh->primitive[i]);
		if (error) {
			return error;
		}
	}
	fill_vertices(shaping);
	fill_triangles(shaping);
	for (int i = 0; i < mesh->primitive_count; i++) {
		model_normalize_influences(&mesh->primitive[i]);
	}
	return 0;
}

static int shape_mesh(struct xfile_build *build, int index)
{
	struct model *model = build->model;
	struct shaping shaping = {
		.build = build,
		.from = build->mesh[index],
		.mesh = &model->mesh[model->mesh_count],
	};
	int error = resolve_slots(&shaping);

	build->mesh_place[index] = model->mesh_count++;
	shaping.mesh->name = arena_strdup(&model->arena, shaping.from->name);
	if (!shaping.mesh->name) {
		return xfile_no_memory(build->where);
	}
	if (!error) {
		error = xfile_build_skin(
			build, shaping.from, index, &shaping.influences);
	}
	if (!error) {
		error = sort_corners(&shaping);
	}
	return error ? error : fill_mesh(&shaping);
}

static int make_tables(struct xfile_build *build)
{
	struct model *model = build->model;
	size_t count = (size_t)build->scene->mesh_count;

	build->mesh_place = ARENA_ARRAY(build->scratch, int, count);
	build->mesh_skin = ARENA_ARRAY(build->scratch, int, count);
	build->mesh_node = ARENA_ARRAY(build->scratch, int, count);
	model->mesh = ARENA_ARRAY(&model->arena, struct model_mesh, count);
	model->skin = ARENA_ARRAY(&model->arena, struct model_skin, count);
	if (!build->mesh_place || !build->mesh_skin || !build->mesh_node ||
		!model->mesh || !model->skin) {
		return xfile_no_memory(build->where);
	}
	for (size_t i = 0; i < count; i++) {
		build->mesh_place[i] = -1;
		build->mesh_skin[i] = -1;
		build->mesh_node[i] = -1;
	}
	return 0;
}

int xfile_build_meshes(struct xfile_build *build)
{
	int error = make_tables(build);

	for (int i = 0; !error && i < build->instance_count; i++) {
		const struct xfile_instance *instance = &build->instance[i];

		if (build->mesh_node[instance->mesh] < 0) {
			build->mesh_node[instance->mesh] =
				build->place[instance->node];
			error = shape_mesh(build, instance->mesh);
		}
	}
	return error;
}
