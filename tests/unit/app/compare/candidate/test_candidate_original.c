/* What the model itself takes in a file, by hand, and parts of its skin. */
#include "app/compare/candidate/candidate_rigid.h"
#include "app/model/model_deltas.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

#include <cglm/cglm.h>

enum {
	VERTICES = 12,
	JOINTS_MAX = 257
};

/* A grid whose one node is each joint of a skin, and turns in a clip. */
struct skinned_grid {
	struct model *model;
	mat4 bind[JOINTS_MAX];
	int joint[JOINTS_MAX];
	struct model_skin skin;
	float time_s[2], value[6];
	struct model_channel channel;
	struct model_clip clip;
	uint16_t joints[VERTICES][4];
	float weights[VERTICES][4];
};

static void make_grid(struct skinned_grid *grid, int joint_count)
{
	struct model_primitive *primitive;

	memset(grid, 0, sizeof(*grid));
	grid->model = small_model_grid(3, 2, 1.0f, true);
	primitive = grid->model->mesh->primitive;
	for (int v = 0; v < VERTICES; v++) {
		grid->weights[v][0] = 1.0f;
	}
	primitive->influences = 4;
	primitive->joint = grid->joints[0];
	primitive->weight = grid->weights[0];
	for (int j = 0; j < joint_count; j++) {
		glm_mat4_identity(grid->bind[j]);
	}
	grid->skin = (struct model_skin){.name = "",
		.joint_count = joint_count,
		.joint = grid->joint,
		.inverse_bind = grid->bind};
	grid->time_s[1] = 1.0f;
	grid->channel = (struct model_channel){.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 2,
		.time_s = grid->time_s,
		.value = grid->value};
	grid->clip = (struct model_clip){.name = "",
		.duration_s = 1.0f,
		.channel_count = 1,
		.channel = &grid->channel};
	grid->model->skin = &grid->skin;
	grid->model->skin_count = 1;
	grid->model->node->skin = 0;
	grid->model->clip = &grid->clip;
	grid->model->clip_count = 1;
}

static struct candidate_bytes bytes_capped(
	const struct model *model, const char *kernel, int max_influences)
{
	const struct log log = log_to_stderr(LOG_WARNING);
	struct candidate_bytes bytes;
	struct reference *reference;
	struct candidate candidate;

	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	assert_int_equal(
		candidate_original(&candidate, reference, kernel_find(kernel),
			max_influences, true, 60.0, &log),
		0);
	bytes = candidate.bytes;
	candidate_destroy(&candidate);
	reference_destroy(reference);
	return bytes;
}

static struct candidate_bytes bytes_with_kernel(
	const struct model *model, const char *kernel)
{
	return bytes_capped(model, kernel, 0);
}

static struct candidate_bytes bytes_of(const struct model *model)
{
	return bytes_with_kernel(model, "float");
}

static struct candidate_bytes bytes_with(int joint_count)
{
	struct skinned_grid grid;
	struct candidate_bytes bytes;

	make_grid(&grid, joint_count);
	bytes = bytes_of(grid.model);
	model_destroy(grid.model);
	return bytes;
}

/*
 * A file has positions and normals, four influences a vertex and a matrix of
 * each joint; the number of a joint is one byte as far as that goes.
 */
static void test_joints_up_to_256_have_numbers_of_a_byte(void **state)
{
	(void)state;
	for (int joints = 255; joints <= JOINTS_MAX; joints++) {
		size_t number = joints <= 256 ? 1 : 2;
		struct candidate_bytes bytes = bytes_with(joints);

		assert_int_equal(bytes.shared_file,
			VERTICES * 2 * 12 + VERTICES * 4 * (number + 4) +
				(size_t)joints * 64);
		/* Two times and two translations. */
		assert_int_equal(bytes.own_file, 2 * 4 + 2 * 12);
	}
}

/* In memory a joint has an inverse bind matrix and one of the palette. */
static void test_a_joint_more_takes_two_matrices_in_memory(void **state)
{
	(void)state;
	assert_int_equal(bytes_with(9).shared - bytes_with(8).shared, 128);
}

static void test_a_mesh_that_two_nodes_show_counts_once(void **state)
{
	struct candidate_bytes one, two;
	struct skinned_grid grid;
	struct model_node node[2];

	(void)state;
	make_grid(&grid, 1);
	grid.model->skin_count = 0;
	grid.model->node->skin = -1;
	one = bytes_of(grid.model);
	node[0] = node[1] = *grid.model->node;
	grid.model->node = node;
	grid.model->node_count = 2;
	two = bytes_of(grid.model);
	assert_int_equal(two.shared_file, one.shared_file);
	assert_int_equal(two.shared - one.shared,
		sizeof(struct transform) + sizeof(mat4));
	model_destroy(grid.model);
}

/* A target has an array for what it moves, in a file and in memory. */
static void test_a_target_counts_the_arrays_that_it_has(void **state)
{
	static const float moved[VERTICES][3] = {{1.0f}};
	struct model_deltas deltas = model_deltas_view(moved, VERTICES);
	struct model_target target[2] = {{.position = {0}}};
	float weight[2] = {0, 0};
	struct candidate_bytes least;
	struct skinned_grid grid;

	(void)state;
	make_grid(&grid, 1);
	grid.model->mesh->target_count = 2;
	grid.model->mesh->primitive->target = target;
	grid.model->weight_count = 2;
	grid.model->rest_weights = weight;
	target[0].position = deltas;
	least = bytes_of(grid.model);
	for (int arrays = 1; arrays <= 3; arrays++) {
		size_t more = (size_t)(arrays - 1) * VERTICES * 12;
		struct candidate_bytes bytes;

		if (arrays > 1) {
			target[arrays - 2].normal = deltas;
		}
		bytes = bytes_of(grid.model);
		assert_int_equal(bytes.shared_file, least.shared_file + more);
		assert_int_equal(bytes.shared, least.shared + more);
	}
	model_destroy(grid.model);
}

static void test_a_file_holds_only_the_displacements_of_what_moves(void **state)
{
	static const float moved[VERTICES][3] = {{1.0f}};
	struct model_target target = {.position = {0}};
	float weight = 0;
	struct candidate_bytes none;
	struct skinned_grid grid;
	struct arena arena = arena_empty();

	(void)state;
	make_grid(&grid, 1);
	grid.model->mesh->target_count = 1;
	grid.model->mesh->primitive->target = &target;
	grid.model->weight_count = 1;
	grid.model->rest_weights = &weight;
	none = bytes_of(grid.model);
	assert_int_equal(model_deltas_pack(&target.position, moved, VERTICES,
				 MODEL_FLOAT, 1.0f, &arena),
		0);
	assert_int_equal(bytes_of(grid.model).shared_file,
		none.shared_file + model_deltas_bytes(&target.position));
	assert_true(model_deltas_bytes(&target.position) < VERTICES * 12);
	arena_release(&arena);
	model_destroy(grid.model);
}

/* Twice the area of the part's triangle, positive if its normal faces out. */
static float facing(const struct rigid_bake *rigid, const uint32_t *corner)
{
	vec3 a, b, across;

	glm_vec3_sub(rigid->position[corner[1]], rigid->position[corner[0]], a);
	glm_vec3_sub(rigid->position[corner[2]], rigid->position[corner[0]], b);
	glm_vec3_cross(a, b, across);
	return glm_vec3_dot(across, rigid->normal[corner[0]]);
}

/* The grid faces +Z, which it also does in the space of a mirrored joint. */
static void test_rigid_parts_of_mirrored_joints_face_outwards(void **state)
{
	const struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	for (float side = 1.0f; side >= -1.0f; side -= 2.0f) {
		const struct rigid_bake *rigid;
		struct reference *reference;
		struct candidate candidate;
		struct skinned_grid grid;

		make_grid(&grid, 1);
		grid.bind[0][0][0] = side;
		grid.model->node->rest.scale[0] = side;
		assert_int_equal(
			reference_create(grid.model, 0, &log, &reference), 0);
		assert_int_equal(
			candidate_rigid(&candidate, reference, &log), 0);
		rigid = candidate_rigid_bake(&candidate);
		assert_int_equal(rigid->index_count, 3 * 2 * 3 * 2);
		for (int i = 0; i < rigid->index_count; i += 3) {
			assert_near(facing(rigid, rigid->index + i),
				1.0f / 6.0f, 1e-6);
		}
		candidate_destroy(&candidate);
		reference_destroy(reference);
		model_destroy(grid.model);
	}
}

/* A posed vector is three floats, or four shorts in fixed point. */
static void test_posed_vectors_are_smaller_in_fixed_point(void **state)
{
	struct skinned_grid grid;

	(void)state;
	make_grid(&grid, 1);
	grid.model->skin_count = 0;
	grid.model->node->skin = -1;
	for (int vectors = 2; vectors >= 1; vectors--) {
		size_t nodes = sizeof(struct transform) + sizeof(mat4);
		size_t count = VERTICES * (size_t)vectors;

		if (vectors == 1) {
			grid.model->mesh->primitive->normal = NULL;
		}
		assert_int_equal(bytes_with_kernel(grid.model, "float").shared,
			nodes + count * 12);
		assert_int_equal(bytes_with_kernel(grid.model, "fixed").shared,
			nodes + count * 8);
	}
	model_destroy(grid.model);
}

/* A skin moves what its targets leave, so these have a base in floats. */
static void test_targets_of_a_skin_have_a_base_in_floats(void **state)
{
	static const float moved[VERTICES][3] = {{1.0f}};
	struct model_target target = {
		.position = model_deltas_view(moved, VERTICES)};
	static const char *const kernels[] = {"float", "fixed"};
	float weight = 0;

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct candidate_bytes plain, morphed;
		struct skinned_grid grid;

		make_grid(&grid, 1);
		plain = bytes_with_kernel(grid.model, kernels[i]);
		grid.model->mesh->target_count = 1;
		grid.model->mesh->primitive->target = &target;
		grid.model->weight_count = 1;
		grid.model->rest_weights = &weight;
		morphed = bytes_with_kernel(grid.model, kernels[i]);
		assert_true(morphed.shared >=
			plain.shared + VERTICES * 2 * 12 + VERTICES * 12);
		model_destroy(grid.model);
	}
}

/* In floats, each influence has a weight, a position and maybe a normal. */
static void test_influences_take_memory_in_floats(void **state)
{
	(void)state;
	for (int vectors = 2; vectors >= 1; vectors--) {
		struct candidate_bytes one, two;
		struct skinned_grid grid;

		make_grid(&grid, 2);
		if (vectors == 1) {
			grid.model->mesh->primitive->normal = NULL;
		}
		one = bytes_of(grid.model);
		for (int v = 0; v < VERTICES; v++) {
			grid.weights[v][0] = grid.weights[v][1] = 0.5f;
			grid.joints[v][1] = 1;
		}
		two = bytes_of(grid.model);
		assert_int_equal(two.shared - one.shared,
			VERTICES *
				(sizeof(struct joint_weight) +
					(size_t)vectors * sizeof(float[4])));
		assert_int_equal(two.shared_file, one.shared_file);
		/* A cap leaves the heaviest ones. */
		assert_int_equal(bytes_capped(grid.model, "float", 2).shared,
			two.shared);
		assert_int_equal(bytes_capped(grid.model, "float", 1).shared,
			one.shared);
		model_destroy(grid.model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_joints_up_to_256_have_numbers_of_a_byte),
		cmocka_unit_test(test_a_joint_more_takes_two_matrices_in_memory),
		cmocka_unit_test(test_a_mesh_that_two_nodes_show_counts_once),
		cmocka_unit_test(test_a_target_counts_the_arrays_that_it_has),
		cmocka_unit_test(
			test_a_file_holds_only_the_displacements_of_what_moves),
		cmocka_unit_test(
			test_rigid_parts_of_mirrored_joints_face_outwards),
		cmocka_unit_test(test_posed_vectors_are_smaller_in_fixed_point),
		cmocka_unit_test(test_targets_of_a_skin_have_a_base_in_floats),
		cmocka_unit_test(test_influences_take_memory_in_floats),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
