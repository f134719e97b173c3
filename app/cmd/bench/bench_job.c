#include "app/cmd/bench/bench_job.h"

#include <errno.h>
#include <string.h>

struct kernel_state {
	const struct kernel *kernel;
	const struct bench_mesh *mesh;
	struct skin_stream stream;
	float (*position)[3];
	float (*normal)[3];
	float (*tangent)[3];
};

static void skin(void *user)
{
	struct kernel_state *s = user;

	s->kernel->skin(&s->stream, (const mat4 *)s->mesh->palette, 0,
		s->position, NULL);
}

static void skin_normals(void *user)
{
	struct kernel_state *s = user;

	s->kernel->skin(&s->stream, (const mat4 *)s->mesh->palette, 0,
		s->position, s->normal);
}

static void skin_tangents(void *user)
{
	struct kernel_state *s = user;

	skin_normals(user);
	s->kernel->skin_directions(&s->stream,
		(const float(*)[4])s->stream.tangent,
		(const mat4 *)s->mesh->palette, 0, s->tangent);
}

static void lerp(void *user)
{
	static const float none[3] = {0, 0, 0};
	struct kernel_state *s = user;

	s->kernel->morph_lerp(s->mesh->primitive.vertex_count,
		(const float(*)[3])s->mesh->primitive.position,
		(const float(*)[3])s->mesh->destiny, 0.3f, none, s->position);
}

static void lerp_normals(void *user)
{
	static const float none[3] = {0, 0, 0};
	struct kernel_state *s = user;

	lerp(user);
	s->kernel->morph_lerp(s->mesh->primitive.vertex_count,
		(const float(*)[3])s->mesh->primitive.normal,
		(const float(*)[3])s->mesh->destiny_normal, 0.3f, none,
		s->normal);
}

static void targets(void *user)
{
	struct kernel_state *s = user;
	const struct bench_mesh *mesh = s->mesh;
	const struct morph_term term[2] = {
		{.weight = 0.25f, .position = (const float(*)[3])mesh->delta[0]},
		{.weight = 0.5f, .position = (const float(*)[3])mesh->delta[1]},
	};

	s->kernel->morph_targets(mesh->primitive.vertex_count,
		(const float(*)[3])mesh->primitive.position, term, 2, false,
		s->position);
}

static int prepare(void *user, const struct kernel *kernel,
	const struct bench_mesh *mesh, enum bench_work work, struct arena *arena)
{
	const struct model_primitive *primitive = &mesh->primitive;
	struct kernel_state *state = user;
	size_t count = (size_t)primitive->vertex_count;
	int error = 0;

	state->kernel = kernel;
	state->mesh = mesh;
	if (work <= BENCH_SKIN_TANGENTS) {
		error = skin_stream_init(&state->stream, primitive, 1.0f, arena);
	}
	if (!error && work == BENCH_SKIN_TANGENTS) {
		error = skin_stream_add_tangents(
			&state->stream, primitive, arena);
	}
	state->position = arena_alloc(arena, count, sizeof(float[3]));
	state->normal = arena_alloc(arena, count, sizeof(float[3]));
	state->tangent = arena_alloc(arena, count, sizeof(float[3]));
	if (!error && (!state->position || !state->normal || !state->tangent)) {
		error = -ENOMEM;
	}
	return error;
}

const struct bench_loops bench_float_loops = {
	sizeof(struct kernel_state),
	{skin, skin_normals, skin_tangents, lerp, lerp_normals, targets, NULL},
	prepare,
};

static const struct bench_loops *loops_of(
	const char *name, const struct kernel *kernel)
{
	if (strcmp(name, "an4044") == 0) {
		return &bench_an4044_loops;
	}
	if (!kernel) {
		return NULL;
	}
	return kernel->fixed ? &bench_fixed_loops : &bench_float_loops;
}

int bench_job_prepare(const char *name, const struct bench_mesh *mesh,
	enum bench_work work, struct arena *arena, struct bench_job *out)
{
	const struct kernel *kernel = kernel_find(name);
	const struct bench_loops *loops = loops_of(name, kernel);

	if (!loops) {
		return -EINVAL;
	}
	if (!loops->run[work]) {
		return -ENOTSUP;
	}
	*out = (struct bench_job){
		.vertex_count = mesh->primitive.vertex_count,
		.state = arena_alloc(arena, 1, loops->state_size),
		.run = loops->run[work],
	};
	if (!out->state) {
		return -ENOMEM;
	}
	return loops->prepare(out->state, kernel, mesh, work, arena);
}
