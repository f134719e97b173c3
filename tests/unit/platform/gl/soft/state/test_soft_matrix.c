/* Matrix stacks: every operation against the same in double. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/soft.h"
#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <string.h>

#define ONE FX16_ONE

/* Column-major, as in GL. */
struct wide_matrix {
	double m[16];
};

static struct wide_matrix identity(void)
{
	struct wide_matrix out = {{0}};

	for (int i = 0; i < 4; i++) {
		out.m[5 * i] = 1;
	}
	return out;
}

static struct wide_matrix multiply(
	const struct wide_matrix *a, const struct wide_matrix *b)
{
	struct wide_matrix out = {{0}};

	for (int i = 0; i < 16; i++) {
		for (int k = 0; k < 4; k++) {
			out.m[i] += a->m[i % 4 + 4 * k] * b->m[i / 4 * 4 + k];
		}
	}
	return out;
}

enum operation {
	TRANSLATE,
	SCALE,
	ROTATE,
	FRUSTUM,
	ORTHO,
	LOAD,
	MULT,
	IDENTITY,
};

struct step {
	enum operation operation;
	double v[6];
};

/* What Load and Mult take, made of one number. */
static struct wide_matrix strange(double seed)
{
	struct wide_matrix out;

	for (int i = 0; i < 16; i++) {
		out.m[i] = seed * (i % 5) - 0.75 * (i % 3) + 0.25;
	}
	return out;
}

/* GL ES 1.1 section 2.10.2: the axis is made a unit vector first. */
static struct wide_matrix rotation(const double v[6])
{
	double length = sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
	double angle = v[0] * acos(-1) / 180, c = cos(angle), s = sin(angle);
	double x = v[1] / length, y = v[2] / length, z = v[3] / length;

	return (struct wide_matrix){{x * x * (1 - c) + c,
		y * x * (1 - c) + z * s, x * z * (1 - c) - y * s, 0,
		x * y * (1 - c) - z * s, y * y * (1 - c) + c,
		y * z * (1 - c) + x * s, 0, x * z * (1 - c) + y * s,
		y * z * (1 - c) - x * s, z * z * (1 - c) + c, 0, 0, 0, 0, 1}};
}

static struct wide_matrix projection(const double v[6], bool ortho)
{
	double w = v[1] - v[0], h = v[3] - v[2], d = v[5] - v[4];
	struct wide_matrix out = {{0}};

	if (ortho) {
		out = identity();
		out.m[0] = 2 / w;
		out.m[5] = 2 / h;
		out.m[10] = -2 / d;
		out.m[12] = -(v[1] + v[0]) / w;
		out.m[13] = -(v[3] + v[2]) / h;
		out.m[14] = -(v[5] + v[4]) / d;
		return out;
	}
	out.m[0] = 2 * v[4] / w;
	out.m[5] = 2 * v[4] / h;
	out.m[8] = (v[1] + v[0]) / w;
	out.m[9] = (v[3] + v[2]) / h;
	out.m[10] = -(v[5] + v[4]) / d;
	out.m[11] = -1;
	out.m[14] = -2 * v[5] * v[4] / d;
	return out;
}

static struct wide_matrix factor_of(const struct step *step)
{
	struct wide_matrix out = identity();

	switch (step->operation) {
	case TRANSLATE:
		memcpy(out.m + 12, step->v, 3 * sizeof(double));
		return out;
	case SCALE:
		for (int i = 0; i < 3; i++) {
			out.m[5 * i] = step->v[i];
		}
		return out;
	case ROTATE:
		return rotation(step->v);
	case FRUSTUM:
	case ORTHO:
		return projection(step->v, step->operation == ORTHO);
	case LOAD:
	case MULT:
		return strange(step->v[0]);
	default:
		return out;
	}
}

static void call(struct gl *gl, const struct step *step)
{
	struct wide_matrix wide = strange(step->v[0]);
	GLfixed v[6], m[16];

	gl_fixed_all(step->v, 6, v);
	gl_fixed_all(wide.m, 16, m);
	switch (step->operation) {
	case TRANSLATE:
		gl->Translatex(v[0], v[1], v[2]);
		return;
	case SCALE:
		gl->Scalex(v[0], v[1], v[2]);
		return;
	case ROTATE:
		gl->Rotatex(v[0], v[1], v[2], v[3]);
		return;
	case FRUSTUM:
		gl->Frustumx(v[0], v[1], v[2], v[3], v[4], v[5]);
		return;
	case ORTHO:
		gl->Orthox(v[0], v[1], v[2], v[3], v[4], v[5]);
		return;
	case LOAD:
		gl->LoadMatrixx(m);
		return;
	case MULT:
		gl->MultMatrixx(m);
		return;
	default:
		gl->LoadIdentity();
	}
}

/* Each goes on from the one before. */
static const struct step steps[] = {
	{TRANSLATE, {1.5, -2, 0.25}},
	{ROTATE, {30, 0, 0, 1}},
	{SCALE, {2, 0.5, -1}},
	{ROTATE, {-75, 1, 0, 0}},
	{ROTATE, {200, 0, 3, 0}},
	{ROTATE, {45, 1, 2, -2}},
	{TRANSLATE, {-30, 0, 7.5}},
	{IDENTITY, {0}},
	{ROTATE, {720, 1, 1, 1}},
	{ROTATE, {-1090, 0.25, 0.5, 0}},
	{LOAD, {1.5}},
	{TRANSLATE, {1, 2, 3}},
	{MULT, {-0.5}},
	{SCALE, {0.25, 0.25, 0.25}},
	{ROTATE, {90, 0, 0, 5}},
	{IDENTITY, {0}},
	{FRUSTUM, {-1, 1, -0.75, 0.75, 2, 100}},
	{TRANSLATE, {0, 0, -4}},
	{IDENTITY, {0}},
	{FRUSTUM, {-1, 3, 0.5, -0.75, 0.5, 8}},
	{IDENTITY, {0}},
	{ORTHO, {-2, 6, -1, 3, -1, 10}},
	{ORTHO, {0, 640, 480, 0, -1, 1}},
};

static const struct matrix *top_of(const struct gl_canvas *canvas, GLenum mode)
{
	const struct soft *soft = (const struct soft *)canvas->context;

	return soft->matrices.stack[mode - GL_MODELVIEW].top;
}

static void expect_matrix(const struct gl_canvas *canvas, GLenum mode,
	const struct wide_matrix *wanted)
{
	const float *is = top_of(canvas, mode)->m;

	for (int i = 0; i < 16; i++) {
		assert_near(
			is[i], wanted->m[i], 2e-5 * (1 + fabs(wanted->m[i])));
	}
}

static const GLenum modes[] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};

static void test_each_operation_multiplies_from_the_right(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);

	(void)state;
	for (int n = 0; n < 3; n++) {
		struct wide_matrix wanted = identity();

		canvas.gl->MatrixMode(modes[n]);
		for (size_t i = 0; i < sizeof(steps) / sizeof(steps[0]); i++) {
			struct wide_matrix by = factor_of(&steps[i]);
			enum operation operation = steps[i].operation;
			bool anew = operation == LOAD || operation == IDENTITY;

			call(canvas.gl, &steps[i]);
			wanted = anew ? by : multiply(&wanted, &by);
			expect_matrix(&canvas, modes[n], &wanted);
		}
	}
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

static void test_stacks_are_apart(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);

	(void)state;
	for (int n = 0; n < 3; n++) {
		canvas.gl->MatrixMode(modes[n]);
		canvas.gl->LoadIdentity();
		canvas.gl->Translatex((n + 1) * ONE, 0, 0);
	}
	for (int n = 0; n < 3; n++) {
		struct wide_matrix wanted = identity();

		wanted.m[12] = n + 1;
		expect_matrix(&canvas, modes[n], &wanted);
	}
	gl_canvas_close(&canvas);
}

/* As deep as it goes: each level comes back as it was. */
static void test_popping_brings_each_level_back(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	for (int n = 0; n < 3; n++) {
		struct wide_matrix wanted = identity();
		int level = 0;

		gl->MatrixMode(modes[n]);
		for (; level < SOFT_STACK_DEPTH - 1; level++) {
			gl->PushMatrix();
			gl->Translatex(ONE, 0, 0);
		}
		assert_int_equal(gl->GetError(), GL_NO_ERROR);
		gl->PushMatrix();
		assert_int_equal(gl->GetError(), GL_STACK_OVERFLOW);
		for (; level >= 0; level--) {
			wanted.m[12] = level;
			expect_matrix(&canvas, modes[n], &wanted);
			gl->PopMatrix();
		}
		assert_int_equal(gl->GetError(), GL_STACK_UNDERFLOW);
		expect_matrix(&canvas, modes[n], &wanted);
	}
	gl_canvas_close(&canvas);
}

/* The second unit's texture matrix is one of its own. */
static void test_each_unit_has_a_texture_matrix(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	const struct soft *soft = (const struct soft *)canvas.context;
	struct gl *gl = canvas.gl;

	(void)state;
	gl->MatrixMode(GL_TEXTURE);
	gl->Scalex(2 * ONE, ONE, ONE);
	gl->ActiveTexture(GL_TEXTURE1);
	gl->Scalex(3 * ONE, ONE, ONE);
	assert_near(soft->matrices.stack[STACK_TEXTURE].top->m[0], 2, 0);
	assert_near(soft->matrices.stack[STACK_TEXTURE + 1].top->m[0], 3, 0);
	gl_canvas_close(&canvas);
}

/* s and t are turned, moved and scaled before they are looked up. */
static void test_the_texture_matrix_moves_texels(void **state)
{
	static const float st[] = {0, 0, 1, 0, 0, 1, 1, 1};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	GLuint texture = gl_canvas_make_texture(gl);

	(void)state;
	gl->MatrixMode(GL_TEXTURE);
	gl->Translatex(ONE, 0, 0);
	gl->Rotatex(90 * ONE, 0, 0, ONE);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, st);
	gl_canvas_draw_all(gl);
	/* (s, t) looks up (1 - t, s): red green / blue white turned. */
	gl_expect_color(&canvas, "lower left", 7, 18, (double[]){0, 1, 0});
	gl_expect_color(&canvas, "lower right", 24, 18, (double[]){1, 1, 1});
	gl_expect_color(&canvas, "upper left", 7, 5, (double[]){1, 0, 0});
	gl_expect_color(&canvas, "upper right", 24, 5, (double[]){0, 0, 1});
	gl->DeleteTextures(1, &texture);
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_operation_multiplies_from_the_right),
		cmocka_unit_test(test_stacks_are_apart),
		cmocka_unit_test(test_popping_brings_each_level_back),
		cmocka_unit_test(test_each_unit_has_a_texture_matrix),
		cmocka_unit_test(test_the_texture_matrix_moves_texels),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
