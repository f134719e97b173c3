/* GL's initial state, GL ES 1.1 tables 6.3 to 6.21, by what is drawn in it. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"

#define ONE FX16_ONE

/* What a case enables or sets, and the grey or colour that comes of it. */
struct initial_case {
	const char *name;
	void (*set)(struct gl *gl);
	double color[3];
};

static void set_nothing(struct gl *gl)
{
	(void)gl;
}

/* The scene's light alone: 0.2 of it on 0.2 of the material. */
static void set_lighting(struct gl *gl)
{
	gl->Enable(GL_LIGHTING);
}

/* From in front, white on 0.8 of the material. */
static void set_first_light(struct gl *gl)
{
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
}

/* The others are black. */
static void set_second_light(struct gl *gl)
{
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT1);
	gl->Enable(GL_LIGHT2);
}

/* A point is no spot: it also lights what is opposite to its direction, -Z. */
static void set_point(struct gl *gl)
{
	static const GLfixed white[4] = {ONE, ONE, ONE, ONE};
	static const GLfixed behind[4] = {0, 0, -ONE, ONE};

	set_second_light(gl);
	gl->Lightxv(GL_LIGHT1, GL_AMBIENT, white);
	gl->Lightxv(GL_LIGHT1, GL_POSITION, behind);
}

/* The material shines in nothing until it is given a colour. */
static void set_shine(struct gl *gl)
{
	static const GLfixed half[4] = {ONE / 2, ONE / 2, ONE / 2, ONE};

	set_first_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, half);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, ONE);
}

static void set_tracked(struct gl *gl)
{
	set_first_light(gl);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->Color4x(ONE / 2, 0, ONE, ONE);
}

/* A depth that is equal does not pass; the clear depth is 1. */
static void set_depth(struct gl *gl)
{
	gl->Enable(GL_DEPTH_TEST);
	gl->Clear(GL_DEPTH_BUFFER_BIT);
	gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, 0);
	gl->Color4x(0, 0, 0, ONE);
}

static void set_blend(struct gl *gl)
{
	gl->Enable(GL_BLEND);
	gl->Color4x(ONE, ONE / 2, 0, ONE / 4);
}

static void set_alpha(struct gl *gl)
{
	gl->Enable(GL_ALPHA_TEST);
	gl->Color4x(0, ONE / 2, 0, 0);
}

static void set_stencil(struct gl *gl)
{
	gl->Enable(GL_STENCIL_TEST);
	gl->Color4x(0, ONE, ONE, ONE);
}

/* Clockwise is the back, which is left out; the rectangle is not. */
static void set_culling(struct gl *gl)
{
	gl->Enable(GL_CULL_FACE);
	gl->Color4x(ONE, ONE, 0, ONE);
}

/* Without an image, texturing does nothing. */
static void set_texture(struct gl *gl)
{
	gl->Enable(GL_TEXTURE_2D);
	gl->Color4x(ONE, 0, ONE, ONE);
}

/* Of density 1, black, at a distance of 0. */
static void set_fog(struct gl *gl)
{
	gl->Enable(GL_FOG);
	gl->Color4x(ONE, ONE / 2, 0, ONE);
}

static void set_linear_fog(struct gl *gl)
{
	gl->Enable(GL_FOG);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Translatex(0, 0, -ONE / 2); /* half way to its end at 1 */
}

static const struct initial_case cases[] = {
	{"white", set_nothing, {1, 1, 1}},
	{"the scene's light", set_lighting, {0.04, 0.04, 0.04}},
	{"light 0", set_first_light, {0.84, 0.84, 0.84}},
	{"other lights", set_second_light, {0.04, 0.04, 0.04}},
	{"a point", set_point, {0.24, 0.24, 0.24}},
	{"no shine", set_shine, {0.54, 0.54, 0.54}},
	{"the tracked colour", set_tracked, {0.6, 0, 1}},
	{"equal depths", set_depth, {1, 1, 1}},
	{"blending", set_blend, {1, 0.5, 0}},
	{"alpha", set_alpha, {0, 0.5, 0}},
	{"stencil", set_stencil, {0, 1, 1}},
	{"culling", set_culling, {1, 1, 0}},
	{"no texture", set_texture, {1, 0, 1}},
	{"fog", set_fog, {1, 0.5, 0}},
	{"fog half way", set_linear_fog, {0.5, 0.5, 0.5}},
};

static void test_the_initial_state_is_gls(void **state)
{
	(void)state;
	for (size_t i = 0; i < 2 * sizeof(cases) / sizeof(cases[0]); i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);

		cases[i / 2].set(canvas.gl);
		gl_canvas_draw_rectangle(canvas.gl, -1, -1, 1, 1, 0);
		gl_expect_color(&canvas, cases[i / 2].name, GL_CANVAS_WIDTH / 2,
			GL_CANVAS_HEIGHT / 2, cases[i / 2].color);
		gl_canvas_end_and_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_initial_state_is_gls),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
