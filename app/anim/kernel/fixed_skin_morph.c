#include "app/anim/kernel/fixed_skin_morph.h"

#include "app/anim/kernel/fixed_influences.h"
#include "app/anim/kernel/fixed_number.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	MOVED_MAX = 65535
};

static const float nowhere[3] = {0, 0, 0};

const float *fixed_skin_growth(const struct fixed_skin *skin, uint32_t vertex)
{
	const struct fixed_skin_morph *morph = skin->morph;

	return morph && morph->moved[vertex]
		? morph->grow[morph->moved[vertex] - 1]
		: nowhere;
}

/*
 * Directions with all their deltas have to fit, and rebase() has room for
 * weights up to a half: what targets move is counted at least twice as fine.
 */
float fixed_skin_scale_limit(
	const struct fixed_skin *skin, enum fixed_attribute attribute)
{
	const struct fixed_skin_morph *morph = skin->morph;
	float limit = attribute == FIXED_POSITION ? 1e18f : 32767.0f;
	float unit;

	if (!morph || !morph->rebase[attribute]) {
		return limit;
	}
	unit = morph->deltas.stream[attribute].unit;
	limit = 0.5f * unit < limit ? 0.5f * unit : limit;
	if (attribute != FIXED_POSITION) {
		float reach = morph->deltas.reach;
		float fits =
			32766.0f / (1.0f + reach * morph->largest[attribute]);

		limit = fits < limit ? fits : limit;
	}
	return limit;
}

static const float (*deltas_of(
	const struct model_target *target, enum fixed_attribute attribute))[3]
{
	return (const float(*)[3])(attribute == FIXED_POSITION ? target->position
			: attribute == FIXED_NORMAL            ? target->normal
						    : target->tangent);
}

static bool is_moved(
	const struct model_primitive *primitive, int target_count, int vertex)
{
	for (int i = 0; i < target_count * FIXED_ATTRIBUTES; i++) {
		const float(*delta)[3] =
			deltas_of(&primitive->target[i / FIXED_ATTRIBUTES],
				(enum fixed_attribute)(i % FIXED_ATTRIBUTES));

		if (delta &&
			(delta[vertex][0] != 0.0f || delta[vertex][1] != 0.0f ||
				delta[vertex][2] != 0.0f)) {
			return true;
		}
	}
	return false;
}

static int list_moved(
	struct fixed_skin_morph *morph, int target_count, struct arena *arena)
{
	const struct fixed_skin *skin = morph->skin;

	morph->moved = ARENA_ARRAY(arena, uint16_t, (size_t)skin->vertex_count);
	if (!morph->moved) {
		return -ENOMEM;
	}
	for (int v = 0; v < skin->vertex_count; v++) {
		if (!is_moved(skin->primitive, target_count, v)) {
			continue;
		}
		if (morph->moved_count == MOVED_MAX) {
			return -ERANGE;
		}
		morph->moved[v] = (uint16_t)++morph->moved_count;
	}
	return 0;
}

/* The moved vertices' deltas one after the other; NULL stays NULL. */
static int gather_deltas(const struct fixed_skin_morph *morph,
	const float (*from)[3], float (**out)[3], struct arena *arena)
{
	*out = NULL;
	if (!from) {
		return 0;
	}
	*out = arena_alloc(arena, (size_t)morph->moved_count, sizeof(**out));
	if (!*out) {
		return -ENOMEM;
	}
	for (int v = 0; v < morph->skin->vertex_count; v++) {
		if (morph->moved[v]) {
			memcpy((*out)[morph->moved[v] - 1], from[v],
				sizeof(**out));
		}
	}
	return 0;
}

/* Over all targets, a vertex's way along each axis. */
static void measure_growth(struct fixed_skin_morph *morph, int target_count)
{
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		for (int m = 0; m < morph->moved_count * 3; m++) {
			float way = 0.0f;

			for (int t = 0; t < target_count; t++) {
				const float(*delta)[3] =
					deltas_of(&morph->still.target[t],
						(enum fixed_attribute)a);

				way += delta ? scalar_abs(delta[m / 3][m % 3])
					     : 0.0f;
			}
			if (a == FIXED_POSITION) {
				morph->grow[m / 3][m % 3] = way;
			}
			morph->largest[a] = way > morph->largest[a]
				? way
				: morph->largest[a];
		}
	}
}

static unsigned streams_of(const struct fixed_skin *skin)
{
	return (skin->normal ? FIXED_NORMALS : 0u) |
		(skin->tangent ? FIXED_TANGENTS : 0u);
}

static int make_deltas(struct fixed_skin_morph *morph, int target_count,
	struct arena *scratch, struct arena *arena)
{
	const struct model_primitive *primitive = morph->skin->primitive;
	struct model_target *target =
		ARENA_ARRAY(scratch, struct model_target, (size_t)target_count);
	void *zero = arena_alloc(
		arena, (size_t)morph->moved_count, sizeof(float[4]));
	int error = target && zero ? 0 : -ENOMEM;

	for (int t = 0; t < target_count && !error; t++) {
		const struct model_target *from = &primitive->target[t];

		error = gather_deltas(morph, (const float(*)[3])from->position,
			&target[t].position, scratch);
		if (!error) {
			error = gather_deltas(morph,
				(const float(*)[3])from->normal,
				&target[t].normal, scratch);
		}
		if (!error) {
			error = gather_deltas(morph,
				(const float(*)[3])from->tangent,
				&target[t].tangent, scratch);
		}
	}
	if (error) {
		return error;
	}
	morph->still = (struct model_primitive){
		.vertex_count = morph->moved_count,
		.position = zero,
		.normal = zero,
		.tangent = zero,
		.target = target,
	};
	measure_growth(morph, target_count);
	error = fixed_morph_init(&morph->deltas, &morph->still, target_count,
		streams_of(morph->skin), arena);
	morph->still.target = NULL;
	return error;
}

/* At the present cap; the most there can be is without one. */
static int count_moved_influences(const struct fixed_skin_morph *morph)
{
	const struct fixed_skin *skin = morph->skin;
	int count = 0;

	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		struct fixed_influences in;

		if (morph->moved[v]) {
			fixed_influences_gather(skin->primitive, v, 0, &in);
			count += in.count;
		}
	}
	return count;
}

static int reserve(
	struct fixed_skin_morph *morph, int target_count, struct arena *arena)
{
	size_t moved = (size_t)morph->moved_count;

	morph->grow = arena_alloc(arena, moved, sizeof(*morph->grow));
	morph->delta = ARENA_ARRAY(arena, struct fixed_vector, moved);
	morph->weight = ARENA_ARRAY(arena, float, (size_t)target_count);
	return morph->grow && morph->delta && morph->weight ? 0 : -ENOMEM;
}

static int reserve_rebase(struct fixed_skin_morph *morph, struct arena *arena)
{
	size_t count = (size_t)count_moved_influences(morph);

	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (!morph->deltas.stream[a].base) {
			continue;
		}
		morph->rebase[a] =
			ARENA_ARRAY(arena, struct fixed_rebase, count);
		if (!morph->rebase[a]) {
			return -ENOMEM;
		}
	}
	return 0;
}

int fixed_skin_morph_init(struct fixed_skin_morph *morph,
	struct fixed_skin *skin, int target_count, struct arena *arena)
{
	struct arena scratch = arena_empty();
	int error;

	*morph = (struct fixed_skin_morph){.skin = skin};
	error = list_moved(morph, target_count, arena);
	if (!error) {
		error = reserve(morph, target_count, arena);
	}
	if (!error) {
		error = make_deltas(morph, target_count, &scratch, arena);
	}
	if (!error) {
		error = reserve_rebase(morph, arena);
	}
	arena_release(&scratch);
	if (!error) {
		skin->morph = morph;
		fixed_skin_lay_out(skin, skin->max_influences);
	}
	return error;
}

static struct fixed_base *bases_of(
	const struct fixed_skin *skin, enum fixed_attribute attribute)
{
	return attribute == FIXED_POSITION  ? skin->position
		: attribute == FIXED_NORMAL ? skin->normal
					    : skin->tangent;
}

static float scale_of(
	const struct fixed_skin *skin, enum fixed_attribute attribute)
{
	return attribute == FIXED_POSITION  ? skin->position_scale
		: attribute == FIXED_NORMAL ? skin->normal_scale
					    : skin->tangent_scale;
}

/* The base vectors are those without any target. */
static void write_rebase(struct fixed_skin_morph *morph,
	enum fixed_attribute attribute, int at, int moved, int weight_q14,
	struct fixed_rebase *out)
{
	const struct fixed_skin *skin = morph->skin;
	float ratio = scale_of(skin, attribute) /
		morph->deltas.stream[attribute].unit;

	*out = (struct fixed_rebase){
		.rest = bases_of(skin, attribute)[at],
		.at = (uint32_t)at,
		.moved = (uint16_t)moved,
		/* A ratio of a half and all the weight: clamped to 32767. */
		.weight_q16 = fixed_round(65536.0f * ratio * (float)weight_q14 /
			FIXED_WEIGHT_ONE_Q14),
	};
}

void fixed_skin_morph_lay_out(struct fixed_skin_morph *morph)
{
	const struct fixed_skin *skin = morph->skin;
	int count = 0;

	for (int i = 0, at = 0; i < skin->vertex_count; i++) {
		uint32_t v = skin->order[i];
		struct fixed_influences in;

		fixed_influences_gather(
			skin->primitive, v, skin->max_influences, &in);
		fixed_influences_by_joint(&in);
		for (int k = 0; k < in.count && morph->moved[v]; k++, count++) {
			for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
				if (morph->rebase[a]) {
					write_rebase(morph,
						(enum fixed_attribute)a, at + k,
						morph->moved[v] - 1,
						in.weight_q14[k],
						&morph->rebase[a][count]);
				}
			}
		}
		at += in.count;
	}
	morph->rebase_count = count;
	memset(morph->weight, 0,
		(size_t)morph->deltas.target_count * sizeof(*morph->weight));
}

int fixed_skin_morph_update(struct fixed_skin_morph *morph,
	const struct fixed_loops *loops, const float *weight)
{
	size_t size =
		(size_t)morph->deltas.target_count * sizeof(*morph->weight);
	float reach = morph->deltas.reach;
	int error;

	if (memcmp(morph->weight, weight, size) == 0) {
		return 0;
	}
	error = fixed_morph_set_weights(&morph->deltas, weight);
	if (error) {
		return error;
	}
	if (morph->deltas.reach > reach) {
		for (int i = 0; i < morph->moved_count * 3; i++) {
			morph->grow[i / 3][i % 3] *= morph->deltas.reach / reach;
		}
		fixed_skin_lay_out(morph->skin, morph->skin->max_influences);
	}
	memcpy(morph->weight, weight, size);
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (morph->rebase[a]) {
			fixed_morph_run(&morph->deltas, loops,
				(enum fixed_attribute)a, morph->delta);
			loops->rebase(morph->rebase_count, morph->rebase[a],
				morph->delta,
				bases_of(morph->skin, (enum fixed_attribute)a));
		}
	}
	return 0;
}
