/* The mesh that limber bench measures with, number by number. */
#include "app/anim/clip.h"
#include "app/cmd/bench/bench_mesh.h"
#include "app/model/model_deltas.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	COUNT = 2000
};

/* The numbers of the text on limber bench: Numerical Recipes' generator. */
static float next_float(uint32_t *state)
{
	*state = *state * 1664525u + 1013904223u;
	return (float)(*state >> 16) * (2.0f / 65535.0f) - 1.0f;
}

/* A vector of length 1, from points of a cube that lie in a ball. */
static void next_unit(uint32_t *state, float out[3])
{
	float length;

	do {
		for (int k = 0; k < 3; k++) {
			out[k] = next_float(state);
		}
		length = sqrtf(
			out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
	} while (length < 0.1f || length > 1.0f);
	for (int k = 0; k < 3; k++) {
		out[k] /= length;
	}
}

static void check_vectors(
	uint32_t *state, const float (*found)[3], int count, float size)
{
	for (int v = 0; v < count; v++) {
		float wanted[3];

		next_unit(state, wanted);
		for (int k = 0; k < 3; k++) {
			assert_near(found[v][k], wanted[k] * size, 1e-5);
		}
	}
}

static void check_target(
	uint32_t *state, const struct bench_mesh *mesh, int t, int count)
{
	float(*normal)[3] = calloc((size_t)count, sizeof(*normal));

	assert_non_null(normal);
	check_vectors(state, (const float(*)[3])mesh->delta[t], count, 0.2f);
	model_deltas_unpack(&mesh->target[t].normal, count, normal);
	check_vectors(state, (const float(*)[3])normal, count, 0.2f);
	model_deltas_unpack(&mesh->target[t].position, count, normal);
	assert_all_near(normal, mesh->delta[t], (size_t)count * 3, 0.0);
	free(normal);
}

/* The second key frame and the targets, and where the numbers go on. */
static void check_keys(uint32_t *state, const struct bench_mesh *mesh, int count)
{
	check_vectors(state, (const float(*)[3])mesh->destiny, count, 0.9f);
	check_vectors(
		state, (const float(*)[3])mesh->destiny_normal, count, 1.0f);
	for (int t = 0; t < 2; t++) {
		check_target(state, mesh, t, count);
	}
}

static void test_vectors_have_their_lengths(void **state)
{
	uint32_t number = 4044;
	struct bench_mesh mesh;

	(void)state;
	assert_int_equal(bench_mesh_make(&mesh, COUNT, 4, 24), 0);
	assert_int_equal(mesh.primitive.vertex_count, COUNT);
	assert_int_equal(mesh.primitive.influences, 4);
	assert_int_equal(mesh.joint_count, 24);
	assert_false(mesh.is_model);
	check_vectors(&number, (const float(*)[3])mesh.primitive.position,
		COUNT, 0.9f);
	check_vectors(
		&number, (const float(*)[3])mesh.primitive.normal, COUNT, 1.0f);
	for (int v = 0; v < COUNT; v++) {
		check_vectors(&number,
			(const float(*)[3])mesh.primitive.tangent[v], 1, 1.0f);
		assert_near(mesh.primitive.tangent[v][3], 1.0, 0.0);
	}
	bench_mesh_release(&mesh);
}

/* The weights are drawn from 0.25 to 2.25 and then add up to 1. */
static void check_weights(const float *weight, int influences, int stored)
{
	float least = 1.0f, most = 0.0f;

	for (int i = 0; i < stored; i++) {
		if (i < influences) {
			least = weight[i] < least ? weight[i] : least;
			most = weight[i] > most ? weight[i] : most;
		} else {
			assert_near(weight[i], 0.0, 0.0);
		}
	}
	assert_true(most <= least * 9.001f);
}

static void test_joints_differ_and_weights_are_within_nine_times(void **state)
{
	(void)state;
	for (int influences = 1; influences <= 8; influences++) {
		const int stored = influences > 4 ? 8 : 4;
		struct bench_mesh mesh;
		int used[24] = {0};
		float ratio = 1.0f;

		assert_int_equal(
			bench_mesh_make(&mesh, COUNT, influences, 0), 0);
		assert_int_equal(mesh.primitive.influences, stored);
		for (int v = 0; v < COUNT; v++) {
			const uint16_t *joint =
				mesh.primitive.joint + stored * v;
			const float *weight = mesh.primitive.weight + stored * v;

			check_weights(weight, influences, stored);
			for (int i = 0; i < influences; i++) {
				used[joint[i]]++;
				for (int k = 0; k < i; k++) {
					assert_int_not_equal(joint[k], joint[i]);
				}
			}
			ratio = influences == 2 && weight[0] > weight[1] * ratio
				? weight[0] / weight[1]
				: ratio;
		}
		for (int j = 0; j < 24; j++) {
			/* A 24th, give or take a half. */
			assert_in_range(used[j], COUNT * influences / 48,
				COUNT * influences / 16);
		}
		assert_true(influences != 2 || ratio > 7.0f);
		bench_mesh_release(&mesh);
	}
}

static void test_the_palette_turns_and_moves(void **state)
{
	struct bench_mesh mesh;
	float farthest = 0.0f;

	(void)state;
	assert_int_equal(bench_mesh_make(&mesh, 1, 1, 24), 0);
	for (int j = 0; j < mesh.joint_count; j++) {
		for (int a = 0; a < 3; a++) {
			float far = fabsf(mesh.palette[j][3][a]);

			for (int b = 0; b < 3; b++) {
				assert_near(glm_vec3_dot(mesh.palette[j][a],
						    mesh.palette[j][b]),
					a == b ? 1.0 : 0.0, 1e-5);
			}
			assert_true(far <= 0.5f);
			farthest = far > farthest ? far : farthest;
			assert_near(mesh.palette[j][a][3], 0.0, 0.0);
		}
		assert_near(glm_mat4_det(mesh.palette[j]), 1.0, 1e-4);
	}
	assert_true(farthest > 0.4f);
	bench_mesh_release(&mesh);
}

/* The numbers of the keys follow those of the palette, of which there are 8. */
static void test_keys_follow_the_palette(void **state)
{
	uint32_t number = 4044;
	struct bench_mesh mesh;
	float unit[3];

	(void)state;
	assert_int_equal(bench_mesh_make(&mesh, 3, 2, 24), 0);
	for (int i = 0; i < 9; i++) {
		next_unit(&number, unit);
	}
	/* A number for the set of joints, and one for each weight. */
	for (int i = 0; i < 3 * 3; i++) {
		(void)next_float(&number);
	}
	for (int j = 0; j < 24; j++) {
		float angle_rad = 3.0f * next_float(&number);
		float cosine = 0.5f *
			(mesh.palette[j][0][0] + mesh.palette[j][1][1] +
				mesh.palette[j][2][2] - 1.0f);

		assert_near(cosine, cosf(angle_rad), 1e-5);
		next_unit(&number, unit);
		for (int k = 0; k < 3; k++) {
			assert_near(mesh.palette[j][3][k],
				0.5f * next_float(&number), 1e-5);
		}
	}
	check_keys(&number, &mesh, 3);
	bench_mesh_release(&mesh);
}

static void check_palette(
	const struct bench_mesh *mesh, const struct model *model, int skin)
{
	struct arena arena = arena_empty();
	mat4 *world = ARENA_ARRAY(&arena, mat4, (size_t)model->node_count);
	struct clip_cursor cursor;
	struct pose pose;

	assert_non_null(world);
	assert_int_equal(pose_init(&pose, model, &arena), 0);
	assert_int_equal(clip_cursor_init(&cursor, model, &arena), 0);
	if (model->clip_count > 0) {
		clip_sample(&model->clip[0], model->clip[0].duration_s / 2.0f,
			&cursor, &pose);
	}
	pose_world(&pose, model, NULL, world);
	assert_int_equal(mesh->joint_count, model->skin[skin].joint_count);
	for (int j = 0; j < mesh->joint_count; j++) {
		mat4 wanted;

		glm_mat4_mul(world[model->skin[skin].joint[j]],
			model->skin[skin].inverse_bind[j], wanted);
		assert_all_near(mesh->palette[j], wanted, 16, 1e-4);
	}
	arena_release(&arena);
}

static void check_model(const char *path, int vertices)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	struct bench_mesh mesh;
	struct model *model;
	uint32_t number = 4044;
	float(*normal)[3] = NULL;

	assert_int_equal(model_load(path, &log, &model), 0);
	/* The first part's normals, of which models may have none. */
	if (vertices < 0) {
		vertices = -vertices;
		model->mesh[0].primitive[0].normal = NULL;
		normal = calloc((size_t)vertices, sizeof(*normal));
	}
	assert_int_equal(bench_mesh_of_model(&mesh, model), 0);
	assert_true(mesh.is_model);
	assert_int_equal(mesh.primitive.vertex_count, vertices);
	check_palette(&mesh, model, 0);
	check_keys(&number, &mesh, vertices);
	if (normal) {
		check_vectors(&number, (const float(*)[3])mesh.primitive.normal,
			vertices, 1.0f);
		free(normal);
	}
	bench_mesh_release(&mesh);
	model_destroy(model);
}

static void test_a_models_largest_skinned_part_is_taken(void **state)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	struct bench_mesh mesh;
	struct model *model;

	(void)state;
	check_model("assets/walker.glb", 2985);
	check_model(fixture_path("gltf/skin/unsorted.gltf").text, -3);
	assert_int_equal(model_load("assets/arm.glb", &log, &model), 0);
	assert_int_equal(bench_mesh_of_model(&mesh, model), -ENOENT);
	model_destroy(model);
}

/* In the middle of its first clip, or at rest if it has none. */
static void test_a_model_may_have_one_clip_or_none(void **state)
{
	const struct log log = log_to_stderr(LOG_ERROR);
	struct model *model;

	(void)state;
	assert_int_equal(
		model_load(fixture_path("gltf/skin/and_morph.gltf").text, &log,
			&model),
		0);
	assert_int_equal(model->clip_count, 1);
	for (; model->clip_count >= 0; model->clip_count--) {
		struct bench_mesh mesh;

		assert_int_equal(bench_mesh_of_model(&mesh, model), 0);
		check_palette(&mesh, model, 0);
		bench_mesh_release(&mesh);
	}
	model->clip_count = 0;
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_vectors_have_their_lengths),
		cmocka_unit_test(
			test_joints_differ_and_weights_are_within_nine_times),
		cmocka_unit_test(test_the_palette_turns_and_moves),
		cmocka_unit_test(test_keys_follow_the_palette),
		cmocka_unit_test(test_a_models_largest_skinned_part_is_taken),
		cmocka_unit_test(test_a_model_may_have_one_clip_or_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
