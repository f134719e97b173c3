#include "app/compare/screen_view.h"

#include "app/scene/stage/camera.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

/* The same as in app/demo/viewer.c. */
static const struct camera_framing framing = {
	.yaw_rad = 0.45f,
	.pitch_rad = 0.16f,
	.margin = 1.15f,
};

struct screen_view screen_view_create(
	const struct reference *reference, int width, int height)
{
	struct screen_view screen = {.width = width, .height = height};
	struct camera camera = camera_default();
	struct camera_framing wanted = framing;
	struct bounds bounds = bounds_empty();
	float unit = reference->instance->unit_scale;
	size_t count = (size_t)reference->frame_count *
		(size_t)reference->vertex_count;
	float half_rad = 0.5f * camera.yfov_rad;

	for (size_t i = 0; i < count; i++) {
		float point[3];

		glm_vec3_scale(reference->position[i], unit, point);
		bounds_add(&bounds, point);
	}
	wanted.aspect = (float)width / (float)height;
	camera_frame(&camera, &bounds, &wanted);
	camera_view(&camera, screen.view);
	for (int column = 0; column < 3; column++) {
		glm_vec3_scale(screen.view[column], unit, screen.view[column]);
	}
	screen.focal_px = 0.5f * (float)height * scalar_cos(half_rad) /
		scalar_sin(half_rad);
	return screen;
}

static void project(
	const struct screen_view *screen, const float point[3], float out[2])
{
	const vec4 *view = screen->view;
	float eye[3];

	for (int row = 0; row < 3; row++) {
		eye[row] = view[0][row] * point[0] + view[1][row] * point[1] +
			view[2][row] * point[2] + view[3][row];
	}
	/* The clip is in front of the eye, but a bad bake may leave it. */
	eye[2] = eye[2] < -1e-3f ? eye[2] : -1e-3f;
	out[0] = eye[0] * screen->focal_px / -eye[2];
	out[1] = eye[1] * screen->focal_px / -eye[2];
}

float screen_view_distance_px(
	const struct screen_view *screen, const float a[3], const float b[3])
{
	float p[2], q[2];

	project(screen, a, p);
	project(screen, b, q);
	p[0] -= q[0];
	p[1] -= q[1];
	return scalar_sqrt(p[0] * p[0] + p[1] * p[1]);
}
