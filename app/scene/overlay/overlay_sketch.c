#include "app/scene/overlay/overlay_sketch.h"

#include "app/anim/math/vec.h"
#include "app/scene/stage/light.h"
#include "platform/base/scalar.h"

#include <string.h>

static void flush(struct overlay_sketch *sketch)
{
	const GLsizei stride = sizeof(sketch->vertex[0]);

	if (sketch->count > 0) {
		sketch->gl->VertexPointer(
			3, GL_FLOAT, stride, sketch->vertex[0].position);
		sketch->gl->ColorPointer(
			4, GL_UNSIGNED_BYTE, stride, sketch->vertex[0].color);
		sketch->gl->DrawArrays(sketch->mode, 0, sketch->count);
	}
	sketch->count = 0;
}

void overlay_sketch_begin(
	struct overlay_sketch *sketch, const struct gl *gl, GLenum mode)
{
	sketch->gl = gl;
	sketch->mode = mode;
	sketch->count = 0;
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_ALPHA_TEST);
	gl->Disable(GL_CULL_FACE);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void overlay_sketch_end(struct overlay_sketch *sketch)
{
	flush(sketch);
	sketch->gl->Disable(GL_BLEND);
}

static void add_vertex(struct overlay_sketch *sketch, const float at[3],
	const uint8_t color[4])
{
	struct overlay_vertex *vertex = &sketch->vertex[sketch->count++];

	memcpy(vertex->position, at, sizeof(vertex->position));
	memcpy(vertex->color, color, sizeof(vertex->color));
	if (sketch->count == OVERLAY_SKETCH_VERTICES) {
		flush(sketch);
	}
}

void overlay_sketch_line(struct overlay_sketch *sketch, const float a[3],
	const float b[3], const uint8_t color[4])
{
	add_vertex(sketch, a, color);
	add_vertex(sketch, b, color);
}

/* Shades a face whose corners run around it counter-clockwise. */
static void add_face(struct overlay_sketch *sketch, const float corner[3][3],
	const uint8_t color[4])
{
	float light[3], ab[3], ac[3], normal[3], length, brightness;
	uint8_t shaded[4] = {0, 0, 0, color[3]};

	light_direction(light);
	vec_subtract(corner[1], corner[0], ab);
	vec_subtract(corner[2], corner[0], ac);
	vec_cross(ab, ac, normal);
	length = vec_length(normal);
	brightness = length > 0.0f ? vec_dot(normal, light) / length : 0.0f;
	brightness = 0.68f + 0.32f * brightness;
	for (int i = 0; i < 3; i++) {
		shaded[i] = (uint8_t)((float)color[i] * brightness);
	}
	for (int i = 0; i < 3; i++) {
		add_vertex(sketch, corner[i], shaded);
	}
}

/* The corners of the square base, around the axis from a to b. */
static void base_corners(const float a[3], const float b[3], float bulge,
	float radius, float out[4][3])
{
	float axis[3], side[3], other[3], middle[3];
	const float helper[2][3] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
	int lying;

	vec_subtract(b, a, axis);
	lying = axis[0] * axis[0] > 0.5f * vec_dot(axis, axis);
	vec_cross(axis, helper[lying], side);
	vec_cross(axis, side, other);
	vec_add_scaled(a, axis, bulge, middle);
	for (int i = 0; i < 2; i++) {
		float *arm = i ? other : side;
		float length = vec_length(arm);

		vec_add_scaled(middle, arm, radius / length, out[i]);
		vec_add_scaled(middle, arm, -radius / length, out[i + 2]);
	}
}

void overlay_sketch_spindle(struct overlay_sketch *sketch, const float a[3],
	const float b[3], float bulge, float radius, const uint8_t color[4])
{
	float axis[3], base[4][3];

	vec_subtract(b, a, axis);
	if (!(vec_dot(axis, axis) > 1e-14f)) {
		return;
	}
	base_corners(a, b, bulge, radius, base);
	for (int i = 0; i < 4; i++) {
		const float *from = base[i], *to = base[(i + 1) % 4];
		float upper[3][3], lower[3][3];

		memcpy(lower[0], a, sizeof(lower[0]));
		memcpy(lower[1], to, sizeof(lower[1]));
		memcpy(lower[2], from, sizeof(lower[2]));
		memcpy(upper[0], b, sizeof(upper[0]));
		memcpy(upper[1], from, sizeof(upper[1]));
		memcpy(upper[2], to, sizeof(upper[2]));
		add_face(sketch, (const float(*)[3])lower, color);
		add_face(sketch, (const float(*)[3])upper, color);
	}
}

void overlay_sketch_octahedron(struct overlay_sketch *sketch,
	const float center[3], float radius, const uint8_t color[4])
{
	const float a[3] = {center[0], center[1] - radius, center[2]};
	const float b[3] = {center[0], center[1] + radius, center[2]};

	overlay_sketch_spindle(sketch, a, b, 0.5f, radius, color);
}
