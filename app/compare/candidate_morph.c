#include "app/compare/candidate_morph.h"

#include "app/anim/kernel/layout/fixed_key.h"
#include "app/anim/kernel/run/fixed_lerp.h"
#include "app/compare/fit.h"
#include "platform/base/count.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct morph_bake {
	const struct reference *reference;
	const struct kernel *kernel;
	struct arena arena;
	int key_count;
	int *key;    /* [key_count], frames of the reference */
	int at;      /* the key at or before the last pose's time */
	float omega; /* that time between this key (0) and the next (1) */
	float (*position)[3];
	float (*normal)[3];

	/* In fixed point instead of these two: [0] positions, [1] normals. */
	const struct fixed_loops *loops;
	struct fixed_pair (*pair[2])[3]; /* [key_count - 1][vertex_count] */
	struct fixed_vector *posed[2];
};

static float key_time_s(const struct morph_bake *bake, int key)
{
	return bake->reference->time_s[bake->key[key]];
}

static void find_key(struct morph_bake *bake, float time_s)
{
	if (time_s < key_time_s(bake, bake->at)) {
		bake->at = 0;
	}
	while (bake->at < bake->key_count - 2 &&
		time_s >= key_time_s(bake, bake->at + 1)) {
		bake->at++;
	}
}

static void find_omega(struct morph_bake *bake, float time_s)
{
	float from_s, to_s;

	find_key(bake, time_s);
	from_s = key_time_s(bake, bake->at);
	to_s = key_time_s(bake, bake->at + 1);
	bake->omega = (time_s - from_s) / (to_s - from_s);
	bake->omega = bake->omega > 1.0f ? 1.0f : bake->omega;
}

static void pose_fixed(struct candidate *candidate, float time_s)
{
	struct morph_bake *bake = candidate->state;
	int count = bake->reference->vertex_count;
	size_t first;

	find_omega(bake, time_s);
	first = (size_t)bake->at * (size_t)count;
	for (int i = 0; i < 2; i++) {
		bake->loops->lerp(count,
			(const struct fixed_pair(*)[3])bake->pair[i] + first,
			fixed_lerp_weights(bake->omega), bake->posed[i]);
	}
}

static void vertex_fixed(
	const struct candidate *candidate, int vertex, float out[3])
{
	const struct morph_bake *bake = candidate->state;
	const int *key = bake->key + bake->at;

	glm_vec3_lerp(
		(float *)reference_position(bake->reference, key[0])[vertex],
		(float *)reference_position(bake->reference, key[1])[vertex],
		bake->omega, out);
}

static void pose_morph(struct candidate *candidate, float time_s)
{
	static const float nowhere[3] = {0.0f, 0.0f, 0.0f};
	struct morph_bake *bake = candidate->state;
	const struct reference *reference = bake->reference;
	int count = reference->vertex_count;
	int from, to;
	float omega;

	find_omega(bake, time_s);
	from = bake->key[bake->at];
	to = bake->key[bake->at + 1];
	omega = bake->omega;
	bake->kernel->morph_lerp(count, reference_position(reference, from),
		reference_position(reference, to), omega, nowhere,
		bake->position);
	bake->kernel->morph_lerp(count, reference_normal(reference, from),
		reference_normal(reference, to), omega, nowhere, bake->normal);
	bake->kernel->normalize(count, bake->normal);
}

static void vertex_morph(
	const struct candidate *candidate, int vertex, float out[3])
{
	const struct morph_bake *bake = candidate->state;

	memcpy(out, bake->position[vertex], sizeof(float[3]));
}

static void destroy_morph(struct candidate *candidate)
{
	struct morph_bake *bake = candidate->state;

	if (bake) {
		arena_release(&bake->arena);
		free(bake);
	}
}

/*
 * The file holds the first key as base, the others as targets, and a weight for
 * each target and key. The board interpolates between keys in fixed point.
 */
static void count_costs(
	struct candidate *candidate, const struct morph_bake *bake)
{
	const struct reference *reference = bake->reference;
	size_t keys = (size_t)bake->key_count;
	size_t vectors = 0;

	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];

		struct board_cost cost =
			board_cost_lerp(part->vertex_count, part->normals);

		board_cost_add(&candidate->board, &cost);
		vectors +=
			(size_t)(part->vertex_count * (part->normals ? 2 : 1));
	}
	candidate->memory_bytes = bake->loops
		? (keys - 1) * vectors * sizeof(struct fixed_pair[3]) +
			vectors * sizeof(struct fixed_vector)
		: (keys + 1) * vectors * sizeof(float[3]);
	candidate->memory_bytes += keys * sizeof(float);
	candidate->file_bytes = keys * vectors * sizeof(float[3]) +
		keys * sizeof(float) + keys * (keys - 1) * sizeof(float);
}

/* Converts the positions (stream 0) or normals (1) of a key. */
static void write_key(const struct morph_bake *bake, int stream, int key,
	const struct fixed_placement *placement, struct fixed_vector *out)
{
	const struct reference *reference = bake->reference;
	int frame = bake->key[key];

	if (stream == 0) {
		fixed_key_positions(reference->vertex_count,
			reference_position(reference, frame), placement, out);
	} else {
		fixed_key_normals(reference->vertex_count,
			reference_normal(reference, frame), out);
	}
}

/* Prepares each key with the next; scratch holds two keys. */
static void pair_keys(struct morph_bake *bake,
	const struct fixed_placement *placement, struct fixed_vector *scratch)
{
	int count = bake->reference->vertex_count;

	for (int i = 0; i < 2 * (bake->key_count - 1); i++) {
		int stream = i % 2, key = i / 2;

		write_key(bake, stream, key, placement, scratch);
		write_key(bake, stream, key + 1, placement, scratch + count);
		fixed_lerp_prepare(count, scratch, scratch + count,
			bake->pair[stream] + (size_t)key * (size_t)count);
	}
}

/* Returns 0, -ENOMEM, or -ERANGE where 16 bits cannot hold the keys. */
static int prepare_fixed(struct morph_bake *bake)
{
	const struct reference *reference = bake->reference;
	size_t count = (size_t)reference->vertex_count;
	size_t pairs;
	struct fixed_range range = fixed_range_empty();
	struct fixed_placement placement;
	struct fixed_vector *scratch;

	if (!size_multiply((size_t)(bake->key_count - 1), count, &pairs)) {
		return -ENOMEM;
	}
	for (int k = 0; k < bake->key_count; k++) {
		fixed_range_add(&range, reference->vertex_count,
			reference_position(reference, bake->key[k]));
	}
	if (fixed_range_placement(&range, &placement) != 0) {
		return -ERANGE;
	}
	for (int i = 0; i < 2; i++) {
		bake->pair[i] = arena_alloc(
			&bake->arena, pairs, sizeof(struct fixed_pair[3]));
		bake->posed[i] =
			ARENA_ARRAY(&bake->arena, struct fixed_vector, count);
	}
	scratch = calloc(2 * count, sizeof(*scratch));
	if (!bake->pair[0] || !bake->pair[1] || !bake->posed[0] ||
		!bake->posed[1] || !scratch) {
		free(scratch);
		return -ENOMEM;
	}
	pair_keys(bake, &placement, scratch);
	free(scratch);
	bake->loops = bake->kernel->fixed;
	return 0;
}

static int prepare(struct morph_bake *bake, const int *key)
{
	size_t count = (size_t)bake->reference->vertex_count;
	int error;

	bake->key = ARENA_ARRAY(&bake->arena, int, (size_t)bake->key_count);
	if (!bake->key) {
		return -ENOMEM;
	}
	memcpy(bake->key, key, (size_t)bake->key_count * sizeof(*key));
	if (bake->kernel->fixed) {
		error = prepare_fixed(bake);
		if (error != -ERANGE) {
			return error;
		}
	}
	bake->position = arena_alloc(&bake->arena, count, sizeof(float[3]));
	bake->normal = arena_alloc(&bake->arena, count, sizeof(float[3]));
	return bake->position && bake->normal ? 0 : -ENOMEM;
}

int candidate_morph(struct candidate *candidate,
	const struct reference *reference, const struct kernel *kernel,
	const int *key, int key_count, const struct log *log)
{
	struct morph_bake *bake = calloc(1, sizeof(*bake));

	*candidate = (struct candidate){
		.technique = TECHNIQUE_MORPHING,
		.key_count = key_count,
		.vertex_count = reference->vertex_count,
		.pose = pose_morph,
		.vertex = vertex_morph,
		.destroy = destroy_morph,
		.state = bake,
	};
	if (bake) {
		bake->reference = reference;
		bake->kernel = kernel;
		bake->key_count = key_count;
		bake->arena = arena_within(reference->model->budget);
	}
	if (!bake || prepare(bake, key) != 0) {
		candidate_destroy(candidate);
		return memory_budget_fail(
			reference->model->budget, reference->model->path, log);
	}
	if (bake->loops) {
		candidate->pose = pose_fixed;
		candidate->vertex = vertex_fixed;
	}
	snprintf(candidate->name, sizeof(candidate->name), "morph, %d keys",
		key_count);
	count_costs(candidate, bake);
	return 0;
}

const int *candidate_morph_keys(const struct candidate *candidate)
{
	const struct morph_bake *bake = candidate->state;

	return bake->key;
}

void candidate_morph_vertices(const struct candidate *candidate,
	const float (**position)[3], const float (**normal)[3])
{
	const struct morph_bake *bake = candidate->state;

	*position = (const float(*)[3])bake->position;
	*normal = (const float(*)[3])bake->normal;
}
