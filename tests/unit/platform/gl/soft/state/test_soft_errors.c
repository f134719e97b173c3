/* The errors of GL ES 1.1, and that the call in error changes nothing. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_checks.h"

#define ONE FX16_ONE

/* One call and the error it must leave. */
#define EXPECT(wanted, call)                                   \
	do {                                                   \
		gl->call;                                      \
		assert_int_equal(gl->GetError(), wanted);      \
		assert_int_equal(gl->GetError(), GL_NO_ERROR); \
	} while (0)

static void test_enumerants_are_checked(void **state)
{
	const GLfixed zeros[16] = {0};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	EXPECT(GL_INVALID_ENUM, Enable(GL_RGB));
	EXPECT(GL_INVALID_ENUM, Disable(0));
	EXPECT(GL_INVALID_ENUM, EnableClientState(GL_TEXTURE_2D));
	EXPECT(GL_INVALID_ENUM, MatrixMode(GL_RGB));
	EXPECT(GL_INVALID_ENUM, DepthFunc(GL_ZERO));
	EXPECT(GL_INVALID_ENUM, AlphaFuncx(GL_KEEP, 0));
	EXPECT(GL_INVALID_ENUM, BlendFunc(GL_SRC_COLOR, GL_ZERO));
	EXPECT(GL_INVALID_ENUM, BlendFunc(GL_ONE, GL_DST_COLOR));
	EXPECT(GL_INVALID_ENUM, CullFace(GL_CW));
	EXPECT(GL_INVALID_ENUM, FrontFace(GL_FRONT));
	EXPECT(GL_INVALID_ENUM, ShadeModel(GL_FRONT));
	EXPECT(GL_INVALID_ENUM, StencilFunc(GL_KEEP, 0, 1));
	EXPECT(GL_INVALID_ENUM, StencilOp(GL_KEEP, GL_KEEP, GL_ALWAYS));
	EXPECT(GL_INVALID_ENUM, Lightx(GL_LIGHT0 + 8, GL_SPOT_CUTOFF, 0));
	EXPECT(GL_INVALID_ENUM, Lightxv(GL_LIGHT0, GL_FOG, zeros));
	EXPECT(GL_INVALID_ENUM, LightModelx(GL_FOG, 0));
	EXPECT(GL_INVALID_ENUM, Materialx(GL_FRONT, GL_SHININESS, 0));
	EXPECT(GL_INVALID_ENUM, Fogx(GL_FOG_MODE, GL_RGB));
	EXPECT(GL_INVALID_ENUM, ActiveTexture(GL_TEXTURE0 + 2));
	EXPECT(GL_INVALID_ENUM, ClientActiveTexture(GL_TEXTURE0 + 2));
	EXPECT(GL_INVALID_ENUM, BindTexture(GL_RGB, 1));
	EXPECT(GL_INVALID_ENUM,
		TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
			GL_LINEAR_MIPMAP_NEAREST));
	EXPECT(GL_INVALID_ENUM,
		TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_RGB));
	EXPECT(GL_INVALID_ENUM, DrawArrays(GL_TRIANGLE_FAN + 1, 0, 3));
	EXPECT(GL_INVALID_ENUM, DrawElements(GL_TRIANGLES, 3, GL_FLOAT, zeros));
	EXPECT(GL_INVALID_ENUM, GetIntegerv(GL_RGB, &(GLint){0}));
	gl_canvas_close(&canvas);
}

static void test_values_are_checked(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	GLuint name = 0;

	(void)state;
	EXPECT(GL_INVALID_VALUE, Clear(1));
	EXPECT(GL_INVALID_VALUE, Viewport(0, 0, -1, 4));
	EXPECT(GL_INVALID_VALUE, Scissor(0, 0, 4, -1));
	EXPECT(GL_INVALID_VALUE, LineWidthx(0));
	EXPECT(GL_INVALID_VALUE, PointSizex(-ONE));
	EXPECT(GL_INVALID_VALUE, Frustumx(-ONE, ONE, -ONE, ONE, 0, ONE));
	EXPECT(GL_INVALID_VALUE, Orthox(ONE, ONE, -ONE, ONE, 0, ONE));
	EXPECT(GL_INVALID_VALUE, Lightx(GL_LIGHT0, GL_SPOT_CUTOFF, 91 * ONE));
	EXPECT(GL_INVALID_VALUE,
		Materialx(GL_FRONT_AND_BACK, GL_SHININESS, 129 * ONE));
	EXPECT(GL_INVALID_VALUE, Fogx(GL_FOG_DENSITY, -1));
	EXPECT(GL_INVALID_VALUE, PixelStorei(GL_UNPACK_ALIGNMENT, 3));
	EXPECT(GL_INVALID_VALUE, GenTextures(-1, &name));
	EXPECT(GL_INVALID_VALUE, VertexPointer(1, GL_FLOAT, 0, NULL));
	EXPECT(GL_INVALID_VALUE, ColorPointer(3, GL_FLOAT, 0, NULL));
	EXPECT(GL_INVALID_VALUE, DrawArrays(GL_TRIANGLES, -1, 3));
	EXPECT(GL_INVALID_VALUE, DrawArrays(GL_TRIANGLES, 0, -3));
	EXPECT(GL_INVALID_VALUE,
		TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 3, 4, 0, GL_RGB,
			GL_UNSIGNED_BYTE, NULL));
	EXPECT(GL_INVALID_VALUE,
		TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2048, 1, 0, GL_RGB,
			GL_UNSIGNED_BYTE, NULL));
	gl_canvas_close(&canvas);
}

static void test_pairs_that_do_not_go_together_are_refused(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	uint8_t texels[64] = {0};

	(void)state;
	EXPECT(GL_INVALID_OPERATION,
		TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGB,
			GL_UNSIGNED_BYTE, texels));
	EXPECT(GL_INVALID_OPERATION,
		TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA,
			GL_UNSIGNED_SHORT_5_6_5, texels));
	EXPECT(GL_NO_ERROR,
		TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA,
			GL_UNSIGNED_BYTE, texels));
	EXPECT(GL_INVALID_VALUE,
		TexSubImage2D(GL_TEXTURE_2D, 0, 3, 0, 2, 1, GL_RGBA,
			GL_UNSIGNED_BYTE, texels));
	EXPECT(GL_INVALID_OPERATION,
		TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_ALPHA,
			GL_UNSIGNED_BYTE, texels));
	gl_canvas_close(&canvas);
}

/* How many pushes a stack takes; and as many pops, then one too many. */
static void check_stack(struct gl *gl, GLenum mode, int depth)
{
	gl->MatrixMode(mode);
	for (int i = 1; i < depth; i++) {
		EXPECT(GL_NO_ERROR, PushMatrix());
	}
	EXPECT(GL_STACK_OVERFLOW, PushMatrix());
	for (int i = 1; i < depth; i++) {
		EXPECT(GL_NO_ERROR, PopMatrix());
	}
	EXPECT(GL_STACK_UNDERFLOW, PopMatrix());
}

static void test_stacks_end(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	GLint depth = 0;

	(void)state;
	canvas.gl->GetIntegerv(GL_MAX_MODELVIEW_STACK_DEPTH, &depth);
	assert_true(depth >= 16);
	check_stack(canvas.gl, GL_MODELVIEW, depth);
	check_stack(canvas.gl, GL_PROJECTION, depth);
	check_stack(canvas.gl, GL_TEXTURE, depth);
	gl_canvas_close(&canvas);
}

static void test_the_first_error_stays(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	gl->LineWidthx(-1);
	gl->Enable(0);
	assert_int_equal(gl->GetError(), GL_INVALID_VALUE);
	assert_int_equal(gl->GetError(), GL_NO_ERROR);
	gl_canvas_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_enumerants_are_checked),
		cmocka_unit_test(test_values_are_checked),
		cmocka_unit_test(test_pairs_that_do_not_go_together_are_refused),
		cmocka_unit_test(test_stacks_end),
		cmocka_unit_test(test_the_first_error_stays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
