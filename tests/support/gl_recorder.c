#include "tests/support/gl_recorder.h"

#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	STACK_ROOM = 32
};

/* GL's calls carry no context, so a recorder has one of its own. */
static struct {
	struct gl_recording recording;
	double stack[STACK_ROOM][16];
	bool model_view;
	const void *position;
	GLenum front_face;
} recorder;

static double *top(void)
{
	return recorder.stack[recorder.recording.depth];
}

static void multiply(const double by[16])
{
	double product[16];

	if (!recorder.model_view) {
		return;
	}
	for (int column = 0; column < 4; column++) {
		for (int row = 0; row < 4; row++) {
			double sum = 0.0;

			for (int k = 0; k < 4; k++) {
				sum += top()[k * 4 + row] * by[column * 4 + k];
			}
			product[column * 4 + row] = sum;
		}
	}
	memcpy(top(), product, sizeof(product));
}

static void identity(double out[16])
{
	memset(out, 0, 16 * sizeof(*out));
	out[0] = out[5] = out[10] = out[15] = 1.0;
}

static double number(GLfixed fixed)
{
	return fixed / 65536.0;
}

static void record_PushMatrix(void)
{
	struct gl_recording *r = &recorder.recording;

	assert_true(r->depth + 1 < STACK_ROOM);
	memcpy(recorder.stack[r->depth + 1], top(), sizeof(recorder.stack[0]));
	r->depth++;
	r->deepest = r->depth > r->deepest ? r->depth : r->deepest;
}

static void record_PopMatrix(void)
{
	assert_true(recorder.recording.depth > 0);
	recorder.recording.depth--;
}

static void record_MatrixMode(GLenum mode)
{
	recorder.model_view = mode == GL_MODELVIEW;
}

static void record_LoadIdentity(void)
{
	if (recorder.model_view) {
		identity(top());
	}
}

static void record_MultMatrixx(const GLfixed *matrix)
{
	double by[16];

	for (int i = 0; i < 16; i++) {
		by[i] = number(matrix[i]);
	}
	multiply(by);
}

static void record_LoadMatrixx(const GLfixed *matrix)
{
	record_LoadIdentity();
	record_MultMatrixx(matrix);
}

static void record_Translatex(GLfixed x, GLfixed y, GLfixed z)
{
	double by[16];

	identity(by);
	by[12] = number(x);
	by[13] = number(y);
	by[14] = number(z);
	multiply(by);
}

static void record_Scalex(GLfixed x, GLfixed y, GLfixed z)
{
	double by[16];

	identity(by);
	by[0] = number(x);
	by[5] = number(y);
	by[10] = number(z);
	multiply(by);
}

/* OpenGL ES 1.1, 2.10.2, for the three axes. */
static void record_Rotatex(GLfixed degrees, GLfixed x, GLfixed y, GLfixed z)
{
	double angle = number(degrees) * 3.14159265358979 / 180.0;
	double c = cos(angle), s = sin(angle);
	int axis = x ? 0 : y ? 1 : 2;
	int u = (axis + 1) % 3, v = (axis + 2) % 3;
	double by[16];

	assert_int_equal(x + y + z, 65536);
	identity(by);
	by[u * 4 + u] = by[v * 4 + v] = c;
	by[u * 4 + v] = s;
	by[v * 4 + u] = -s;
	multiply(by);
}

static void record_VertexPointer(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	(void)size;
	(void)type;
	(void)stride;
	recorder.position = pointer;
}

static void record_FrontFace(GLenum mode)
{
	recorder.front_face = mode;
}

static void record_draw(GLsizei count)
{
	struct gl_recording *r = &recorder.recording;

	assert_true(r->draw_count < GL_RECORDER_DRAWS);
	memcpy(r->draw[r->draw_count].matrix, top(), sizeof(double[16]));
	r->draw[r->draw_count].count = count;
	r->draw[r->draw_count].position = recorder.position;
	r->draw[r->draw_count].front_face = recorder.front_face;
	r->draw_count++;
}

static void record_DrawElements(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	(void)indices;
	assert_int_equal(mode, GL_TRIANGLES);
	assert_int_equal(type, GL_UNSIGNED_SHORT);
	record_draw(count);
}

static void record_DrawArrays(GLenum mode, GLint first, GLsizei count)
{
	(void)first;
	assert_int_equal(mode, GL_TRIANGLES);
	record_draw(count);
}

/* State that does not matter here. */
static void ignore_enum(GLenum name)
{
	(void)name;
}

static void ignore_enum_fixed(GLenum name, GLfixed value)
{
	(void)name;
	(void)value;
}

static void ignore_two_enums_fixed(GLenum target, GLenum name, GLfixed value)
{
	(void)target;
	(void)name;
	(void)value;
}

static void ignore_vector(GLenum target, GLenum name, const GLfixed *values)
{
	(void)target;
	(void)name;
	(void)values;
}

static void ignore_color(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	(void)red;
	(void)green;
	(void)blue;
	(void)alpha;
}

static void ignore_boolean(GLboolean value)
{
	(void)value;
}

static void ignore_two_enums(GLenum source, GLenum destination)
{
	(void)source;
	(void)destination;
}

static void ignore_normals(GLenum type, GLsizei stride, const void *pointer)
{
	(void)type;
	(void)stride;
	(void)pointer;
}

static void ignore_array(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	(void)size;
	ignore_normals(type, stride, pointer);
}

struct gl gl_recorder_begin(void)
{
	memset(&recorder, 0, sizeof(recorder));
	recorder.model_view = true;
	recorder.front_face = GL_CCW;
	identity(top());
	return (struct gl){
		.AlphaFuncx = ignore_enum_fixed,
		.BlendFunc = ignore_two_enums,
		.Color4x = ignore_color,
		.ColorPointer = ignore_array,
		.CullFace = ignore_enum,
		.DepthMask = ignore_boolean,
		.Disable = ignore_enum,
		.DisableClientState = ignore_enum,
		.DrawArrays = record_DrawArrays,
		.DrawElements = record_DrawElements,
		.Enable = ignore_enum,
		.EnableClientState = ignore_enum,
		.FrontFace = record_FrontFace,
		.LightModelx = ignore_enum_fixed,
		.LoadIdentity = record_LoadIdentity,
		.LoadMatrixx = record_LoadMatrixx,
		.Materialx = ignore_two_enums_fixed,
		.Materialxv = ignore_vector,
		.MatrixMode = record_MatrixMode,
		.MultMatrixx = record_MultMatrixx,
		.NormalPointer = ignore_normals,
		.PopMatrix = record_PopMatrix,
		.PushMatrix = record_PushMatrix,
		.Rotatex = record_Rotatex,
		.Scalex = record_Scalex,
		.TexCoordPointer = ignore_array,
		.TexEnvx = ignore_two_enums_fixed,
		.Translatex = record_Translatex,
		.VertexPointer = record_VertexPointer,
	};
}

const struct gl_recording *gl_recorder_result(void)
{
	return &recorder.recording;
}
