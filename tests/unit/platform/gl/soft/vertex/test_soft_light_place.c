/* Lights at places that are very far from models of any size. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/gl_expect.h"

static void scale(struct gl *gl, int doublings)
{
	const GLfixed by = doublings < 0 ? FX16_ONE / 2 : 2 * FX16_ONE;

	for (int i = 0; i < (doublings < 0 ? -doublings : doublings); i++) {
		gl->Scalex(by, by, by);
	}
}

/*
 * Draws a rectangle that fills the picture: a model of such a scale, which the
 * projection undoes, moved by z, below a white light whose place has a scale of
 * its own.
 */
static void draw(struct gl *gl, const GLfixed place[4], int light_scale,
	int model_scale, GLfixed z)
{
	static const GLfixed white[] = {FX16_ONE, FX16_ONE, FX16_ONE, FX16_ONE};

	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->Enable(GL_NORMALIZE);
	gl->PushMatrix();
	scale(gl, light_scale);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, place);
	gl->PopMatrix();
	gl->MatrixMode(GL_PROJECTION);
	scale(gl, -model_scale);
	gl->MatrixMode(GL_MODELVIEW);
	scale(gl, model_scale);
	gl->Translatex(0, 0, z);
	gl_canvas_draw_all(gl);
}

/* The cosine is 0.8, and the light fades to a half at a distance of 1. */
static void test_a_tiny_model_is_lit_from_afar(void **state)
{
	static const GLfixed place[] = {39322, 0, 52429, FX16_ONE};

	(void)state;
	for (int model_scale = -12; model_scale >= -40; model_scale -= 4) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);

		canvas.gl->Lightx(GL_LIGHT0, GL_LINEAR_ATTENUATION, FX16_ONE);
		draw(canvas.gl, place, 0, model_scale, 0);
		gl_expect_color(&canvas, "a tiny model", 3, 3,
			(double[]){0.4, 0.4, 0.4});
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_a_light_beyond_all_numbers_is_one_far_away(void **state)
{
	static const GLfixed places[][4] = {
		{0, 0, FX16_ONE, 1}, {0, 0, FX16_ONE, -1}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);
		const double lit = i == 0;

		draw(canvas.gl, places[i], 120, 0, 0);
		gl_expect_color(
			&canvas, "beyond", 3, 3, (double[]){lit, lit, lit});
		gl_canvas_end_and_close(&canvas);
	}
}

/* Its coordinates have no place in fixed point; what is lit may be black. */
static void test_a_model_beyond_all_numbers_can_be_lit(void **state)
{
	static const GLfixed place[] = {39322, 0, 52429, FX16_ONE};

	(void)state;
	for (int model_scale = 40; model_scale <= 120; model_scale += 8) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);

		draw(canvas.gl, place, 0, model_scale, -FX16_ONE / 2);
		gl_canvas_end_and_close(&canvas);
	}
}

/* A highlight of so large a product of colours is as bright as can be, or black. */
static void test_highlights_beyond_all_colours_are_cut(void **state)
{
	static const GLfixed place[] = {0, 0, 99 * FX16_ONE, FX16_ONE};

	(void)state;
	for (int sign = -1; sign <= 1; sign += 2) {
		const GLfixed color = 300 * FX16_ONE, other = sign * color;
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);
		const double lit = sign > 0;

		draw(canvas.gl, place, 0, 0, 0);
		canvas.gl->Lightxv(GL_LIGHT0, GL_SPECULAR,
			(GLfixed[]){color, color, color, color});
		canvas.gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR,
			(GLfixed[]){other, other, other, other});
		canvas.gl->Clear(GL_DEPTH_BUFFER_BIT);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color(&canvas, "a highlight", 3, 3,
			(double[]){lit, lit, lit});
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_distances_are_cut_to_16_16(void **state)
{
	static const struct {
		int32_t distance;
		int q;
		int32_t expected;
	} cases[] = {{3 << 20, 20, 3 << 16}, {5, 16, 5}, {7, 60, 0},
		{32767, 0, 32767 << 16}, {32768, 0, INT32_MAX},
		{1, -14, 1 << 30}, {2, -14, INT32_MAX}, {0, -14, 0},
		{1, -15, INT32_MAX}, {0, -15, 0}, {0, -60, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		assert_int_equal(
			soft_shade_to_q16(cases[i].distance, cases[i].q),
			cases[i].expected);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_tiny_model_is_lit_from_afar),
		cmocka_unit_test(test_a_light_beyond_all_numbers_is_one_far_away),
		cmocka_unit_test(test_a_model_beyond_all_numbers_can_be_lit),
		cmocka_unit_test(test_highlights_beyond_all_colours_are_cut),
		cmocka_unit_test(test_distances_are_cut_to_16_16),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
