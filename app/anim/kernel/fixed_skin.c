#include "app/anim/kernel/fixed_skin.h"

#include "app/anim/kernel/fixed_influences.h"
#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/fixed_skin_morph.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = SKIN_INFLUENCES_MAX,
	JOINTS_MAX = 2048,
	MATRIX_ONE = 28672, /* the step that unit matrices are scaled to */
	FINER_BITS = 2
};

/* What a vertex is to a sort: joints that move it, then by weight. */
struct sorted {
	uint32_t vertex;
	int count;
	uint16_t joint[WIDTH];   /* ascending */
	uint16_t heavier[WIDTH]; /* by descending weight */
};

static int compare_sorted(const void *left, const void *right)
{
	const struct sorted *a = left, *b = right;

	if (a->count != b->count) {
		return a->count < b->count ? -1 : 1;
	}
	for (int i = 0; i < a->count; i++) {
		if (a->joint[i] != b->joint[i]) {
			return a->joint[i] < b->joint[i] ? -1 : 1;
		}
	}
	for (int i = 0; i < a->count; i++) {
		if (a->heavier[i] != b->heavier[i]) {
			return a->heavier[i] < b->heavier[i] ? -1 : 1;
		}
	}
	return a->vertex < b->vertex ? -1 : 1;
}

/* Whether every cap leaves both the same joints. */
static bool alike(const struct sorted *a, const struct sorted *b)
{
	return a->count == b->count &&
		memcmp(a->heavier, b->heavier,
			(size_t)a->count * sizeof(a->heavier[0])) == 0;
}

/* Room for the runs at any cap. */
static size_t count_run_words(const struct sorted *list, size_t count)
{
	size_t words = 0;

	for (size_t i = 0; i < count; i++) {
		if (i == 0 || !alike(&list[i - 1], &list[i])) {
			words += 1 + (size_t)list[i].count;
		}
	}
	return words;
}

/*
 * Fills order and place, and makes room for runs. The scratch list is the C
 * library's, for a moment.
 */
static int sort_vertices(struct fixed_skin *skin, struct arena *arena)
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
		memcpy(list[v].heavier, in.joint, sizeof(in.joint));
		fixed_influences_by_joint(&in);
		memcpy(list[v].joint, in.joint, sizeof(in.joint));
	}
	qsort(list, count, sizeof(*list), compare_sorted);
	for (uint32_t i = 0; i < count; i++) {
		skin->order[i] = list[i].vertex;
		skin->inverse_order[list[i].vertex] = i;
	}
	skin->run = ARENA_ARRAY(arena, int32_t, count_run_words(list, count));
	free(list);
	return skin->run ? 0 : -ENOMEM;
}

/* Joint numbers of the primitive to places in joint[]; the boxes come later. */
static int list_joints(struct fixed_skin *skin, struct arena *arena)
{
	const struct model_primitive *primitive = skin->primitive;
	size_t entries =
		(size_t)skin->vertex_count * (size_t)primitive->influences;
	size_t top = 0;

	for (size_t i = 0; i < entries; i++) {
		top = primitive->joint[i] >= top ? primitive->joint[i] + 1u
						 : top;
	}
	skin->slot = ARENA_ARRAY(arena, uint16_t, top);
	if (!skin->slot) {
		return -ENOMEM;
	}
	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		struct fixed_influences in;

		fixed_influences_gather(primitive, v, 0, &in);
		for (int i = 0; i < in.count; i++) {
			skin->slot[in.joint[i]] = 1;
		}
	}
	for (size_t j = 0; j < top; j++) {
		skin->joint_count += skin->slot[j];
	}
	if (skin->joint_count > JOINTS_MAX) {
		return -ERANGE;
	}
	skin->joint = ARENA_ARRAY(
		arena, struct fixed_joint, (size_t)skin->joint_count);
	if (!skin->joint) {
		return -ENOMEM;
	}
	for (size_t j = 0, next = 0; j < top; j++) {
		if (skin->slot[j]) {
			skin->joint[next].joint = (int)j;
			skin->slot[j] = (uint16_t)next++;
		}
	}
	return 0;
}

static bool positions_are_usable(const struct model_primitive *primitive)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			if (!fixed_can_use(primitive->position[v][axis])) {
				return false;
			}
		}
	}
	return true;
}

/* The box around the vertices of each joint, at the present cap. */
static void measure_joints(struct fixed_skin *skin)
{
	const struct model_primitive *primitive = skin->primitive;

	for (int j = 0; j < skin->joint_count; j++) {
		for (int axis = 0; axis < 3; axis++) {
			skin->joint[j].middle[axis] = 1e30f;
			skin->joint[j].half[axis] = -1e30f;
		}
	}
	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		const float *at = primitive->position[v];
		const float *grow = fixed_skin_growth(skin, v);
		struct fixed_influences in;

		fixed_influences_gather(primitive, v, skin->max_influences, &in);
		for (int i = 0; i < in.count * 3; i++) {
			struct fixed_joint *joint =
				&skin->joint[skin->slot[in.joint[i / 3]]];
			float low = at[i % 3] - grow[i % 3];
			float high = at[i % 3] + grow[i % 3];

			if (low < joint->middle[i % 3]) {
				joint->middle[i % 3] = low;
			}
			if (high > joint->half[i % 3]) {
				joint->half[i % 3] = high;
			}
		}
	}
	for (int i = 0; i < skin->joint_count * 3; i++) {
		struct fixed_joint *joint = &skin->joint[i / 3];
		float low = joint->middle[i % 3];
		float high = joint->half[i % 3];

		joint->used = high >= low;
		joint->middle[i % 3] = joint->used ? 0.5f * (low + high) : 0.0f;
		joint->half[i % 3] = joint->used ? 0.5f * (high - low) : 0.0f;
	}
}

static float largest(float a, float b)
{
	return a > b ? a : b;
}

/* The largest coordinate of any base vector, before scaling. */
static float measure_bases(const struct fixed_skin *skin)
{
	const struct model_primitive *primitive = skin->primitive;
	float size = 0.0f;

	for (uint32_t v = 0; v < (uint32_t)skin->vertex_count; v++) {
		const float *grow = fixed_skin_growth(skin, v);
		struct fixed_influences in;

		fixed_influences_gather(primitive, v, skin->max_influences, &in);
		for (int i = 0; i < in.count * 3; i++) {
			const struct fixed_joint *joint =
				&skin->joint[skin->slot[in.joint[i / 3]]];
			float away = primitive->position[v][i % 3] -
				joint->middle[i % 3];

			away = (away < 0.0f ? -away : away) + grow[i % 3];
			size = largest(size,
				away * (float)in.weight_q14[i / 3] /
					FIXED_WEIGHT_ONE_Q14);
		}
	}
	return size;
}

/* Half the larger sides of the boxes around all vertices, and all middles. */
static void measure_bind_pose(
	const struct fixed_skin *skin, float *vertices, float *middles)
{
	*vertices = *middles = 0.0f;
	for (int axis = 0; axis < 3; axis++) {
		float low = 1e30f, high = -1e30f, from = 1e30f, to = -1e30f;

		for (int j = 0; j < skin->joint_count; j++) {
			float at = skin->joint[j].middle[axis];
			float half = skin->joint[j].half[axis];

			if (!skin->joint[j].used) {
				continue;
			}
			low = at - half < low ? at - half : low;
			high = largest(high, at + half);
			from = at < from ? at : from;
			to = largest(to, at);
		}
		*vertices = largest(*vertices, 0.5f * (high - low));
		*middles = largest(*middles, 0.5f * (to - from));
	}
}

/*
 * Such that the bind pose, a quarter larger, fills the output when 1 is
 * MATRIX_ONE in the matrices, or a half or a quarter of that where the base
 * vectors are small enough: both have then the same share of 16 bits.
 */
static float choose_scale(const struct fixed_skin *skin)
{
	const float per_output = 65536.0f / MATRIX_ONE;
	float vertices, middles, most, rest;
	float scale = 32766.0f / largest(measure_bases(skin), 1e-12f);

	measure_bind_pose(skin, &vertices, &middles);
	most = per_output * 32767.0f / largest(1.25f * vertices, 1e-12f);
	rest = per_output * 16383.0f / largest(1.25f * middles, 1e-12f);
	most = rest < most ? rest : most;
	rest = fixed_skin_scale_limit(skin, FIXED_POSITION);
	scale = rest < scale ? rest : scale;
	for (int i = 0; i < FINER_BITS && most * 2.0f <= scale; i++) {
		most *= 2.0f;
	}
	return scale < most ? scale : most;
}

static void write_base(const float v[3], const float middle[3], float scale,
	int weight_q14, struct fixed_base *out)
{
	float weight = scale * (float)weight_q14 / FIXED_WEIGHT_ONE_Q14;

	out->x = fixed_round((v[0] - middle[0]) * weight);
	out->y = fixed_round((v[1] - middle[1]) * weight);
	out->z = fixed_round((v[2] - middle[2]) * weight);
}

static void write_direction(
	const float *v, float scale, int weight_q14, struct fixed_base *out)
{
	static const float origin[3] = {0, 0, 0};

	write_base(v, origin, scale, weight_q14, out);
	out->w = 0;
}

static void write_vertex(struct fixed_skin *skin, uint32_t vertex,
	const struct fixed_influences *in, size_t at)
{
	const struct model_primitive *primitive = skin->primitive;

	for (int i = 0; i < in->count; i++, at++) {
		int weight = in->weight_q14[i];

		write_base(primitive->position[vertex],
			skin->joint[skin->slot[in->joint[i]]].middle,
			skin->position_scale, weight, &skin->position[at]);
		/* -1 fits where 1 would not. */
		skin->position[at].w = (int16_t)(-2 * weight);
		if (skin->normal) {
			write_direction(primitive->normal[vertex],
				skin->normal_scale, weight, &skin->normal[at]);
		}
		if (skin->tangent) {
			write_direction(primitive->tangent[vertex],
				skin->tangent_scale, weight, &skin->tangent[at]);
		}
	}
}

static struct fixed_group *last_group(struct fixed_skin *skin)
{
	return &skin->group[skin->group_count - 1];
}

/* Extends the last run by a vertex or begins another one. */
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
			skin->slot[in->joint[i]] *
				(int32_t)sizeof(struct fixed_matrix);
	}
	if (same) {
		last[0]++;
		return last;
	}
	last_group(skin)->run_count++;
	end[0] = 1;
	for (int i = 0; i < in->count; i++) {
		end[1 + i] = skin->slot[in->joint[i]] *
			(int32_t)sizeof(struct fixed_matrix);
	}
	return end;
}

/* Runs and base vectors, in the order that is there. */
static void write_streams(struct fixed_skin *skin)
{
	int32_t *last = NULL, *end = skin->run;

	skin->group_count = 0;
	skin->influence_count = 0;
	for (int i = 0; i < skin->vertex_count; i++) {
		struct fixed_influences in;
		int32_t *run;

		fixed_influences_gather(skin->primitive, skin->order[i],
			skin->max_influences, &in);
		fixed_influences_by_joint(&in);
		run = extend_run(skin, &in, last, end);
		if (run == end) {
			end += 1 + in.count;
		}
		last = run;
		write_vertex(skin, skin->order[i], &in,
			(size_t)skin->influence_count);
		skin->influence_count += in.count;
	}
}

void fixed_skin_lay_out(struct fixed_skin *skin, int max_influences)
{
	skin->max_influences = max_influences;
	measure_joints(skin);
	skin->position_scale = choose_scale(skin);
	skin->normal_scale = fixed_skin_scale_limit(skin, FIXED_NORMAL);
	skin->tangent_scale = fixed_skin_scale_limit(skin, FIXED_TANGENT);
	write_streams(skin);
	if (skin->morph) {
		fixed_skin_morph_lay_out(skin->morph);
	}
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
	/* One more than there are: loops load ahead. */
	size_t count = (size_t)count_influences(skin) + 1;

	skin->order = ARENA_ARRAY(arena, uint32_t, vertices);
	skin->inverse_order = ARENA_ARRAY(arena, uint32_t, vertices);
	skin->position = ARENA_ARRAY(arena, struct fixed_base, count);
	if (!skin->order || !skin->inverse_order || !skin->position) {
		return -ENOMEM;
	}
	if (streams & FIXED_NORMALS) {
		skin->normal = ARENA_ARRAY(arena, struct fixed_base, count);
		if (!skin->normal) {
			return -ENOMEM;
		}
	}
	if (streams & FIXED_TANGENTS) {
		skin->tangent = ARENA_ARRAY(arena, struct fixed_base, count);
		if (!skin->tangent) {
			return -ENOMEM;
		}
	}
	return 0;
}

int fixed_skin_init(struct fixed_skin *skin,
	const struct model_primitive *primitive, unsigned streams,
	struct arena *arena)
{
	int error;

	*skin = (struct fixed_skin){
		.primitive = primitive,
		.vertex_count = primitive->vertex_count,
	};
	if (!positions_are_usable(primitive)) {
		return -ERANGE;
	}
	error = list_joints(skin, arena);
	if (!error) {
		error = reserve(skin, streams, arena);
	}
	if (!error) {
		error = sort_vertices(skin, arena);
	}
	if (!error) {
		fixed_skin_lay_out(skin, 0);
	}
	return error;
}

void fixed_skin_set_cap(struct fixed_skin *skin, int max_influences)
{
	int cap = max_influences < WIDTH ? max_influences : 0;

	if (cap != skin->max_influences) {
		fixed_skin_lay_out(skin, cap);
	}
}

size_t fixed_skin_bytes(const struct fixed_skin *skin)
{
	size_t streams = 1u + (skin->normal != NULL) + (skin->tangent != NULL);
	size_t bytes = (size_t)skin->influence_count * streams *
		sizeof(struct fixed_base);

	for (int g = 0; g < skin->group_count; g++) {
		size_t each = 1 + (size_t)skin->group[g].influences;

		bytes += each * (size_t)skin->group[g].run_count *
			sizeof(int32_t);
	}
	return bytes + (size_t)skin->vertex_count * 2 * sizeof(uint32_t) +
		(size_t)skin->joint_count * sizeof(struct fixed_joint);
}
