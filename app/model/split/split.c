#include "app/model/split/split.h"

#include "app/model/model_deltas.h"
#include "app/model/split/split_triangles.h"
#include "platform/base/compiler.h"

#include <errno.h>
#include <string.h>

/* A large primitive, its parts, and the primitives that the parts become. */
struct split {
	struct model *model;
	struct arena *integers;
	int target_count;
	struct model_primitive whole;
	const struct split_part *part; /* linked list of the parts */
	struct model_primitive *out;   /* one primitive for each part, in
					order */
};

/* The arrays of struct model_primitive with an element for each vertex. */
static const struct {
	size_t at; /* offset of the pointer in the struct */
	size_t bytes, bytes_an_influence;
} arrays[] = {
	{offsetof(struct model_primitive, position), sizeof(float[3]), 0},
	{offsetof(struct model_primitive, normal), sizeof(float[3]), 0},
	{offsetof(struct model_primitive, tangent), sizeof(float[4]), 0},
	{offsetof(struct model_primitive, texcoord), sizeof(float[2]), 0},
	{offsetof(struct model_primitive, color), sizeof(uint8_t[4]), 0},
	{offsetof(struct model_primitive, joint), 0, sizeof(uint16_t)},
	{offsetof(struct model_primitive, weight), 0, sizeof(float)},
};

/* Bytes of a vertex in arrays[i]. */
static size_t vertex_bytes(const struct model_primitive *primitive, size_t i)
{
	return arrays[i].bytes +
		(size_t)primitive->influences * arrays[i].bytes_an_influence;
}

/*
 * Sets *out to whether a primitive is divided: it is large, or its triangles
 * use less than half of its vertices. Returns 0 or -ENOMEM.
 */
static int find_divided(const struct model_primitive *primitive,
	struct memory_budget *budget, bool *out)
{
	struct arena brief = arena_within(budget);
	bool *seen;
	int used = 0;

	*out = primitive->vertex_count > SPLIT_VERTICES_MAX;
	if (*out || primitive->lod_count > 0) {
		return 0;
	}
	seen = ARENA_ARRAY(&brief, bool, primitive->vertex_count);
	for (int i = 0; seen && i < primitive->index_count; i++) {
		used += !seen[primitive->index[i]];
		seen[primitive->index[i]] = true;
	}
	*out = used > 0 && used < primitive->vertex_count / 2;
	arena_release(&brief);
	return seen ? 0 : -ENOMEM;
}

/* Copies the elements of the part's vertices. */
static void gather(
	const struct split_part *part, const char *from, size_t bytes, char *to)
{
	for (int v = 0; v < part->vertex_count; v++) {
		memcpy(to + (size_t)v * bytes, from + part->vertex[v] * bytes,
			bytes);
	}
}

/*
 * Divides one array and frees it. at is the offset of its pointer in struct
 * model_primitive.
 */
static int divide_array(struct split *split, size_t at, size_t bytes)
{
	struct arena *arena = &split->model->arena;
	struct model_primitive *out = split->out;
	char *from;

	memcpy(&from, (char *)&split->whole + at, sizeof(from));
	if (!from || bytes == 0) {
		return 0;
	}
	for (const struct split_part *part = split->part; part;
		part = part->next) {
		char *to = arena_alloc(arena, (size_t)part->vertex_count, bytes);

		if (!to) {
			return -ENOMEM;
		}
		gather(part, from, bytes, to);
		memcpy((char *)out++ + at, &to, sizeof(to));
	}
	arena_free(arena, from, (size_t)split->whole.vertex_count * bytes);
	return 0;
}

static int divide_arrays(struct split *split)
{
	int error = 0;

	for (size_t i = 0; i < ARRAY_COUNT(arrays) && !error; i++) {
		error = divide_array(
			split, arrays[i].at, vertex_bytes(&split->whole, i));
	}
	return error;
}

/*
 * Divides the deltas of one attribute of a target. at is the attribute's offset
 * in struct model_target.
 */
static int divide_deltas(struct split *split, const struct model_deltas *deltas,
	size_t target, size_t at)
{
	bool integers = deltas->number != MODEL_FLOAT;
	struct arena *arena =
		integers ? split->integers : &split->model->targets;
	struct arena brief = arena_within(split->model->budget);
	struct model_primitive *out = split->out;
	const float(*all)[3];
	float(*own)[3];
	int error;

	if (deltas->vertex_count == 0) {
		return 0;
	}
	own = arena_alloc(&brief, SPLIT_VERTICES_MAX, sizeof(*own));
	error = own ? model_deltas_floats(deltas, &brief, &all) : -ENOMEM;
	for (const struct split_part *part = split->part; part && !error;
		part = part->next, out++) {
		struct model_deltas *to =
			(struct model_deltas *)((char *)&out->target[target] +
				at);

		gather(part, (const char *)all, sizeof(*own), (char *)own);
		error = model_deltas_pack(to, (const float(*)[3])own,
			part->vertex_count, deltas->number, deltas->unit, arena);
	}
	arena_release(&brief);
	if (!error) {
		arena_free(arena, deltas->value, model_deltas_bytes(deltas));
	}
	return error;
}

static int divide_targets(struct split *split)
{
	static const size_t members[] = {
		offsetof(struct model_target, position),
		offsetof(struct model_target, normal),
		offsetof(struct model_target, tangent),
	};
	int error = 0;

	for (size_t t = 0; t < (size_t)split->target_count && !error; t++) {
		const char *target = (const char *)&split->whole.target[t];

		for (size_t i = 0; i < ARRAY_COUNT(members) && !error; i++) {
			error = divide_deltas(split,
				(const struct model_deltas *)(target +
					members[i]),
				t, members[i]);
		}
	}
	return error;
}

/* Fills in what needs no division, and allocates targets, of each part. */
static int begin_parts(struct split *split)
{
	struct model_primitive *out = split->out;

	for (const struct split_part *part = split->part; part;
		part = part->next, out++) {
		*out = (struct model_primitive){
			.file_index = split->whole.file_index,
			.file_vertex = part->vertex,
			.repeated_count = part->repeated_count,
			.material = split->whole.material,
			.vertex_count = part->vertex_count,
			.influences = split->whole.influences,
			.index_count = part->index_count,
			.index = part->index,
			.target = ARENA_ARRAY(&split->model->arena,
				struct model_target, split->target_count),
		};
		if (!out->target) {
			return -ENOMEM;
		}
	}
	return 0;
}

static void free_list(struct arena *arena, const uint32_t *index, int count)
{
	arena_free(arena, index, (size_t)count * sizeof(*index));
}

static int divide(struct split *split)
{
	const struct model_primitive *whole = &split->whole;
	struct arena *arena = &split->model->arena;
	int error = begin_parts(split);

	free_list(arena, whole->index, whole->index_count);
	for (int i = 0; i < whole->lod_count; i++) {
		free_list(arena, whole->lod[i].index, whole->lod[i].index_count);
	}
	if (!error) {
		error = divide_arrays(split);
	}
	return error ? error : divide_targets(split);
}

static int count_parts(const struct split_part *part)
{
	int count = 0;

	for (; part; part = part->next) {
		count++;
	}
	return count;
}

/*
 * Finds the parts of each primitive in parts, which holds NULL (not divided),
 * and sets *count to the number of primitives after the division. Returns 0 or
 * -ENOMEM.
 */
static int find_parts(struct model *model, const struct model_mesh *mesh,
	struct split_part **parts, int *count)
{
	int error = 0;
	bool divided;

	*count = 0;
	for (int p = 0; p < mesh->primitive_count && !error; p++) {
		error = find_divided(
			&mesh->primitive[p], model->budget, &divided);
		if (!error && divided) {
			error = split_triangles(&mesh->primitive[p],
				SPLIT_VERTICES_MAX, &model->arena, &parts[p]);
		}
		*count += parts[p] ? count_parts(parts[p]) : 1;
	}
	return error;
}

static int split_mesh(struct model *model, struct model_mesh *mesh,
	struct split_part **parts, struct arena *integers)
{
	struct model_primitive *out;
	int count, error = find_parts(model, mesh, parts, &count);

	if (error || count == mesh->primitive_count) {
		return error;
	}
	out = ARENA_ARRAY(&model->arena, struct model_primitive, count);
	if (!out) {
		return -ENOMEM;
	}
	for (int p = 0, at = 0; p < mesh->primitive_count && !error; p++) {
		struct split split = {
			.model = model,
			.integers = integers,
			.target_count = mesh->target_count,
			.whole = mesh->primitive[p],
			.part = parts[p],
			.out = &out[at],
		};

		out[at] = split.whole;
		error = split.part ? divide(&split) : 0;
		at += split.part ? count_parts(split.part) : 1;
	}
	mesh->primitive = out;
	mesh->primitive_count = count;
	return error;
}

int split_primitives(struct model *model, struct arena *integers)
{
	struct arena scratch = arena_within(model->budget);
	int error = 0;

	for (int m = 0; m < model->mesh_count && !error; m++) {
		struct model_mesh *mesh = &model->mesh[m];
		struct split_part **parts = ARENA_ARRAY(
			&scratch, struct split_part *, mesh->primitive_count);

		error = parts ? split_mesh(model, mesh, parts, integers)
			      : -ENOMEM;
	}
	arena_release(&scratch);
	return error;
}

/* Frees the arrays that take most memory; targets stay. */
static void free_arrays(
	struct arena *arena, const struct model_primitive *primitive)
{
	for (size_t i = 0; i < ARRAY_COUNT(arrays); i++) {
		const void *array;

		memcpy(&array, (const char *)primitive + arrays[i].at,
			sizeof(array));
		arena_free(arena, array,
			(size_t)primitive->vertex_count *
				vertex_bytes(primitive, i));
	}
}

void split_drop_unused(struct model *model)
{
	for (int m = 0; m < model->mesh_count; m++) {
		struct model_mesh *mesh = &model->mesh[m];
		int kept = 0;

		for (int p = 0; p < mesh->primitive_count; p++) {
			const struct model_primitive *part = &mesh->primitive[p];

			if (part->file_vertex && part->index_count == 0) {
				free_arrays(&model->arena, part);
			} else {
				mesh->primitive[kept++] = *part;
			}
		}
		mesh->primitive_count = kept;
	}
}
