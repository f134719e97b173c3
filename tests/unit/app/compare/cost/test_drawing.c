/* What a drawing consists of: how often each part of a model is drawn. */
#include "app/compare/cost/drawing.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

enum {
	LAWN,
	PLATE,
	LAMP
};

/* The calls of GL that a drawing of the instance takes. */
static double count_calls(struct drawing *drawing, struct instance *instance)
{
	struct gl_counts counts = {0};

	drawing_count(drawing, &counts);
	drawing_draw(drawing, instance, drawing_extent(instance));
	drawing_count(drawing, NULL);
	return counts.calls;
}

/* The calls that a drawable takes in a drawing. */
static double calls_of(const struct model *model, int index)
{
	struct instance *instance = small_model_instance(model);
	struct bounds box = bounds_of_clip(instance, -1);
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct drawing *drawing;
	double calls;

	assert_int_equal(
		drawing_create(instance, &box, 80, 60, &log, &drawing), 0);
	calls = count_calls(drawing, instance);
	instance->drawable[index].batch_count = 0;
	calls -= count_calls(drawing, instance);
	drawing_destroy(drawing);
	instance_destroy(instance);
	return calls;
}

static void test_a_shadow_without_ground_is_drawn_once(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);

	(void)state;
	assert_near(calls_of(model, 0), 2, 0);
	model_destroy(model);
}

/* On the floor and on the ground, which throws no shadow on itself. */
static void test_a_shadow_on_level_ground_is_drawn_twice(void **state)
{
	struct model *model = model_fixture("gltf/scene/ground.gltf", NULL);

	(void)state;
	assert_near(calls_of(model, LAMP), 3, 0);
	assert_near(calls_of(model, PLATE), 2, 0);
	model_destroy(model);
}

static void test_a_shadow_on_hills_is_drawn_once(void **state)
{
	struct model *model = model_fixture("gltf/scene/ground.gltf", NULL);

	(void)state;
	model->mesh[LAWN].primitive->position[0][1] = 0.1f;
	model->mesh[LAWN].primitive->position[1][1] = 0.2f;
	assert_near(calls_of(model, LAMP), 2, 0);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_shadow_without_ground_is_drawn_once),
		cmocka_unit_test(test_a_shadow_on_level_ground_is_drawn_twice),
		cmocka_unit_test(test_a_shadow_on_hills_is_drawn_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
