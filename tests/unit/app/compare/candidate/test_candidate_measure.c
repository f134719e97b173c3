/* What is measured of a candidate that is off by known distances and angles. */
#include "app/scene/stage/light.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/candidate/measure_bench.h"

#include <math.h>
#include <string.h>

/* A unit at a distance of 10 is 10 pixels. */
static void test_the_mean_is_that_of_all_vertices(void **state)
{
	struct candidate_error error;
	struct bench bench;

	(void)state;
	begin(&bench);
	glm_vec3_copy((vec3){0.3f, 0.4f, 0}, bench.moved[0]);
	glm_vec3_copy((vec3){0, -0.2f, 0}, bench.moved[2]);
	glm_vec3_copy((vec3){-0.1f, 0, 0}, bench.moved[3]);
	error = measure(&bench, 2, 500);
	assert_near(error.peak_px, 5.0, 1e-3);
	assert_near(error.mean_px, (5.0 + 2.0 + 1.0) / 4.0, 1e-3);
	assert_near(error.peak_s, 0.0, 0.0); /* the first of equal ones */
	assert_int_equal(error.samples, 3);
	assert_near(error.normal_deg, 0.0, 1e-3);
	assert_near(error.shade_steps, 0.0, 1e-3);
	assert_near(error.outline_px, 0.0, 0.0);
	assert_false(bench.candidate.positions_only);
	end(&bench);
}

/* Moments of normals are moments of the grid, evenly spread. */
static void test_normals_are_compared_at_some_moments(void **state)
{
	static const int most[] = {500, 10, 9, 5, 4, 3, 2, 1};
	static const int steps[] = {1, 2, 2, 3, 3, 4, 6, 11};
	struct bench bench;

	(void)state;
	begin(&bench);
	for (int i = 0; i < 8; i++) {
		measure(&bench, 10, most[i]);
		assert_int_equal(bench.moment_count, 9 / steps[i] + 1);
		for (int k = 0; k < bench.moment_count; k++) {
			assert_near(bench.moment_s[k], k * steps[i] / 9.0, 1e-6);
		}
	}
	end(&bench);
}

static void test_the_largest_angle_of_two_normals(void **state)
{
	static const float degrees[] = {0, 0.5f, 10, 90, 150, 180};
	struct bench bench;

	(void)state;
	begin(&bench);
	for (int i = 0; i < 6; i++) {
		vec3 normal = {0.36f, 0.48f, 0.8f}, axis = {0.8f, -0.6f, 0};

		for (int v = 0; v < VERTICES; v++) {
			glm_vec3_copy(normal, bench.wanted[v]);
			glm_vec3_copy(normal, bench.shown[v]);
		}
		glm_vec3_rotate(bench.shown[2], glm_rad(degrees[i]), axis);
		assert_near(measure(&bench, 2, 2).normal_deg, degrees[i], 0.06);
		/* Vertices without normals have no angle. */
		glm_vec3_zero(bench.shown[2]);
		assert_near(measure(&bench, 2, 2).normal_deg, 0.0, 0.03);
		glm_vec3_copy(normal, bench.shown[2]);
		glm_vec3_zero(bench.wanted[1]);
		glm_vec3_zero(bench.shown[1]);
		assert_near(measure(&bench, 2, 2).normal_deg, 0.0, 0.03);
	}
	end(&bench);
}

/* A surface that faces the light has all 63 steps, and one behind it none. */
static void test_steps_of_shading_are_those_of_the_key_light(void **state)
{
	static const float cosines[][2] = {{1, 0}, {0, 1}, {1, 0.5f},
		{-1, -0.5f}, {-1, 0.25f}, {0.5f, -1}};
	struct bench bench;
	float world[3];
	vec3 light, across;

	(void)state;
	begin(&bench);
	light_direction(world);
	glm_mat4_mulv3(bench.screen.view, world, 0.0f, light);
	glm_vec3_ortho(light, across);
	glm_vec3_normalize(across);
	for (size_t i = 0; i < sizeof(cosines) / sizeof(cosines[0]); i++) {
		float lit[2];

		for (int k = 0; k < 2; k++) {
			float *normal = k ? bench.shown[1] : bench.wanted[1];
			float cosine = cosines[i][k];

			glm_vec3_scale(light, cosine, normal);
			glm_vec3_muladds(
				across, sqrtf(1.0f - cosine * cosine), normal);
			lit[k] = cosine > 0.0f ? cosine : 0.0f;
		}
		assert_near(measure(&bench, 2, 2).shade_steps,
			63.0f * fabsf(lit[0] - lit[1]), 0.05);
	}
	end(&bench);
}

/* Across it, in the normal's direction on the screen; along it, nothing. */
static void test_an_outline_moves_where_normals_are_seen_from_the_side(
	void **state)
{
	static const struct {
		float eye[3], normal[3], moved[3], outline_px;
	} cases[] = {
		{{0, 0, -10}, {1, 0, 0}, {0.3f, 0.4f, 0}, 3},
		{{0, 0, -10}, {0, -1, 0}, {0.3f, 0.4f, 0}, 4},
		{{0, 0, -10}, {0.6f, 0.8f, 0}, {0.5f, 0.1f, 0}, 3.8f},
		{{0, 0, -10}, {0.6f, -0.8f, 0}, {-0.5f, 0.1f, 0}, 3.8f},
		{{0, 0, -10}, {0.9818f, 0, 0.19f}, {0.3f, 0, 0}, 3},
		{{0, 0, -10}, {0, 0.9818f, -0.19f}, {0, 0.3f, 0}, 3},
		{{0, 0, -10}, {0.9777f, 0, 0.21f}, {0.3f, 0, 0}, 0},
		{{0, 0, -10}, {0, 0.9777f, -0.21f}, {0, 0.3f, 0}, 0},
		/* of any length, and just before the eye */
		{{0, 0, -10}, {1.4727f, 0, 0.285f}, {0.3f, 0, 0}, 3},
		{{0, 0, -10}, {1.4665f, 0, 0.315f}, {0.3f, 0, 0}, 0},
		{{0, 0, -10}, {0.72f, 0, 0}, {0.3f, 0, 0}, 3},
		{{0, 0, -10}, {0.7f, 0, 0}, {0.3f, 0, 0}, 0},
		{{0, 0, -0.5f}, {1, 0, 0}, {0.015f, 0.02f, 0}, 3},
		/* seen along a slope, so that the normal has to slope as well */
		{{6, 0, -8}, {0.8f, 0, 0.6f}, {0.4f, 0, 0}, 5},
		{{0, 6, -8}, {0, 0.8f, 0.6f}, {0, 0.4f, 0}, 5},
		{{6, 0, -8}, {1, 0, 0}, {0.4f, 0, 0}, 0},
		{{0, 6, -8}, {0, 1, 0}, {0, 0.4f, 0}, 0},
	};
	struct bench bench;

	(void)state;
	begin(&bench);
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		vec3 eye, normal;

		memcpy(eye, cases[i].eye, sizeof(eye));
		memcpy(normal, cases[i].normal, sizeof(normal));
		from_eye(&bench, eye, 1.0f,
			bench.model->mesh->primitive->position[3]);
		glm_vec3_copy(normal, bench.wanted[3]);
		glm_vec3_copy(normal, bench.shown[3]);
		memcpy(bench.moved[3], cases[i].moved, sizeof(vec3));
		assert_near(measure(&bench, 2, 2).outline_px,
			cases[i].outline_px, 2e-3);
	}
	end(&bench);
}

/* Far at the side of the eye, it may be seen from the side nevertheless. */
static void test_a_normal_along_the_view_has_no_direction_on_the_screen(
	void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	glm_mat4_identity(bench.screen.view);
	for (int v = 0; v < VERTICES; v++) {
		glm_vec3_copy((vec3){10, 0, -1},
			bench.model->mesh->primitive->position[v]);
	}
	for (int axis = 0; axis < 2; axis++) {
		glm_vec3_copy((vec3){0, 0, 1}, bench.wanted[0]);
		glm_vec3_copy((vec3){0, 0, 1}, bench.shown[0]);
		glm_vec3_zero(bench.moved[0]);
		bench.moved[0][axis] = 0.1f;
		assert_near(measure(&bench, 2, 2).outline_px, 0.0, 0.0);
	}
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_mean_is_that_of_all_vertices),
		cmocka_unit_test(test_normals_are_compared_at_some_moments),
		cmocka_unit_test(test_the_largest_angle_of_two_normals),
		cmocka_unit_test(
			test_steps_of_shading_are_those_of_the_key_light),
		cmocka_unit_test(
			test_an_outline_moves_where_normals_are_seen_from_the_side),
		cmocka_unit_test(
			test_a_normal_along_the_view_has_no_direction_on_the_screen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
