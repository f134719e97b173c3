#include "app/anim/kernel/fixed_skin.h"
#include "app/cmd/bench_job.h"

#include <errno.h>

struct fixed_state {
	const struct fixed_loops *loops;
	const struct bench_mesh *mesh;
	struct fixed_skin skin;
	struct fixed_matrix *matrix;
	struct fixed_placement placement;
	struct fixed_vector *posed[3]; /* positions, normals, tangents */
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

	if (s->mesh->is_whole) {
		fixed_palette_make(&s->skin, (const mat4 *)s->mesh->palette,
			s->matrix, &s->placement);
	}
	skin_stream(s, s->skin.position, s->posed[0]);
}

static void skin_normals(void *user)
{
	struct fixed_state *s = user;

	skin(user);
	skin_stream(s, s->skin.normal, s->posed[1]);
}

static void skin_tangents(void *user)
{
	struct fixed_state *s = user;

	skin_normals(user);
	skin_stream(s, s->skin.tangent, s->posed[2]);
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
	for (int i = 0; i < 3; i++) {
		state->posed[i] = ARENA_ARRAY(arena, struct fixed_vector,
			(size_t)mesh->primitive.vertex_count);
		if (!state->posed[i]) {
			return -ENOMEM;
		}
	}
	if (!state->matrix) {
		return -ENOMEM;
	}
	error = fixed_palette_make(&state->skin, (const mat4 *)mesh->palette,
		state->matrix, &state->placement);
	return error == -ERANGE ? -ENOTSUP : error;
}

int bench_fixed_prepare(const struct fixed_loops *loops,
	const struct bench_mesh *mesh, enum bench_work work,
	struct arena *arena, struct bench_job *out)
{
	static void (*const run[])(void *user) = {
		[BENCH_SKIN] = skin,
		[BENCH_SKIN_NORMALS] = skin_normals,
		[BENCH_SKIN_TANGENTS] = skin_tangents,
		[BENCH_BY_FRAMES] = NULL,
	};
	struct fixed_state *state;

	if (!run[work]) {
		return -ENOTSUP;
	}
	state = ARENA_NEW(arena, struct fixed_state);
	if (!state) {
		return -ENOMEM;
	}
	state->loops = loops;
	state->mesh = mesh;
	*out = (struct bench_job){
		.vertex_count = mesh->primitive.vertex_count,
		.state = state,
		.run = run[work],
	};
	return prepare_skin(state, work, arena);
}
