/* How far a turn and a wave reach each vertex of a morphed part. */
#include "app/anim/ease.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/instance/bend.h"
#include "platform/base/compiler.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDE = 10,
	VERTICES = (SIDE + 1) * (SIDE + 1),
	FAINT = 0,  /* moves too little to count; at the corner 0, 0 */
	WEAK = SIDE /* just enough; at the corner 2, 0 */
};

static const struct bend_neck neck = {.low = 0.5f, .high = 1.5f};

/*
 * A grid of 2 x 2 units, of which two targets move parts: x from 0.4 to 1, y
 * from 0.6 to 1.4. z goes with x.
 */
struct scene {
	struct model *model;
	struct instance *instance;
	float moved[2][VERTICES][3], weight[2];
	struct model_target target[2];
};

static void begin(struct scene *scene, const char *kernel, bool normals)
{
	struct log nowhere = log_to_nowhere();
	struct model_primitive *primitive;

	memset(scene, 0, sizeof(*scene));
	scene->model = small_model_grid(SIDE, SIDE, 2, normals);
	primitive = scene->model->mesh[0].primitive;
	assert_int_equal(primitive->vertex_count, VERTICES);
	for (int v = 0; v < VERTICES; v++) {
		float *at = primitive->position[v];
		bool inside = at[0] > 0.3f && at[0] < 1.1f && at[1] > 0.5f &&
			at[1] < 1.5f;

		at[2] = 0.5f * at[0];
		scene->moved[at[1] > 0.9f][v][2] = inside ? -1 : 0;
	}
	scene->moved[0][FAINT][0] = 0.079f;
	scene->moved[1][WEAK][1] = -0.081f;
	for (int t = 0; t < 2; t++) {
		scene->target[t].position =
			(struct model_deltas){.vertex_count = VERTICES,
				.number = MODEL_FLOAT,
				.unit = 1,
				.value = scene->moved[t]};
	}
	primitive->target = scene->target;
	scene->model->mesh[0].target_count = 2;
	scene->model->weight_count = 2;
	scene->model->rest_weights = scene->weight;
	assert_int_equal(instance_create(scene->model, kernel_find(kernel),
				 &nowhere, &scene->instance),
		0);
}

static void end(struct scene *scene)
{
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

/* 1 up to 0.8 halves of the box from its middle, 0 from 1.45 halves on. */
static double reach_at(
	const float at[3], const double low[3], const double high[3])
{
	double reach = 1;

	for (int axis = 0; axis < 3; axis++) {
		double half = 0.5 * (high[axis] - low[axis]);
		double part =
			fabs((double)at[axis] - 0.5 * (low[axis] + high[axis])) /
			half;

		reach *= (double)ease_at(
			EASE_CUBIC, (float)((1.45 - part) / 0.65));
	}
	return reach;
}

static void check_vertices(const struct bend *bend)
{
	const struct drawable *drawable = bend->part[0].drawable;
	/* The part, and the weakly moved corner. */
	const double low[3] = {0.4, 0, 0.2}, high[3] = {2, 1.4, 1};
	/* Along 0.6, -0.8, 0: from 0.24 - 1.12 to 1.2. */
	const double from = 0.24 - 1.12, to = 1.2;

	for (int axis = 0; axis < 3; axis++) {
		assert_near(bend->low[axis], low[axis], 1e-5);
		assert_near(bend->high[axis], high[axis], 1e-5);
	}
	for (int i = 0; i < VERTICES; i++) {
		const struct bend_vertex *vertex = &bend->part[0].vertex[i];
		const float *at = drawable->primitive->position[batch_vertex(
			drawable, drawable->batch, i)];
		double place =
			(0.6 * (double)at[0] - 0.8 * (double)at[1] - from) /
			(to - from);

		assert_near(vertex->turn_q14,
			16384 * ease_at(EASE_CUBIC, at[1] - 0.5f), 1);
		assert_near(
			vertex->reach_q14, 16384 * reach_at(at, low, high), 2);
		assert_near(vertex->place, 255 * fmin(fmax(place, 0), 1), 0.51);
	}
}

static void test_vertices_are_reached_by_their_place_in_the_part(void **state)
{
	static const struct morph_wave wave = {
		.direction = {0, 0, 1}, .axis = {0.6f, -0.8f, 0}};
	static const char *const kernels[] = {"float", "fixed"};
	static struct scene scene;

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct bend bend;

		begin(&scene, kernels[i], true);
		assert_int_equal(bend_init(&bend, scene.instance, 0, &neck), 0);
		assert_int_equal(bend.part_count, 1);
		bend_set_wave(&bend, &wave);
		check_vertices(&bend);
		end(&scene);
	}
}

/* What targets do not move has no wave, but turns. */
static void test_nothing_reaches_a_part_that_nothing_moves(void **state)
{
	static struct scene scene;
	struct bend bend;

	(void)state;
	begin(&scene, "float", true);
	memset(scene.moved, 0, sizeof(scene.moved));
	assert_int_equal(bend_init(&bend, scene.instance, 0, &neck), 0);
	for (int i = 0; i < VERTICES; i++) {
		assert_int_equal(bend.part[0].vertex[i].reach_q14, 0);
	}
	assert_int_equal(bend.part[0].vertex[VERTICES - 1].turn_q14, 16384);
	end(&scene);
}

/* Facets have vertices that each frame gathers. */
static void test_facets_are_not_bent(void **state)
{
	static struct scene scene;
	struct bend bend;

	(void)state;
	begin(&scene, "float", false);
	assert_int_equal(bend_init(&bend, scene.instance, 0, &neck), 0);
	assert_int_equal(bend.part_count, 0);
	bend_update(&bend, 0.2f, 0.5f);
	end(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_vertices_are_reached_by_their_place_in_the_part),
		cmocka_unit_test(test_nothing_reaches_a_part_that_nothing_moves),
		cmocka_unit_test(test_facets_are_not_bent),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
