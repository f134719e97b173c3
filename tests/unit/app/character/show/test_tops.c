/* Shadows on level surfaces of a character's parts. */
#include "tests/unit/app/character/show/drawn.h"

#include <stdio.h>

/*
 * A level top of the turntable, and the crate that may stand above it. The
 * crate's middle lies 0.06 above the ground.
 */
#define TOP "[part Base]\ntop = 0.5 -2 -2 2 2\n"

static int draws_with(const char *text, bool has_stencil)
{
	struct shown shown;
	int count;

	begin(&shown, "assets/arm.glb", text);
	shown.stage.has_stencil = has_stencil;
	acting_run_to(&shown.acting, 0.1, 50.0);
	count = draw(&shown);
	end(&shown);
	return count;
}

/* The arm alone has shadows above the turntable; it is drawn once more. */
static void test_what_is_above_a_top_casts_shadows_on_it(void **state)
{
	int plain, low, high, none;

	(void)state;
	plain = draws_with("[part Base]\n[part Crate]\n", true);
	none = draws_with(TOP "[part Crate]\n", false);
	assert_int_equal(none, plain);
	low = draws_with(TOP "[part Crate]\n", true);
	/* The marked rectangle, and at least a link of the arm. */
	assert_true(low >= plain + 2);
	high = draws_with(TOP "[part Crate]\ny = 0.6\n", true);
	assert_int_equal(high, low + 1);
	/* Beside the top, where its shadow passes by. */
	for (int side = -1; side <= 1; side += 2) {
		char text[128];

		snprintf(text, sizeof(text),
			TOP "[part Crate]\ny = 0.6\nx = %d\n", 4 * side);
		assert_int_equal(draws_with(text, true), low);
		snprintf(text, sizeof(text),
			TOP "[part Crate]\ny = 0.6\nz = %d\n", 4 * side);
		assert_int_equal(draws_with(text, true), low);
	}
	assert_int_equal(draws_with(TOP "[part Crate]\ny = 0.6\n"
					"[scene]\nshadow = no\n",
				 true),
		plain / 2);
}

/* A crate that sinks into it by 2% of its extent, which is 4, is above it. */
static void test_what_sinks_into_a_top_a_little_is_above_it(void **state)
{
	int high = draws_with(TOP "[part Crate]\ny = 0.6\n", true);

	(void)state;
	assert_int_equal(draws_with(TOP "[part Crate]\ny = 0.43\n", true), high);
	assert_int_equal(
		draws_with(TOP "[part Crate]\ny = 0.41\n", true), high - 1);
}

/* The first drawable, too; but not what is hidden. */
static void test_all_above_a_top_but_its_own_node_casts_a_shadow(void **state)
{
	struct shown shown;
	int plain, with, all = 0;

	(void)state;
	plain = draws_with("[part Car]\n", true);
	begin(&shown, "assets/arm.glb", "[part Car]\ntop = -1 -9 -9 9 9\n");
	acting_run_to(&shown.acting, 0.1, 50.0);
	for (int i = 0; i < shown.acting.instance->drawable_count; i++) {
		all += shown.acting.instance->drawable[i].node !=
			model_find_node(shown.acting.model, "Car");
	}
	with = draw(&shown);
	/* One for the rectangle. */
	assert_int_equal(with, plain + 1 + all);
	/* It was drawn, and cast a shadow on the ground and on the top. */
	shown.acting.instance->drawable[0].hidden = true;
	assert_int_equal(draw(&shown), with - 3);
	end(&shown);
}

/* A crate 1 m above the top, whose edge is 0.12 long, at x and z. */
static int draws_with_crate_at(double x, double z)
{
	char text[160];

	snprintf(text, sizeof(text),
		TOP "[part Crate]\ny = 1.44\nx = %.3f\nz = %.3f\n", x - 0.34,
		z - 0.4);
	return draws_with(text, true);
}

/* Light falls by 0.778 along 0.389 and 0.494; the top ends at -2 and 2. */
static void test_a_shadow_falls_on_a_top_that_the_light_reaches(void **state)
{
	static const double in[4][2] = {{2.55, 0}, {-1.4, 0}, {0, 2.69},
		{0, -1.25}},
			    out[4][2] = {
				    {2.65, 0}, {-1.65, 0}, {0, 2.8}, {0, -1.5}};
	int with = draws_with_crate_at(0, 0);

	(void)state;
	for (int i = 0; i < 4; i++) {
		assert_int_equal(draws_with_crate_at(in[i][0], in[i][1]), with);
		assert_int_equal(
			draws_with_crate_at(out[i][0], out[i][1]), with - 1);
	}
}

static float marked[4][3];
static int rectangles;

static void note_rectangle(GLenum mode, GLint first, GLsizei count)
{
	if (mode == GL_TRIANGLE_FAN && count == 4) {
		assert_int_equal(first, 0);
		memcpy(marked, array, sizeof(marked));
		rectangles++;
	}
}

/* From one corner round to the other, where the node is. */
static void test_the_rectangle_of_a_top_is_marked(void **state)
{
	static const float wanted[4][2] = {
		{-1.5f, -0.5f}, {2, -0.5f}, {2, 1}, {-1.5f, 1}};
	struct shown shown;

	(void)state;
	begin(&shown, "assets/arm.glb",
		"[part Base]\ntop = 0.3 -2 -1 1.5 0.5\nx = 0.5\nz = 0.5\n");
	shown.gl.VertexPointer = note_array;
	shown.gl.DrawArrays = note_rectangle;
	shown.stage.camera.distance = 1.0f;
	acting_run_to(&shown.acting, 0.1, 50.0);
	rectangles = 0;
	character_draw(&shown.drawing, &shown.stage, &shown.textures, &shown.gl);
	assert_int_equal(rectangles, 1);
	for (int i = 0; i < 4; i++) {
		assert_near(marked[i][0], unit * wanted[i][0], 1e-5);
		assert_near(marked[i][1], unit * 0.3 + 0.001, 1e-5);
		assert_near(marked[i][2], unit * wanted[i][1], 1e-5);
	}
	end(&shown);
}

/* A node's scale, another one on each axis, does not change what a file means. */
static void test_numbers_of_a_part_are_metres_on_each_axis(void **state)
{
	static const float scale[3] = {2, 4, 8};
	static const float top[5] = {
		1.0f / 4, -2.0f / 2, -3.0f / 8, 5.0f / 2, 7.0f / 8};
	struct log log = log_to_stderr(LOG_ERROR);
	struct acting acting = {0};
	const struct character_part *part;
	int base;

	(void)state;
	assert_int_equal(model_load("assets/arm.glb", &log, &acting.model), 0);
	base = model_find_node(acting.model, "Base");
	for (int axis = 0; axis < 3; axis++) {
		acting.model->node[base].rest.scale[axis] = scale[axis];
	}
	assert_int_equal(instance_create(acting.model, &kernel_float, &log,
				 &acting.instance),
		0);
	acting_expect(&acting,
		"[part Base]\ntop = 1 -2 -3 5 7\ntop = 1 -2 -3 5 7\n"
		"guard = 0.5 1 2 3 4 5 6\nguard = 0.5 1 2 3 4 5 6\n");
	part = &acting.character->part[0];
	assert_int_equal(part->top_count, 2);
	assert_int_equal(part->guard_count, 2);
	for (int i = 0; i < 2; i++) {
		const struct character_guard *guard = &part->guard[i];

		assert_all_near(part->top[i], top, 5, 1e-6);
		assert_near(guard->radius_m, 0.5, 0);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(guard->from[axis],
				(float)(axis + 1) / scale[axis], 1e-6);
			assert_near(guard->to[axis],
				(float)(axis + 4) / scale[axis], 1e-6);
		}
	}
	acting_end(&acting);
}

static void test_a_top_that_is_not_level_has_no_shadows(void **state)
{
	int plain = draws_with("[part Base]\nbank = 0\n", true);

	(void)state;
	assert_true(draws_with(TOP "bank = 0.4\n", true) > plain);
	assert_int_equal(draws_with(TOP "bank = 2\n", true), plain);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_is_above_a_top_casts_shadows_on_it),
		cmocka_unit_test(test_what_sinks_into_a_top_a_little_is_above_it),
		cmocka_unit_test(
			test_all_above_a_top_but_its_own_node_casts_a_shadow),
		cmocka_unit_test(
			test_a_shadow_falls_on_a_top_that_the_light_reaches),
		cmocka_unit_test(test_the_rectangle_of_a_top_is_marked),
		cmocka_unit_test(test_numbers_of_a_part_are_metres_on_each_axis),
		cmocka_unit_test(test_a_top_that_is_not_level_has_no_shadows),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
