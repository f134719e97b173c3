#include "app/compare/candidate/candidate_morph.h"

#include "app/anim/kernel/layout/fixed_keys.h"
#include "app/anim/kernel/run/fixed_lerp.h"
#include "platform/base/count.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

struct morph_bake {
	const struct fixed_loops *loops;
	struct fixed_placement placement;
	struct arena arena;
	int key_count;
	float *key_time_s; /* [key_count] */
	int at;            /* the last key not after the pose's time */
	float omega; /* of the pose's time: 0 at this key, 1 at the next */

	/* Keys in memory: slot key % slot_count holds slot_key[slot]. */
	int slot_count, stride;
	int *slot_key;            /* [slot_count]; -1: none yet */
	struct fixed_key *key[2]; /* positions, normals: [slot_count][stride] */
	struct fixed_vector *posed[2];
	float (*vector)[3]; /* [vertex_count]: scratch of bake_key() */
};

struct fixed_placement candidate_morph_placement(const struct bounds *box)
{
	struct fixed_placement placement = {.scale = 1e-12f};

	for (int axis = 0; axis < 3; axis++) {
		float half = 0.5f * (box->high[axis] - box->low[axis]);
		float scale = half / (float)MORPH_POSITION_MAX;

		placement.offset[axis] = box->low[axis] + half;
		placement.scale =
			scale > placement.scale ? scale : placement.scale;
	}
	return placement;
}

static int rounded(float value, int most)
{
	float low = (float)-most, high = (float)most;

	value = scalar_clamp(value, low, high);
	return (int)(value + (value < 0.0f ? -0.5f : 0.5f));
}

void candidate_morph_position(const struct fixed_placement *placement,
	const float position[3], int16_t out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = (int16_t)rounded(
			(position[axis] - placement->offset[axis]) /
				placement->scale,
			MORPH_POSITION_MAX);
	}
}

void candidate_morph_normal(const float normal[3], int8_t out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = (int8_t)rounded(
			normal[axis] * (float)MORPH_NORMAL_LENGTH,
			MORPH_NORMAL_LENGTH);
	}
}

/*
 * Converts the reference's pose to a key frame as the player loads it from the
 * file: the numbers are rounded as in the file.
 */
static void bake_key(
	struct morph_bake *bake, const struct reference *reference, int slot)
{
	static const struct fixed_placement as_is = {1.0f, {0.0f, 0.0f, 0.0f}};
	size_t first = (size_t)slot * (size_t)bake->stride;
	int count = reference->vertex_count;

	for (int v = 0; v < count; v++) {
		int16_t number[3];

		candidate_morph_position(
			&bake->placement, reference->position[v], number);
		for (int axis = 0; axis < 3; axis++) {
			bake->vector[v][axis] = (float)number[axis];
		}
	}
	fixed_keys_convert(count, (const float(*)[3])bake->vector, &as_is,
		bake->key[0] + first);
	for (int v = 0; v < count; v++) {
		int8_t number[3];

		candidate_morph_normal(reference->normal[v], number);
		for (int axis = 0; axis < 3; axis++) {
			bake->vector[v][axis] = (float)number[axis] / 127.0f;
		}
	}
	fixed_keys_convert(count, (const float(*)[3])bake->vector,
		&fixed_keys_directions, bake->key[1] + first);
}

static void need_key(
	struct morph_bake *bake, struct reference *reference, int key)
{
	int slot = key % bake->slot_count;

	if (bake->slot_key[slot] != key) {
		reference_pose(reference, bake->key_time_s[key], true);
		bake_key(bake, reference, slot);
		bake->slot_key[slot] = key;
	}
}

static void find_omega(struct morph_bake *bake, float time_s)
{
	const float *key_s = bake->key_time_s;

	if (time_s < key_s[bake->at]) {
		bake->at = 0;
	}
	while (bake->at < bake->key_count - 2 && time_s >= key_s[bake->at + 1]) {
		bake->at++;
	}
	bake->omega = scalar_clamp((time_s - key_s[bake->at]) /
			(key_s[bake->at + 1] - key_s[bake->at]),
		0.0f, 1.0f);
}

static void seek_morph(struct candidate *candidate, float time_s)
{
	struct morph_bake *bake = candidate->state;

	find_omega(bake, time_s);
	need_key(bake, candidate->reference, bake->at);
	need_key(bake, candidate->reference, bake->at + 1);
}

static void pose_morph(struct candidate *candidate, float time_s)
{
	struct morph_bake *bake = candidate->state;
	size_t stride = (size_t)bake->stride;
	size_t from, to;

	find_omega(bake, time_s);
	from = (size_t)(bake->at % bake->slot_count) * stride;
	to = (size_t)((bake->at + 1) % bake->slot_count) * stride;
	for (int i = 0; i < (candidate->positions_only ? 1 : 2); i++) {
		bake->loops->lerp_keys(candidate->vertex_count,
			bake->key[i] + from, bake->key[i] + to,
			fixed_lerp_weights(bake->omega), bake->posed[i]);
	}
}

static void take_normal(const struct fixed_vector *posed, float out[3])
{
	float x = posed->x, y = posed->y, z = posed->z;
	float length = scalar_sqrt(x * x + y * y + z * z);
	float scale = length > 0.0f ? 1.0f / length : 0.0f;

	out[0] = x * scale;
	out[1] = y * scale;
	out[2] = z * scale;
}

static void take_morph(const struct candidate *candidate, float (*position)[3],
	float (*normal)[3])
{
	const struct morph_bake *bake = candidate->state;

	for (int v = 0; v < candidate->vertex_count; v++) {
		fixed_placement_apply(
			&bake->placement, &bake->posed[0][v], position[v]);
		if (normal) {
			take_normal(&bake->posed[1][v], normal[v]);
		}
	}
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
 * The player keeps the mesh itself and each key frame, 6 bytes a vertex and
 * attribute. The weights of a clip are counted by the comparison, since their
 * number depends on all clips of the file. The costs leave out what copying
 * posed vertices for GL takes, which depends on how the file is drawn
 * (comparison_draw.c).
 */
static void count_costs(
	struct candidate *candidate, const struct morph_bake *bake)
{
	const struct reference *reference = candidate->reference;
	size_t keys = (size_t)bake->key_count;
	size_t key_bytes = 0, file_bytes = 0;

	candidate->board.sample = board_cost_sample_keys(bake->key_count);
	candidate->board.matrices = board_cost_matrices(1, 1, 0);
	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];
		size_t count = (size_t)part->vertex_count;
		size_t streams = part->normals ? 2 : 1;
		struct board_cost cost = board_cost_keys(
			part->vertex_count, part->normals, bake->key_count);

		board_cost_add(&candidate->board.vertices, &cost);
		key_bytes += (count + count % 2) * streams *
			sizeof(struct fixed_key);
		file_bytes += count *
			(size_t)(MORPH_POSITION_FILE_BYTES +
				(part->normals ? MORPH_NORMAL_FILE_BYTES : 0));
		candidate->bytes.shared +=
			count * streams * sizeof(struct fixed_vector);
	}
	candidate->bytes.shared += key_bytes;
	candidate->bytes.own = keys * (key_bytes + sizeof(float));
	candidate->bytes.shared_file = file_bytes;
	candidate->bytes.own_file = keys * (file_bytes + sizeof(float));
}

static int slots_for(int key_count, size_t stride, size_t keep_bytes)
{
	size_t key_bytes = 2 * stride * sizeof(struct fixed_key);
	size_t most = keep_bytes / (key_bytes > 0 ? key_bytes : 1);

	return (size_t)key_count <= most ? key_count : 2;
}

static int prepare(struct morph_bake *bake, const struct reference *reference,
	const struct fit_keys *key, size_t keep_bytes)
{
	size_t count = (size_t)reference->vertex_count, total;
	struct arena *arena = &bake->arena;

	bake->key_count = key->count;
	bake->stride = reference->vertex_count + reference->vertex_count % 2;
	bake->slot_count =
		slots_for(key->count, (size_t)bake->stride, keep_bytes);
	if (!size_multiply(
		    (size_t)bake->slot_count, (size_t)bake->stride, &total)) {
		return -ENOMEM;
	}
	bake->key_time_s = ARENA_ARRAY(arena, float, (size_t)key->count);
	bake->slot_key = ARENA_ARRAY(arena, int, (size_t)bake->slot_count);
	bake->vector = arena_alloc(arena, count, sizeof(float[3]));
	for (int i = 0; i < 2; i++) {
		bake->key[i] = ARENA_ARRAY(arena, struct fixed_key, total);
		bake->posed[i] = ARENA_ARRAY(arena, struct fixed_vector, count);
	}
	if (!bake->key_time_s || !bake->slot_key || !bake->vector ||
		!bake->key[0] || !bake->key[1] || !bake->posed[0] ||
		!bake->posed[1]) {
		return -ENOMEM;
	}
	memcpy(bake->key_time_s, key->time_s,
		(size_t)key->count * sizeof(*key->time_s));
	for (int i = 0; i < bake->slot_count; i++) {
		bake->slot_key[i] = -1;
	}
	return 0;
}

int candidate_morph(struct candidate *candidate, struct reference *reference,
	const struct kernel *kernel, const struct fixed_placement *placement,
	const struct fit_keys *key, size_t keep_bytes, const struct log *log)
{
	struct morph_bake *bake = calloc(1, sizeof(*bake));

	*candidate = (struct candidate){
		.reference = reference,
		.vertex_count = reference->vertex_count,
		.seek = seek_morph,
		.pose = pose_morph,
		.take = take_morph,
		.destroy = destroy_morph,
		.state = bake,
	};
	if (bake) {
		bake->loops = kernel->fixed ? kernel->fixed : &fixed_loops_c;
		bake->placement = *placement;
		bake->arena = arena_within(reference->model->budget);
	}
	if (!bake || prepare(bake, reference, key, keep_bytes) != 0) {
		candidate_destroy(candidate);
		return memory_budget_fail(
			reference->model->budget, reference->model->path, log);
	}
	count_costs(candidate, bake);
	for (int i = 0; i < bake->key_count && bake->slot_count > 2; i++) {
		if (interrupt_pending()) {
			candidate_destroy(candidate);
			return -EINTR;
		}
		need_key(bake, reference, i);
	}
	return 0;
}
