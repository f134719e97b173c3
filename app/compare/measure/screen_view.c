#include "app/compare/measure/screen_view.h"

#include "app/scene/stage/camera.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

/* The same as in app/demo/viewer/viewer.c. */
static const struct camera_framing framing = {
	.yaw_rad = 0.45f,
	.pitch_rad = 0.16f,
	.margin = 1.15f,
};

static struct bounds box_of(
	struct reference *reference, const struct time_grid *grid)
{
	struct bounds box = bounds_empty();

	for (int i = 0; i < grid->count; i++) {
		reference_pose(reference, grid->time_s[i], false);
		for (int v = 0; v < reference->vertex_count; v++) {
			bounds_add(&box, reference->position[v]);
		}
	}
	return box;
}

struct screen_view screen_view_create(struct reference *reference,
	const struct time_grid *grid, int width, int height)
{
	struct screen_view screen = {
		.width = width,
		.height = height,
		.unit = reference->instance->unit_scale,
	};
	struct bounds box = box_of(reference, grid);

	screen_view_frame(&screen, &box);
	return screen;
}

void screen_view_frame(struct screen_view *screen, const struct bounds *box)
{
	struct camera camera = camera_default();
	struct camera_framing wanted = framing;
	struct bounds scene_box = *box;
	float half_rad = 0.5f * camera.yfov_rad;

	screen->box = *box;
	glm_vec3_scale(scene_box.low, screen->unit, scene_box.low);
	glm_vec3_scale(scene_box.high, screen->unit, scene_box.high);
	wanted.aspect = (float)screen->width / (float)screen->height;
	camera_frame(&camera, &scene_box, &wanted);
	camera_view(&camera, screen->view);
	for (int column = 0; column < 3; column++) {
		glm_vec3_scale(screen->view[column], screen->unit,
			screen->view[column]);
	}
	screen->focal_px = 0.5f * (float)screen->height * scalar_cos(half_rad) /
		scalar_sin(half_rad);
}

void screen_view_project(
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

	screen_view_project(screen, a, p);
	screen_view_project(screen, b, q);
	p[0] -= q[0];
	p[1] -= q[1];
	return scalar_sqrt(p[0] * p[0] + p[1] * p[1]);
}
