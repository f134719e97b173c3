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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_normals_turn_with_the_nodes_of_parts),
		cmocka_unit_test(test_parts_take_positions_and_normals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
