#include "app/scene/stage/camera.h"

#include "app/scene/draw/matrix_gl.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

#include <string.h>

/* Moves of the box below this part of the radius do not change the camera. */
static const float least_move = 1e-4f;
/* Factors of the distance at which the box fits, between which users zoom. */
static const float zoom_nearest = 1.0f / 32.0f, zoom_farthest = 32.0f;
/* Farther from the origin than this many distances, rounding would show. */
static const float far_eye = 8.0f;
/* Above the horizon; flat is what is this low, as a part of both its sides. */
static const float usual_pitch = 0.16f, flat_pitch = 0.56f, flat_part = 0.25f;
/* A float has 24 bits; the last three may be wrong after some operations. */
static const float float_parts = 2097152.0f;

enum {
	YAW_STEPS = 9,
	FIT_STEPS = 18
};

struct camera camera_default(void)
{
	return (struct camera){
		.distance = 4.0f,
		.yaw_rad = 0.45f,
		.pitch_rad = usual_pitch,
		.yfov_rad = 0.52f,
		.radius = 2.0f,
		.fit = {.zoom = 1.0f},
	};
}

float camera_pitch_for(const struct bounds *bounds)
{
	float side[3];

	for (int i = 0; i < 3; i++) {
		side[i] = bounds->high[i] - bounds->low[i];
	}
	return !bounds_is_empty(bounds) && side[1] <= flat_part * side[0] &&
			side[1] <= flat_part * side[2]
		? flat_pitch
		: usual_pitch;
}

/* The axes of eye space in world space; the camera looks along -back. */
static void view_axes(float yaw_rad, float pitch_rad, float right[3],
	float up[3], float back[3])
{
	float sy = scalar_sin(yaw_rad), cy = scalar_cos(yaw_rad);
	float sp = scalar_sin(pitch_rad), cp = scalar_cos(pitch_rad);

	glm_vec3_copy((vec3){cy, 0.0f, -sy}, right);
	glm_vec3_copy((vec3){-sy * sp, cp, -cy * sp}, up);
	glm_vec3_copy((vec3){sy * cp, sp, cy * cp}, back);
}

/* The eye's least distance at which a corner of the box is in the picture. */
static float distance_for(const float corner[3], float right[3], float up[3],
	float back[3], float tan_x, float tan_y)
{
	float x = glm_vec3_dot((float *)corner, right);
	float y = glm_vec3_dot((float *)corner, up);
	float z = glm_vec3_dot((float *)corner, back);
	float distance_x = z + (x < 0.0f ? -x : x) / tan_x;
	float distance_y = z + (y < 0.0f ? -y : y) / tan_y;

	return scalar_max(distance_x, distance_y);
}

float camera_tan_half(float angle_rad)
{
	return scalar_sin(0.5f * angle_rad) / scalar_cos(0.5f * angle_rad);
}

/* Computes one of the eight corners of a box around the target. */
static void box_corner(const float half[3], int number, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = number >> axis & 1 ? half[axis] : -half[axis];
	}
}

/* Returns the least distance at which a box at the target fits at any yaw. */
static float distance_for_every_yaw(const struct camera *camera,
	const float half[3], float tan_x, float tan_y)
{
	float farthest = 0.0f;

	for (int i = 0; i < YAW_STEPS * 8; i++) {
		float corner[3], right[3], up[3], back[3], distance;
		float yaw = (float)(i / 8) * (2.0f * SCALAR_PI / YAW_STEPS);

		box_corner(half, i % 8, corner);
		view_axes(yaw, camera->pitch_rad, right, up, back);
		distance = distance_for(corner, right, up, back, tan_x, tan_y);
		farthest = scalar_max(distance, farthest);
	}
	return farthest > 0.0f ? farthest : 1.0f;
}

/* The box's corners in eye space, relative to the target. */
struct seen_box {
	float corner[8][3]; /* right, up, towards the eye */
	float nearest;      /* the largest third coordinate of a corner */
	float fits_at;      /* a distance at which the box surely fits */
};

static struct seen_box see_box(
	const struct camera *camera, float tan_x, float tan_y)
{
	struct seen_box box = {.nearest = 0.0f};
	float axis[3][3];

	view_axes(camera->yaw_rad, camera->pitch_rad, axis[0], axis[1], axis[2]);
	for (int i = 0; i < 8; i++) {
		float corner[3], distance;

		box_corner(camera->fit.half, i, corner);
		for (int k = 0; k < 3; k++) {
			box.corner[i][k] = glm_vec3_dot(corner, axis[k]);
		}
		distance = distance_for(
			corner, axis[0], axis[1], axis[2], tan_x, tan_y);
		box.fits_at = scalar_max(distance, box.fits_at);
		box.nearest = scalar_max(box.corner[i][2], box.nearest);
	}
	return box;
}

/*
 * Finds the least and the greatest slope of the box's corners for a camera at
 * this distance: x / depth for axis 0, y / depth for axis 1.
 */
static void slopes(const struct seen_box *box, int axis, float distance,
	float *low, float *high)
{
	*low = *high = box->corner[0][axis] / (distance - box->corner[0][2]);
	for (int i = 1; i < 8; i++) {
		float slope =
			box->corner[i][axis] / (distance - box->corner[i][2]);

		*low = scalar_min(slope, *low);
		*high = scalar_max(slope, *high);
	}
}

/*
 * Moves the camera to the least distance at which the box is no larger than the
 * region, found by halving, and shifts the picture so that the box is in the
 * region's middle.
 */
static void fit_box(struct camera *camera)
{
	const struct camera_region *region = &camera->fit.region;
	float tan_y = camera_tan_half(camera->yfov_rad);
	float tan_x = tan_y * camera->fit.aspect;
	float wide = tan_x * (region->right - region->left);
	float high = tan_y * (region->top - region->bottom);
	struct seen_box box = see_box(camera, 0.5f * wide, 0.5f * high);
	float far = box.fits_at, near = box.nearest * 1.02f;
	float x[2], y[2];

	for (int i = 0; i < FIT_STEPS; i++) {
		float middle = 0.5f * (near + far);

		slopes(&box, 0, middle, &x[0], &x[1]);
		slopes(&box, 1, middle, &y[0], &y[1]);
		if (x[1] - x[0] <= wide && y[1] - y[0] <= high) {
			far = middle;
		} else {
			near = middle;
		}
	}
	far = far > 0.0f ? far : 1.0f;
	slopes(&box, 0, far, &x[0], &x[1]);
	slopes(&box, 1, far, &y[0], &y[1]);
	camera->shift_x =
		0.5f * (region->left + region->right - (x[0] + x[1]) / tan_x);
	camera->shift_y =
		0.5f * (region->bottom + region->top - (y[0] + y[1]) / tan_y);
	camera->distance = far * camera->fit.zoom;
}

/* Returns the region, or the whole picture if it is empty, less the margin. */
static struct camera_region inner_region(
	const struct camera_region *region, float margin)
{
	static const struct camera_region whole = {-1.0f, 1.0f, -1.0f, 1.0f};
	struct camera_region in =
		region->right > region->left && region->top > region->bottom
		? *region
		: whole;
	float x = 0.5f * (in.right - in.left) * (1.0f - 1.0f / margin);
	float y = 0.5f * (in.top - in.bottom) * (1.0f - 1.0f / margin);

	return (struct camera_region){
		in.left + x, in.right - x, in.bottom + y, in.top - y};
}

void camera_frame(struct camera *camera, const struct bounds *bounds,
	const struct camera_framing *framing)
{
	struct camera_region region =
		inner_region(&framing->region, framing->margin);
	float *half = camera->fit.half;

	camera->yaw_rad = framing->yaw_rad;
	camera->pitch_rad = framing->pitch_rad;
	camera->fit.on = framing->follow;
	camera->fit.region = region;
	camera->fit.aspect = framing->aspect;
	camera->fit.zoom = 1.0f;
	bounds_center(bounds, camera->target);
	for (int axis = 0; axis < 3; axis++) {
		half[axis] = bounds_is_empty(bounds)
			? 0.5f
			: 0.5f * (bounds->high[axis] - bounds->low[axis]);
		half[axis] = scalar_clamp(half[axis], 0.0f, CAMERA_REACH);
	}
	camera->radius = glm_vec3_norm(half) * 1.5f;
	if (framing->follow) {
		fit_box(camera);
	} else {
		float tan_y = 0.5f * (region.top - region.bottom) *
			camera_tan_half(camera->yfov_rad);
		float tan_x = 0.5f * (region.right - region.left) *
			camera_tan_half(camera->yfov_rad) * framing->aspect;

		camera->distance =
			distance_for_every_yaw(camera, half, tan_x, tan_y);
		camera->shift_x = 0.5f * (region.left + region.right);
		camera->shift_y = 0.5f * (region.bottom + region.top);
	}
}

void camera_ease_to(
	struct camera *camera, const struct bounds *bounds, float fraction)
{
	float center[3], moved = 0.0f;

	if (bounds_is_empty(bounds)) {
		return;
	}
	bounds_center(bounds, center);
	for (int axis = 0; axis < 3; axis++) {
		float half = 0.5f * (bounds->high[axis] - bounds->low[axis]);
		float move = (center[axis] - camera->target[axis]) * fraction;
		float grow = (half - camera->fit.half[axis]) * fraction;

		camera->target[axis] += move;
		camera->fit.half[axis] += grow;
		moved += scalar_abs(move) + scalar_abs(grow);
	}
	if (camera->fit.on && moved > least_move * camera->radius) {
		fit_box(camera);
	}
}

void camera_set_region(struct camera *camera,
	const struct camera_region *region, float margin, float aspect)
{
	struct camera_region inner = inner_region(region, margin);
	struct camera_fit *fit = &camera->fit;
	bool same = aspect == fit->aspect &&
		memcmp(&inner, &fit->region, sizeof(inner)) == 0;

	fit->region = inner;
	fit->aspect = aspect;
	if (fit->on && !same) {
		fit_box(camera);
	}
}

struct camera_region camera_covered(const struct camera *camera)
{
	float tan_y = camera_tan_half(camera->yfov_rad);
	float tan_x = tan_y * camera->fit.aspect;
	struct seen_box box;
	float x[2], y[2];

	if (!camera->fit.on) {
		return camera->fit.region;
	}
	box = see_box(camera, tan_x, tan_y);
	slopes(&box, 0, camera->distance, &x[0], &x[1]);
	slopes(&box, 1, camera->distance, &y[0], &y[1]);
	return (struct camera_region){x[0] / tan_x + camera->shift_x,
		x[1] / tan_x + camera->shift_x, y[0] / tan_y + camera->shift_y,
		y[1] / tan_y + camera->shift_y};
}

void camera_zoom(struct camera *camera, float factor)
{
	float zoom = scalar_clamp(
		camera->fit.zoom * factor, zoom_nearest, zoom_farthest);

	camera->distance *= zoom / camera->fit.zoom;
	camera->fit.zoom = zoom;
}

float camera_farthest(const struct camera *camera)
{
	struct camera turned = *camera;
	float farthest = camera->distance;

	for (int i = 0; camera->fit.on && i < YAW_STEPS; i++) {
		turned.yaw_rad = (float)i * (2.0f * SCALAR_PI / YAW_STEPS);
		fit_box(&turned);
		farthest = scalar_max(turned.distance, farthest);
	}
	return farthest;
}

void camera_orbit(struct camera *camera, float yaw_rad, float pitch_rad)
{
	if (yaw_rad == 0.0f && pitch_rad == 0.0f) {
		return;
	}
	camera->yaw_rad += yaw_rad;
	if (camera->yaw_rad > SCALAR_PI) {
		camera->yaw_rad -= 2.0f * SCALAR_PI;
	}
	if (camera->yaw_rad < -SCALAR_PI) {
		camera->yaw_rad += 2.0f * SCALAR_PI;
	}
	camera->pitch_rad =
		scalar_clamp(camera->pitch_rad + pitch_rad, 0.02f, 1.5f);
	if (camera->fit.on) {
		fit_box(camera);
	}
}

void camera_eye(const struct camera *camera, float out[3])
{
	float right[3], up[3], back[3];

	view_axes(camera->yaw_rad, camera->pitch_rad, right, up, back);
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = camera->target[axis] + back[axis] * camera->distance;
	}
}

static bool is_far(const struct camera *camera, const float eye[3])
{
	return glm_vec3_norm((float *)eye) > far_eye * camera->distance;
}

float camera_view_error(const struct camera *camera)
{
	float eye[3], away;

	camera_eye(camera, eye);
	away = glm_vec3_norm(eye);
	return is_far(camera, eye) ? away / float_parts + 1.0f / FX16_ONE
				   : away / FX16_ONE;
}

/* Sums in double, because the terms may be far larger than the sum. */
static float dot_far(const float a[3], const float b[3])
{
	return (float)((double)a[0] * (double)b[0] +
		(double)a[1] * (double)b[1] + (double)a[2] * (double)b[2]);
}

/*
 * Far from the origin, the axes are rounded as GL will round them before the
 * translation is found: so both belong together, and the eye stays in its place.
 */
void camera_view(const struct camera *camera, mat4 out)
{
	float axis[3][3], eye[3];
	bool far;

	view_axes(camera->yaw_rad, camera->pitch_rad, axis[0], axis[1], axis[2]);
	camera_eye(camera, eye);
	far = is_far(camera, eye);
	glm_mat4_identity(out);
	for (int row = 0; row < 3; row++) {
		for (int i = 0; i < 3; i++) {
			axis[row][i] = far
				? fx16_to_float(fx16_from_float(axis[row][i]))
				: axis[row][i];
			out[i][row] = axis[row][i];
		}
		out[3][row] = far ? -dot_far(axis[row], eye)
				  : -glm_vec3_dot(axis[row], eye);
	}
}

/* Clamps a frustum's edge so that the difference of two edges fits 16.16. */
static fx16_t edge(float value)
{
	return fx16_from_float(scalar_clamp(value, -16000.0f, 16000.0f));
}

/*
 * The depth of the ground that the box stands on at the picture's lower edge,
 * where it is nearest.
 */
static float ground_depth(const struct camera *camera)
{
	float sine = scalar_sin(camera->pitch_rad);
	float slope =
		camera_tan_half(camera->yfov_rad) * (1.0f + camera->shift_y);
	float fall = sine + scalar_cos(camera->pitch_rad) * slope;
	float height = camera->distance * sine + camera->fit.half[1];

	return fall > 0.0f ? height / fall : camera->distance;
}

struct camera_frustum camera_frustum(
	const struct camera *camera, int width, int height)
{
	float ground = 0.95f * ground_depth(camera);
	float model = scalar_clamp(camera->distance - camera->radius,
		0.05f * camera->distance, 0.35f * camera->distance);
	float near = ground < model
		? scalar_clamp(ground, 0.02f * camera->distance, model)
		: model;
	float far = 2.2f * camera->distance + 3.0f * camera->radius +
		1.1f * CAMERA_RISE_AHEAD * camera->rise;
	const float far_max = 30000.0f;
	float top = near * camera_tan_half(camera->yfov_rad);
	float half_width = top * (float)width / (float)height;
	float right = camera->shift_x * half_width;
	float up = camera->shift_y * top;

	return (struct camera_frustum){
		.left = edge(-half_width - right),
		.right = edge(half_width - right),
		.bottom = edge(-top - up),
		.top = edge(top - up),
		.near = fx16_from_float(near),
		.far = fx16_from_float(scalar_min(far, far_max)),
	};
}

void camera_apply(
	const struct camera *camera, const struct gl *gl, int width, int height)
{
	const struct camera_frustum frustum =
		camera_frustum(camera, width, height);
	mat4 view;

	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(frustum.left, frustum.right, frustum.bottom, frustum.top,
		frustum.near, frustum.far);
	gl->MatrixMode(GL_MODELVIEW);
	camera_view(camera, view);
	matrix_gl_load(gl, (const vec4 *)view);
}
