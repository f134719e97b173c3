/*
 * What the timed loops in float compute. A made-up kernel passes each call on
 * to the reference; AN4044's loops are replaced by some that look at what they
 * are given.
 */
#include "app/anim/kernel/an4044.h"
#include "tests/unit/app/cmd/bench/loops.h"

static void note_skin(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*position)[3], float (*normal)[3])
{
	kernel_float.skin(stream, palette, max_influences, position, normal);
	note(stream->vertex_count, position);
	if (normal) {
		note(stream->vertex_count, normal);
	}
}

static void note_directions(const struct skin_stream *stream,
	const float (*base)[4], const mat4 *palette, int max_influences,
	float (*direction)[3])
{
	kernel_float.skin_directions(
		stream, base, palette, max_influences, direction);
	note(stream->vertex_count, direction);
}

static void note_lerp(int count, const float (*source)[3],
	const float (*destiny)[3], float omega, const float offset[3],
	float (*out)[3])
{
	kernel_float.morph_lerp(count, source, destiny, omega, offset, out);
	note(count, out);
}

static void note_targets(int count, const float (*base)[3],
	const struct morph_term *term, int term_count, bool use_normals,
	float (*out)[3])
{
	kernel_float.morph_targets(
		count, base, term, term_count, use_normals, out);
	note(count, out);
}

static const struct kernel float_kernel = {.name = "float",
	.skin = note_skin,
	.skin_directions = note_directions,
	.morph_lerp = note_lerp,
	.morph_targets = note_targets};

/* Fails unless weights are AN4044's stream of the mesh, for its matrices. */
static void check_joints(const struct an4044_joint_mat *joint,
	const float (*base)[4], const struct joint_weight *weight)
{
	const struct bench_mesh *mesh = noted.mesh;
	struct arena arena = arena_empty();
	struct skin_stream stream;

	for (int j = 0; j < mesh->joint_count; j++) {
		for (int row = 0; row < 3; row++) {
			for (int column = 0; column < 4; column++) {
				assert_near(joint[j].mat[4 * row + column],
					mesh->palette[j][column][row], 0);
			}
		}
	}
	assert_int_equal(
		skin_stream_init(&stream, &mesh->primitive, 1.0f, &arena), 0);
	assert_all_near(
		base, stream.position, 4 * (size_t)stream.influence_count, 0);
	for (int i = 0; i < stream.influence_count; i++) {
		size_t number =
			(size_t)stream.influence[i].joint_offset / sizeof(mat4);

		assert_int_equal(weight[i].joint_offset,
			number * sizeof(struct an4044_joint_mat));
	}
	arena_release(&arena);
}

void an4044_transform(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const struct joint_weight *weight)
{
	check_joints(joint, base, weight);
	note(vertex_count, vertex);
}

void an4044_transform_normals(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const struct joint_weight *weight)
{
	an4044_transform(vertex, vertex_count, joint, base, weight);
	note(vertex_count, normal);
}

void an4044_transform_tangents(struct an4044_vertex *vertex, int vertex_count,
	const struct an4044_joint_mat *joint, const float (*base)[4],
	const float (*normal)[4], const float (*tangent)[4],
	const struct joint_weight *weight)
{
	an4044_transform_normals(
		vertex, vertex_count, joint, base, normal, weight);
	note(vertex_count, tangent);
}

void an4044_over_time(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, float omega, an4044_vec3 *temporal)
{
	mix(count, source, destiny, omega, temporal);
	note(count, temporal);
}

/* Its last argument holds the positions before the first step. */
void an4044_by_frames(int count, const an4044_vec3 *source,
	const an4044_vec3 *destiny, int frames, an4044_vec3 *temporal)
{
	assert_all_near(temporal, source, 3 * (size_t)count, 0);
	mix(count, source, destiny, 1.0f / (float)frames, temporal);
	note(count, temporal);
}

void an4044_two_targets(int count, const an4044_vec3 *base,
	const an4044_vec3 *delta0, float weight0, const an4044_vec3 *delta1,
	float weight1, an4044_vec3 *temporal)
{
	const struct morph_term terms[] = {
		{.weight = weight0, .position = delta0},
		{.weight = weight1, .position = delta1}};

	kernel_float.morph_targets(count, base, terms, 2, false, temporal);
	note(count, temporal);
}

void an4044_add(int count, const float height[3], an4044_vec3 *temporal)
{
	(void)count;
	(void)height;
	(void)temporal;
	fail();
}

static void test_float_loops_compute_what_they_are_named_for(void **state)
{
	(void)state;
	for (int work = BENCH_SKIN; work <= BENCH_TARGETS; work++) {
		float wanted[RESULTS][VERTICES][3];
		struct loops loops;

		run(&loops, &bench_float_loops, &float_kernel,
			(enum bench_work)work);
		expected(&loops.mesh, (enum bench_work)work, wanted);
		/* The positions and normals of tangents are skinned first. */
		assert_int_equal(
			noted.count, result_count((enum bench_work)work));
		for (int i = 0; i < noted.count; i++) {
			assert_all_near(
				noted.result[i], wanted[i], VERTICES * 3, 1e-6);
		}
		end(&loops);
	}
}

static void test_an4044s_loops_get_what_they_are_named_for(void **state)
{
	(void)state;
	for (int work = BENCH_LERP; work <= BENCH_BY_FRAMES; work++) {
		float wanted[RESULTS][VERTICES][3];
		struct loops loops;

		run(&loops, &bench_an4044_loops, NULL, (enum bench_work)work);
		expected(&loops.mesh, (enum bench_work)work, wanted);
		assert_int_equal(
			noted.count, result_count((enum bench_work)work));
		for (int i = 0; i < noted.count; i++) {
			assert_all_near(
				noted.result[i], wanted[i], VERTICES * 3, 1e-6);
		}
		end(&loops);
	}
}

static void test_an4044s_skins_get_matrices_and_directions(void **state)
{
	(void)state;
	for (int work = BENCH_SKIN; work <= BENCH_SKIN_TANGENTS; work++) {
		struct arena arena = arena_empty();
		struct skin_stream stream;
		struct loops loops;
		size_t floats;

		run(&loops, &bench_an4044_loops, NULL, (enum bench_work)work);
		assert_int_equal(
			noted.count, result_count((enum bench_work)work));
		assert_int_equal(skin_stream_init(&stream,
					 &loops.mesh.primitive, 1.0f, &arena),
			0);
		assert_int_equal(skin_stream_add_tangents(&stream,
					 &loops.mesh.primitive, &arena),
			0);
		floats = 4 * (size_t)stream.influence_count;
		if (work >= BENCH_SKIN_NORMALS) {
			assert_all_near(
				noted.result[1], stream.normal, floats, 0);
		}
		if (work == BENCH_SKIN_TANGENTS) {
			assert_all_near(
				noted.result[2], stream.tangent, floats, 0);
		}
		arena_release(&arena);
		end(&loops);
	}
}

static void test_loops_without_memory_are_refused(void **state)
{
	(void)state;
	for (int work = BENCH_SKIN; work <= BENCH_TARGETS; work++) {
		check_memory(&bench_float_loops, &float_kernel,
			(enum bench_work)work);
		check_memory(&bench_an4044_loops, NULL, (enum bench_work)work);
	}
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_float_loops_compute_what_they_are_named_for),
		cmocka_unit_test(test_an4044s_loops_get_what_they_are_named_for),
		cmocka_unit_test(test_an4044s_skins_get_matrices_and_directions),
		cmocka_unit_test(test_loops_without_memory_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
