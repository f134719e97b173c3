/*
 * What each call of gl_functions.h refuses: the error, that the first error
 * stays, and that nothing else of the context changes. A call without a row
 * here must be among those that refuse nothing.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/soft.h"
#include "tests/support/gl/gl_entries.h"
#include "tests/support/gl/gl_expect.h"

#include <stdlib.h>
#include <string.h>

#define ONE FX16_ONE

struct trial {
	struct gl_canvas canvas;
	struct soft before;
	bool tried[ENTRIES];
};

static void remember(struct trial *trial)
{
	memcpy(&trial->before, trial->canvas.context, sizeof(trial->before));
}

static void expect_unchanged(
	struct trial *trial, enum entry entry, GLenum wanted, const char *text)
{
	GLenum error = trial->canvas.gl->GetError();

	trial->tried[entry] = true;
	if (error != wanted) {
		fail_msg("%s leaves error 0x%04x, not 0x%04x", text, error,
			wanted);
	}
	if (memcmp(&trial->before, trial->canvas.context,
		    sizeof(trial->before)) != 0) {
		fail_msg("%s changes the context", text);
	}
}

/*
 * Twice: with no error before, and after one of another kind, which stays.
 * Both errors that are used for it change nothing themselves.
 */
#define REFUSED(wanted, name, ...)                                             \
	do {                                                                   \
		remember(trial);                                               \
		(void)gl->name(__VA_ARGS__);                                   \
		expect_unchanged(trial, ENTRY_##name, wanted,                  \
			#name "(" #__VA_ARGS__ ")");                           \
		gl->LineWidthx(0);                                             \
		(void)gl->name(__VA_ARGS__);                                   \
		expect_unchanged(trial, ENTRY_##name, GL_INVALID_VALUE,        \
			"after another error, " #name "(" #__VA_ARGS__ ")");   \
		if ((wanted) != GL_INVALID_ENUM) {                             \
			gl->Enable(0);                                         \
			(void)gl->name(__VA_ARGS__);                           \
			expect_unchanged(trial, ENTRY_##name, GL_INVALID_ENUM, \
				#name " after Enable");                        \
		}                                                              \
	} while (0)

#define ENUM(...)  REFUSED(GL_INVALID_ENUM, __VA_ARGS__)
#define VALUE(...) REFUSED(GL_INVALID_VALUE, __VA_ARGS__)
#define WRONG(...) REFUSED(GL_INVALID_OPERATION, __VA_ARGS__)

static const GLfixed four[4] = {ONE, ONE, ONE, ONE};
static const GLfixed none[4] = {-ONE, 0, 0, 0};

static void refuse_state(struct trial *trial, struct gl *gl)
{
	ENUM(AlphaFuncx, GL_KEEP, 0);
	ENUM(BlendFunc, GL_SRC_COLOR, GL_ZERO);
	ENUM(BlendFunc, GL_ONE_MINUS_SRC_COLOR, GL_ZERO);
	ENUM(BlendFunc, GL_ONE, GL_DST_COLOR);
	ENUM(BlendFunc, GL_ONE, GL_ONE_MINUS_DST_COLOR);
	ENUM(BlendFunc, GL_ONE, 0x0308);
	VALUE(Clear, 1);
	VALUE(Clear, GL_COLOR_BUFFER_BIT | 0x200);
	ENUM(CullFace, GL_CW);
	ENUM(DepthFunc, GL_ALWAYS + 1);
	ENUM(DepthFunc, GL_NEVER - 1);
	ENUM(Disable, GL_VERTEX_ARRAY);
	ENUM(Enable, GL_RGB);
	ENUM(Enable, GL_LIGHT0 + 8);
	ENUM(FrontFace, GL_FRONT);
	VALUE(LineWidthx, 0);
	VALUE(LineWidthx, -ONE);
	VALUE(PointSizex, 0);
	VALUE(PointSizex, -ONE);
	VALUE(Scissor, 0, 0, -1, 4);
	VALUE(Scissor, 0, 0, 4, -1);
	VALUE(Viewport, 0, 0, -1, 4);
	VALUE(Viewport, 0, 0, 4, -1);
	ENUM(ShadeModel, GL_FRONT);
	ENUM(StencilFunc, GL_KEEP, 1, 1);
	ENUM(StencilOp, GL_ALWAYS, GL_KEEP, GL_KEEP);
	ENUM(StencilOp, GL_ZERO, GL_ALWAYS, GL_KEEP);
	ENUM(StencilOp, GL_ZERO, GL_ZERO, GL_ALWAYS);
}

static void refuse_lights(struct trial *trial, struct gl *gl)
{
	ENUM(Fogx, GL_FOG_MODE, GL_RGB);
	ENUM(Fogx, GL_FOG_COLOR, 0);
	ENUM(Fogx, GL_AMBIENT, 0);
	VALUE(Fogx, GL_FOG_DENSITY, -1);
	ENUM(Fogxv, GL_AMBIENT, four);
	VALUE(Fogxv, GL_FOG_DENSITY, none);
	ENUM(LightModelx, GL_LIGHT_MODEL_AMBIENT, 0);
	ENUM(LightModelx, GL_FOG, 1);
	ENUM(LightModelxv, GL_FOG, four);
	ENUM(Lightx, GL_LIGHT0 + 8, GL_SPOT_CUTOFF, 0);
	ENUM(Lightx, GL_LIGHT0, GL_AMBIENT, ONE);
	ENUM(Lightx, GL_LIGHT0, GL_SHININESS, ONE);
	VALUE(Lightx, GL_LIGHT0, GL_SPOT_EXPONENT, -1);
	VALUE(Lightx, GL_LIGHT0, GL_SPOT_EXPONENT, 128 * ONE + 1);
	VALUE(Lightx, GL_LIGHT0, GL_SPOT_CUTOFF, -1);
	VALUE(Lightx, GL_LIGHT0, GL_SPOT_CUTOFF, 90 * ONE + 1);
	VALUE(Lightx, GL_LIGHT0, GL_SPOT_CUTOFF, 181 * ONE);
	VALUE(Lightx, GL_LIGHT0, GL_CONSTANT_ATTENUATION, -1);
	VALUE(Lightx, GL_LIGHT0, GL_LINEAR_ATTENUATION, -1);
	VALUE(Lightx, GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -1);
	ENUM(Lightxv, GL_LIGHT0 - 1, GL_AMBIENT, four);
	ENUM(Lightxv, GL_LIGHT0, GL_EMISSION, four);
	VALUE(Lightxv, GL_LIGHT0, GL_LINEAR_ATTENUATION, none);
	ENUM(Materialx, GL_FRONT, GL_SHININESS, 0);
	ENUM(Materialx, GL_FRONT_AND_BACK, GL_AMBIENT, 0);
	VALUE(Materialx, GL_FRONT_AND_BACK, GL_SHININESS, -1);
	VALUE(Materialx, GL_FRONT_AND_BACK, GL_SHININESS, 128 * ONE + 1);
	ENUM(Materialxv, GL_BACK, GL_AMBIENT, four);
	ENUM(Materialxv, GL_FRONT_AND_BACK, GL_POSITION, four);
	VALUE(Materialxv, GL_FRONT_AND_BACK, GL_SHININESS, none);
}

static void refuse_matrices(struct trial *trial, struct gl *gl)
{
	ENUM(MatrixMode, GL_TEXTURE_2D);
	REFUSED(GL_STACK_UNDERFLOW, PopMatrix);
	for (int i = 0; i < SOFT_STACK_DEPTH - 1; i++) {
		gl->PushMatrix();
	}
	REFUSED(GL_STACK_OVERFLOW, PushMatrix);
	VALUE(Frustumx, ONE, ONE, -ONE, ONE, ONE, 2 * ONE);
	VALUE(Frustumx, -ONE, ONE, ONE, ONE, ONE, 2 * ONE);
	VALUE(Frustumx, -ONE, ONE, -ONE, ONE, 0, 2 * ONE);
	VALUE(Frustumx, -ONE, ONE, -ONE, ONE, ONE, 0);
	VALUE(Frustumx, -ONE, ONE, -ONE, ONE, -ONE, ONE);
	VALUE(Frustumx, -ONE, ONE, -ONE, ONE, ONE, ONE);
	VALUE(Orthox, ONE, ONE, -ONE, ONE, -ONE, ONE);
	VALUE(Orthox, -ONE, ONE, ONE, ONE, -ONE, ONE);
	VALUE(Orthox, -ONE, ONE, -ONE, ONE, ONE, ONE);
}

static void refuse_arrays(struct trial *trial, struct gl *gl)
{
	static const GLushort index[3] = {0};

	ENUM(ClientActiveTexture, GL_TEXTURE0 + SOFT_UNITS);
	ENUM(ClientActiveTexture, GL_TEXTURE0 - 1);
	VALUE(VertexPointer, 1, GL_FLOAT, 0, four);
	VALUE(VertexPointer, 5, GL_FLOAT, 0, four);
	VALUE(VertexPointer, 3, GL_FLOAT, -1, four);
	ENUM(VertexPointer, 3, GL_UNSIGNED_BYTE, 0, four);
	ENUM(VertexPointer, 3, GL_UNSIGNED_SHORT, 0, four);
	VALUE(NormalPointer, GL_FLOAT, -1, four);
	ENUM(NormalPointer, GL_UNSIGNED_BYTE, 0, four);
	VALUE(ColorPointer, 3, GL_FLOAT, 0, four);
	VALUE(ColorPointer, 4, GL_FLOAT, -4, four);
	ENUM(ColorPointer, 4, GL_BYTE, 0, four);
	ENUM(ColorPointer, 4, GL_SHORT, 0, four);
	VALUE(TexCoordPointer, 1, GL_FLOAT, 0, four);
	VALUE(TexCoordPointer, 2, GL_FLOAT, -8, four);
	ENUM(TexCoordPointer, 2, GL_UNSIGNED_BYTE, 0, four);
	ENUM(EnableClientState, GL_TEXTURE_2D);
	ENUM(DisableClientState, GL_LIGHTING);
	ENUM(DrawArrays, GL_TRIANGLE_FAN + 1, 0, 3);
	VALUE(DrawArrays, GL_TRIANGLES, -1, 3);
	VALUE(DrawArrays, GL_TRIANGLES, 0, -1);
	ENUM(DrawElements, GL_TRIANGLE_FAN + 1, 3, GL_UNSIGNED_SHORT, index);
	ENUM(DrawElements, GL_TRIANGLES, 3, GL_SHORT, index);
	ENUM(DrawElements, GL_TRIANGLES, 3, GL_FIXED, index);
	VALUE(DrawElements, GL_TRIANGLES, -1, GL_UNSIGNED_SHORT, index);
}

static void refuse_textures(struct trial *trial, struct gl *gl)
{
	static const uint8_t texels[4 * 16] = {0};
	const GLenum t2d = GL_TEXTURE_2D, byte = GL_UNSIGNED_BYTE;
	const GLenum env = GL_TEXTURE_ENV, bits = GL_UNSIGNED_SHORT_5_6_5;
	GLuint name = 77;

	ENUM(ActiveTexture, GL_TEXTURE0 + SOFT_UNITS);
	ENUM(ActiveTexture, GL_TEXTURE0 - 1);
	ENUM(BindTexture, GL_RGB, 1);
	VALUE(GenTextures, -1, &name);
	assert_int_equal(name, 77);
	VALUE(DeleteTextures, -1, &name);
	ENUM(PixelStorei, GL_RGB, 4);
	VALUE(PixelStorei, GL_UNPACK_ALIGNMENT, 3);
	VALUE(PixelStorei, GL_PACK_ALIGNMENT, 16);
	ENUM(TexEnvx, GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_ADD);
	ENUM(TexEnvx, env, GL_TEXTURE_ENV_MODE, GL_RGB);
	ENUM(TexEnvx, env, GL_TEXTURE_ENV_COLOR, 0);
	ENUM(TexEnvx, env, GL_COMBINE_RGB, GL_DECAL);
	ENUM(TexEnvx, env, GL_COMBINE_ALPHA, GL_DOT3_RGB);
	ENUM(TexEnvx, env, GL_SRC0_RGB, GL_RGB);
	ENUM(TexEnvx, env, GL_SRC0_ALPHA, GL_SRC_COLOR);
	ENUM(TexEnvx, env, GL_OPERAND0_RGB, GL_DST_COLOR);
	ENUM(TexEnvx, env, 0x8598, GL_SRC_COLOR);
	VALUE(TexEnvx, env, GL_RGB_SCALE, 3 * ONE);
	ENUM(TexEnvxv, GL_TEXTURE_2D, GL_TEXTURE_ENV_COLOR, four);
	ENUM(TexEnvxv, env, GL_RGB, four);
	ENUM(TexParameterx, GL_RGB, GL_TEXTURE_WRAP_S, GL_REPEAT);
	ENUM(TexParameterx, t2d, GL_RGB, GL_REPEAT);
	ENUM(TexParameterx, t2d, GL_TEXTURE_WRAP_S, GL_NEAREST);
	ENUM(TexParameterx, t2d, GL_TEXTURE_WRAP_T, 0x2900);
	ENUM(TexParameterx, t2d, GL_TEXTURE_MIN_FILTER, GL_REPEAT);
	ENUM(TexParameterx, t2d, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR);
	ENUM(TexImage2D, GL_RGB, 0, GL_RGB, 4, 4, 0, GL_RGB, byte, texels);
	ENUM(TexImage2D, t2d, 0, GL_TEXTURE, 4, 4, 0, GL_TEXTURE, byte, texels);
	ENUM(TexImage2D, t2d, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_FLOAT, texels);
	VALUE(TexImage2D, t2d, -1, GL_RGB, 4, 4, 0, GL_RGB, byte, texels);
	VALUE(TexImage2D, t2d, 11, GL_RGB, 1, 1, 0, GL_RGB, byte, texels);
	VALUE(TexImage2D, t2d, 0, GL_RGB, 3, 4, 0, GL_RGB, byte, texels);
	VALUE(TexImage2D, t2d, 0, GL_RGB, 4, -4, 0, GL_RGB, byte, texels);
	VALUE(TexImage2D, t2d, 0, GL_RGB, 2048, 1, 0, GL_RGB, byte, texels);
	VALUE(TexImage2D, t2d, 0, GL_RGB, 4, 4, 1, GL_RGB, byte, texels);
	VALUE(TexImage2D, t2d, 0, 99, 4, 4, 0, GL_RGB, byte, texels);
	WRONG(TexImage2D, t2d, 0, GL_RGBA, 4, 4, 0, GL_RGB, byte, texels);
	WRONG(TexImage2D, t2d, 0, GL_RGBA, 4, 4, 0, GL_RGBA, bits, texels);
	gl->TexImage2D(t2d, 0, GL_RGBA, 4, 4, 0, GL_RGBA, byte, texels);
	ENUM(TexSubImage2D, GL_RGB, 0, 0, 0, 1, 1, GL_RGBA, byte, texels);
	ENUM(TexSubImage2D, t2d, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, texels);
	VALUE(TexSubImage2D, t2d, -1, 0, 0, 1, 1, GL_RGBA, byte, texels);
	VALUE(TexSubImage2D, t2d, 0, -1, 0, 1, 1, GL_RGBA, byte, texels);
	VALUE(TexSubImage2D, t2d, 0, 0, 3, 1, 2, GL_RGBA, byte, texels);
	VALUE(TexSubImage2D, t2d, 0, INT32_MAX, 0, 2, 1, GL_RGBA, byte, texels);
	VALUE(TexSubImage2D, t2d, 0, 0, 0, 1, -1, GL_RGBA, byte, texels);
	WRONG(TexSubImage2D, t2d, 1, 0, 0, 1, 1, GL_RGBA, byte, texels);
	WRONG(TexSubImage2D, t2d, 0, 0, 0, 1, 1, GL_RGB, byte, texels);
}

static void refuse_queries(struct trial *trial, struct gl *gl)
{
	uint8_t pixels[4] = {7, 7, 7, 7};
	GLint value = 77;

	ENUM(GetIntegerv, GL_RGB, &value);
	assert_int_equal(value, 77);
	ENUM(GetString, GL_RGB);
	assert_null(gl->GetString(0));
	assert_int_equal(gl->GetError(), GL_INVALID_ENUM);
	ENUM(ReadPixels, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, pixels);
	ENUM(ReadPixels, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixels);
	VALUE(ReadPixels, 0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	VALUE(ReadPixels, 0, 0, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	assert_int_equal(pixels[0], 7);
}

/* These take anything. */
static const enum entry harmless[] = {ENTRY_ClearColorx, ENTRY_ClearDepthx,
	ENTRY_ClearStencil, ENTRY_Color4x, ENTRY_ColorMask, ENTRY_DepthMask,
	ENTRY_Finish, ENTRY_GetError, ENTRY_LoadIdentity, ENTRY_LoadMatrixx,
	ENTRY_MultMatrixx, ENTRY_Normal3x, ENTRY_PolygonOffsetx, ENTRY_Rotatex,
	ENTRY_Scalex, ENTRY_StencilMask, ENTRY_Translatex};

static void test_what_is_refused_changes_nothing(void **state)
{
	struct trial *trial = calloc(1, sizeof(*trial));

	(void)state;
	assert_non_null(trial);
	for (size_t i = 0; i < sizeof(harmless) / sizeof(harmless[0]); i++) {
		trial->tried[harmless[i]] = true;
	}
	trial->canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	refuse_state(trial, trial->canvas.gl);
	refuse_lights(trial, trial->canvas.gl);
	refuse_matrices(trial, trial->canvas.gl);
	refuse_arrays(trial, trial->canvas.gl);
	refuse_textures(trial, trial->canvas.gl);
	refuse_queries(trial, trial->canvas.gl);
	gl_canvas_close(&trial->canvas);
	for (int i = 0; i < ENTRIES; i++) {
		if (!trial->tried[i]) {
			fail_msg("%s has no row", entry_names[i]);
		}
	}
	free(trial);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_is_refused_changes_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
