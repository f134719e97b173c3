/* The calls of GL that set state, with values from the input. */
#include "tests/fuzz/fuzz_gl_calls.h"

void fuzz_gl_matrix(struct scene *scene)
{
	const struct gl *gl = scene->gl;
	struct reader *from = scene->from;
	GLfixed v[16];

	values(from, v, 16);
	switch (byte(from) % 10) {
	case 0:
		gl->MatrixMode(
			PICK(from, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE));
		break;
	case 1:
		gl->LoadMatrixx(v);
		break;
	case 2:
		gl->MultMatrixx(v);
		break;
	case 3:
		gl->Rotatex(v[0], v[1], v[2], v[3]);
		break;
	case 4:
		gl->Scalex(v[0], v[1], v[2]);
		break;
	case 5:
		gl->Translatex(v[0], v[1], v[2]);
		break;
	case 6:
		gl->Frustumx(v[0], v[1], v[2], v[3], v[4], v[5]);
		break;
	case 7:
		gl->Orthox(v[0], v[1], v[2], v[3], v[4], v[5]);
		break;
	case 8:
		gl->PushMatrix();
		break;
	default:
		gl->PopMatrix();
		gl->LoadIdentity();
		break;
	}
}

void fuzz_gl_light(struct scene *scene)
{
	const struct gl *gl = scene->gl;
	struct reader *from = scene->from;
	GLenum light = PICK(from, GL_LIGHT0, GL_LIGHT1, GL_LIGHT2);
	GLfixed v[4];

	values(from, v, 4);
	switch (byte(from) % 6) {
	case 0:
		gl->Lightxv(light,
			PICK(from, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
				GL_POSITION, GL_SPOT_DIRECTION),
			v);
		break;
	case 1:
		gl->Lightx(light,
			PICK(from, GL_SPOT_EXPONENT, GL_SPOT_CUTOFF,
				GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION,
				GL_QUADRATIC_ATTENUATION),
			v[0]);
		break;
	case 2:
		gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, v);
		gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, v[0] & 1);
		break;
	case 3:
		gl->Materialxv(GL_FRONT_AND_BACK,
			PICK(from, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
				GL_EMISSION, GL_AMBIENT_AND_DIFFUSE),
			v);
		break;
	case 4:
		gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, v[0]);
		break;
	default:
		gl->Normal3x(v[0], v[1], v[2]);
		break;
	}
}

/* Tests, blending, fog and faces: way is below 7. */
static void set_tests(const struct gl *gl, struct reader *from,
	unsigned int way, const GLfixed v[4])
{
	switch (way) {
	case 0:
		gl->AlphaFuncx(comparison(from), v[0]);
		break;
	case 1:
		gl->BlendFunc(PICK(from, GL_ZERO, GL_ONE, GL_DST_COLOR,
				      GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA,
				      GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA),
			PICK(from, GL_ZERO, GL_ONE, GL_SRC_COLOR,
				GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
				GL_ONE_MINUS_SRC_ALPHA, GL_ONE_MINUS_DST_ALPHA));
		break;
	case 2:
		gl->DepthFunc(comparison(from));
		gl->DepthMask(v[0] & 1);
		break;
	case 3:
		gl->StencilFunc(comparison(from), v[0], (GLuint)v[1]);
		gl->StencilMask((GLuint)v[2]);
		break;
	case 4:
		gl->StencilOp(PICK(from, GL_KEEP, GL_INCR, GL_DECR, GL_INVERT),
			PICK(from, GL_KEEP, GL_INCR, GL_REPLACE, GL_ZERO),
			PICK(from, GL_KEEP, GL_INCR, GL_DECR, GL_INVERT));
		break;
	case 5:
		gl->Fogx(GL_FOG_MODE,
			(GLfixed)PICK(from, GL_LINEAR, GL_EXP, GL_EXP2));
		gl->Fogx(PICK(from, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END),
			v[0]);
		gl->Fogxv(GL_FOG_COLOR, v);
		break;
	default:
		gl->CullFace(PICK(from, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK));
		gl->FrontFace(PICK(from, GL_CW, GL_CCW));
		break;
	}
}

/* Shading, the viewport and what is written: way is 7 to 13. */
static void set_output(const struct gl *gl, struct reader *from,
	unsigned int way, const GLfixed v[4])
{
	switch (way) {
	case 7:
		gl->ShadeModel(PICK(from, GL_FLAT, GL_SMOOTH));
		break;
	case 8:
		gl->Scissor(v[0] % 100, v[1] % 100, v[2] % 200, v[3] % 200);
		break;
	case 9:
		gl->Viewport(v[0], v[1], v[2], v[3]);
		break;
	case 10:
		gl->Viewport(v[0] % 32, v[1] % 32, v[2] & 127, v[3] & 127);
		break;
	case 11:
		gl->PolygonOffsetx(v[0], v[1]);
		gl->LineWidthx(v[2]);
		gl->PointSizex(v[3]);
		break;
	case 12:
		gl->ColorMask(v[0] & 1, v[1] & 1, v[2] & 1, v[3] & 1);
		break;
	default:
		gl->Color4x(v[0], v[1], v[2], v[3]);
		break;
	}
}

void fuzz_gl_fragment(struct scene *scene)
{
	unsigned int way;
	GLfixed v[4];

	values(scene->from, v, 4);
	way = byte(scene->from) % 14;
	if (way < 7) {
		set_tests(scene->gl, scene->from, way, v);
	} else {
		set_output(scene->gl, scene->from, way, v);
	}
}

void fuzz_gl_texture(struct scene *scene)
{
	const struct gl *gl = scene->gl;
	struct reader *from = scene->from;
	GLsizei width = 1 << byte(from) % 7, height = 1 << byte(from) % 7;
	GLenum format = PICK(from, GL_RGBA, GL_RGB, GL_LUMINANCE,
		GL_LUMINANCE_ALPHA, GL_ALPHA);
	GLenum type = PICK(from, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE,
		GL_UNSIGNED_SHORT_5_6_5, GL_UNSIGNED_SHORT_4_4_4_4,
		GL_UNSIGNED_SHORT_5_5_5_1);
	GLint level = byte(from) % 8 == 0 ? (GLint)(byte(from) % 8) : 0;
	GLfixed v[4];

	switch (byte(from) % 8) {
	case 0:
		gl->BindTexture(
			GL_TEXTURE_2D, scene->texture[byte(from) % TEXTURES]);
		break;
	case 1:
	case 2:
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)format, width,
			height, 0, format, type, scene->pool + byte(from) * 4);
		break;
	case 3:
		gl->TexSubImage2D(GL_TEXTURE_2D, level, (GLint)byte(from) - 32,
			(GLint)byte(from) - 32, width, height, format, type,
			scene->pool);
		break;
	case 4:
		gl->TexParameterx(GL_TEXTURE_2D,
			PICK(from, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER),
			(GLfixed)PICK(from, GL_NEAREST, GL_LINEAR,
				GL_LINEAR_MIPMAP_NEAREST,
				GL_NEAREST_MIPMAP_NEAREST,
				GL_LINEAR_MIPMAP_LINEAR));
		break;
	case 5:
		gl->TexParameterx(GL_TEXTURE_2D,
			PICK(from, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T),
			(GLfixed)PICK(from, GL_REPEAT, GL_CLAMP_TO_EDGE));
		break;
	case 6:
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
			(GLfixed)PICK(from, GL_MODULATE, GL_DECAL, GL_REPLACE,
				GL_ADD, GL_BLEND, GL_COMBINE));
		break;
	default:
		values(from, v, 4);
		gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v);
		gl->ActiveTexture(GL_TEXTURE0 + byte(from) % 3);
		gl->ClientActiveTexture(GL_TEXTURE0 + byte(from) % 3);
		break;
	}
}

void fuzz_gl_arrays(struct scene *scene)
{
	const struct gl *gl = scene->gl;
	struct reader *from = scene->from;
	const uint8_t *at = scene->pool + (byte(from) << 2);
	GLenum type = PICK(from, GL_SHORT, GL_FIXED, GL_BYTE, GL_SHORT);
	GLint size = 2 + (GLint)(byte(from) % 3);
	GLsizei stride =
		byte(from) % 2 ? 0 : 16 + (GLsizei)(byte(from) % 12) * 4;

	switch (byte(from) % 6) {
	case 0:
		gl->VertexPointer(size, type, stride, at);
		break;
	case 1:
		gl->NormalPointer(type, stride, at);
		break;
	case 2:
		gl->ColorPointer(4,
			PICK(from, GL_UNSIGNED_BYTE, GL_FIXED, GL_UNSIGNED_BYTE),
			stride, at);
		break;
	case 3:
		gl->TexCoordPointer(size, type, stride, at);
		break;
	case 4:
		gl->EnableClientState(array(from));
		break;
	default:
		gl->DisableClientState(array(from));
		break;
	}
}
