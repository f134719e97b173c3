#include "app/scene/draw/matrix_gl.h"

#include "platform/base/fixed.h"

static void to_fixed(const vec4 *matrix, GLfixed out[16])
{
	for (int i = 0; i < 16; i++) {
		out[i] = fx16_from_float(matrix[i / 4][i % 4]);
	}
}

void matrix_gl_load(const struct gl *gl, const vec4 *matrix)
{
	GLfixed fixed[16];

	to_fixed(matrix, fixed);
	gl->LoadMatrixx(fixed);
}

void matrix_gl_multiply(const struct gl *gl, const vec4 *matrix)
{
	GLfixed fixed[16];

	to_fixed(matrix, fixed);
	gl->MultMatrixx(fixed);
}
