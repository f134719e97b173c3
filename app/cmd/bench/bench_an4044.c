#include "app/anim/kernel/an4044.h"
#include "app/cmd/bench/bench_job.h"

#include <errno.h>
#include <string.h>

struct an4044_state {
	int vertex_count;
	struct skin_stream stream;
	struct an4044_vertex *vertex;
	struct an4044_joint_mat *joint;
	const an4044_vec3 *from[2]; /* positions, normals */
	const an4044_vec3 *to[2];
	an4044_vec3 *temporal[2];
};

static void skin(void *user)
{
	struct an4044_state *s = user;

	an4044_transform(s->vertex, s->vertex_count, s->joint,
		(const float(*)[4])s->stream.position, s->stream.influence);
}

static void skin_normals(void *user)
{
	struct an4044_state *s = user;

	an4044_transform_normals(s->vertex, s->vertex_count, s->joint,
		(const float(*)[4])s->stream.position,
		(const float(*)[4])s->stream.normal, s->stream.influence);
}

static void skin_tangents(void *user)
{
	struct an4044_state *s = user;

	an4044_transform_tangents(s->vertex, s->vertex_count, s->joint,
		(const float(*)[4])s->stream.position,
		(const float(*)[4])s->stream.normal,
		(const float(*)[4])s->stream.tangent, s->stream.influence);
}

static void lerp(void *user)
{
	struct an4044_state *s = user;

	an4044_over_time(
		s->vertex_count, s->from[0], s->to[0], 0.3f, s->temporal[0]);
}

static void lerp_normals(void *user)
{
	struct an4044_state *s = user;

	lerp(user);
	an4044_over_time(
		s->vertex_count, s->from[1], s->to[1], 0.3f, s->temporal[1]);
}

static void targets(void *user)
{
	struct an4044_state *s = user;

	an4044_two_targets(s->vertex_count, s->from[0], s->to[0], 0.25f,
		s->to[1], 0.5f, s->temporal[0]);
}

static void by_frames(void *user)
{
	struct an4044_state *s = user;

	an4044_by_frames(
		s->vertex_count, s->from[0], s->to[0], 15, s->temporal[0]);
}

/* Converts the palette: AN4044's matrices are row-major and have three rows. */
static void set_joints(struct an4044_state *state, const struct bench_mesh *mesh)
{
	for (int j = 0; j < mesh->joint_count; j++) {
		for (int i = 0; i < 12; i++) {
			state->joint[j].mat[i] = mesh->palette[j][i % 4][i / 4];
		}
	}
}

/* Converts the offsets, in bytes, from limber's 4x4 matrices to AN4044's. */
static void set_offsets(struct skin_stream *stream)
{
	for (int i = 0; i < stream->influence_count; i++) {
		int32_t *offset = &stream->influence[i].joint_offset;

		*offset = *offset / (int32_t)sizeof(mat4) *
			(int32_t)sizeof(struct an4044_joint_mat);
	}
}

static int prepare_skin(struct an4044_state *state,
	const struct bench_mesh *mesh, enum bench_work work, struct arena *arena)
{
	struct skin_stream *stream = &state->stream;
	int error = skin_stream_init(stream, &mesh->primitive, 1.0f, arena);

	if (!error && work == BENCH_SKIN_TANGENTS) {
		error = skin_stream_add_tangents(
			stream, &mesh->primitive, arena);
	}
	if (error) {
		return error;
	}
	state->vertex = ARENA_ARRAY(
		arena, struct an4044_vertex, (size_t)state->vertex_count);
	state->joint = ARENA_ARRAY(
		arena, struct an4044_joint_mat, (size_t)mesh->joint_count);
	if (!state->vertex || !state->joint) {
		return -ENOMEM;
	}
	set_joints(state, mesh);
	set_offsets(stream);
	return 0;
}

static int prepare_morph(struct an4044_state *state,
	const struct bench_mesh *mesh, enum bench_work work, struct arena *arena)
{
	const struct model_primitive *primitive = &mesh->primitive;
	bool is_lerp = work == BENCH_LERP || work == BENCH_LERP_NORMALS;

	state->from[0] = (const an4044_vec3 *)primitive->position;
	state->from[1] = (const an4044_vec3 *)primitive->normal;
	state->to[0] =
		(const an4044_vec3 *)(work == BENCH_TARGETS ? mesh->delta[0]
							    : mesh->destiny);
	state->to[1] = (const an4044_vec3 *)(is_lerp ? mesh->destiny_normal
						     : mesh->delta[1]);
	for (int i = 0; i < 2; i++) {
		state->temporal[i] = arena_alloc(arena,
			(size_t)state->vertex_count, sizeof(an4044_vec3));
		if (!state->temporal[i]) {
			return -ENOMEM;
		}
	}
	memcpy(state->temporal[0], primitive->position,
		(size_t)state->vertex_count * sizeof(an4044_vec3));
	return 0;
}

static int prepare(void *user, const struct kernel *kernel,
	const struct bench_mesh *mesh, enum bench_work work, struct arena *arena)
{
	struct an4044_state *state = user;

	(void)kernel;
	state->vertex_count = mesh->primitive.vertex_count;
	return work <= BENCH_SKIN_TANGENTS
		? prepare_skin(state, mesh, work, arena)
		: prepare_morph(state, mesh, work, arena);
}

const struct bench_loops bench_an4044_loops = {
	sizeof(struct an4044_state),
	{skin, skin_normals, skin_tangents, lerp, lerp_normals, targets,
		by_frames},
	prepare,
};
