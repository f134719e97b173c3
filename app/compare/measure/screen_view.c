#include "app/compare/measure/screen_view.h"

#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <math.h>

#include <cglm/cglm.h>

struct camera_framing screen_view_played(const struct bounds *rest)
{
	struct camera camera = camera_default();

	return (struct camera_framing){
		.yaw_rad = camera.yaw_rad,
		.pitch_rad = camera_pitch_for(rest),
		.margin = 1.1f,
		.follow = true,
	};
}

static void add_vertices(struct bounds *box, const struct reference *reference)
{
	for (int v = 0; v < reference->vertex_count; v++) {
		bounds_add(box, reference->position[v]);
	}
}

static struct bounds box_of(
	struct reference *reference, const struct time_grid *grid)
{
	struct bounds box = bounds_empty();

	for (int i = 0; i < grid->count && (i == 0 || !interrupt_pending());
		i++) {
		reference_pose(reference, grid->time_s[i], false);
		add_vertices(&box, reference);
	}
	return box;
}

struct screen_view screen_view_begin(
	struct reference *reference, int width, int height)
{
	struct bounds rest = bounds_empty();

	reference_rest(reference);
	add_vertices(&rest, reference);
	return (struct screen_view){
		.width = width,
		.height = height,
		.unit = reference->instance->unit_scale,
		.framing = screen_view_played(&rest),
	};
}

struct screen_view screen_view_create(struct reference *reference,
	const struct time_grid *grid, int width, int height)
{
	struct screen_view screen = screen_view_begin(reference, width, height);
	struct bounds box = box_of(reference, grid);

	screen_view_frame(&screen, &box);
	return screen;
}

/*
 * Finds an upper limit of the pixels that a unit covers. The projections p and
 * q of two points of eye space whose difference is d differ by
 *
 *	q - p = focal / z_q * (d.xy - p / focal * d.z),
 *
 * which is at most focal / z_q * sqrt(1 + (p / focal)^2) * |d|. The first may
 * lie outside of the box by a fifth of the nearest corner's depth, because a
 * clip can leave the box between the moments of its grid; the second is another
 * twentieth of it away.
 */
static void find_scale(struct screen_view *screen)
{
	const struct bounds *box = &screen->box;
	float nearest = 1e30f, aside = 0.0f, tangent;

	for (int i = 0; i < 8; i++) {
		const float corner[3] = {i & 1 ? box->high[0] : box->low[0],
			i & 2 ? box->high[1] : box->low[1],
			i & 4 ? box->high[2] : box->low[2]};
		float eye[3], square;

		screen_view_to_eye(screen, corner, eye);
		square = eye[0] * eye[0] + eye[1] * eye[1];
		nearest = fminf(nearest, -eye[2]);
		aside = fmaxf(aside, square);
	}
	screen->px_per_unit = 1.0f;
	screen->near_square = -1.0f; /* no points are near enough */
	if (nearest > 0.0f) {
		tangent = (scalar_sqrt(aside) + 0.2f * nearest) /
			(0.8f * nearest);
		screen->px_per_unit = screen->unit * screen->focal_px /
			(0.75f * nearest) *
			scalar_sqrt(1.0f + tangent * tangent);
		nearest *= 0.05f;
		screen->near_square =
			nearest * nearest / (screen->unit * screen->unit);
	}
}

void screen_view_frame(struct screen_view *screen, const struct bounds *box)
{
	struct camera_framing wanted = screen->framing;
	struct camera camera = camera_default();
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
	find_scale(screen);
}

void screen_view_project(
	const struct screen_view *screen, const float point[3], float out[2])
{
	float eye[3];

	screen_view_to_eye(screen, point, eye);
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
