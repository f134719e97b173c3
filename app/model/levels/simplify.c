#include "app/model/levels/simplify.h"

#include "app/model/levels/simplify_choose.h"
#include "app/model/levels/simplify_error.h"
#include "app/model/levels/simplify_merge.h"
#include "app/model/model_deltas.h"
#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	PASSES_MAX = 60,
	/* The last pass removes fewer than one in so many triangles. */
	PASS_WORTH = 100,
};

/* A pass does collapses whose error is up to this many times the median. */
static const float pass_factor = 1.5f;

/* Makes positions relative to the first vertex, so that few digits are lost. */
static void scale_positions(struct simplify *simplify)
{
	const struct model_primitive *primitive = simplify->primitive;
	const float *origin = primitive->position[0];
	float scale = 1.0f / simplify->extent;

	for (int v = 0; v < primitive->vertex_count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			simplify->position[v][axis] =
				(primitive->position[v][axis] - origin[axis]) *
				scale;
		}
	}
}

static float distance(const float *a, const float *b, int width)
{
	float square = 0.0f;

	for (int i = 0; i < width; i++) {
		square += (a[i] - b[i]) * (a[i] - b[i]);
	}
	return scalar_sqrt(square);
}

static float find_texture_scale(const struct simplify *simplify)
{
	const struct model_primitive *primitive = simplify->primitive;
	float lengths = 0.0f, units = 0.0f;

	for (int i = 0; primitive->texcoord && i + 1 < simplify->index_count;
		i += 3) {
		uint32_t a = simplify->index[i], b = simplify->index[i + 1];

		lengths += distance(
			simplify->position[a], simplify->position[b], 3);
		units += distance(
			primitive->texcoord[a], primitive->texcoord[b], 2);
	}
	return units > 0.0f ? lengths / units : 0.0f;
}

static int allocate(struct simplify *simplify, int index_count)
{
	size_t vertices = (size_t)simplify->primitive->vertex_count;
	size_t indices = (size_t)index_count;
	struct arena *arena = &simplify->arena;

	simplify->position = arena_alloc(arena, vertices, sizeof(float[3]));
	simplify->index = ARENA_ARRAY(arena, uint32_t, indices);
	simplify->leader = ARENA_ARRAY(arena, uint32_t, vertices);
	simplify->next = ARENA_ARRAY(arena, uint32_t, vertices);
	simplify->locked = ARENA_ARRAY(arena, bool, vertices);
	simplify->quadric =
		ARENA_ARRAY(arena, struct simplify_quadric, vertices);
	simplify->first_triangle = ARENA_ARRAY(arena, uint32_t, vertices + 1);
	simplify->triangle = ARENA_ARRAY(arena, uint32_t, indices);
	simplify->best = ARENA_ARRAY(arena, struct simplify_collapse, vertices);
	simplify->known = ARENA_ARRAY(arena, uint8_t, vertices);
	simplify->collapse =
		ARENA_ARRAY(arena, struct simplify_collapse, vertices);
	simplify->to = ARENA_ARRAY(arena, uint32_t, vertices);
	simplify->touched = ARENA_ARRAY(arena, bool, vertices);
	simplify->mark = ARENA_ARRAY(arena, uint32_t, vertices);
	return simplify->position && simplify->index && simplify->leader &&
			simplify->next && simplify->locked &&
			simplify->quadric && simplify->first_triangle &&
			simplify->triangle && simplify->best &&
			simplify->known && simplify->collapse && simplify->to &&
			simplify->touched && simplify->mark
		? 0
		: -ENOMEM;
}

/* Copies the list, without triangles that have two corners at one position. */
static void copy_index(
	struct simplify *simplify, const struct simplify_input *input)
{
	const uint32_t *leader = simplify->leader;

	for (int i = 0; i + 2 < input->index_count; i += 3) {
		const uint32_t *at = input->index + i;
		uint32_t *to = simplify->index + simplify->index_count;

		if (leader[at[0]] == leader[at[1]] ||
			leader[at[0]] == leader[at[2]] ||
			leader[at[1]] == leader[at[2]]) {
			continue;
		}
		for (int j = 0; j < 3; j++) {
			to[j] = input->shape_only ? leader[at[j]] : at[j];
		}
		simplify->index_count += 3;
	}
}

static int read_targets(
	struct simplify *simplify, const struct model_target *from)
{
	int error = 0;

	simplify->target = ARENA_ARRAY(&simplify->arena, struct simplify_target,
		(size_t)simplify->target_count);
	if (!simplify->target) {
		return -ENOMEM;
	}
	for (int t = 0; t < simplify->target_count && !error; t++) {
		struct simplify_target *to = &simplify->target[t];

		error = model_deltas_floats(
			&from[t].position, &simplify->arena, &to->position);
		if (!error && !simplify->shape_only && !simplify->source) {
			error = model_deltas_floats(
				&from[t].normal, &simplify->arena, &to->normal);
		}
	}
	return error;
}

int simplify_begin(struct simplify *simplify,
	const struct simplify_input *input, struct memory_budget *budget)
{
	const struct model_target *targets =
		input->source ? input->whole->target : input->primitive->target;
	int error;

	*simplify = (struct simplify){
		.arena = arena_within(budget),
		.primitive = input->primitive,
		.target_count = input->target_count,
		.shape_only = input->shape_only,
		.extent = input->extent,
		.source = input->source,
	};
	if (allocate(simplify, input->index_count) != 0 ||
		read_targets(simplify, targets) != 0) {
		return -ENOMEM;
	}
	scale_positions(simplify);
	error = simplify_mesh_weld(simplify);
	if (error) {
		return error;
	}
	copy_index(simplify, input);
	simplify->texture_scale = find_texture_scale(simplify);
	for (int v = 0; v < input->primitive->vertex_count; v++) {
		uint32_t leader = simplify->leader[v];

		simplify->to[v] = (uint32_t)v;
		simplify->locked[leader] =
			simplify->locked[leader] || input->shared[v];
	}
	simplify_mesh_link(simplify);
	simplify->divided =
		!input->shape_only && simplify_merge_is_wanted(simplify);
	simplify_error_begin(simplify);
	return 0;
}

static int list_collapses(struct simplify *simplify, float limit)
{
	int count = 0;

	for (uint32_t v = 0; v < (uint32_t)simplify->primitive->vertex_count &&
		!interrupt_pending();
		v++) {
		struct simplify_collapse *best = &simplify->best[v];

		if (simplify->leader[v] != v || simplify->locked[v]) {
			continue;
		}
		if (simplify->known[v] == SIMPLIFY_NOTHING ||
			(simplify->known[v] == SIMPLIFY_BOUND &&
				best->error <= limit)) {
			simplify_choose(simplify, v, limit);
		}
		if (simplify->known[v] == SIMPLIFY_BEST && best->to != v &&
			best->error <= limit) {
			simplify->collapse[count++] = *best;
		}
	}
	return count;
}

static int compare_collapses(const void *left, const void *right)
{
	const struct simplify_collapse *a = left, *b = right;

	if (a->error != b->error) {
		return a->error < b->error ? -1 : 1;
	}
	return a->from < b->from ? -1 : a->from > b->from;
}

static bool collapse(struct simplify *simplify, uint32_t from, uint32_t to)
{
	if (simplify->touched[from] || simplify->touched[to]) {
		return false;
	}
	simplify->known[from] = SIMPLIFY_NOTHING;
	if (!simplify_choose_again(simplify, from, to)) {
		return false;
	}
	simplify_error_collapse(simplify, from, to);
	simplify->touched[from] = simplify->touched[to] = true;
	for (uint32_t i = simplify->first_triangle[from];
		i < simplify->first_triangle[from + 1]; i++) {
		const uint32_t *at = simplify->index + simplify->triangle[i];

		for (int j = 0; j < 3; j++) {
			simplify->known[simplify->leader[at[j]]] =
				SIMPLIFY_NOTHING;
		}
	}
	return true;
}

/*
 * Moves corners to the vertices that theirs collapsed to, and drops triangles
 * that have become lines.
 */
static void move_corners(struct simplify *simplify)
{
	const uint32_t *leader = simplify->leader;
	int count = simplify->index_count;

	simplify->index_count = 0;
	for (int i = 0; i < count; i += 3) {
		uint32_t *to = simplify->index + simplify->index_count;
		uint32_t a = simplify->to[simplify->index[i]];
		uint32_t b = simplify->to[simplify->index[i + 1]];
		uint32_t c = simplify->to[simplify->index[i + 2]];

		if (leader[a] != leader[b] && leader[a] != leader[c] &&
			leader[b] != leader[c]) {
			to[0] = a;
			to[1] = b;
			to[2] = c;
			simplify->index_count += 3;
		}
	}
}

static bool run_pass(struct simplify *simplify, float limit)
{
	int count = list_collapses(simplify, limit), done = 0;
	float most;

	if (count == 0) {
		return false;
	}
	qsort(simplify->collapse, (size_t)count, sizeof(*simplify->collapse),
		compare_collapses);
	most = simplify->collapse[count / 2].error * pass_factor;
	memset(simplify->touched, 0,
		(size_t)simplify->primitive->vertex_count *
			sizeof(*simplify->touched));
	for (int i = 0; i < count && simplify->collapse[i].error <= most &&
		!interrupt_pending();
		i++) {
		done += collapse(simplify, simplify->collapse[i].from,
			simplify->collapse[i].to);
	}
	move_corners(simplify);
	for (int v = 0; v < simplify->primitive->vertex_count; v++) {
		simplify->to[v] = (uint32_t)v;
	}
	simplify_mesh_link(simplify);
	return done * PASS_WORTH > simplify->index_count / 3;
}

void simplify_until(struct simplify *simplify, float limit)
{
	simplify_merge(simplify, limit);
	for (int pass = 0; pass < PASSES_MAX && run_pass(simplify, limit);
		pass++) {
	}
}

void simplify_end(struct simplify *simplify)
{
	arena_release(&simplify->arena);
}
