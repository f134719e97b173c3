/* Rigid parts of a grid whose joints and weights the tests choose. */
#include "app/compare/candidate/candidate_rigid.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

#include <cglm/cglm.h>

enum {
	JOINTS = 3,
	NODES = 1 + JOINTS,
	VERTICES = 9, /* of a grid of two quads by two */
	TRIANGLES = 8,
	INFLUENCES = 4
};

struct bench {
	struct model *model, own;
	struct model_node node[NODES];
	struct model_mesh mesh;
	struct model_primitive primitive;
	struct model_skin skin;
	struct model_clip clip;
	struct model_channel channel[JOINTS];
	int joint_node[JOINTS];
	mat4 inverse_bind[JOINTS];
	uint16_t joint[VERTICES][INFLUENCES];
	float weight[VERTICES][INFLUENCES];
	float time_s[2], turn[2][4];
	struct reference *reference;
	struct candidate candidate;
	const struct rigid_bake *rigid;
};

/* All vertices follow joint 0; all joints turn by 90 degrees about (1, 2, 3). */
static void begin(struct bench *bench)
{
	const struct transform rest = {
		.rotation = {0, 0, 0, 1}, .scale = {1, 1, 1}};
	vec3 axis = {1, 2, 3};

	*bench = (struct bench){
		.model = small_model_grid(2, 2, 1.0f, true), .time_s = {0, 1}};
	bench->own = *bench->model;
	bench->primitive = *bench->model->mesh->primitive;
	bench->mesh = *bench->model->mesh;
	bench->mesh.primitive = &bench->primitive;
	bench->primitive.influences = INFLUENCES;
	bench->primitive.joint = bench->joint[0];
	bench->primitive.weight = bench->weight[0];
	for (int v = 0; v < VERTICES; v++) {
		glm_vec3_copy(
			(vec3){0.48f, 0.64f, 0.6f}, bench->primitive.normal[v]);
		bench->weight[v][0] = 1.0f;
	}
	bench->node[0] = *bench->model->node;
	bench->node[0].skin = 0;
	glm_vec3_normalize(axis);
	glm_vec3_scale(axis, sqrtf(0.5f), bench->turn[1]);
	bench->turn[0][3] = 1.0f;
	bench->turn[1][3] = sqrtf(0.5f);
	for (int j = 0; j < JOINTS; j++) {
		bench->node[1 + j] = (struct model_node){.name = "joint",
			.file_index = 1 + j,
			.parent = -1,
			.in_scene = true,
			.rest = rest,
			.mesh = -1,
			.skin = -1,
			.camera = -1};
		bench->node[1 + j].rest.translation[0] = (float)j;
		bench->joint_node[j] = 1 + j;
		bench->channel[j] = (struct model_channel){.node = 1 + j,
			.path = MODEL_ROTATION,
			.interpolation = MODEL_LINEAR,
			.width = 4,
			.key_count = 2,
			.time_s = bench->time_s,
			.value = bench->turn[0]};
	}
	bench->skin = (struct model_skin){.name = "",
		.joint_count = JOINTS,
		.joint = bench->joint_node,
		.inverse_bind = bench->inverse_bind};
	bench->clip = (struct model_clip){.name = "turn",
		.duration_s = 1.0f,
		.channel_count = JOINTS,
		.channel = bench->channel};
	bench->own.node_count = NODES;
	bench->own.node = bench->node;
	bench->own.mesh = &bench->mesh;
	bench->own.skin_count = 1;
	bench->own.skin = &bench->skin;
	bench->own.clip_count = 1;
	bench->own.clip = &bench->clip;
}

static void bake(struct bench *bench)
{
	const struct log log = log_to_stderr(LOG_WARNING);

	assert_int_equal(
		reference_create(&bench->own, 0, &log, &bench->reference), 0);
	assert_int_equal(
		candidate_rigid(&bench->candidate, bench->reference, &log), 0);
	bench->rigid = candidate_rigid_bake(&bench->candidate);
}

static void end(struct bench *bench)
{
	candidate_destroy(&bench->candidate);
	reference_destroy(bench->reference);
	model_destroy(bench->model);
}

/* Binds all joints at rest, so that there the skin is where the grid is. */
static void bind_at_rest(struct bench *bench)
{
	for (int j = 0; j < JOINTS; j++) {
		const struct transform *rest = &bench->node[1 + j].rest;
		mat4 world = GLM_MAT4_IDENTITY_INIT;

		glm_translate(world, (float *)(uintptr_t)rest->translation);
		glm_scale(world, (float *)(uintptr_t)rest->scale);
		glm_mat4_inv(world, bench->inverse_bind[j]);
	}
}

/* Joints of these scales, which all vertices follow one by one. */
static const float scales[][3] = {{1, 1, 1}, {2, 2, 2}, {1, 2, 3}, {-1, 1, 1},
	{1, -3, 1}, {0.5f, 1, -1}, {-1, -1, 1}, {-1, -2, -3}};

static void begin_scaled(struct bench *bench, const float scale[3], int joint)
{
	begin(bench);
	for (int j = 0; j < JOINTS; j++) {
		memcpy(bench->node[1 + j].rest.scale, scale, sizeof(float[3]));
	}
	for (int v = 0; v < VERTICES; v++) {
		bench->joint[v][0] = (uint16_t)joint;
	}
	bind_at_rest(bench);
	bake(bench);
}

static void test_vertices_of_one_joint_move_as_in_the_skin(void **state)
{
	float position[VERTICES][3], normal[VERTICES][3];
	struct bench bench;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(scales); i++) {
		begin_scaled(&bench, scales[i], (int)(i % JOINTS));
		assert_int_equal(bench.candidate.vertex_count, VERTICES);
		for (int t = 0; t <= 2; t++) {
			float time_s = 0.5f * (float)t;

			candidate_pose(&bench.candidate, time_s);
			bench.candidate.take(&bench.candidate, position, normal);
			reference_pose(bench.reference, time_s, true);
			for (int v = 0; v < VERTICES; v++) {
				int from = bench.candidate.source[v];

				assert_all_near(position[v],
					bench.reference->position[from], 3,
					1e-5);
				assert_all_near(normal[v],
					bench.reference->normal[from], 3, 1e-4);
			}
		}
		end(&bench);
	}
}

/* What is stored mirrored is turned around, so that the node shows its front. */
static void test_triangles_of_mirrored_joints_turn_around(void **state)
{
	struct bench bench;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(scales); i++) {
		const float *scale = scales[i];
		bool mirrored = scale[0] * scale[1] * scale[2] < 0.0f;

		begin_scaled(&bench, scale, 1);
		assert_int_equal(bench.rigid->part_count, 1);
		assert_int_equal(bench.rigid->index_count, 3 * TRIANGLES);
		for (int k = 0; k < 3 * TRIANGLES; k++) {
			int corner = k % 3;
			int from = mirrored ? (3 - corner) % 3 : corner;

			assert_int_equal(
				bench.rigid->source[bench.rigid->index[k]],
				bench.primitive.index[k - corner + from]);
		}
		end(&bench);
	}
}

/* A node without height at rest has no cofactors that could turn a normal. */
static void test_a_flat_joint_keeps_the_normals_of_its_space(void **state)
{
	const float flat[3] = {1, 1, 0};
	const float wanted[3] = {0, 0, 1};
	struct bench bench;

	(void)state;
	begin(&bench);
	for (int j = 0; j < JOINTS; j++) {
		memcpy(bench.node[1 + j].rest.scale, flat, sizeof(flat));
		glm_mat4_identity(bench.inverse_bind[j]);
		glm_scale_uni(bench.inverse_bind[j], 3.0f);
	}
	for (int v = 0; v < VERTICES; v++) {
		glm_vec3_copy(
			(float *)(uintptr_t)wanted, bench.primitive.normal[v]);
	}
	bake(&bench);
	for (int v = 0; v < VERTICES; v++) {
		assert_all_near(bench.rigid->normal[v], wanted, 3, 1e-6);
		assert_near(bench.rigid->position[v][0],
			3.0f * bench.primitive.position[bench.rigid->source[v]][0],
			1e-6);
	}
	end(&bench);
}

/* The joints and weights of the corners of the first triangle: 0, 1 and 3. */
struct choice {
	uint16_t joint[3][INFLUENCES];
	float weight[3][INFLUENCES];
	int wanted;
};

static const struct choice choices[] = {
	/* all weights of a joint count together: 1, 1.5, 0.5 */
	{{{1, 0}, {0, 2}, {1, 0}}, {{0.6f, 0.4f}, {0.5f, 0.5f}, {0.9f, 0.1f}}, 1},
	{{{2, 0}, {2, 1}, {1, 2}}, {{1}, {0.25f, 0.75f}, {0.5f, 0.5f}}, 2},
	/* also in the last place, and at one corner alone */
	{{{0, 1, 1, 2}, {0}, {0, 1}},
		{{0.1f, 0, 0, 0.9f}, {0.3f}, {0.4f, 0.6f}}, 2},
	/* of equal sums, the joint that is found first */
	{{{2}, {0}, {1, 0}}, {{1}, {1}, {1, 0}}, 2},
	{{{1, 2}, {2, 1}, {0}}, {{0.5f, 0.5f}, {0.5f, 0.5f}, {1}}, 1},
	{{{0, 1}, {1}, {0}}, {{0, 1}, {0}, {1}}, 0},
};

static void test_a_triangle_follows_the_joint_of_the_largest_sum(void **state)
{
	static const int corner[3] = {0, 1, 3};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(choices); i++) {
		struct bench bench;
		int found = -1;

		begin(&bench);
		bind_at_rest(&bench);
		for (int c = 0; c < 3; c++) {
			int v = corner[c];

			assert_int_equal(bench.primitive.index[c], v);
			memcpy(bench.joint[v], choices[i].joint[c],
				sizeof(bench.joint[v]));
			memcpy(bench.weight[v], choices[i].weight[c],
				sizeof(bench.weight[v]));
		}
		bake(&bench);
		for (int p = 0; p < bench.rigid->part_count; p++) {
			const struct rigid_part *part = &bench.rigid->part[p];
			const uint32_t *first =
				bench.rigid->index + part->first_index;

			if (bench.rigid->source[part->first_vertex +
				    (int)first[0]] == 0) {
				found = part->node;
			}
		}
		assert_int_equal(found, 1 + choices[i].wanted);
		end(&bench);
	}
}

/* Each part has a copy of its own of a vertex at its border, but only one. */
static void test_a_vertex_is_stored_once_for_each_part(void **state)
{
	int copies[VERTICES] = {0};
	struct bench bench;

	(void)state;
	begin(&bench);
	bind_at_rest(&bench);
	/* The upper row, whose triangles have most of its weights. */
	for (int v = 6; v < VERTICES; v++) {
		bench.joint[v][0] = 2;
	}
	for (int v = 3; v < 6; v++) {
		bench.joint[v][1] = 2;
		bench.weight[v][0] = 0.4f;
		bench.weight[v][1] = 0.6f;
	}
	bake(&bench);
	assert_int_equal(bench.rigid->part_count, 2);
	assert_int_equal(bench.candidate.vertex_count, 12);
	for (int p = 0; p < 2; p++) {
		const struct rigid_part *part = &bench.rigid->part[p];

		assert_int_equal(part->node, p ? 3 : 1);
		assert_int_equal(part->part, 0);
		assert_int_equal(part->vertex_count, 6);
		assert_int_equal(part->first_vertex, 6 * p);
		assert_int_equal(part->index_count, 12);
		assert_int_equal(part->first_index, 12 * p);
		for (int v = 0; v < 6; v++) {
			assert_int_equal(
				bench.rigid->node[6 * p + v], part->node);
			copies[bench.rigid->source[6 * p + v]]++;
		}
	}
	for (int v = 0; v < VERTICES; v++) {
		assert_int_equal(copies[v], v / 3 == 1 ? 2 : 1);
	}
	end(&bench);
}

/* Normals of two nodes that turn differently, in one list of vertices. */
static void test_each_part_turns_its_own_normals(void **state)
{
	float position[3 * TRIANGLES][3], normal[3 * TRIANGLES][3];
	struct bench bench;
	float still[2][4] = {{0, 0, 0, 1}, {0, 0, 0, 1}};

	(void)state;
	begin(&bench);
	bind_at_rest(&bench);
	for (int v = 3; v < VERTICES; v++) {
		bench.joint[v][0] = 2;
	}
	bench.channel[2].value = still[0];
	bake(&bench);
	assert_int_equal(bench.rigid->part_count, 2);
	/* Joint 0 has two triangles, and joint 2 all vertices but 0. */
	assert_int_equal(bench.candidate.vertex_count, 5 + 8);
	candidate_pose(&bench.candidate, 1.0f);
	bench.candidate.take(&bench.candidate, position, normal);
	reference_pose(bench.reference, 1.0f, true);
	for (int v = 0; v < bench.candidate.vertex_count; v++) {
		/* All vertices have the normal of the joint's first one. */
		int from = bench.rigid->node[v] == 1 ? 0 : VERTICES - 1;

		assert_all_near(
			normal[v], bench.reference->normal[from], 3, 1e-4);
	}
	end(&bench);
}

static void test_memory_and_files_have_the_stored_vectors(void **state)
{
	struct bench bench;

	(void)state;
	for (int normals = 0; normals < 2; normals++) {
		size_t vectors = VERTICES * (normals ? 2 : 1);

		begin(&bench);
		bind_at_rest(&bench);
		bench.primitive.normal = normals ? bench.primitive.normal : NULL;
		bake(&bench);
		assert_int_equal(
			bench.candidate.bytes.shared_file, vectors * 12);
		assert_int_equal(bench.candidate.bytes.shared,
			vectors * 8 + NODES * (sizeof(struct transform) + 64));
		assert_int_equal(bench.candidate.bytes.own,
			bench.candidate.bytes.own_file);
		end(&bench);
	}
}

/* Each of three joints without a parent is one matrix, and each part one more. */
static void test_the_board_computes_the_matrices_of_all_nodes(void **state)
{
	struct board_cost matrices = board_cost_matrices(NODES, NODES, 0);
	struct board_cost solid = board_cost_solid(2);
	const struct board_frame *board;
	struct bench bench;

	(void)state;
	begin(&bench);
	bind_at_rest(&bench);
	for (int v = 3; v < VERTICES; v++) {
		bench.joint[v][0] = 2;
	}
	bake(&bench);
	board = &bench.candidate.board;
	assert_near(board->matrices.cycles, matrices.cycles, 1e-9);
	assert_near(board->matrices.instructions, matrices.instructions, 1e-9);
	assert_near(board->vertices.cycles, solid.cycles, 1e-9);
	assert_near(board->vertices.instructions, solid.instructions, 1e-9);
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_vertices_of_one_joint_move_as_in_the_skin),
		cmocka_unit_test(test_triangles_of_mirrored_joints_turn_around),
		cmocka_unit_test(
			test_a_flat_joint_keeps_the_normals_of_its_space),
		cmocka_unit_test(
			test_a_triangle_follows_the_joint_of_the_largest_sum),
		cmocka_unit_test(test_a_vertex_is_stored_once_for_each_part),
		cmocka_unit_test(test_each_part_turns_its_own_normals),
		cmocka_unit_test(test_memory_and_files_have_the_stored_vectors),
		cmocka_unit_test(
			test_the_board_computes_the_matrices_of_all_nodes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
