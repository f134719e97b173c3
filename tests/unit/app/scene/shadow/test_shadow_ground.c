/* Ground of the model's own: a lawn and a plate, and a lamp above them. */
#include "app/anim/math/quat.h"
#include "app/scene/draw/draw.h"
#include "app/scene/shadow/shadow_ground.h"
#include "app/scene/stage/light.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

enum {
	LAWN,
	PLATE,
	LAMP
};

static struct model *load(void)
{
	return model_fixture("gltf/scene/ground.gltf", NULL);
}

/* The number of drawables that are level ground; *y becomes its height. */
static int count_ground(const struct model *model, float *y)
{
	struct instance *instance = small_model_instance(model);
	struct shadow_ground ground;
	int count;

	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	count = ground.relief.height ? 0 : ground.count;
	for (int i = 0; i < count; i++) {
		assert_int_equal(ground.drawable[i], i);
	}
	if (y) {
		*y = ground.y / instance->unit_scale;
	}
	instance_destroy(instance);
	return count;
}

static void test_level_surfaces_at_the_bottom_are_ground(void **state)
{
	struct model *model = load();
	float y = 9.0f;

	(void)state;
	assert_int_equal(count_ground(model, &y), 2);
	assert_near(y, 0, 1e-6);
	model_destroy(model);
}

static void turn_round(const struct model *model, int mesh)
{
	const struct model_primitive *primitive = model->mesh[mesh].primitive;

	for (int k = 0; k < primitive->index_count; k += 3) {
		uint32_t first = primitive->index[k];

		primitive->index[k] = primitive->index[k + 1];
		primitive->index[k + 1] = first;
	}
}

/* A hill in it throws shadows that no plane shows. */
static void test_uneven_ground_has_a_relief(void **state)
{
	struct model *model = load();
	struct instance *instance;
	struct shadow_ground ground;

	(void)state;
	model->mesh[LAWN].primitive->position[0][1] = 0.1f;
	model->mesh[LAWN].primitive->position[1][1] = 0.2f;
	assert_int_equal(count_ground(model, NULL), 0);
	instance = small_model_instance(model);
	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	assert_int_equal(ground.count, 2);
	assert_non_null(ground.relief.height);
	assert_near(shadow_relief_height(&ground.relief, -2, 2), 0.1, 1e-3);
	assert_near(shadow_relief_height(&ground.relief, 2, 2), 0.0, 1e-3);
	instance_destroy(instance);
	model_destroy(model);
}

/* Whether there is uneven ground when two of the lawn's corners are so high. */
static bool has_hill(struct model *model, float height)
{
	struct instance *instance;
	struct shadow_ground ground;

	model->mesh[LAWN].primitive->position[0][1] = height;
	model->mesh[LAWN].primitive->position[1][1] = 0.5f * height;
	instance = small_model_instance(model);
	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	instance_destroy(instance);
	return ground.relief.height != NULL;
}

static void test_walls_and_what_moves_are_no_hills(void **state)
{
	struct model *model = load();

	(void)state;
	assert_true(has_hill(model, 0.2f));
	assert_false(has_hill(model, 3.0f));
	turn_round(model, LAWN);
	assert_false(has_hill(model, 0.2f));
	turn_round(model, LAWN);
	model->clip[0].channel[0].node = LAWN;
	assert_false(has_hill(model, 0.2f));
	model_destroy(model);
}

static void test_a_slab_is_ground(void **state)
{
	struct model *model = load();
	float(*position)[3] = model->mesh[LAWN].primitive->position;
	float y;

	(void)state;
	/* Its far side is thick. */
	position[0][1] = position[1][1] = -0.2f;
	assert_int_equal(count_ground(model, &y), 2);
	assert_near(y, 0, 1e-6);
	model_destroy(model);
}

static void test_what_moves_or_is_clear_is_no_ground(void **state)
{
	struct model *model = load();

	(void)state;
	model->material[model->mesh[LAWN].primitive->material].alpha =
		MODEL_BLEND;
	assert_int_equal(count_ground(model, NULL), 0);
	model_destroy(model);
	model = load();
	model->clip[0].channel[0].node = LAWN;
	assert_int_equal(count_ground(model, NULL), 0);
	model_destroy(model);
}

static bool is_in_plane(const struct model *model)
{
	struct instance *instance = small_model_instance(model);
	struct shadow_ground ground;

	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	instance_destroy(instance);
	return ground.in_plane;
}

/* The floor of a room is one surface with its walls, so it is no ground. */
static void test_a_bottom_that_is_seen_is_in_the_floors_plane(void **state)
{
	struct model *model = load();
	float(*position)[3] = model->mesh[LAMP].primitive->position;

	(void)state;
	assert_true(is_in_plane(model));
	model->material[model->mesh[LAWN].primitive->material].alpha =
		MODEL_BLEND;
	assert_int_equal(count_ground(model, NULL), 0);
	assert_true(is_in_plane(model));
	turn_round(model, LAWN);
	turn_round(model, PLATE);
	assert_false(is_in_plane(model));
	model->node[LAWN].rest.scale[0] *= -1.0f;
	assert_false(is_in_plane(model));
	turn_round(model, LAWN);
	assert_true(is_in_plane(model));
	position[0][1] -= 10.0f;
	assert_false(is_in_plane(model));
	model_destroy(model);
}

/* In its own unit; GL gets a model of about a metre. */
static struct model *load_of_size(float size)
{
	struct model *model = load();

	for (int mesh = LAWN; mesh <= LAMP; mesh++) {
		struct model_primitive *primitive = model->mesh[mesh].primitive;

		for (int v = 0; v < primitive->vertex_count; v++) {
			for (int axis = 0; axis < 3; axis++) {
				primitive->position[v][axis] *= size;
			}
			primitive->position[v][1] += 0.5f * size;
		}
	}
	for (int n = 0; n < model->node_count; n++) {
		for (int axis = 0; axis < 3; axis++) {
			model->node[n].rest.translation[axis] *= size;
		}
	}
	return model;
}

static void test_ground_of_a_tiny_or_huge_model_is_found(void **state)
{
	static const float sizes[] = {1e-3f, 1e3f};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct model *model = load_of_size(sizes[i]);
		float y;

		assert_int_equal(count_ground(model, &y), 2);
		assert_near(y / sizes[i], 0.5, 1e-4);
		assert_true(is_in_plane(model));
		for (int v = 0; v < 2; v++) {
			model->mesh[LAWN].primitive->position[v][1] +=
				0.1f * (float)(v + 1) * sizes[i];
		}
		assert_int_equal(count_ground(model, NULL), 0);
		model_destroy(model);
	}
}

static void stretch_lamp(const struct model *model, int axis, float factor)
{
	const struct model_primitive *lamp = model->mesh[LAMP].primitive;

	for (int v = 0; v < lamp->vertex_count; v++) {
		lamp->position[v][axis] *= factor;
	}
}

static void test_a_model_that_is_only_flat_has_no_ground(void **state)
{
	struct model *model = load();

	(void)state;
	stretch_lamp(model, 1, 0.01f);
	assert_int_equal(count_ground(model, NULL), 0);
	model_destroy(model);
}

/* Files of key frames have targets everywhere, also where nothing moves. */
static void test_targets_that_move_nothing_do_not_matter(void **state)
{
	struct model *model = load();
	float weight = 0, moved[4][3] = {{0}};
	struct model_target target = {.position = {.vertex_count = 4,
					      .number = MODEL_FLOAT,
					      .unit = 1,
					      .value = moved}};

	(void)state;
	model->mesh[LAWN].target_count = 1;
	model->mesh[LAWN].primitive->target = &target;
	model->weight_count = 1;
	model->rest_weights = &weight;
	model->clip[0].channel[0].node = LAWN;
	model->clip[0].channel[0].path = MODEL_WEIGHTS;
	assert_int_equal(count_ground(model, NULL), 2);
	moved[3][1] = 0.5f;
	assert_int_equal(count_ground(model, NULL), 0);
	model_destroy(model);
}

/* A flat thing that lies on it, such as a letter, does not hide the ground. */
static void test_a_small_surface_above_it_is_not_taken_for_it(void **state)
{
	struct model *model = load();
	float y;

	(void)state;
	for (int v = 0; v < 4; v++) {
		model->mesh[PLATE].primitive->position[v][1] = 0.1f;
		model->mesh[PLATE].primitive->position[v][0] *= 0.1f;
		model->mesh[LAWN].primitive->position[v][0] *= 2.0f;
	}
	assert_int_equal(count_ground(model, &y), 1);
	assert_near(y, 0, 1e-6);
	model_destroy(model);
}

static void test_ground_narrower_than_the_model_is_none(void **state)
{
	struct model *model = load();

	(void)state;
	stretch_lamp(model, 0, 6.0f);
	assert_int_equal(count_ground(model, NULL), 0);
	model_destroy(model);
}

/*
 * Begins the shadows on the ground and returns whether it has any; *y becomes
 * the height at which the lamp's shadow lies.
 */
static bool begin_shadows(struct instance *instance,
	const struct shadow_ground *ground, double *y)
{
	const struct stage stage = {.has_stencil = true};
	const struct texture_set textures = {0};
	struct gl gl = gl_recorder_begin();
	const struct gl_recording *drawn = gl_recorder_result();
	float light[3];
	bool begun;

	instance_update(instance);
	light_direction(light);
	begun = shadow_ground_begin(
		ground, &stage, &gl, light, instance, &textures);
	if (begun) {
		draw_instance(&gl, instance, &textures, DRAW_SHADOW);
		assert_true(drawn->draw_count > ground->count);
		*y = drawn->draw[drawn->draw_count - 1].matrix[13] /
			(double)instance->unit_scale;
		stage_top_end(&gl);
	}
	shadow_ground_hide(ground, instance, false);
	return begun;
}

/* A part of a character may lift it, such as the platform of a lift. */
static void check_lifted(float size)
{
	struct model *model = load_of_size(size);
	struct instance *instance = small_model_instance(model);
	struct transform *lawn = &instance->pose.local[LAWN];
	struct transform *plate = &instance->pose.local[PLATE];
	struct shadow_ground ground;
	double y = 9.0 * (double)size;

	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	assert_true(begin_shadows(instance, &ground, &y));
	assert_near(y / (double)size, 0.5, 1e-4);
	lawn->translation[1] += 0.25f * size;
	assert_false(begin_shadows(instance, &ground, &y));
	plate->translation[1] += 0.25f * size;
	assert_true(begin_shadows(instance, &ground, &y));
	assert_near(y / (double)size, 0.75, 1e-4);
	quat_from_axis_angle((const float[3]){1, 0, 0}, 0.2f, lawn->rotation);
	assert_false(begin_shadows(instance, &ground, &y));
	instance_destroy(instance);
	model_destroy(model);
}

static void test_shadows_lie_on_ground_that_was_lifted(void **state)
{
	(void)state;
	check_lifted(1.0f);
	check_lifted(1e-3f);
	check_lifted(1e3f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ground_of_a_tiny_or_huge_model_is_found),
		cmocka_unit_test(test_level_surfaces_at_the_bottom_are_ground),
		cmocka_unit_test(test_uneven_ground_has_a_relief),
		cmocka_unit_test(test_walls_and_what_moves_are_no_hills),
		cmocka_unit_test(test_a_slab_is_ground),
		cmocka_unit_test(test_what_moves_or_is_clear_is_no_ground),
		cmocka_unit_test(
			test_a_bottom_that_is_seen_is_in_the_floors_plane),
		cmocka_unit_test(test_a_model_that_is_only_flat_has_no_ground),
		cmocka_unit_test(test_targets_that_move_nothing_do_not_matter),
		cmocka_unit_test(
			test_a_small_surface_above_it_is_not_taken_for_it),
		cmocka_unit_test(test_ground_narrower_than_the_model_is_none),
		cmocka_unit_test(test_shadows_lie_on_ground_that_was_lifted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
