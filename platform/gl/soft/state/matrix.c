/* Matrices: arithmetic, stacks and the calls that change them. */
#include "platform/gl/soft/state/matrix.h"

#include <string.h>

#include "platform/base/fixed.h"
#include "platform/base/scalar.h"
#include "platform/gl/soft/state/state.h"

const struct matrix soft_matrix_identity = {
	{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};

struct matrix soft_matrix_multiply(
	const struct matrix *a, const struct matrix *b)
{
	struct matrix product;

	for (int column = 0; column < 4; column++) {
		soft_matrix_transform(
			a, b->m + 4 * column, product.m + 4 * column);
	}
	return product;
}

void soft_matrix_normal(const struct matrix *m, float out[9])
{
	const float *a = m->m, *b = m->m + 4, *c = m->m + 8;
	const float *column[3] = {a, b, c};
	float determinant, factor;

	for (int i = 0; i < 3; i++) {
		const float *u = column[(i + 1) % 3], *v = column[(i + 2) % 3];

		for (int j = 0; j < 3; j++) {
			int k = (j + 1) % 3, l = (j + 2) % 3;

			out[3 * i + j] = u[k] * v[l] - u[l] * v[k];
		}
	}
	determinant = a[0] * out[0] + a[1] * out[1] + a[2] * out[2];
	factor = determinant != 0.0f ? 1.0f / determinant : 0.0f;
	for (int i = 0; i < 9; i++) {
		out[i] *= factor;
	}
}

static float dot3(const float *a, const float *b)
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void soft_matrix_normalize(float v[3])
{
	float length = scalar_sqrt(dot3(v, v));

	for (int i = 0; i < 3 && length > 0.0f; i++) {
		v[i] /= length;
	}
}

float soft_matrix_uniform_scale(const struct matrix *m)
{
	const float *a = m->m, *b = m->m + 4, *c = m->m + 8;
	const float square = dot3(a, a), most = square / 1024.0f;
	const bool uniform = scalar_abs(dot3(b, b) - square) < most &&
		scalar_abs(dot3(c, c) - square) < most &&
		scalar_abs(dot3(a, b)) < most &&
		scalar_abs(dot3(a, c)) < most && scalar_abs(dot3(b, c)) < most;

	return uniform ? scalar_sqrt(square) : 0.0f;
}

float soft_matrix_largest(const float *values, int count)
{
	float most = 0.0f;

	for (int i = 0; i < count; i++) {
		const float size = scalar_abs(values[i]);

		most = size > most ? size : most;
	}
	return most;
}

int soft_matrix_exponent(float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	return (int)(bits >> 23 & 255) - 127;
}

float soft_matrix_power_of_two(int exponent)
{
	uint32_t bits = (uint32_t)(exponent + 127) << 23;
	float value;

	memcpy(&value, &bits, sizeof(value));
	return value;
}

static struct matrix_stack *current_stack(void)
{
	struct soft *soft = soft_current();
	const GLenum mode = soft->matrices.mode;

	return &soft->matrices.stack[mode - GL_MODELVIEW] +
		(mode == GL_TEXTURE ? soft->textures.active : 0);
}

/* The current matrix, which changes. */
static struct matrix *change_matrix(void)
{
	soft_change(soft_current()->matrices.mode == GL_TEXTURE
			? GROUP_TEXTURES
			: GROUP_MATRICES);
	return current_stack()->top;
}

void soft_gl_LoadIdentity(void)
{
	*change_matrix() = soft_matrix_identity;
}

static struct matrix take_matrix(const GLfixed *values)
{
	struct matrix matrix;

	for (int i = 0; i < 16; i++) {
		matrix.m[i] = fx16_to_float(values[i]);
	}
	return matrix;
}

void soft_gl_LoadMatrixx(const GLfixed *values)
{
	*change_matrix() = take_matrix(values);
}

static void multiply(const struct matrix *by)
{
	struct matrix *top = change_matrix();

	*top = soft_matrix_multiply(top, by);
}

void soft_gl_MultMatrixx(const GLfixed *values)
{
	struct matrix matrix = take_matrix(values);

	multiply(&matrix);
}

void soft_gl_PushMatrix(void)
{
	struct matrix_stack *stack = current_stack();

	if (soft_check(stack->top < &stack->matrix[SOFT_STACK_DEPTH - 1],
		    GL_STACK_OVERFLOW)) {
		stack->top[1] = stack->top[0];
		stack->top++;
	}
}

void soft_gl_PopMatrix(void)
{
	struct matrix_stack *stack = current_stack();

	if (soft_check(stack->top != stack->matrix, GL_STACK_UNDERFLOW)) {
		change_matrix();
		stack->top--;
	}
}

void soft_gl_Translatex(GLfixed x, GLfixed y, GLfixed z)
{
	const float by[4] = {
		fx16_to_float(x), fx16_to_float(y), fx16_to_float(z), 1.0f};
	struct matrix *top = change_matrix();

	soft_matrix_transform(top, by, top->m + 12);
}

void soft_gl_Scalex(GLfixed x, GLfixed y, GLfixed z)
{
	const float by[3] = {
		fx16_to_float(x), fx16_to_float(y), fx16_to_float(z)};
	struct matrix *top = change_matrix();

	for (int i = 0; i < 12; i++) {
		top->m[i] *= by[i / 4];
	}
}

void soft_gl_Rotatex(GLfixed degrees, GLfixed x, GLfixed y, GLfixed z)
{
	float angle = fx16_to_float(degrees) * (SCALAR_PI / 180.0f);
	float axis[3] = {fx16_to_float(x), fx16_to_float(y), fx16_to_float(z)};
	float c = scalar_cos(angle), s = scalar_sin(angle);
	struct matrix turn = soft_matrix_identity;

	if (dot3(axis, axis) == 0.0f) {
		return;
	}
	soft_matrix_normalize(axis);
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		turn.m[5 * i] = axis[i] * axis[i] * (1.0f - c) + c;
		turn.m[4 * i + j] = axis[i] * axis[j] * (1.0f - c) + axis[k] * s;
		turn.m[4 * i + k] = axis[i] * axis[k] * (1.0f - c) - axis[j] * s;
	}
	multiply(&turn);
}

/* Multiplies by glFrustum's matrix, or glOrtho's; ends has two for each axis. */
static void project(const GLfixed ends[6], bool perspective)
{
	struct matrix matrix = {{0}};
	float *centre = matrix.m + (perspective ? 8 : 12);
	float far = fx16_to_float(ends[5]), size = 0.0f;
	float twice = perspective ? 2.0f * fx16_to_float(ends[4]) : 2.0f;

	for (int i = 0; i < 3; i++) {
		float from = fx16_to_float(ends[2 * i]);
		float to = fx16_to_float(ends[2 * i + 1]);

		if (!soft_check(
			    ends[2 * i] != ends[2 * i + 1], GL_INVALID_VALUE)) {
			return;
		}
		size = to - from;
		matrix.m[5 * i] = twice / size;
		centre[i] = -(to + from) / size;
	}
	if (perspective) {
		matrix.m[8] = -matrix.m[8];
		matrix.m[9] = -matrix.m[9];
		matrix.m[11] = -1.0f;
		matrix.m[14] = -twice * far / size;
	} else {
		matrix.m[10] = -matrix.m[10];
		matrix.m[15] = 1.0f;
	}
	multiply(&matrix);
}

void soft_gl_Frustumx(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top,
	GLfixed near, GLfixed far)
{
	if (soft_check(near > 0 && far > 0, GL_INVALID_VALUE)) {
		project((GLfixed[]){left, right, bottom, top, near, far}, true);
	}
}

void soft_gl_Orthox(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top,
	GLfixed near, GLfixed far)
{
	project((GLfixed[]){left, right, bottom, top, near, far}, false);
}

void soft_init_matrices(struct matrices *matrices)
{
	matrices->mode = GL_MODELVIEW;
	for (int i = 0; i < SOFT_STACKS; i++) {
		matrices->stack[i].top = matrices->stack[i].matrix;
		*matrices->stack[i].top = soft_matrix_identity;
	}
}
