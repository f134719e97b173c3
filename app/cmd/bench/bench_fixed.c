#include "app/anim/kernel/layout/fixed_key.h"
#include "app/anim/kernel/layout/fixed_keys.h"
#include "app/anim/kernel/layout/fixed_morph.h"
#include "app/anim/kernel/layout/fixed_skin.h"
#include "app/anim/kernel/run/fixed_lerp.h"
#include "app/anim/kernel/run/fixed_morph_run.h"
#include "app/anim/kernel/run/fixed_palette.h"
#include "app/cmd/bench/bench_job.h"

#include <errno.h>

struct fixed_state {
	const struct fixed_loops *loops;
	const struct bench_mesh *mesh;
	struct fixed_skin skin;
	struct fixed_matrix *matrix;
	struct fixed_placement placement;
	struct fixed_vector *posed[FIXED_ATTRIBUTES];

	struct fixed_pair (*pair[2])[3]; /* positions, normals */
	struct fixed_key *key[2];
	struct fixed_vector *step;
	struct model_primitive morphed; /* the primitive with its targets */
	struct fixed_morph morph;
};

static void skin_stream(struct fixed_state *s, const struct fixed_base *base,
	struct fixed_vector *posed)
{
	s->loops->skin(
		s->skin.group, s->skin.group_count, base, s->matrix, posed);
}

static void skin(void *user)
{
	struct fixed_state *s = user;

	if (s->mesh->is_model) {
		fixed_palette_make(&s->skin, (const mat4 *)s->mesh->palette,
			s->matrix, &s->placement);
	}
	skin_stream(s, s->skin.base[FIXED_POSITION], s->posed[0]);
}

static void skin_normals(void *user)
{
	struct fixed_state *s = user;

	skin(user);
	skin_stream(s, s->skin.base[FIXED_NORMAL], s->posed[1]);
}

static void skin_tangents(void *user)
{
	struct fixed_state *s = user;

	skin_normals(user);
	skin_stream(s, s->skin.base[FIXED_TANGENT], s->posed[2]);
}

static void lerp(void *user)
{
	struct fixed_state *s = user;

	s->loops->lerp(s->mesh->primitive.vertex_count,
		(const struct fixed_pair(*)[3])s->pair[0],
		fixed_lerp_weights(0.3f), s->posed[FIXED_POSITION]);
}

static void lerp_normals(void *user)
{
	struct fixed_state *s = user;

	lerp(user);
	s->loops->lerp(s->mesh->primitive.vertex_count,
		(const struct fixed_pair(*)[3])s->pair[1],
		fixed_lerp_weights(0.3f), s->posed[FIXED_NORMAL]);
}

static void lerp_keys(void *user)
{
	struct fixed_state *s = user;

	s->loops->lerp_keys(s->mesh->primitive.vertex_count, s->key[0],
		s->key[1], fixed_lerp_weights(0.3f), s->posed[FIXED_POSITION]);
}

static void targets(void *user)
{
	struct fixed_state *s = user;

	fixed_morph_run(
		&s->morph, s->loops, FIXED_POSITION, s->posed[FIXED_POSITION]);
}

static void by_frames(void *user)
{
	struct fixed_state *s = user;

	s->loops->increment(s->mesh->primitive.vertex_count, s->step,
		s->posed[FIXED_POSITION]);
}

static struct fixed_vector *vectors(struct arena *arena, int count)
{
	return ARENA_ARRAY(arena, struct fixed_vector, (size_t)count);
}

/* Sets the steps of BENCH_BY_FRAMES: 15 frames from one key to the next. */
static void prepare_steps(struct fixed_state *state,
	const struct fixed_vector *from, const struct fixed_vector *to)
{
	for (int v = 0; v < state->mesh->primitive.vertex_count; v++) {
		state->step[v] = (struct fixed_vector){
			.x = (int16_t)((to[v].x - from[v].x) / 15),
			.y = (int16_t)((to[v].y - from[v].y) / 15),
			.z = (int16_t)((to[v].z - from[v].z) / 15),
		};
	}
}

static int prepare_keys(struct fixed_state *state, struct arena *arena)
{
	const struct bench_mesh *mesh = state->mesh;
	int count = mesh->primitive.vertex_count;
	const float(*from[2])[3] = {
		(const float(*)[3])mesh->primitive.position,
		(const float(*)[3])mesh->primitive.normal,
	};
	const float(*to[2])[3] = {
		(const float(*)[3])mesh->destiny,
		(const float(*)[3])mesh->destiny_normal,
	};
	struct fixed_vector *key[2] = {
		vectors(arena, count), vectors(arena, count)};
	struct fixed_range range = fixed_range_empty();
	int error;

	fixed_range_add(&range, count, from[0]);
	fixed_range_add(&range, count, to[0]);
	error = fixed_range_placement(&range, &state->placement);
	if (error) {
		return -ENOTSUP;
	}
	for (int i = 0; i < 2; i++) {
		state->pair[i] = arena_alloc(
			arena, (size_t)count, sizeof(struct fixed_pair[3]));
	}
	state->step = vectors(arena, count);
	if (!key[0] || !key[1] || !state->pair[0] || !state->pair[1] ||
		!state->step) {
		return -ENOMEM;
	}
	fixed_key_normals(count, from[1], key[0]);
	fixed_key_normals(count, to[1], key[1]);
	fixed_lerp_prepare(count, key[0], key[1], state->pair[1]);
	fixed_key_positions(count, from[0], &state->placement, key[0]);
	fixed_key_positions(count, to[0], &state->placement, key[1]);
	fixed_lerp_prepare(count, key[0], key[1], state->pair[0]);
	prepare_steps(state, key[0], key[1]);
	return 0;
}

static int prepare_lerp_keys(struct fixed_state *state, struct arena *arena)
{
	const struct bench_mesh *mesh = state->mesh;
	int count = mesh->primitive.vertex_count;
	const float(*position[2])[3] = {
		(const float(*)[3])mesh->primitive.position,
		(const float(*)[3])mesh->destiny,
	};
	struct fixed_range range = fixed_range_empty();

	fixed_range_add(&range, count, position[0]);
	fixed_range_add(&range, count, position[1]);
	if (fixed_range_placement(&range, &state->placement) != 0) {
		return -ENOTSUP;
	}
	for (int i = 0; i < 2; i++) {
		/* The loop may load one key vector more. */
		state->key[i] =
			ARENA_ARRAY(arena, struct fixed_key, (size_t)count + 1);
		if (!state->key[i]) {
			return -ENOMEM;
		}
		fixed_keys_convert(
			count, position[i], &state->placement, state->key[i]);
	}
	return 0;
}

static int prepare_targets(struct fixed_state *state, struct arena *arena)
{
	static const float weight[2] = {0.25f, 0.5f};
	int error;

	state->morphed = state->mesh->primitive;
	state->morphed.target = (struct model_target *)state->mesh->target;
	error = fixed_morph_init(&state->morph, &state->morphed, 2, 0, arena);
	if (!error) {
		error = fixed_morph_set_weights(&state->morph, weight);
	}
	return error == -ERANGE ? -ENOTSUP : error;
}

static int prepare_skin(
	struct fixed_state *state, enum bench_work work, struct arena *arena)
{
	static const unsigned streams[] = {
		[BENCH_SKIN] = 0,
		[BENCH_SKIN_NORMALS] = FIXED_NORMALS,
		[BENCH_SKIN_TANGENTS] = FIXED_NORMALS | FIXED_TANGENTS,
	};
	const struct bench_mesh *mesh = state->mesh;
	int error = fixed_skin_init(
		&state->skin, &mesh->primitive, streams[work], arena);

	if (error) {
		return error == -ERANGE ? -ENOTSUP : error;
	}
	state->matrix = ARENA_ARRAY(
		arena, struct fixed_matrix, (size_t)state->skin.joint_count);
	if (!state->matrix) {
		return -ENOMEM;
	}
	error = fixed_palette_make(&state->skin, (const mat4 *)mesh->palette,
		state->matrix, &state->placement);
	return error == -ERANGE ? -ENOTSUP : error;
}

static int prepare(void *user, const struct kernel *kernel,
	const struct bench_mesh *mesh, enum bench_work work, struct arena *arena)
{
	struct fixed_state *state = user;

	state->loops = kernel->fixed;
	state->mesh = mesh;
	for (int i = 0; i < FIXED_ATTRIBUTES; i++) {
		state->posed[i] = vectors(arena, mesh->primitive.vertex_count);
		if (!state->posed[i]) {
			return -ENOMEM;
		}
	}
	switch (work) {
	case BENCH_LERP:
	case BENCH_LERP_NORMALS:
	case BENCH_BY_FRAMES:
		return prepare_keys(state, arena);
	case BENCH_LERP_KEYS:
		return prepare_lerp_keys(state, arena);
	case BENCH_TARGETS:
		return prepare_targets(state, arena);
	default:
		return prepare_skin(state, work, arena);
	}
}

const struct bench_loops bench_fixed_loops = {
	sizeof(struct fixed_state),
	{skin, skin_normals, skin_tangents, lerp, lerp_normals, targets,
		by_frames, lerp_keys},
	prepare,
};
