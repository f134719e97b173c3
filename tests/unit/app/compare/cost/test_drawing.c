/*
 * What is counted of a picture: how often each part of a model is drawn,
 * shadows on hills, and how near the camera is.
 */
#include "app/compare/cost/drawing.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

enum {
	WIDTH = 60,
	HEIGHT = 80
};

/* The drawables of scene/ground.gltf. */
enum {
	LAWN,
	PLATE,
	LAMP
};

struct picture {
	struct gl_counts counts;
	struct drawing_shadow shadow;
};

/* A lawn, a plate and a lamp above them; the lawn's corner is so high. */
static struct model *load(float hill)
{
	struct model *model = model_fixture("gltf/scene/ground.gltf", NULL);

	model->mesh[LAWN].primitive->position[0][1] = hill;
	return model;
}

/* Draws a picture of the rest pose, framed as wide as it is times zoom. */
static struct picture draw(const struct model *model, float zoom)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance = small_model_instance(model);
	struct bounds box = bounds_of_clip(instance, -1), shown = box;
	struct drawing *drawing = NULL;
	struct picture picture = {.shadow = {0}};
	float extent = drawing_extent(instance);

	assert_int_equal(drawing_create(instance, &box, WIDTH, HEIGHT, &nowhere,
				 &drawing),
		0);
	for (int axis = 0; axis < 3; axis++) {
		shown.low[axis] *= zoom;
		shown.high[axis] *= zoom;
	}
	drawing_frame(drawing, &shown);
	drawing_count(drawing, &picture.counts, &picture.shadow);
	drawing_draw(drawing, instance, extent);
	drawing_count(drawing, NULL, NULL);
	drawing_draw(drawing, instance, extent);
	drawing_destroy(drawing);
	instance_destroy(instance);
	return picture;
}

static void test_shadows_on_hills_count(void **state)
{
	struct model *flat = load(0.0f), *hilly = load(0.2f);
	struct picture level = draw(flat, 1.0f), uneven = draw(hilly, 1.0f);

	(void)state;
	assert_true(level.shadow.points == 0.0 && level.shadow.rays == 0.0);
	assert_true(uneven.shadow.points > 0.0);
	assert_true(uneven.shadow.rays > 0.0);
	/* They are blended after a test of depths. */
	assert_true(uneven.counts.work[GL_WORK_MIXED].pixels > 0.0);
	model_destroy(flat);
	model_destroy(hilly);
}

static double pixels_of(const struct picture *picture)
{
	const struct gl_work *work = picture->counts.work;

	return work[GL_WORK_PLAIN].pixels + work[GL_WORK_SPANS].pixels;
}

static void test_a_smaller_box_is_shown_larger(void **state)
{
	struct model *model = load(0.0f);
	struct picture whole = draw(model, 1.0f), far = draw(model, 2.0f);

	(void)state;
	assert_true(pixels_of(&far) > 0.0);
	assert_true(pixels_of(&whole) > 2.5 * pixels_of(&far));
	model_destroy(model);
}

/* The calls of GL that a drawing of the instance takes. */
static double count_calls(struct drawing *drawing, struct instance *instance)
{
	struct gl_counts counts = {0};

	drawing_count(drawing, &counts, NULL);
	drawing_draw(drawing, instance, drawing_extent(instance));
	drawing_count(drawing, NULL, NULL);
	return counts.calls;
}

/* The calls that a drawable takes in a drawing. */
static double calls_of(const struct model *model, int index)
{
	struct instance *instance = small_model_instance(model);
	struct bounds box = bounds_of_clip(instance, -1);
	struct log nowhere = log_to_nowhere();
	struct drawing *drawing;
	double calls;

	assert_int_equal(drawing_create(instance, &box, WIDTH, HEIGHT, &nowhere,
				 &drawing),
		0);
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_shadows_on_hills_count),
		cmocka_unit_test(test_a_shadow_without_ground_is_drawn_once),
		cmocka_unit_test(test_a_shadow_on_level_ground_is_drawn_twice),
		cmocka_unit_test(test_a_smaller_box_is_shown_larger),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
