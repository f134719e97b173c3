/* Rigid parts: their normals turn with their nodes, and what they take. */
#include "app/compare/candidate/candidate_rigid.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/test.h"

#include <stdlib.h>

#include <cglm/cglm.h>

/* Each vertex that follows one joint alone is where the skin has it. */
static void test_normals_turn_with_the_nodes_of_parts(void **state)
{
	struct candidate candidate;
	struct compared_clip bench;
	float(*position)[3], (*normal)[3];
	int exact = 0, near = 0;

	(void)state;
	compared_clip_begin(&bench, "assets/walker.glb", "walk");
	assert_int_equal(
		candidate_rigid(&candidate, bench.reference, &bench.log), 0);
	position = malloc((size_t)candidate.vertex_count * sizeof(*position));
	normal = malloc((size_t)candidate.vertex_count * sizeof(*normal));
	assert_non_null(position);
	assert_non_null(normal);
	candidate_pose(&candidate, 0.3f);
	candidate.take(&candidate, position, normal);
	reference_pose(bench.reference, 0.3f, true);
	for (int v = 0; v < candidate.vertex_count; v++) {
		int source = candidate.source[v];
		float *wanted = bench.reference->normal[source];

		assert_near(glm_vec3_norm(normal[v]), 1.0, 1e-4);
		near += glm_vec3_dot(normal[v], wanted) > 0.7f;
		if (glm_vec3_distance(position[v],
			    bench.reference->position[source]) < 1e-6f) {
			exact++;
			assert_all_near(normal[v], wanted, 3, 2e-3);
		}
	}
	assert_true(exact > candidate.vertex_count / 10);
	assert_true(near > candidate.vertex_count * 9 / 10);
	free(position);
	free(normal);
	candidate_destroy(&candidate);
	compared_clip_end(&bench);
}

/* A file has floats, memory 16-bit vectors and each node's matrices. */
static void test_parts_take_positions_and_normals(void **state)
{
	struct candidate with, without;
	struct compared_clip bench;
	size_t vertices;

	(void)state;
	compared_clip_begin(&bench, "assets/walker.glb", "walk");
	assert_int_equal(candidate_rigid(&with, bench.reference, &bench.log), 0);
	vertices = (size_t)with.vertex_count;
	assert_true(vertices > (size_t)bench.reference->vertex_count);
	assert_int_equal(with.bytes.shared_file, vertices * 2 * 12);
	assert_int_equal(with.bytes.own, with.bytes.own_file);
	assert_true(with.bytes.own > 1000);
	for (int p = 0; p < bench.reference->part_count; p++) {
		bench.reference->part[p].normals = false;
	}
	assert_int_equal(
		candidate_rigid(&without, bench.reference, &bench.log), 0);
	assert_int_equal(without.bytes.shared_file, vertices * 12);
	assert_int_equal(with.bytes.shared - without.bytes.shared, vertices * 8);
	candidate_destroy(&with);
	candidate_destroy(&without);
	compared_clip_end(&bench);
}

/* Without skins, parts are where the model's nodes have them. */
static void expect_exact(const char *clip)
{
	struct candidate candidate;
	struct compared_clip bench;
	float position[64][3], normal[64][3];

	compared_clip_begin(&bench, "tests/fixtures/gltf/clip/door.gltf", clip);
	assert_int_equal(
		candidate_rigid(&candidate, bench.reference, &bench.log), 0);
	assert_in_range(candidate.vertex_count, 12, 64);
	for (int i = 0; i <= 4; i++) {
		float time_s = 0.25f * (float)i;

		candidate_pose(&candidate, time_s);
		candidate.take(&candidate, position, normal);
		reference_pose(bench.reference, time_s, true);
		for (int v = 0; v < candidate.vertex_count; v++) {
			int source = candidate.source[v];

			assert_all_near(position[v],
				bench.reference->position[source], 3, 1e-5);
			assert_all_near(normal[v],
				bench.reference->normal[source], 3, 1e-5);
		}
	}
	candidate_destroy(&candidate);
	compared_clip_end(&bench);
}

static void test_parts_without_skins_move_exactly(void **state)
{
	(void)state;
	expect_exact("drive");
	expect_exact("roll");
	expect_exact("leave");
}

/* The sum of the weights with which the node moves a triangle's corners. */
static float weight_of(const struct model *model, int skin,
	const struct model_primitive *primitive, const uint32_t corner[3],
	int node)
{
	float sum = 0.0f;

	for (int i = 0; i < 3 * primitive->influences; i++) {
		size_t at = (size_t)corner[i / primitive->influences] *
				(size_t)primitive->influences +
			(size_t)(i % primitive->influences);

		sum += model->skin[skin].joint[primitive->joint[at]] == node
			? primitive->weight[at]
			: 0.0f;
	}
	return sum;
}

static void expect_heaviest(const struct rigid_bake *rigid,
	const struct rigid_part *part, const uint32_t index[3])
{
	const struct reference_part *from = &rigid->reference->part[part->part];
	const struct drawable *drawable =
		&rigid->reference->instance->drawable[from->drawable];
	const struct model *model = rigid->reference->model;
	uint32_t corner[3];
	float own;

	assert_true(drawable->skin >= 0);
	for (int i = 0; i < 3; i++) {
		assert_in_range(index[i], 0, part->vertex_count - 1);
		corner[i] = (uint32_t)(rigid->source[part->first_vertex +
					       (int)index[i]] -
			from->first_vertex);
		assert_in_range(corner[i], 0, from->vertex_count - 1);
	}
	own = weight_of(
		model, drawable->skin, drawable->primitive, corner, part->node);
	for (int j = 0; j < model->skin[drawable->skin].joint_count; j++) {
		assert_true(own + 1e-6f >=
			weight_of(model, drawable->skin, drawable->primitive,
				corner, model->skin[drawable->skin].joint[j]));
	}
}

/* All triangles are in some part, with the joint that moves them most. */
static void test_triangles_follow_the_joint_of_the_largest_weight(void **state)
{
	struct candidate candidate;
	struct compared_clip bench;
	const struct rigid_bake *rigid;
	int left[8] = {0};

	(void)state;
	compared_clip_begin(&bench, "assets/walker.glb", "walk");
	assert_int_equal(
		candidate_rigid(&candidate, bench.reference, &bench.log), 0);
	rigid = candidate_rigid_bake(&candidate);
	assert_in_range(bench.reference->part_count, 1, 8);
	for (int p = 0; p < bench.reference->part_count; p++) {
		left[p] = bench.reference->instance
				  ->drawable[bench.reference->part[p].drawable]
				  .primitive->index_count;
	}
	for (int p = 0; p < rigid->part_count; p++) {
		const struct rigid_part *part = &rigid->part[p];

		assert_true(part->index_count > 0);
		left[part->part] -= part->index_count;
		for (int i = 0; i < part->index_count; i += 3) {
			expect_heaviest(rigid, part,
				rigid->index + part->first_index + i);
		}
	}
	for (int p = 0; p < bench.reference->part_count; p++) {
		assert_int_equal(left[p], 0);
	}
	candidate_destroy(&candidate);
	compared_clip_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_normals_turn_with_the_nodes_of_parts),
		cmocka_unit_test(test_parts_take_positions_and_normals),
		cmocka_unit_test(test_parts_without_skins_move_exactly),
		cmocka_unit_test(
			test_triangles_follow_the_joint_of_the_largest_weight),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
