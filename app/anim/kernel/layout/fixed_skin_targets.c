#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/layout/fixed_attribute.h"
#include "app/anim/kernel/layout/fixed_skin_parts.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	MOVED_MAX = 65535
};

float fixed_skin_scale_limit(
	const struct fixed_skin *skin, enum fixed_attribute attribute)
{
	const struct fixed_skin_targets *targets = &skin->targets;
	float limit = attribute == FIXED_POSITION ? 1e18f : 32767.0f;
	float unit;

	if (!targets->rebase[attribute]) {
		return limit;
	}
	unit = targets->deltas.stream[attribute].unit;
	limit = 0.5f * unit < limit ? 0.5f * unit : limit;
	if (attribute != FIXED_POSITION) {
		float fits = 32766.0f /
			(1.0f +
				targets->deltas.weight_limit *
					targets->largest[attribute]);

		limit = fits < limit ? fits : limit;
	}
	return limit;
}

static bool is_moved(
	const struct model_primitive *primitive, int target_count, int vertex)
{
	for (int i = 0; i < target_count * FIXED_ATTRIBUTES; i++) {
		if (model_deltas_moves(
			    fixed_attribute_deltas(
				    &primitive->target[i / FIXED_ATTRIBUTES],
				    (enum fixed_attribute)(i % FIXED_ATTRIBUTES)),
			    vertex)) {
			return true;
		}
	}
	return false;
}

static int list_moved(
	struct fixed_skin *skin, int target_count, struct arena *arena)
{
	struct fixed_skin_targets *targets = &skin->targets;

	targets->moved =
		ARENA_ARRAY(arena, uint16_t, (size_t)skin->vertex_count);
	if (!targets->moved) {
		return -ENOMEM;
	}
	for (int v = 0; v < skin->vertex_count; v++) {
		if (!is_moved(skin->primitive, target_count, v)) {
			continue;
		}
		if (targets->moved_count == MOVED_MAX) {
			return -ERANGE;
		}
		targets->moved[v] = (uint16_t)++targets->moved_count;
	}
	return 0;
}

/* Copies the deltas of the moved vertices, one after the other, as floats. */
static int gather_deltas(const struct fixed_skin *skin,
	const struct model_deltas *from, struct model_deltas *out,
	struct arena *arena)
{
	const struct fixed_skin_targets *targets = &skin->targets;
	float(*value)[3];

	if (from->vertex_count == 0) {
		return 0;
	}
	value = arena_alloc(arena, (size_t)targets->moved_count, sizeof(*value));
	if (!value) {
		return -ENOMEM;
	}
	for (int v = 0; v < skin->vertex_count; v++) {
		if (targets->moved[v]) {
			model_deltas_get(from, v, value[targets->moved[v] - 1]);
		}
	}
	*out = model_deltas_view((const float(*)[3])value, targets->moved_count);
	return 0;
}

/* Computes the sums of all targets' |delta| of a moved vertex. */
static void sum_deltas(const struct fixed_skin_targets *targets,
	int target_count, enum fixed_attribute attribute, int moved,
	float sum[3])
{
	memset(sum, 0, sizeof(float[3]));
	for (int t = 0; t < target_count; t++) {
		float delta[3];

		model_deltas_get(fixed_attribute_deltas(
					 &targets->zero.target[t], attribute),
			moved, delta);
		for (int axis = 0; axis < 3; axis++) {
			sum[axis] += scalar_abs(delta[axis]);
		}
	}
}

/*
 * Computes extent[], the sums of positions, and largest[], the largest sum of
 * each attribute.
 */
static void measure_deltas(struct fixed_skin_targets *targets, int target_count)
{
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		float *largest = &targets->largest[a];

		for (int m = 0; m < targets->moved_count; m++) {
			float sum[3];

			sum_deltas(targets, target_count,
				(enum fixed_attribute)a, m, sum);
			for (int axis = 0; axis < 3; axis++) {
				*largest = sum[axis] > *largest ? sum[axis]
								: *largest;
			}
			if (a == FIXED_POSITION) {
				memcpy(targets->extent[m], sum, sizeof(sum));
			}
		}
	}
}

/* Copies all targets, but only the moved vertices. */
static int gather_targets(const struct fixed_skin *skin, int target_count,
	struct model_target *out, struct arena *arena)
{
	int error = 0;

	for (int t = 0; t < target_count && !error; t++) {
		const struct model_target *from = &skin->primitive->target[t];

		error = gather_deltas(
			skin, &from->position, &out[t].position, arena);
		if (!error) {
			error = gather_deltas(
				skin, &from->normal, &out[t].normal, arena);
		}
		if (!error) {
			error = gather_deltas(
				skin, &from->tangent, &out[t].tangent, arena);
		}
	}
	return error;
}

static int make_deltas(struct fixed_skin *skin, int target_count,
	struct arena *scratch, struct arena *arena)
{
	struct fixed_skin_targets *targets = &skin->targets;
	struct model_target *target =
		ARENA_ARRAY(scratch, struct model_target, (size_t)target_count);
	void *zero = arena_alloc(
		arena, (size_t)targets->moved_count, sizeof(float[4]));
	int error = target && zero ? 0 : -ENOMEM;

	if (!error) {
		error = gather_targets(skin, target_count, target, scratch);
	}
	if (error) {
		return error;
	}
	targets->zero = (struct model_primitive){
		.vertex_count = targets->moved_count,
		.position = zero,
		.normal = zero,
		.tangent = zero,
		.target = target,
	};
	measure_deltas(targets, target_count);
	error = fixed_morph_init(&targets->deltas, &targets->zero, target_count,
		(skin->base[FIXED_NORMAL] ? FIXED_NORMALS : 0u) |
			(skin->base[FIXED_TANGENT] ? FIXED_TANGENTS : 0u),
		arena);
	targets->zero.target = NULL;
	return error;
}

static int reserve(struct fixed_skin_targets *targets, int target_count,
	struct arena *arena)
{
	size_t moved = (size_t)targets->moved_count;

	targets->extent = arena_alloc(arena, moved, sizeof(*targets->extent));
	targets->delta = ARENA_ARRAY(arena, struct fixed_vector, moved);
	targets->weight = ARENA_ARRAY(arena, float, (size_t)target_count);
	return targets->extent && targets->delta && targets->weight ? 0
								    : -ENOMEM;
}

/*
 * Allocates rebase records for all influences of the moved vertices; with a cap
 * there are fewer.
 */
static int reserve_rebase(struct fixed_skin *skin, struct arena *arena)
{
	struct fixed_skin_targets *targets = &skin->targets;
	size_t count = 0;

	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		struct fixed_influences in;

		if (targets->moved[v]) {
			fixed_influences_gather(skin->primitive, v, 0, &in);
			count += (size_t)in.count;
		}
	}
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (!targets->deltas.stream[a].base) {
			continue;
		}
		targets->rebase[a] =
			ARENA_ARRAY(arena, struct fixed_rebase, count);
		if (!targets->rebase[a]) {
			return -ENOMEM;
		}
	}
	return 0;
}

int fixed_skin_init_targets(
	struct fixed_skin *skin, int target_count, struct arena *arena)
{
	struct arena scratch = arena_empty();
	int error = list_moved(skin, target_count, arena);

	if (!error) {
		error = reserve(&skin->targets, target_count, arena);
	}
	if (!error) {
		error = make_deltas(skin, target_count, &scratch, arena);
	}
	if (!error) {
		error = reserve_rebase(skin, arena);
	}
	arena_release(&scratch);
	return error;
}

/* The streams have been written, so base vectors contain no targets. */
static struct fixed_rebase make_rebase(const struct fixed_skin *skin,
	enum fixed_attribute attribute, int base_index, int delta_index,
	int weight_q14)
{
	float ratio = skin->scale[attribute] /
		skin->targets.deltas.stream[attribute].unit;

	return (struct fixed_rebase){
		.rest = skin->base[attribute][base_index],
		.base_index = (uint32_t)base_index,
		.delta_index = (uint16_t)delta_index,
		/* at most 32767, for a ratio of a half and a weight of 1 */
		.weight_q16 = fixed_round(65536.0f * ratio * (float)weight_q14 /
			FIXED_WEIGHT_ONE_Q14),
	};
}

static void write_rebase(struct fixed_skin *skin, int base_index,
	int delta_index, int weight_q14)
{
	struct fixed_skin_targets *targets = &skin->targets;

	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (targets->rebase[a]) {
			targets->rebase[a][targets->rebase_count] =
				make_rebase(skin, (enum fixed_attribute)a,
					base_index, delta_index, weight_q14);
		}
	}
	targets->rebase_count++;
}

void fixed_skin_write_rebase(struct fixed_skin *skin)
{
	struct fixed_skin_targets *targets = &skin->targets;

	targets->rebase_count = 0;
	for (int i = 0, first = 0; targets->moved && i < skin->vertex_count;
		i++) {
		uint32_t v = skin->order[i];
		struct fixed_influences in;

		fixed_influences_gather(
			skin->primitive, v, skin->max_influences, &in);
		fixed_influences_by_joint(&in);
		for (int k = 0; k < in.count && targets->moved[v]; k++) {
			write_rebase(skin, first + k, targets->moved[v] - 1,
				in.weight_q14[k]);
		}
		first += in.count;
	}
	for (int t = 0; t < targets->deltas.target_count; t++) {
		targets->weight[t] = 0;
	}
}
