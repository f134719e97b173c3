/*
 * Morph key frames baked from the clip: AN4044, section 1.
 */
#include "app/compare/candidate.h"

#include "app/compare/fit.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct morph_bake {
	const struct reference *reference;
	const struct kernel *kernel;
	struct arena arena;
	int key_count;
	int *key; /* frames of the reference, which holds their vertices */
	int at;   /* the key before the last time */
	float (*position)[3];
	float (*normal)[3];
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

static void pose_morph(struct candidate *candidate, float time_s)
{
	static const float nowhere[3] = {0.0f, 0.0f, 0.0f};
	struct morph_bake *bake = candidate->state;
	const struct reference *reference = bake->reference;
	int count = reference->vertex_count;
	int from, to;
	float omega;

	find_key(bake, time_s);
	from = bake->key[bake->at];
	to = bake->key[bake->at + 1];
	omega = (time_s - reference->time_s[from]) /
		(reference->time_s[to] - reference->time_s[from]);
	omega = omega > 1.0f ? 1.0f : omega;
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

/* Key frames as base and targets, and one weight a target and key. */
static void count_bytes(struct candidate *candidate,
	const struct reference *reference, size_t keys)
{
	size_t vectors = 0;

	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];

		vectors +=
			(size_t)(part->vertex_count * (part->normals ? 2 : 1));
	}
	candidate->memory_bytes =
		(keys + 1) * vectors * sizeof(float[3]) + keys * sizeof(float);
	candidate->file_bytes = keys * vectors * sizeof(float[3]) +
		keys * sizeof(float) + keys * (keys - 1) * sizeof(float);
}

static int prepare(struct morph_bake *bake, const int *key)
{
	size_t count = (size_t)bake->reference->vertex_count;

	bake->key = ARENA_ARRAY(&bake->arena, int, (size_t)bake->key_count);
	bake->position = arena_alloc(&bake->arena, count, sizeof(float[3]));
	bake->normal = arena_alloc(&bake->arena, count, sizeof(float[3]));
	if (!bake->key || !bake->position || !bake->normal) {
		return -ENOMEM;
	}
	memcpy(bake->key, key, (size_t)bake->key_count * sizeof(*key));
	return 0;
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
		bake->arena = arena_empty();
	}
	if (!bake || prepare(bake, key) != 0) {
		log_error(log, "%s: not enough memory for %d key frames",
			reference->model->path, key_count);
		candidate_destroy(candidate);
		return -ENOMEM;
	}
	snprintf(candidate->name, sizeof(candidate->name), "morph, %d keys",
		key_count);
	count_bytes(candidate, reference, (size_t)key_count);
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
