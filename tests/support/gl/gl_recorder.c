#include "tests/support/gl/gl_recorder.h"

#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	STACK_ROOM = 32
};

/* GL's calls carry no context argument, so the recorder is a static one. */
static struct {
	struct gl_recording recording;
	double stack[STACK_ROOM][16];
	bool model_view;
	const void *position;
	bool counted;
	GLenum type;
	GLsizei stride;
	GLenum front_face;
	GLuint textures;
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

	if (!recorder.model_view) {
		return;
	}
	assert_true(r->depth + 1 < STACK_ROOM);
	memcpy(recorder.stack[r->depth + 1], top(), sizeof(recorder.stack[0]));
	r->depth++;
}

static void record_PopMatrix(void)
{
	if (recorder.model_view) {
		assert_true(recorder.recording.depth > 0);
		recorder.recording.depth--;
	}
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

/* The rotation matrix of OpenGL ES 1.1, section 2.10.2. */
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
	recorder.position = pointer;
	recorder.stride = stride;
	recorder.counted = size == 3 && (type == GL_FLOAT || type == GL_SHORT);
	recorder.type = type;
}

static void record_FrontFace(GLenum mode)
{
	recorder.front_face = mode;
}

/* FNV-1a, 64 bits. */
static void add_to_hash(const void *data, size_t size)
{
	const uint8_t *bytes = data;
	uint64_t hash = recorder.recording.vertex_hash;

	for (size_t i = 0; i < size; i++) {
		hash = (hash ^ bytes[i]) * 0x100000001b3u;
	}
	recorder.recording.vertex_hash = hash;
}

static void add_vertex(const float vertex[3])
{
	const double *m = top();

	for (int i = 0; i < 3; i++) {
		recorder.recording.sum[i] += m[i] * vertex[0] +
			m[4 + i] * vertex[1] + m[8 + i] * vertex[2] + m[12 + i];
	}
	recorder.recording.vertex_count++;
	add_to_hash(vertex, sizeof(float[3]));
}

static void load_vertex(GLint index, float out[3])
{
	const char *array = recorder.position;
	int16_t shorts[3];

	if (recorder.type == GL_FLOAT) {
		GLsizei stride = recorder.stride ? recorder.stride
						 : (GLsizei)sizeof(float[3]);

		memcpy(out, array + (ptrdiff_t)index * stride, sizeof(float[3]));
		return;
	}
	memcpy(shorts, array + (ptrdiff_t)index * recorder.stride,
		sizeof(shorts));
	for (int i = 0; i < 3; i++) {
		out[i] = shorts[i];
	}
}

static void record_draw(GLsizei count, const uint16_t *index, GLint first)
{
	struct gl_recording *r = &recorder.recording;
	assert_true(r->draw_count < GL_RECORDER_DRAWS);
	memcpy(r->draw[r->draw_count].matrix, top(), sizeof(double[16]));
	r->draw[r->draw_count].count = count;
	r->draw[r->draw_count].position = recorder.position;
	r->draw[r->draw_count].front_face = recorder.front_face;
	r->draw_count++;
	add_to_hash(top(), sizeof(double[16]));
	for (GLsizei i = 0; recorder.counted && i < count; i++) {
		float vertex[3];

		load_vertex(index ? index[i] : first + i, vertex);
		add_vertex(vertex);
	}
}

static void record_DrawElements(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	(void)mode;
	assert_int_equal(type, GL_UNSIGNED_SHORT);
	record_draw(count, indices, 0);
}

static void record_DrawArrays(GLenum mode, GLint first, GLsizei count)
{
	(void)mode;
	record_draw(count, NULL, first);
}

static void record_GenTextures(GLsizei count, GLuint *textures)
{
	for (GLsizei i = 0; i < count; i++) {
		textures[i] = ++recorder.textures;
	}
}

static void record_GetIntegerv(GLenum name, GLint *values)
{
	*values = name == GL_STENCIL_BITS ? 8 : 2048;
}

/* All other calls do nothing. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define GL_FUNCTION(result, name, parameters)  \
	static result ignore_##name parameters \
	{                                      \
		return (result)0;              \
	}
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
#pragma GCC diagnostic pop

struct gl gl_recorder_begin(void)
{
	struct gl gl = {
#define GL_FUNCTION(result, name, parameters) .name = ignore_##name,
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
	};

	memset(&recorder, 0, sizeof(recorder));
	recorder.model_view = true;
	recorder.front_face = GL_CCW;
	recorder.recording.vertex_hash = 0xcbf29ce484222325u;
	identity(top());
	gl.DrawArrays = record_DrawArrays;
	gl.DrawElements = record_DrawElements;
	gl.FrontFace = record_FrontFace;
	gl.GenTextures = record_GenTextures;
	gl.GetIntegerv = record_GetIntegerv;
	gl.LoadIdentity = record_LoadIdentity;
	gl.LoadMatrixx = record_LoadMatrixx;
	gl.MatrixMode = record_MatrixMode;
	gl.MultMatrixx = record_MultMatrixx;
	gl.PopMatrix = record_PopMatrix;
	gl.PushMatrix = record_PushMatrix;
	gl.Rotatex = record_Rotatex;
	gl.Scalex = record_Scalex;
	gl.Translatex = record_Translatex;
	gl.VertexPointer = record_VertexPointer;
	return gl;
}

void gl_recorder_clear(void)
{
	recorder.recording.draw_count = 0;
	recorder.recording.vertex_count = 0;
	memset(recorder.recording.sum, 0, sizeof(recorder.recording.sum));
	recorder.recording.vertex_hash = 0xcbf29ce484222325u;
}

const struct gl_recording *gl_recorder_result(void)
{
	return &recorder.recording;
}
