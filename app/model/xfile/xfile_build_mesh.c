#include "app/model/color.h"
#include "app/model/xfile/xfile_build.h"
#include "app/model/xfile/xfile_convert.h"

#include <cglm/mat4.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/*
 * A corner of a face. Corners with the same material, position and normal
 * become one vertex; corners with the same material are in one primitive.
 */
struct corner {
	uint32_t material;
	uint32_t position;
	uint32_t normal;
	uint32_t order; /* its index in xfile_faces.corner */
};

struct mesh_builder {
	struct xfile_build *build;
	const struct xfile_mesh *from;
	struct xfile_influences influences;
	uint32_t *slot_material; /* [slot_count]: index of the material in the
				    model */
	uint32_t slot_count;
	struct corner *corner; /* [corner_count], sorted by material, position,
				  normal */
	size_t corner_count;
	uint32_t *vertex_of; /* [corner.order]: vertex within its primitive */
	int *primitive_of;   /* [corner.order]: primitive */
	struct model_mesh *mesh;
	bool mirrored; /* where it is drawn: glTF turns its triangles there */
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
	xfile_warn_at(build->context, slot->location,
		"this mesh refers to the material \"%.200s\", which does not exist",
		slot->name);
	return default_material(build);
}

static int resolve_slots(struct mesh_builder *builder)
{
	const struct xfile_slot *slot = builder->from->slots;

	for (; slot; slot = slot->next) {
		builder->slot_count++;
	}
	builder->slot_material = ARENA_ARRAY(
		builder->build->scratch, uint32_t, builder->slot_count);
	if (!builder->slot_material) {
		return xfile_no_memory(builder->build->context);
	}
	slot = builder->from->slots;
	for (uint32_t i = 0; slot; slot = slot->next, i++) {
		builder->slot_material[i] = resolve_slot(builder->build, slot);
	}
	return 0;
}

static uint32_t face_material(const struct mesh_builder *builder, uint32_t face)
{
	const struct xfile_mesh *from = builder->from;
	uint32_t slot = from->face_slot ? from->face_slot[face] : 0;

	return slot < builder->slot_count ? builder->slot_material[slot]
					  : default_material(builder->build);
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

/* Sorts the corners of all faces that have at least three corners. */
static int sort_corners(struct mesh_builder *builder)
{
	const struct xfile_mesh *from = builder->from;
	const struct xfile_faces *faces = &from->faces;
	size_t total = faces->first[faces->count];

	builder->corner =
		ARENA_ARRAY(builder->build->scratch, struct corner, total);
	builder->vertex_of =
		ARENA_ARRAY(builder->build->scratch, uint32_t, total);
	builder->primitive_of = ARENA_ARRAY(builder->build->scratch, int, total);
	if (!builder->corner || !builder->vertex_of || !builder->primitive_of) {
		return xfile_no_memory(builder->build->context);
	}
	for (uint32_t face = 0; face < faces->count; face++) {
		uint32_t material;

		if (face_corners(faces, face) < 3) {
			continue;
		}
		material = face_material(builder, face);
		for (uint32_t i = faces->first[face];
			i < faces->first[face + 1]; i++) {
			builder->corner[builder->corner_count++] =
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
	qsort(builder->corner, builder->corner_count, sizeof(*builder->corner),
		compare_corners);
	return 0;
}

static bool is_same_vertex(const struct corner *a, const struct corner *b)
{
	return a->material == b->material && a->position == b->position &&
		a->normal == b->normal;
}

static int count_primitives(struct mesh_builder *builder)
{
	struct arena *arena = &builder->build->model->arena;
	const struct corner *corner = builder->corner;
	int count = 0;

	for (size_t i = 0; i < builder->corner_count; i++) {
		count += i == 0 || corner[i].material != corner[i - 1].material;
	}
	builder->mesh->primitive =
		ARENA_ARRAY(arena, struct model_primitive, count);
	builder->mesh->primitive_count = count;
	return builder->mesh->primitive
		? 0
		: xfile_no_memory(builder->build->context);
}

/* Assigns a primitive and a vertex to each corner. */
static void number_vertices(struct mesh_builder *builder)
{
	const struct corner *corner = builder->corner;
	struct model_primitive *primitive = NULL;

	for (size_t i = 0; i < builder->corner_count; i++) {
		const struct corner *at = &corner[i];

		if (i == 0 || at->material != at[-1].material) {
			primitive = primitive ? primitive + 1
					      : builder->mesh->primitive;
			primitive->file_index =
				(int)(primitive - builder->mesh->primitive);
			primitive->material = (int)at->material;
		}
		if (i == 0 || !is_same_vertex(at, at - 1)) {
			primitive->vertex_count++;
		}
		builder->vertex_of[at->order] =
			(uint32_t)primitive->vertex_count - 1;
		builder->primitive_of[at->order] = primitive->file_index;
	}
}

static int allocate(
	struct mesh_builder *builder, struct model_primitive *primitive)
{
	const struct xfile_mesh *from = builder->from;
	struct arena *arena = &builder->build->model->arena;
	size_t count = (size_t)primitive->vertex_count;
	size_t influences = count * (size_t)builder->influences.width;

	primitive->influences = builder->influences.width;
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
		return xfile_no_memory(builder->build->context);
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

static void fill_vertex(const struct mesh_builder *builder,
	const struct corner *corner, struct model_primitive *to, size_t vertex)
{
	const struct xfile_mesh *from = builder->from;
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
			to->color[vertex][i] =
				color_to_byte(from->color[position][i]);
		}
	}
	if (width) {
		memcpy(to->joint + vertex * width,
			builder->influences.joint[position],
			width * sizeof(*to->joint));
		memcpy(to->weight + vertex * width,
			builder->influences.weight[position],
			width * sizeof(*to->weight));
	}
}

static void fill_vertices(struct mesh_builder *builder)
{
	struct model_primitive *primitive = builder->mesh->primitive;

	for (size_t i = 0; i < builder->corner_count; i++) {
		const struct corner *corner = &builder->corner[i];
		uint32_t order = corner->order;

		fill_vertex(builder, corner,
			&primitive[builder->primitive_of[order]],
			builder->vertex_of[order]);
	}
}

/*
 * Writes the triangles of all faces, as fans. Corners are reversed, because
 * negating z reverses the winding, but not where glTF reverses it once more:
 * Direct3D draws the same side of a triangle wherever it is.
 */
static void fill_triangles(struct mesh_builder *builder)
{
	const struct xfile_faces *faces = &builder->from->faces;
	uint32_t second = builder->mirrored ? 0 : 1, third = 1 - second;

	for (uint32_t face = 0; face < faces->count; face++) {
		uint32_t corners = face_corners(faces, face);
		uint32_t first = faces->first[face];
		struct model_primitive *primitive;

		if (corners < 3) {
			continue;
		}
		primitive =
			&builder->mesh->primitive[builder->primitive_of[first]];
		for (uint32_t i = 1; i + 1 < corners; i++) {
			uint32_t *index =
				primitive->index + primitive->index_count;

			index[0] = builder->vertex_of[first];
			index[1] = builder->vertex_of[first + i + second];
			index[2] = builder->vertex_of[first + i + third];
			primitive->index_count += 3;
		}
	}
}

/*
 * Counts the indices of each primitive. This cannot overflow, since
 * read_faces() limits the corners to INT_MAX / 3.
 */
static void count_triangles(struct mesh_builder *builder)
{
	const struct xfile_faces *faces = &builder->from->faces;

	for (uint32_t face = 0; face < faces->count; face++) {
		uint32_t corners = face_corners(faces, face);

		if (corners >= 3) {
			int primitive =
				builder->primitive_of[faces->first[face]];

			builder->mesh->primitive[primitive].index_count +=
				3 * (int)(corners - 2);
		}
	}
}

static int fill_mesh(struct mesh_builder *builder)
{
	struct model_mesh *mesh = builder->mesh;
	int error = count_primitives(builder);

	if (error) {
		return error;
	}
	number_vertices(builder);
	count_triangles(builder);
	for (int i = 0; i < mesh->primitive_count; i++) {
		error = allocate(builder, &mesh->primitive[i]);
		if (error) {
			return error;
		}
	}
	fill_vertices(builder);
	fill_triangles(builder);
	for (int i = 0; i < mesh->primitive_count; i++) {
		model_normalize_influences(&mesh->primitive[i]);
	}
	return 0;
}

static bool mirrors(const float matrix[16])
{
	mat4 converted;

	xfile_convert_matrix(matrix, converted);
	return glm_mat4_det(converted) < 0.0f;
}

/* Finds which frames mirror what is below them. Parents come first. */
static void find_mirroring(struct xfile_build *build)
{
	const struct xfile_frame *frame = build->scene->frames;

	for (int i = 0; frame; frame = frame->next, i++) {
		build->mirrors[i] = mirrors(frame->matrix) !=
			(frame->parent >= 0 && build->mirrors[frame->parent]);
	}
}

/* Whether a mesh is turned when it is drawn: by its frame or its first bone. */
static bool is_mirrored(
	const struct xfile_build *build, const struct xfile_instance *instance)
{
	const struct xfile_bone *bone = build->mesh[instance->mesh]->bones;
	int frame =
		bone ? xfile_names_find(&build->frame_names, bone->name) : -1;

	return (instance->frame >= 0 && build->mirrors[instance->frame]) ||
		(frame >= 0 && build->mirrors[frame] != mirrors(bone->offset));
}

static int build_mesh(
	struct xfile_build *build, const struct xfile_instance *instance)
{
	int index = instance->mesh;
	struct model *model = build->model;
	struct mesh_builder builder = {
		.build = build,
		.from = build->mesh[index],
		.mesh = &model->mesh[model->mesh_count],
		.mirrored = is_mirrored(build, instance),
	};
	int error = resolve_slots(&builder);

	build->mesh_index[index] = model->mesh_count++;
	builder.mesh->name = arena_strdup(&model->arena, builder.from->name);
	if (!builder.mesh->name) {
		return xfile_no_memory(build->context);
	}
	if (!error) {
		error = xfile_build_skin(
			build, builder.from, index, &builder.influences);
	}
	if (!error) {
		error = sort_corners(&builder);
	}
	return error ? error : fill_mesh(&builder);
}

static int make_tables(struct xfile_build *build)
{
	struct model *model = build->model;
	size_t count = (size_t)build->scene->mesh_count;

	build->mesh_index = ARENA_ARRAY(build->scratch, int, count);
	build->mesh_skin = ARENA_ARRAY(build->scratch, int, count);
	build->mesh_node = ARENA_ARRAY(build->scratch, int, count);
	build->mirrors = ARENA_ARRAY(
		build->scratch, bool, (size_t)build->scene->frame_count);
	model->mesh = ARENA_ARRAY(&model->arena, struct model_mesh, count);
	model->skin = ARENA_ARRAY(&model->arena, struct model_skin, count);
	if (!build->mesh_index || !build->mesh_skin || !build->mesh_node ||
		!build->mirrors || !model->mesh || !model->skin) {
		return xfile_no_memory(build->context);
	}
	for (size_t i = 0; i < count; i++) {
		build->mesh_skin[i] = -1;
		build->mesh_node[i] = -1;
	}
	find_mirroring(build);
	return 0;
}

int xfile_build_meshes(struct xfile_build *build)
{
	int error = make_tables(build);

	for (int i = 0; !error && i < build->instance_count; i++) {
		const struct xfile_instance *instance = &build->instance[i];

		if (build->mesh_node[instance->mesh] < 0) {
			build->mesh_node[instance->mesh] =
				build->node_index[instance->node];
			error = build_mesh(build, instance);
		}
	}
	return error;
}
