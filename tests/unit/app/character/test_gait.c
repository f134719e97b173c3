/* How a board of a metre goes over the ground, from what its clip says. */
#include "app/character/build/gait.h"
#include "app/model/model_deltas.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	STEPS = 8
};

/* Where its clip takes the board, from here to the middle and the end. */
struct way {
	float middle[3], end[3];
};

/* A board that stands on two corners and has no width. */
static struct model *make_board(void)
{
	struct model *model = small_model_grid(1, 1, 1, true);

	for (int v = 0; v < 4; v++) {
		model->mesh[0].primitive->position[v][0] = 0.0f;
	}
	return model;
}

/* Measures the only clip of a board, which it destroys. */
static struct gait measure_clip(struct model *model, struct model_clip *clip)
{
	struct instance *instance;
	struct gait_body body;
	struct gait gait;

	model->clip = clip;
	model->clip_count = 1;
	instance = small_model_instance(model);
	gait_body_make(&body, model);
	assert_int_equal(body.count, 4);
	gait = gait_measure(&body, instance, 0, STEPS);
	instance_destroy(instance);
	model->clip_count = 0;
	model_destroy(model);
	return gait;
}

static struct gait measure(const struct way *way, float duration_s)
{
	const float time_s[3] = {0.0f, 0.5f * duration_s, duration_s};
	const float value[9] = {0, 0, 0, way->middle[0], way->middle[1],
		way->middle[2], way->end[0], way->end[1], way->end[2]};
	struct model_channel channel = {.path = MODEL_TRANSLATION,
		.width = 3,
		.key_count = 3,
		.time_s = time_s,
		.value = value};
	struct model_clip clip = {.name = "way",
		.duration_s = duration_s,
		.channel_count = 1,
		.channel = &channel};

	return measure_clip(make_board(), &clip);
}

/* The same in a second for a board that only a morph target moves along x. */
static struct gait measure_morphed(float x)
{
	static const float moved[4][3] = {
		{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
	const float time_s[3] = {0.0f, 0.5f, 1.0f};
	const float value[3] = {0, 0.5f * x, x};
	float rest = 0.0f;
	struct model_channel channel = {.path = MODEL_WEIGHTS,
		.width = 1,
		.key_count = 3,
		.time_s = time_s,
		.value = value};
	struct model_clip clip = {.name = "way",
		.duration_s = 1.0f,
		.channel_count = 1,
		.channel = &channel};
	struct model_target target = {.position = model_deltas_view(moved, 4)};
	struct model *model = make_board();

	model->mesh->target_count = 1;
	model->mesh->primitive->target = &target;
	model->weight_count = 1;
	model->rest_weights = &rest;
	return measure_clip(model, &clip);
}

/* A straight way over level ground, in a second. */
static struct gait measure_straight(float x, float z)
{
	return measure(&(struct way){{0.5f * x, 0, 0.5f * z}, {x, 0, z}}, 1.0f);
}

static void expect(
	struct gait gait, float drift_x, float drift_z, float x, float z)
{
	assert_near(gait.drift[0], drift_x, 1e-5);
	assert_near(gait.drift[1], drift_z, 1e-5);
	assert_near(gait.velocity[0], x, 1e-5);
	assert_near(gait.velocity[1], z, 1e-5);
}

/* A jump comes down again; whoever climbs ends higher than half its height. */
static void test_a_clip_that_climbs_or_falls_says_how_high_it_is(void **state)
{
	struct gait up = measure(&(struct way){{0, 0.2f, 0}, {0, 3, 0}}, 2.0f);
	struct gait down = measure(&(struct way){{0, -1, 0}, {0, -0.6f, 0}}, 1);

	(void)state;
	assert_int_equal(up.steps, STEPS);
	assert_near(up.rise[0], 0.0, 0.0);
	assert_near(up.rise[STEPS / 2], 0.2, 1e-6);
	assert_near(up.rise[STEPS], 3.0, 1e-6);
	assert_int_equal(down.steps, STEPS);
	assert_near(down.rise[STEPS / 2], -1.0, 1e-6);
	assert_near(down.rise[STEPS], -0.6, 1e-6);
	for (int i = 0; i < 2; i++) {
		const struct way jump = {{0, 5, 0}, {0, i ? 0.49f : 0, 0}};
		struct gait gait = measure(&jump, 1);

		assert_int_equal(gait.steps, 0);
		for (int k = 0; k <= STEPS; k++) {
			assert_near(gait.rise[k], 0.0, 0.0);
		}
	}
}

/* A board that drags its foot along stands where the clip takes it. */
static void test_a_clip_carries_what_goes_further_than_a_seventh_of_its_height(
	void **state)
{
	(void)state;
	expect(measure_straight(0.15f, 0), 0, 0, -0.15f, 0);
	expect(measure_straight(0.151f, 0), 0.151f, 0, 0, 0);
	expect(measure_straight(-0.15f, 0), 0, 0, 0.15f, 0);
	expect(measure_straight(-0.151f, 0), -0.151f, 0, 0, 0);
	expect(measure_straight(0, 0.15f), 0, 0, 0, -0.15f);
	expect(measure_straight(0, -0.151f), 0, -0.151f, 0, 0);
}

static void test_what_is_slower_than_an_eighth_of_its_length_stands(void **state)
{
	(void)state;
	expect(measure_straight(0.119f, 0), 0, 0, 0, 0);
	expect(measure_straight(0, -0.119f), 0, 0, 0, 0);
	expect(measure_straight(0, 0.121f), 0, 0, 0, -0.121f);
	/* In a second. */
	expect(measure(&(struct way){{0.07f, 0, 0}, {0.14f, 0, 0}}, 2.0f), 0, 0,
		0, 0);
	expect(measure(&(struct way){{0.035f, 0, 0}, {0.07f, 0, 0}}, 0.5f), 0,
		0, -0.14f, 0);
}

static void test_a_way_near_an_axis_is_along_it(void **state)
{
	(void)state;
	expect(measure_straight(0.14f, 0.027f), 0, 0, -0.14f, 0);
	expect(measure_straight(0.14f, 0.029f), 0, 0, -0.14f, -0.029f);
	expect(measure_straight(-0.027f, 0.14f), 0, 0, 0, -0.14f);
	expect(measure_straight(-0.029f, 0.14f), 0, 0, 0.029f, -0.14f);
}

/* At first it only rises, and then it goes at that height. */
static void test_feet_touch_the_ground_up_to_3_percent_above_it(void **state)
{
	(void)state;
	expect(measure(&(struct way){{0, 0.029f, 0}, {0.149f, 0.029f, 0}}, 0.5f),
		0, 0, -0.298f, 0);
	expect(measure(&(struct way){{0, 0.05f, 0}, {0.149f, 0.05f, 0}}, 0.5f),
		0, 0, 0, 0);
	expect(measure(&(struct way){{0, 0.031f, 0}, {0.149f, 0.031f, 0}}, 0.5f),
		0, 0, 0, 0);
}

static void test_vertices_that_morph_targets_move_go_over_the_ground(
	void **state)
{
	(void)state;
	expect(measure_morphed(0.14f), 0, 0, -0.14f, 0);
	expect(measure_morphed(-0.14f), 0, 0, 0.14f, 0);
	expect(measure_morphed(0.2f), 0.2f, 0, 0, 0);
}

static void test_what_the_scene_does_not_show_touches_no_ground(void **state)
{
	struct model *model = make_board();
	struct gait_body body;

	(void)state;
	model->node->in_scene = false;
	gait_body_make(&body, model);
	assert_int_equal(body.count, 0);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_clip_that_climbs_or_falls_says_how_high_it_is),
		cmocka_unit_test(
			test_a_clip_carries_what_goes_further_than_a_seventh_of_its_height),
		cmocka_unit_test(
			test_what_is_slower_than_an_eighth_of_its_length_stands),
		cmocka_unit_test(test_a_way_near_an_axis_is_along_it),
		cmocka_unit_test(
			test_feet_touch_the_ground_up_to_3_percent_above_it),
		cmocka_unit_test(
			test_vertices_that_morph_targets_move_go_over_the_ground),
		cmocka_unit_test(
			test_what_the_scene_does_not_show_touches_no_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
