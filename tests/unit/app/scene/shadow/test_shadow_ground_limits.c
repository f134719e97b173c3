/*
 * What just counts as ground of a model's own, and what just does not. The
 * model's longest sides are the ground's, 4 units; its lamp reaches from 0.2 to
 * 1.6 above the ground.
 */
#include "app/scene/shadow/shadow_ground.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	LAWN, /* x from -2 to 1; vertices 0 and 3 at the left, 0 and 1 in front */
	PLATE, /* x from 1 to 2 */
	LAMP   /* vertex 5 is its lowest */
};

enum kind {
	NO_GROUND,
	LEVEL,
	UNEVEN
};

static float (*vertices(const struct model *model, int mesh))[3]
{
	return model->mesh[mesh].primitive->position;
}

static enum kind kind_of(const struct model *model)
{
	struct instance *instance = small_model_instance(model);
	struct shadow_ground ground;
	enum kind kind;

	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	assert_true(ground.count == 0 || ground.count == 2);
	assert_true(ground.count == 2 || !ground.relief.height);
	kind = ground.count == 0       ? NO_GROUND
		: ground.relief.height ? UNEVEN
				       : LEVEL;
	/* The stage's floor would be in its plane, wherever the bottom is. */
	assert_true(kind != LEVEL || ground.in_plane);
	instance_destroy(instance);
	return kind;
}

static void scale(const struct model *model, int mesh, int axis, float factor)
{
	for (int v = 0; v < model->mesh[mesh].primitive->vertex_count; v++) {
		vertices(model, mesh)[v][axis] *= factor;
	}
}

static void lift(const struct model *model, int mesh, float height)
{
	for (int v = 0; v < model->mesh[mesh].primitive->vertex_count; v++) {
		vertices(model, mesh)[v][1] += height;
	}
}

/* The kind of the changed model, which is the same at any size. */
static enum kind kind_after(
	void (*change)(const struct model *model, float value), float value)
{
	static const float sizes[] = {1, 1e-3f, 1e3f};
	enum kind kind = NO_GROUND;

	for (int i = 0; i < 3; i++) {
		struct model *model =
			model_fixture("gltf/scene/ground.gltf", NULL);
		enum kind own;

		change(model, value);
		for (int n = 0; n < 9; n++) {
			scale(model, n / 3, n % 3, sizes[i]);
		}
		own = kind_of(model);
		assert_true(i == 0 || own == kind);
		kind = own;
		model_destroy(model);
	}
	return kind;
}

/* The lamp's tip is at the height 0, and the ground is above it. */
static void raise_ground(const struct model *model, float height)
{
	vertices(model, LAMP)[5][1] = 0;
	lift(model, LAWN, height);
	lift(model, PLATE, height);
}

static void test_ground_is_in_the_lowest_tenth(void **state)
{
	(void)state;
	assert_int_equal(kind_after(raise_ground, 0.39f), LEVEL);
	assert_true(kind_after(raise_ground, 0.41f) != LEVEL);
}

static void narrow_x(const struct model *model, float part)
{
	scale(model, LAMP, 0, 4);
	scale(model, LAWN, 0, part);
	scale(model, PLATE, 0, part);
}

static void narrow_z(const struct model *model, float part)
{
	scale(model, LAMP, 2, 4);
	scale(model, LAWN, 2, part);
	scale(model, PLATE, 2, part);
}

static void test_ground_has_four_fifths_of_each_side(void **state)
{
	(void)state;
	assert_int_equal(kind_after(narrow_x, 0.81f), LEVEL);
	assert_int_equal(kind_after(narrow_x, 0.79f), NO_GROUND);
	assert_int_equal(kind_after(narrow_z, 0.81f), LEVEL);
	assert_int_equal(kind_after(narrow_z, 0.79f), NO_GROUND);
}

static void flatten_lamp(const struct model *model, float height)
{
	scale(model, LAMP, 1, height / 1.6f);
}

static void test_the_rest_is_higher_by_a_twentieth(void **state)
{
	(void)state;
	assert_int_equal(kind_after(flatten_lamp, 0.21f), LEVEL);
	assert_int_equal(kind_after(flatten_lamp, 0.19f), NO_GROUND);
}

static void lower_plate(const struct model *model, float depth)
{
	lift(model, PLATE, -depth);
}

/* A slab whose top or bottom has one corner off by this. */
static void bend_top(const struct model *model, float depth)
{
	vertices(model, LAWN)[0][1] = vertices(model, LAWN)[1][1] = -0.2f;
	vertices(model, LAWN)[2][1] = -depth;
}

static void bend_bottom(const struct model *model, float height)
{
	vertices(model, LAWN)[0][1] = -0.2f;
	vertices(model, LAWN)[1][1] = height - 0.2f;
}

static void test_heights_count_as_equal_within_a_thousandth(void **state)
{
	void (*const changes[])(const struct model *, float) = {
		lower_plate, bend_top, bend_bottom};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(changes); i++) {
		assert_int_equal(kind_after(changes[i], 0.0039f), LEVEL);
		assert_int_equal(kind_after(changes[i], 0.0041f), UNEVEN);
	}
}

/* A hill at the left; the lamp is above it. */
static void raise_hill(const struct model *model, float height)
{
	lift(model, LAMP, 2);
	vertices(model, LAWN)[0][1] = vertices(model, LAWN)[3][1] = height;
}

static void test_a_hill_is_in_the_lower_half(void **state)
{
	(void)state;
	assert_int_equal(kind_after(raise_hill, 1.95f), UNEVEN);
	assert_int_equal(kind_after(raise_hill, 2.05f), NO_GROUND);
}

/*
 * A step beside the plate. Its nodes are 4/63 apart, so that it lies between
 * those at 0.984 and 1.048: the plate's corners are off by three quarters of it.
 */
static void make_step(const struct model *model, float height)
{
	vertices(model, LAWN)[1][1] = vertices(model, LAWN)[2][1] = height;
}

static void test_a_relief_is_off_by_at_most_a_twentieth(void **state)
{
	(void)state;
	assert_int_equal(kind_after(make_step, 0.25f), UNEVEN);
	assert_int_equal(kind_after(make_step, 0.28f), NO_GROUND);
}

/*
 * The second triangle of the lawn, folded over its diagonal, which is 5 units
 * long, faces downwards.
 */
static void fold(const struct model *model, float distance)
{
	float *at = vertices(model, LAWN)[3];

	vertices(model, LAWN)[0][1] = 0.1f;
	at[0] = 0.8f * distance - 0.5f;
	at[1] = 0.05f;
	at[2] = 0.6f * distance;
}

/* 6 / (6 + 2.5 * distance) */
static void test_nine_tenths_of_a_hill_face_upwards(void **state)
{
	(void)state;
	assert_int_equal(kind_after(fold, 0.25f), UNEVEN);
	assert_int_equal(kind_after(fold, 0.28f), NO_GROUND);
}

/* The kind with a target of the lawn that moves a vertex by this. */
static enum kind kind_moved(float by, bool uneven)
{
	struct model *model = model_fixture("gltf/scene/ground.gltf", NULL);
	float weight = 0, moved[4][3] = {{0}};
	struct model_target target = {.position = {.vertex_count = 4,
					      .number = MODEL_FLOAT,
					      .unit = 1,
					      .value = moved}};
	enum kind kind;

	model->mesh[LAWN].target_count = 1;
	model->mesh[LAWN].primitive->target = &target;
	model->weight_count = 1;
	model->rest_weights = &weight;
	model->clip_count = 0;
	moved[3][2] = by;
	if (uneven) {
		raise_hill(model, 0.5f);
	}
	kind = kind_of(model);
	model_destroy(model);
	return kind;
}

static void test_a_target_moves_ground_by_less_than_a_thousandth(void **state)
{
	(void)state;
	assert_int_equal(kind_moved(0.0039f, false), LEVEL);
	assert_int_equal(kind_moved(0.0041f, false), NO_GROUND);
	assert_int_equal(kind_moved(0.0039f, true), UNEVEN);
	assert_int_equal(kind_moved(0.0041f, true), NO_GROUND);
}

/* The plate is as wide as the lawn, and its node's parent may be the lawn's. */
static int count_carried(int parent, bool constant)
{
	struct model *model = model_fixture("gltf/scene/ground.gltf", NULL);
	struct model_clip *clip = &model->clip[0];
	struct instance *instance;
	struct shadow_ground ground;

	vertices(model, PLATE)[0][0] = vertices(model, PLATE)[3][0] = -2;
	model->node[PLATE].parent = parent;
	clip->channel[0].node = LAWN;
	clip->channel[0].constant = constant;
	instance = small_model_instance(model);
	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	if (ground.count == 1) {
		assert_int_equal(ground.drawable[0], PLATE);
	}
	instance_destroy(instance);
	model_destroy(model);
	return ground.count;
}

static void test_what_a_moving_node_carries_is_no_ground(void **state)
{
	(void)state;
	assert_int_equal(count_carried(-1, true), 2);
	assert_int_equal(count_carried(-1, false), 1);
	assert_int_equal(count_carried(LAWN, false), 0);
}

/* Whether the ground is still level when it stands like this. */
static bool is_level(const float rotation[4], float lawn_up, float plate_up)
{
	static const struct stage stage = {.has_stencil = true};
	static const float light[3] = {0, 1, 0};
	struct model *model = model_fixture("gltf/scene/ground.gltf", NULL);
	struct instance *instance;
	struct texture_set textures = {0};
	struct gl gl = gl_recorder_begin();
	struct shadow_ground ground;
	bool level;

	/* A slab of the height 0.2: its box is tilted with it. */
	vertices(model, LAWN)[0][1] = vertices(model, LAWN)[1][1] = -0.2f;
	instance = small_model_instance(model);
	assert_int_equal(shadow_ground_find(&ground, instance), 0);
	assert_int_equal(ground.count, 2);
	for (int n = LAWN; n <= PLATE; n++) {
		memcpy(instance->pose.local[n].rotation, rotation,
			4 * sizeof(*rotation));
	}
	instance->pose.local[LAWN].translation[1] = lawn_up;
	instance->pose.local[PLATE].translation[1] = plate_up;
	instance_update(instance);
	level = shadow_ground_begin(
		&ground, &stage, &gl, light, instance, &textures);
	if (level) {
		stage_top_end(&gl);
	}
	for (int i = 0; i < 2; i++) {
		assert_int_equal(instance->drawable[i].hidden, level);
		shadow_ground_hide(&ground, instance, i == 0);
		assert_int_equal(instance->drawable[0].hidden, i == 0);
		assert_int_equal(instance->drawable[1].hidden, i == 0);
		shadow_ground_hide(&ground, instance, level);
	}
	instance_destroy(instance);
	model_destroy(model);
	return level;
}

/* A turn about the vertical leaves it level, and one about x or z does not. */
static void test_ground_is_level_within_a_thousandth(void **state)
{
	static const float none[4] = {0, 0, 0, 1},
			   about_y[4] = {0, 0.6f, 0, 0.8f};
	static const float about_x[4] = {0.01f, 0, 0, 0.99995f};
	static const float about_z[4] = {0, 0, -0.01f, 0.99995f};
	static const float over[4] = {1, 0, 0, 0};

	(void)state;
	assert_true(is_level(none, 0, 0));
	assert_true(is_level(about_y, 0, 0));
	assert_false(is_level(about_x, 0, 0));
	assert_false(is_level(about_z, 0, 0));
	assert_false(is_level(over, 0, 0));
	assert_true(is_level(none, 0.5f, 0.5f));
	assert_true(is_level(none, 0.5f, 0.5039f));
	assert_false(is_level(none, 0.5f, 0.5041f));
	assert_true(is_level(none, 0.5f, 0.4961f));
	assert_false(is_level(none, 0.5f, 0.4959f));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ground_is_in_the_lowest_tenth),
		cmocka_unit_test(test_ground_has_four_fifths_of_each_side),
		cmocka_unit_test(test_the_rest_is_higher_by_a_twentieth),
		cmocka_unit_test(test_heights_count_as_equal_within_a_thousandth),
		cmocka_unit_test(test_a_hill_is_in_the_lower_half),
		cmocka_unit_test(test_a_relief_is_off_by_at_most_a_twentieth),
		cmocka_unit_test(test_nine_tenths_of_a_hill_face_upwards),
		cmocka_unit_test(
			test_a_target_moves_ground_by_less_than_a_thousandth),
		cmocka_unit_test(test_what_a_moving_node_carries_is_no_ground),
		cmocka_unit_test(test_ground_is_level_within_a_thousandth),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
