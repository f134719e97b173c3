#include "app/model/levels/levels.h"

#include "app/model/levels/levels_divide.h"
#include "app/model/levels/simplify.h"
#include "platform/base/compiler.h"
#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	TRIANGLES_MIN = 150, /* primitives with fewer triangles get no levels */
	LEVELS_MAX = 12,
};

/* Limits of the error, one a level, in fractions of the longest side. */
static const float shaded_limits[] = {
	0.0004f, 0.0008f, 0.0016f, 0.003f, 0.0055f, 0.01f, 0.018f, 0.03f};
static const float shadow_limits[] = {
	0.0016f, 0.003f, 0.006f, 0.012f, 0.025f, 0.04f};
/*
 * A level's error_m is its limit times this factor: 99 of 100 points of the
 * surface are at most so far away, as measured with assets/lod/distance.mjs.
 */
static const float shaded_factor = 1.0f, shadow_factor = 2.0f;
static const float worth =
	0.2f; /* the part of the triangles that a level must save */

/* A vertex of a primitive, as an element to sort by position. */
struct place {
	float position[3];
	int primitive, vertex;
};

static int compare_places(const void *left, const void *right)
{
	const struct place *a = left, *b = right;

	for (int i = 0; i < 3; i++) {
		if (a->position[i] != b->position[i]) {
			return a->position[i] < b->position[i] ? -1 : 1;
		}
	}
	return a->primitive - b->primitive;
}

/* Compares floats instead of bytes, since mirrored vertices are at -0. */
static bool are_together(const struct place *a, const struct place *b)
{
	return a->position[0] == b->position[0] &&
		a->position[1] == b->position[1] &&
		a->position[2] == b->position[2];
}

/* Primitives that may touch: those of one mesh, or all skinned ones. */
struct group {
	int count;
	struct model_primitive **primitive;
	int *target_count;
	bool **shared; /* [count][vertex_count]: another primitive has a vertex
			  at the same position */
	size_t vertex_count;
	float extent; /* the longest side of the box around them */
	struct memory_budget *budget; /* the model's, or NULL */
	bool refused;                 /* it left levels out */
};

static int init_group(
	struct group *group, const struct model *model, struct arena *arena)
{
	size_t most = 0;

	for (int m = 0; m < model->mesh_count; m++) {
		most += (size_t)model->mesh[m].primitive_count;
	}
	group->primitive = ARENA_ARRAY(arena, struct model_primitive *, most);
	group->target_count = ARENA_ARRAY(arena, int, most);
	group->shared = ARENA_ARRAY(arena, bool *, most);
	return group->primitive && group->target_count && group->shared
		? 0
		: -ENOMEM;
}

static bool is_skinned(const struct model_mesh *mesh)
{
	return mesh->primitive_count > 0 && mesh->primitive[0].influences > 0;
}

/* Mesh -1 stands for all skinned meshes. */
static void gather_group(
	struct group *group, const struct model *model, int mesh)
{
	int first = mesh < 0 ? 0 : mesh;
	int end = mesh < 0 ? model->mesh_count : mesh + 1;

	group->count = 0;
	group->vertex_count = 0;
	for (int m = first; m < end; m++) {
		struct model_mesh *own = &model->mesh[m];
		bool wanted = mesh >= 0 || is_skinned(own);

		for (int p = 0; wanted && p < own->primitive_count; p++) {
			group->primitive[group->count] = &own->primitive[p];
			group->target_count[group->count] = own->target_count;
			group->vertex_count +=
				(size_t)own->primitive[p].vertex_count;
			group->count++;
		}
	}
}

static void measure(struct group *group)
{
	float low[3], high[3];
	bool first = true;

	for (int p = 0; p < group->count; p++) {
		const struct model_primitive *primitive = group->primitive[p];

		for (int v = 0; v < primitive->vertex_count; v++) {
			for (int i = 0; i < 3; i++) {
				float at = primitive->position[v][i];

				low[i] = first || at < low[i] ? at : low[i];
				high[i] = first || at > high[i] ? at : high[i];
			}
			first = false;
		}
	}
	group->extent = 0.0f;
	for (int i = 0; i < 3 && !first; i++) {
		float side = high[i] - low[i];

		group->extent = scalar_max(side, group->extent);
	}
}

static int list_places(
	const struct group *group, struct arena *arena, struct place **out)
{
	struct place *next;

	*out = next = ARENA_ARRAY(arena, struct place, group->vertex_count);
	for (int p = 0; next && p < group->count; p++) {
		const struct model_primitive *primitive = group->primitive[p];

		group->shared[p] = ARENA_ARRAY(
			arena, bool, (size_t)primitive->vertex_count);
		if (!group->shared[p]) {
			return -ENOMEM;
		}
		for (int v = 0; v < primitive->vertex_count; v++, next++) {
			memcpy(next->position, primitive->position[v],
				sizeof(next->position));
			next->primitive = p;
			next->vertex = v;
		}
	}
	return *out ? 0 : -ENOMEM;
}

/* Marks the vertices at whose position another primitive has one too. */
static int find_shared(const struct group *group, struct arena *arena)
{
	struct place *place;
	size_t end;
	int error = list_places(group, arena, &place);

	if (error) {
		return error;
	}
	qsort(place, group->vertex_count, sizeof(*place), compare_places);
	for (size_t i = 0; i < group->vertex_count; i = end) {
		end = i + 1;
		while (end < group->vertex_count &&
			are_together(&place[i], &place[end])) {
			end++;
		}
		for (size_t j = i;
			place[end - 1].primitive != place[i].primitive && j < end;
			j++) {
			group->shared[place[j].primitive][place[j].vertex] =
				true;
		}
	}
	return 0;
}

/* A primitive's levels made so far: shaded ones or lists for shadows. */
struct levels {
	int count;
	struct model_lod lod[LEVELS_MAX];
	int last_count; /* indices of the last level, or of the list to begin
			   with */
};

/* divided is NULL unless the list is over its vertices. */
static int add_level(struct levels *levels, const struct simplify *simplify,
	const struct levels_divided *divided, float limit, struct arena *arena)
{
	size_t count = (size_t)simplify->index_count;
	struct model_lod *lod = &levels->lod[levels->count];
	uint32_t *index;

	if (count == 0 || levels->count == LEVELS_MAX ||
		(float)count > (1.0f - worth) * (float)levels->last_count) {
		return 0;
	}
	index = ARENA_ARRAY(arena, uint32_t, count);
	if (!index) {
		return -ENOMEM;
	}
	memcpy(index, simplify->index, count * sizeof(*index));
	*lod = (struct model_lod){
		.error_m = limit * simplify->extent *
			(simplify->shape_only ? shadow_factor : shaded_factor),
		.shadow_only = simplify->shape_only,
		.index_count = simplify->index_count,
		.index = index,
	};
	if (divided && levels_join(divided, lod, arena) != 0) {
		return -ENOMEM;
	}
	levels->count++;
	levels->last_count = simplify->index_count;
	return 0;
}

static int make_lists(struct levels *levels, const struct simplify_input *input,
	const struct levels_divided *divided, const float *limit,
	int limit_count, struct model *model)
{
	struct simplify simplify;
	int error = simplify_begin(&simplify, input, model->budget);

	levels->last_count = input->index_count;
	for (int i = 0; !error && i < limit_count; i++) {
		simplify_until(&simplify, limit[i]);
		error = interrupt_pending()
			? -EINTR
			: add_level(levels, &simplify, divided, limit[i],
				  &model->arena);
	}
	simplify_end(&simplify);
	return error;
}

static int shaded_count(const struct model_primitive *primitive)
{
	int count = 0;

	while (count < primitive->lod_count &&
		!primitive->lod[count].shadow_only) {
		count++;
	}
	return count;
}

/* Returns what follows the levels that it has appended. */
static struct model_lod *append(
	struct model_lod *to, const struct model_lod *from, int count)
{
	for (int i = 0; i < count; i++) {
		to[i] = from[i];
	}
	return to + count;
}

/* Sets the levels: those of the file come first, lists for shadows last. */
static int join_levels(struct model_primitive *primitive,
	const struct levels *shaded, const struct levels *shadow,
	struct arena *arena)
{
	int count = primitive->lod_count + shaded->count + shadow->count;
	int own = shaded_count(primitive);
	struct model_lod *lod = ARENA_ARRAY(
				 arena, struct model_lod, (size_t)count),
			 *next;

	if (!lod) {
		return -ENOMEM;
	}
	next = append(lod, primitive->lod, own);
	next = append(next, shaded->lod, shaded->count);
	if (primitive->lod_count > own) {
		next = append(
			next, primitive->lod + own, primitive->lod_count - own);
	}
	append(next, shadow->lod, shadow->count);
	primitive->lod = lod;
	primitive->lod_count = count;
	return 0;
}

/*
 * Returns 0 instead of an error if the budget refused memory, since levels are
 * optional. An error of the machine's memory stays.
 */
static int unless_refused(struct group *group, int error)
{
	if (!error || !group->budget || !group->budget->exceeded) {
		return error;
	}
	group->budget->exceeded = false;
	group->refused = true;
	return 0;
}

/*
 * Makes levels of a primitive without normals from a copy whose triangles have
 * vertices of their own.
 */
static int make_divided(struct levels *levels,
	const struct simplify_input *input, const float *limit, int limit_count,
	struct model *model)
{
	struct arena scratch = arena_within(model->budget);
	struct simplify_input own = *input;
	struct levels_divided divided;
	int error = levels_divide(
		input->primitive, input->shared, &scratch, &divided);

	if (!error) {
		own.primitive = &divided.primitive;
		own.index = divided.primitive.index;
		own.shared = divided.shared;
		own.source = divided.source;
		own.whole = input->primitive;
		error = make_lists(
			levels, &own, &divided, limit, limit_count, model);
	}
	arena_release(&scratch);
	return error;
}

static int make_shaded(struct levels *levels,
	const struct simplify_input *input, struct model *model)
{
	int count = (int)ARRAY_COUNT(shaded_limits);

	return input->primitive->normal
		? make_lists(levels, input, NULL, shaded_limits, count, model)
		: make_divided(levels, input, shaded_limits, count, model);
}

static int make_shadows(struct levels *levels, struct simplify_input *input,
	const struct levels *shaded, struct model *model)
{
	const struct model_primitive *primitive = input->primitive;
	int own = primitive->lod_count;
	bool has_shadow = own > 0 && primitive->lod[own - 1].shadow_only;

	input->shape_only = true;
	for (int i = 0; i < shaded->count &&
		shaded->lod[i].error_m <=
			shadow_limits[0] * shaded_factor * input->extent;
		i++) {
		input->index = shaded->lod[i].index;
		input->index_count = shaded->lod[i].index_count;
	}
	if (has_shadow) {
		input->index = primitive->lod[own - 1].index;
		input->index_count = primitive->lod[own - 1].index_count;
	}
	return make_lists(levels, input, NULL, shadow_limits,
		(int)ARRAY_COUNT(shadow_limits), model);
}

static int add_to_primitive(struct model *model, struct group *group, int number)
{
	struct model_primitive *primitive = group->primitive[number];
	struct simplify_input input = {
		.primitive = primitive,
		.target_count = group->target_count[number],
		.index = primitive->index,
		.index_count = primitive->index_count,
		.extent = group->extent,
		.shared = group->shared[number],
	};
	struct levels shaded = {0}, shadow = {0};
	int error = interrupt_pending() ? -EINTR : 0;

	if (error || primitive->index_count < 3 * TRIANGLES_MIN) {
		return error;
	}
	if (shaded_count(primitive) == 0) {
		error = unless_refused(
			group, make_shaded(&shaded, &input, model));
	}
	if (!error) {
		error = unless_refused(
			group, make_shadows(&shadow, &input, &shaded, model));
	}
	return error ? error
		     : join_levels(primitive, &shaded, &shadow, &model->arena);
}

static int add_to_group(struct model *model, struct group *group, int mesh)
{
	struct arena scratch = arena_within(model->budget);
	int error = 0;

	gather_group(group, model, mesh);
	measure(group);
	if (group->extent > 0.0f) {
		error = interrupt_pending() ? -EINTR
					    : find_shared(group, &scratch);
		for (int p = 0; !error && p < group->count; p++) {
			error = unless_refused(
				group, add_to_primitive(model, group, p));
		}
	}
	arena_release(&scratch);
	return unless_refused(group, error);
}

/* Whether half of the budget is free, since instances need memory too. */
static bool has_room(const struct memory_budget *budget)
{
	return !budget || budget->used_bytes <= budget->limit_bytes / 2;
}

static int add_to_all(struct model *model, struct group *group)
{
	int error = add_to_group(model, group, -1);

	for (int m = 0; !error && m < model->mesh_count; m++) {
		if (!is_skinned(&model->mesh[m])) {
			error = add_to_group(model, group, m);
		}
	}
	return error;
}

/* Sets *refused if the budget left levels out. */
static int make(struct model *model, bool *refused)
{
	struct memory_budget *budget = model->budget;
	struct arena scratch = arena_within(budget);
	bool exceeded = budget && budget->exceeded;
	struct group group = {.budget = budget};
	int error;

	/* A refusal here is not the reason of a later failure. */
	if (budget) {
		budget->exceeded = false;
	}
	error = init_group(&group, model, &scratch);
	if (!error) {
		error = add_to_all(model, &group);
	}
	error = unless_refused(&group, error);
	arena_release(&scratch);
	if (budget) {
		budget->exceeded = exceeded;
	}
	*refused = group.refused;
	return error;
}

int levels_make(struct model *model)
{
	bool refused;

	return has_room(model->budget) ? make(model, &refused) : 0;
}

int levels_make_all(struct model *model)
{
	bool refused;
	int error = make(model, &refused);

	if (!error && refused) {
		model->budget->exceeded = true;
		error = -ENOMEM;
	}
	return error;
}
