/*
 * What is counted of a picture: how often each part of a model is drawn,
 * shadows on hills, and how near the camera is.
 */
#include "app/compare/cost/drawing.h"
#include "app/model/levels/levels.h"
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
static struct picture draw_in(
	const struct model *model, float zoom, int width, int height)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance = small_model_instance(model);
	struct bounds box = bounds_of_clip(instance, -1), shown = box;
	struct drawing *drawing = NULL;
	struct picture picture = {.shadow = {0}};
	float extent = drawing_extent(instance);

	assert_int_equal(drawing_create(instance, &box, width, height, &nowhere,
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

static struct picture draw(const struct model *model, float zoom)
{
	return draw_in(model, zoom, WIDTH, HEIGHT);
}

static void test_shadows_on_hills_count(void **state)
{
	struct model *flat = load(0.0f), *hilly = load(0.2f);
	struct picture level = draw(flat, 1.0f), uneven = draw(hilly, 1.0f);

	(void)state;
	assert_true(level.shadow.points == 0.0 && level.shadow.rays == 0.0);
	/* Edges are divided as in the largest picture, whatever its size. */
	assert_true(uneven.shadow.points > 100.0);
	assert_true(uneven.shadow.rays > 0.0);
	/* They are blended after a test of depths. */
	assert_true(uneven.counts.work[GL_WORK_MIXED].pixels > 0.0);
	model_destroy(flat);
	model_destroy(hilly);
}

/* Whatever their order is. */
static void test_points_of_all_drawables_count(void **state)
{
	struct model *model = load(0.2f), *turned = load(0.2f);
	struct model_node kept = turned->node[LAWN];
	struct picture picture = draw(model, 1.0f), other;

	(void)state;
	assert_int_equal(model->node_count, LAMP + 1);
	turned->node[LAWN] = turned->node[LAMP];
	turned->node[LAMP] = kept;
	for (int i = 0; i < turned->clip[0].channel_count; i++) {
		int *node = &turned->clip[0].channel[i].node;

		*node = *node == LAMP ? LAWN : *node;
	}
	other = draw(turned, 1.0f);
	assert_near(other.shadow.points, picture.shadow.points, 0.0);
	assert_near(other.shadow.rays, picture.shadow.points, 0.0);
	model_destroy(turned);
	model_destroy(model);
}

/* Light is followed from each of a few points, or from a grid's nodes. */
static void test_many_points_take_fewer_rays(void **state)
{
	struct model *model = load(0.2f), *grid;
	struct model_primitive kept = *model->mesh[LAMP].primitive;
	struct picture picture;

	(void)state;
	grid = small_model_grid(60, 60, 0.25f, true);
	*model->mesh[LAMP].primitive = *grid->mesh->primitive;
	model->mesh[LAMP].primitive->material = kept.material;
	for (int v = 0; v < grid->mesh->primitive->vertex_count; v++) {
		grid->mesh->primitive->position[v][1] += kept.position[0][1];
	}
	picture = draw(model, 1.0f);
	assert_true(picture.shadow.points > 1000.0);
	assert_true(picture.shadow.rays > 1.0);
	assert_true(picture.shadow.rays < 0.5 * picture.shadow.points);
	*model->mesh[LAMP].primitive = kept;
	model_destroy(grid);
	model_destroy(model);
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

/* What a picture of that size shows of a square of so many quads. */
static struct picture draw_square(int quads, int width, int height)
{
	struct model *model = small_model_grid(quads, quads, 1.0f, true);
	struct picture picture = draw_in(model, 1.0f, width, height);

	model_destroy(model);
	return picture;
}

/* A triangle of the shadow, of one colour through a stencil, for each. */
static void test_a_shadow_on_the_floor_has_the_triangles_of_the_model(
	void **state)
{
	(void)state;
	for (int quads = 1; quads < 4; quads++) {
		struct picture picture = draw_square(quads, 480, 640);

		assert_near(picture.counts.work[GL_WORK_FLAT].triangles,
			2.0 * quads * quads, 0.0);
	}
}

/* A square is as high as it is wide, and seen whole. */
static void test_a_model_is_framed_by_the_shorter_side_of_the_picture(
	void **state)
{
	struct picture high = draw_square(1, 60, 240);
	struct picture square = draw_square(1, 60, 60);
	struct picture wide = draw_square(1, 240, 60);

	(void)state;
	assert_true(pixels_of(&square) > 600.0);
	assert_near(pixels_of(&wide), pixels_of(&square), 1.0);
	assert_in_range(pixels_of(&high), pixels_of(&square), 60 * 60);
}

/* The triangles that are drawn if the instance were that large. */
static double triangles_at(float extent, bool keys)
{
	struct log nowhere = log_to_nowhere();
	struct model *model;
	struct instance *instance;
	struct gl_counts counts = {0};
	struct drawing *drawing;
	struct bounds box;

	assert_int_equal(model_load("assets/walker.glb", &nowhere, &model), 0);
	assert_int_equal(levels_make(model), 0);
	instance = small_model_instance(model);
	box = bounds_of_clip(instance, -1);
	assert_int_equal(drawing_create(instance, &box, WIDTH, HEIGHT, &nowhere,
				 &drawing),
		0);
	if (keys) {
		drawing_show_keys(drawing);
	}
	drawing_count(drawing, &counts, NULL);
	drawing_draw(drawing, instance, extent);
	drawing_destroy(drawing);
	instance_destroy(instance);
	model_destroy(model);
	return counts.vertices;
}

/* What is larger reaches nearer to the eye, but key frames only their box. */
static void test_levels_follow_the_extent_unless_key_frames_are_shown(
	void **state)
{
	(void)state;
	assert_true(triangles_at(0.01f, false) < triangles_at(100.0f, false));
	assert_near(triangles_at(0.01f, true), triangles_at(100.0f, true), 0.0);
}

static void test_no_drawing_is_destroyed(void **state)
{
	(void)state;
	drawing_destroy(NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_shadows_on_hills_count),
		cmocka_unit_test(test_points_of_all_drawables_count),
		cmocka_unit_test(test_many_points_take_fewer_rays),
		cmocka_unit_test(test_a_shadow_without_ground_is_drawn_once),
		cmocka_unit_test(test_a_shadow_on_level_ground_is_drawn_twice),
		cmocka_unit_test(test_a_smaller_box_is_shown_larger),
		cmocka_unit_test(
			test_a_shadow_on_the_floor_has_the_triangles_of_the_model),
		cmocka_unit_test(
			test_a_model_is_framed_by_the_shorter_side_of_the_picture),
		cmocka_unit_test(
			test_levels_follow_the_extent_unless_key_frames_are_shown),
		cmocka_unit_test(test_no_drawing_is_destroyed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
