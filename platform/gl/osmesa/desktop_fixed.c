#include "platform/gl/osmesa/desktop.h"

#include "platform/base/fixed.h"

#define GL_ALPHA_SCALE            0x0D1C
#define GL_TEXTURE_MAX_ANISOTROPY 0x84FE

static float to_float(GLfixed value)
{
	return fx16_to_float(value);
}

/* Exact: a double holds the 32 bits of GLfixed. */
static double to_double(GLfixed value)
{
	return (double)value / 65536.0;
}

static void to_floats(float *out, const GLfixed *values, int count)
{
	for (int i = 0; i < count; i++) {
		out[i] = to_float(values[i]);
	}
}

static void alpha_funcx(GLenum function, GLfixed reference)
{
	desktop_current()->gl.AlphaFunc(function, to_float(reference));
}

static void clear_colorx(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	desktop_current()->gl.ClearColor(to_float(red), to_float(green),
		to_float(blue), to_float(alpha));
}

static void clear_depthx(GLfixed depth)
{
	desktop_current()->gl.ClearDepth(to_double(depth));
}

static void color4x(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	desktop_current()->gl.Color4f(to_float(red), to_float(green),
		to_float(blue), to_float(alpha));
}

static void fogx(GLenum name, GLfixed value)
{
	desktop_current()->gl.Fogf(
		name, name == GL_FOG_MODE ? (float)value : to_float(value));
}

static void fogxv(GLenum name, const GLfixed *values)
{
	float color[4];

	if (name != GL_FOG_COLOR) {
		fogx(name, values[0]);
		return;
	}
	to_floats(color, values, 4);
	desktop_current()->gl.Fogfv(name, color);
}

static void frustumx(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top,
	GLfixed near, GLfixed far)
{
	desktop_current()->gl.Frustum(to_double(left), to_double(right),
		to_double(bottom), to_double(top), to_double(near),
		to_double(far));
}

static void light_modelx(GLenum name, GLfixed value)
{
	desktop_current()->gl.LightModelf(name, to_float(value));
}

static void light_modelxv(GLenum name, const GLfixed *values)
{
	float color[4];

	if (name != GL_LIGHT_MODEL_AMBIENT) {
		light_modelx(name, values[0]);
		return;
	}
	to_floats(color, values, 4);
	desktop_current()->gl.LightModelfv(name, color);
}

static void lightx(GLenum light, GLenum name, GLfixed value)
{
	desktop_current()->gl.Lightf(light, name, to_float(value));
}

static int light_value_count(GLenum name)
{
	switch (name) {
	case GL_AMBIENT:
	case GL_DIFFUSE:
	case GL_SPECULAR:
	case GL_POSITION:
		return 4;
	case GL_SPOT_DIRECTION:
		return 3;
	default:
		return 1;
	}
}

static void lightxv(GLenum light, GLenum name, const GLfixed *values)
{
	float converted[4] = {0};

	to_floats(converted, values, light_value_count(name));
	desktop_current()->gl.Lightfv(light, name, converted);
}

static void line_widthx(GLfixed width)
{
	desktop_current()->gl.LineWidth(to_float(width));
}

static void load_matrixx(const GLfixed *matrix)
{
	float converted[16];

	to_floats(converted, matrix, 16);
	desktop_current()->gl.LoadMatrixf(converted);
}

static void materialx(GLenum face, GLenum name, GLfixed value)
{
	desktop_current()->gl.Materialf(face, name, to_float(value));
}

static void materialxv(GLenum face, GLenum name, const GLfixed *values)
{
	float converted[4] = {0};

	to_floats(converted, values, name == GL_SHININESS ? 1 : 4);
	desktop_current()->gl.Materialfv(face, name, converted);
}

static void mult_matrixx(const GLfixed *matrix)
{
	float converted[16];

	to_floats(converted, matrix, 16);
	desktop_current()->gl.MultMatrixf(converted);
}

static void normal3x(GLfixed x, GLfixed y, GLfixed z)
{
	desktop_current()->gl.Normal3f(to_float(x), to_float(y), to_float(z));
}

static void orthox(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top,
	GLfixed near, GLfixed far)
{
	desktop_current()->gl.Ortho(to_double(left), to_double(right),
		to_double(bottom), to_double(top), to_double(near),
		to_double(far));
}

static void point_sizex(GLfixed size)
{
	desktop_current()->gl.PointSize(to_float(size));
}

static void polygon_offsetx(GLfixed factor, GLfixed units)
{
	desktop_current()->gl.PolygonOffset(to_float(factor), to_float(units));
}

static void rotatex(GLfixed degrees, GLfixed x, GLfixed y, GLfixed z)
{
	desktop_current()->gl.Rotatef(
		to_float(degrees), to_float(x), to_float(y), to_float(z));
}

static void scalex(GLfixed x, GLfixed y, GLfixed z)
{
	desktop_current()->gl.Scalef(to_float(x), to_float(y), to_float(z));
}

/* All values but those of the two scales are enumerants, exact in a float. */
static void tex_envx(GLenum target, GLenum name, GLfixed value)
{
	bool number = name == GL_RGB_SCALE || name == GL_ALPHA_SCALE;

	desktop_current()->gl.TexEnvf(
		target, name, number ? to_float(value) : (float)value);
}

static void tex_envxv(GLenum target, GLenum name, const GLfixed *values)
{
	float color[4];

	if (name != GL_TEXTURE_ENV_COLOR) {
		tex_envx(target, name, values[0]);
		return;
	}
	to_floats(color, values, 4);
	desktop_current()->gl.TexEnvfv(target, name, color);
}

static void tex_parameterx(GLenum target, GLenum name, GLfixed value)
{
	bool number = name == GL_TEXTURE_MAX_ANISOTROPY;

	desktop_current()->gl.TexParameterf(
		target, name, number ? to_float(value) : (float)value);
}

static void translatex(GLfixed x, GLfixed y, GLfixed z)
{
	desktop_current()->gl.Translatef(to_float(x), to_float(y), to_float(z));
}

void desktop_set_fixed_shims(struct gl *gl)
{
	gl->AlphaFuncx = alpha_funcx;
	gl->ClearColorx = clear_colorx;
	gl->ClearDepthx = clear_depthx;
	gl->Color4x = color4x;
	gl->Fogx = fogx;
	gl->Fogxv = fogxv;
	gl->Frustumx = frustumx;
	gl->LightModelx = light_modelx;
	gl->LightModelxv = light_modelxv;
	gl->Lightx = lightx;
	gl->Lightxv = lightxv;
	gl->LineWidthx = line_widthx;
	gl->LoadMatrixx = load_matrixx;
	gl->Materialx = materialx;
	gl->Materialxv = materialxv;
	gl->MultMatrixx = mult_matrixx;
	gl->Normal3x = normal3x;
	gl->Orthox = orthox;
	gl->PointSizex = point_sizex;
	gl->PolygonOffsetx = polygon_offsetx;
	gl->Rotatex = rotatex;
	gl->Scalex = scalex;
	gl->TexEnvx = tex_envx;
	gl->TexEnvxv = tex_envxv;
	gl->TexParameterx = tex_parameterx;
	gl->Translatex = translatex;
}
