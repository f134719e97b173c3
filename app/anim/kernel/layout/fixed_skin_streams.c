#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/layout/fixed_attribute.h"
#include "app/anim/kernel/layout/fixed_skin_parts.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = SKIN_INFLUENCES_MAX
};

/* The sort key of a vertex. */
struct sorted {
	uint32_t vertex;
	int tier;
	int count;
	uint16_t joint[WIDTH];     /* ascending */
	uint16_t by_weight[WIDTH]; /* the same joints, heaviest first */
};

static int compare_sorted(const void *left, const void *right)
{
	const struct sorted *a = left, *b = right;

	if (a->tier != b->tier) {
		return a->tier < b->tier ? -1 : 1;
	}
	if (a->count != b->count) {
		return a->count < b->count ? -1 : 1;
	}
	for (int i = 0; i < a->count; i++) {
		if (a->joint[i] != b->joint[i]) {
			return a->joint[i] < b->joint[i] ? -1 : 1;
		}
	}
	for (int i = 0; i < a->count; i++) {
		if (a->by_weight[i] != b->by_weight[i]) {
			return a->by_weight[i] < b->by_weight[i] ? -1 : 1;
		}
	}
	return a->vertex < b->vertex ? -1 : 1;
}

/*
 * Whether two neighbours of the sorted list are in one run with any cap: then
 * their heaviest joints are the same too.
 */
static bool same_run_at_any_cap(const struct sorted *a, const struct sorted *b)
{
	return a->tier == b->tier && a->count == b->count &&
		memcmp(a->by_weight, b->by_weight,
			(size_t)a->count * sizeof(a->by_weight[0])) == 0;
}

/* Returns a number of words that is enough for the runs of any cap. */
static size_t count_run_words(const struct sorted *list, size_t count)
{
	size_t words = 0;

	for (size_t i = 0; i < count; i++) {
		if (i == 0 || !same_run_at_any_cap(&list[i - 1], &list[i])) {
			words += 1 + (size_t)list[i].count;
		}
	}
	return words;
}

/* Moves a triangle list's vertices to a tier, if that is earlier. */
static void put_into_tier(
	struct sorted *sorted, const uint32_t *index, int index_count, int tier)
{
	for (int i = 0; i < index_count; i++) {
		struct sorted *vertex = &sorted[index[i]];

		vertex->tier = tier < vertex->tier ? tier : vertex->tier;
	}
}

/*
 * Counts how often the number of triangles falls to a quarter on the way from
 * the full list to a level. Each time begins a tier; more tiers would make runs
 * shorter.
 */
static int count_quarterings(const struct model_primitive *primitive, int level)
{
	int mark = primitive->index_count, count = 0;

	for (int i = 0; i < level; i++) {
		if (primitive->lod[i].index_count <= mark / 4) {
			mark = primitive->lod[i].index_count;
			count++;
		}
	}
	return count < FIXED_SKIN_TIERS_MAX - 1 ? count
						: FIXED_SKIN_TIERS_MAX - 1;
}

int fixed_skin_tier_of(const struct fixed_skin *skin, int level)
{
	int last = skin->tier_count - 1;
	int count = count_quarterings(skin->primitive, level);

	return count < last ? last - count : 0;
}

/* Sets tier_count and sorted[].tier, in the primitive's order. */
static void choose_tiers(struct fixed_skin *skin, struct sorted *sorted)
{
	const struct model_primitive *primitive = skin->primitive;

	skin->tier_count = 1 +
		count_quarterings(primitive, model_lod_of_size(primitive, 0));
	for (int v = 0; v < skin->vertex_count; v++) {
		sorted[v].tier = skin->tier_count - 1;
	}
	for (int i = 0; i < primitive->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];
		int level = lod->shadow_only
			? model_lod_of_size(primitive, lod->index_count)
			: i + 1;

		put_into_tier(sorted, lod->index, lod->index_count,
			fixed_skin_tier_of(skin, level));
		for (int k = 0; lod->corner && k < lod->index_count; k++) {
			put_into_tier(sorted,
				primitive->index + lod->corner[k] / 3 * 3, 3,
				fixed_skin_tier_of(skin, level));
		}
	}
}

/*
 * Fills in order[], inverse_order[], tier_count and vertex_count_to[] and
 * allocates the runs. Returns 0 or -ENOMEM.
 */
static int sort_vertices(
	struct fixed_skin *skin, bool in_tiers, struct arena *arena)
{
	size_t count = (size_t)skin->vertex_count;
	struct sorted *list = calloc(count ? count : 1, sizeof(*list));

	if (!list) {
		return -ENOMEM;
	}
	for (uint32_t v = 0; v < count; v++) {
		struct fixed_influences in;

		fixed_influences_gather(skin->primitive, v, 0, &in);
		list[v].vertex = v;
		list[v].count = in.count;
		memcpy(list[v].by_weight, in.joint, sizeof(in.joint));
		fixed_influences_by_joint(&in);
		memcpy(list[v].joint, in.joint, sizeof(in.joint));
	}
	skin->tier_count = 1;
	if (in_tiers) {
		choose_tiers(skin, list);
	}
	qsort(list, count, sizeof(*list), compare_sorted);
	for (uint32_t i = 0; i < count; i++) {
		skin->order[i] = list[i].vertex;
		skin->inverse_order[list[i].vertex] = i;
		skin->vertex_count_to[list[i].tier] = (int)i + 1;
	}
	for (int t = 1; t < skin->tier_count; t++) {
		if (skin->vertex_count_to[t] == 0) {
			skin->vertex_count_to[t] = skin->vertex_count_to[t - 1];
		}
	}
	skin->run = ARENA_ARRAY(arena, int32_t, count_run_words(list, count));
	free(list);
	return skin->run ? 0 : -ENOMEM;
}

static int count_influences(const struct fixed_skin *skin)
{
	int count = 0;

	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		struct fixed_influences in;

		fixed_influences_gather(skin->primitive, v, 0, &in);
		count += in.count;
	}
	return count;
}

static int reserve(
	struct fixed_skin *skin, unsigned streams, struct arena *arena)
{
	size_t vertices = (size_t)skin->vertex_count;
	/* One more than there are, since the loops load one too many. */
	size_t count = (size_t)count_influences(skin) + 1;

	skin->order = ARENA_ARRAY(arena, uint32_t, vertices);
	skin->inverse_order = ARENA_ARRAY(arena, uint32_t, vertices);
	if (!skin->order || !skin->inverse_order) {
		return -ENOMEM;
	}
	for (unsigned a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (a != FIXED_POSITION && !(streams & 1u << a)) {
			continue;
		}
		skin->base[a] = ARENA_ARRAY(arena, struct fixed_base, count);
		if (!skin->base[a]) {
			return -ENOMEM;
		}
	}
	return 0;
}

int fixed_skin_init_streams(
	struct fixed_skin *skin, unsigned streams, struct arena *arena)
{
	int error = reserve(skin, streams, arena);

	return error ? error
		     : sort_vertices(skin, (streams & FIXED_TIERS) != 0, arena);
}

/* Makes the base vector of one influence of a vertex. */
static struct fixed_base make_base(const struct fixed_skin *skin,
	enum fixed_attribute attribute, uint32_t vertex, uint16_t joint,
	int weight_q14)
{
	static const float origin[3] = {0, 0, 0};
	const float *v = fixed_attribute_of(skin->primitive, attribute, vertex);
	const float *middle = attribute == FIXED_POSITION
		? skin->joint[skin->joint_slot[joint]].middle
		: origin;
	float weight = skin->scale[attribute] * (float)weight_q14 /
		FIXED_WEIGHT_ONE_Q14;

	return (struct fixed_base){
		.x = fixed_round((v[0] - middle[0]) * weight),
		.y = fixed_round((v[1] - middle[1]) * weight),
		.z = fixed_round((v[2] - middle[2]) * weight),
		/* -weight in Q15, which can hold -1 but not 1 */
		.w = attribute == FIXED_POSITION ? (int16_t)(-2 * weight_q14)
						 : 0,
	};
}

static void write_influence(struct fixed_skin *skin, uint32_t vertex,
	uint16_t joint, int weight_q14)
{
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (skin->base[a]) {
			skin->base[a][skin->influence_count] =
				make_base(skin, (enum fixed_attribute)a, vertex,
					joint, weight_q14);
		}
	}
	skin->influence_count++;
}

static struct fixed_group *last_group(struct fixed_skin *skin)
{
	return &skin->group[skin->group_count - 1];
}

/*
 * Adds a vertex to the run `last` or, if its joints differ, begins another run
 * at end. A new group begins if the number of influences changes, and for the
 * first vertex of a tier, where last is NULL. Returns the vertex's run.
 */
static int32_t *extend_run(struct fixed_skin *skin,
	const struct fixed_influences *in, int32_t *last, int32_t *end)
{
	bool same = last && last_group(skin)->influences == in->count;

	if (!same) {
		skin->group[skin->group_count++] =
			(struct fixed_group){in->count, 0, end};
	}
	for (int i = 0; same && i < in->count; i++) {
		same = last[1 + i] ==
			skin->joint_slot[in->joint[i]] *
				(int32_t)sizeof(struct fixed_matrix);
	}
	if (same) {
		last[0]++;
		return last;
	}
	last_group(skin)->run_count++;
	end[0] = 1;
	for (int i = 0; i < in->count; i++) {
		end[1 + i] = skin->joint_slot[in->joint[i]] *
			(int32_t)sizeof(struct fixed_matrix);
	}
	return end;
}

void fixed_skin_write_streams(struct fixed_skin *skin)
{
	int32_t *last = NULL, *end = skin->run;
	int tier = 0;

	skin->group_count = 0;
	skin->influence_count = 0;
	for (int i = 0; i < skin->vertex_count; i++) {
		struct fixed_influences in;

		for (; i == skin->vertex_count_to[tier]; tier++) {
			skin->group_count_to[tier] = skin->group_count;
			last = NULL;
		}

		fixed_influences_gather(skin->primitive, skin->order[i],
			skin->max_influences, &in);
		fixed_influences_by_joint(&in);
		last = extend_run(skin, &in, last, end);
		if (last == end) {
			end += 1 + in.count;
		}
		for (int k = 0; k < in.count; k++) {
			write_influence(skin, skin->order[i], in.joint[k],
				in.weight_q14[k]);
		}
	}
	for (; tier < skin->tier_count; tier++) {
		skin->group_count_to[tier] = skin->group_count;
	}
}
