/*
 * A candidate that is off by known distances and angles.
 */
#ifndef TESTS_UNIT_APP_COMPARE_CANDIDATE_MEASURE_BENCH_H
#define TESTS_UNIT_APP_COMPARE_CANDIDATE_MEASURE_BENCH_H

#include "app/compare/candidate/candidate_error.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

enum {
	VERTICES = 4, /* of a grid of one quad */
	MOMENTS_MAX = 64,
	POSED_MAX = 8192
};

static const float focal_px = 100.0f;

/*
 * A model that stands still, and a candidate that shows its vertices moved. All
 * vectors are those of eye space, which is turned against the model's.
 */
struct bench {
	struct model *model;
	struct model_clip clip;
	struct reference *reference;
	struct screen_view screen;
	vec3 wanted[VERTICES], shown[VERTICES]; /* normals */
	vec3 moved[VERTICES];                   /* times scale_at() */
	float (*scale_at)(float time_s);
	struct candidate candidate;
	float now_s;
	/* moments at which normals were asked for */
	int moment_count;
	float moment_s[MOMENTS_MAX];
	/* all moments, in their order */
	int posed_count;
	float posed_s[POSED_MAX];
};

static inline float scale_of_1(float time_s)
{
	(void)time_s;
	return 1.0f;
}

static inline void pose(struct candidate *candidate, float time_s)
{
	struct bench *bench = candidate->state;

	bench->now_s = time_s;
	assert_in_range(bench->posed_count, 0, POSED_MAX - 1);
	bench->posed_s[bench->posed_count++] = time_s;
	if (!candidate->positions_only) {
		assert_in_range(bench->moment_count, 0, MOMENTS_MAX - 1);
		bench->moment_s[bench->moment_count++] = time_s;
	}
}

/* To model space, of which the view is a turn and a move. */
static inline void from_eye(
	const struct bench *bench, vec3 eye, float w, vec3 out)
{
	mat4 inverse;

	glm_mat4_inv((vec4 *)(uintptr_t)bench->screen.view, inverse);
	glm_mat4_mulv3(inverse, eye, w, out);
}

static inline void take(const struct candidate *candidate, float (*position)[3],
	float (*normal)[3])
{
	const struct bench *bench = candidate->state;
	const struct model_primitive *quad = bench->model->mesh->primitive;

	for (int v = 0; v < VERTICES; v++) {
		vec3 moved;

		glm_vec3_scale((float *)(uintptr_t)bench->moved[v],
			bench->scale_at(bench->now_s), moved);
		from_eye(bench, moved, 0.0f, moved);
		glm_vec3_add(quad->position[v], moved, position[v]);
		if (normal) {
			from_eye(bench, (float *)(uintptr_t)bench->shown[v],
				0.0f, normal[v]);
		}
	}
}

static inline void begin(struct bench *bench)
{
	*bench = (struct bench){.model = small_model_grid(1, 1, 1.0f, true),
		.clip = {.name = "still", .duration_s = 1.0f},
		.scale_at = scale_of_1};
	bench->screen = (struct screen_view){.width = 480,
		.height = 640,
		.focal_px = focal_px,
		.unit = 1.0f,
		.px_per_unit = 1e9f};
	glm_lookat((vec3){3, 5, 7}, (vec3){1, 0, 2}, (vec3){0.6f, 0.8f, 0},
		bench->screen.view);
	for (int v = 0; v < VERTICES; v++) {
		from_eye(bench, (vec3){0, 0, -10}, 1.0f,
			bench->model->mesh->primitive->position[v]);
	}
	bench->model->clip = &bench->clip;
	bench->model->clip_count = 1;
	bench->candidate = (struct candidate){.vertex_count = VERTICES,
		.pose = pose,
		.take = take,
		.state = bench};
	assert_int_equal(bench->model->mesh->primitive->vertex_count, VERTICES);
}

static inline void end(struct bench *bench)
{
	bench->model->clip = NULL;
	bench->model->clip_count = 0;
	model_destroy(bench->model);
}

/* Compares at moments of a grid, and the halves between them. */
static inline struct candidate_error measure_grid(
	struct bench *bench, const struct time_grid *grid, int normal_moments)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct candidate_error error;

	for (int v = 0; v < VERTICES; v++) {
		from_eye(bench, bench->wanted[v], 0.0f,
			bench->model->mesh->primitive->normal[v]);
	}
	bench->moment_count = 0;
	bench->posed_count = 0;
	assert_int_equal(
		reference_create(bench->model, 0, &log, &bench->reference), 0);
	bench->candidate.reference = bench->reference;
	assert_int_equal(
		candidate_error_measure(&bench->candidate, &bench->screen, grid,
			normal_moments, NULL, &error),
		0);
	reference_destroy(bench->reference);
	return error;
}

/* The same of so many moments from 0 to 1. */
static inline struct candidate_error measure(
	struct bench *bench, int moments, int normal_moments)
{
	float time_s[MOMENTS_MAX];
	const struct time_grid grid = {.time_s = time_s, .count = moments};

	for (int i = 0; i < moments; i++) {
		time_s[i] = (float)i / (float)(moments - 1);
	}
	return measure_grid(bench, &grid, normal_moments);
}

#endif
