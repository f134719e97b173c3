#include "app/demo/crowd/crowd_shadow.h"

#include "app/scene/draw/matrix_gl.h"
#include "app/scene/stage/light.h"
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

/* Twelve corners of a circle with the radius 256 that stands on the ground. */
static const int16_t circle[][3] = {{0, 0, 0}, {128, 34, 0}, {222, 128, 0},
	{256, 256, 0}, {222, 384, 0}, {128, 478, 0}, {0, 512, 0}, {-128, 478, 0},
	{-222, 384, 0}, {-256, 256, 0}, {-222, 128, 0}, {-128, 34, 0}};

static void draw_ellipse(const struct crowd_shadow *shadow, const struct gl *gl)
{
	gl->Scalex(fx16_from_float(shadow->half_width_m / 256.0f),
		fx16_from_float(shadow->height_m / 512.0f), FX16_ONE);
	gl->VertexPointer(3, GL_SHORT, 0, circle);
	gl->DrawArrays(GL_TRIANGLE_FAN, 0, (int)ARRAY_COUNT(circle));
}

/* The vertices are in units of 1/256 m. */
static void draw_person(const struct gl *gl)
{
	static const int16_t person[][3] = {{0, 250, 0}, {-28, 440, 0},
		{-44, 380, 0}, {-68, 360, 0}, {-76, 200, 0}, {-48, 190, 0},
		{-42, 0, 0}, {42, 0, 0}, {48, 190, 0}, {76, 200, 0},
		{68, 360, 0}, {44, 380, 0}, {28, 440, 0}, {-28, 440, 0}};

	gl->Scalex(FX16_ONE / 256, FX16_ONE / 256, FX16_ONE / 256);
	gl->VertexPointer(3, GL_SHORT, 0, person);
	gl->DrawArrays(GL_TRIANGLE_FAN, 0, (int)ARRAY_COUNT(person));
}

/* Multiplies by the matrix that turns the outline's flat side to the light. */
static void face_light(
	const struct crowd_position *position, const struct gl *gl)
{
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;
	float light[3], length;

	light_direction(light);
	length = scalar_sqrt(light[0] * light[0] + light[2] * light[2]);
	matrix[0][0] = matrix[2][2] = light[2] / length;
	matrix[2][0] = light[0] / length;
	matrix[0][2] = -light[0] / length;
	matrix[3][0] = position->x;
	matrix[3][2] = position->z;
	gl->PushMatrix();
	matrix_gl_multiply(gl, (const vec4 *)matrix);
}

void crowd_shadow_draw(const struct crowd_shadow *shadow,
	const struct crowd_position *position, const struct gl *gl)
{
	face_light(position, gl);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->Disable(GL_CULL_FACE);
	if (shadow->is_person) {
		draw_person(gl);
	} else {
		draw_ellipse(shadow, gl);
	}
	gl->PopMatrix();
}
