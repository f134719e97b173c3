#include "app/scene/stage/camera.h"

#include "app/scene/draw/matrix_gl.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

enum {
	YAW_STEPS = 9
};

struct camera camera_default(void)
{
	return (struct camera){
		.distance = 4.0f,
		.yaw_rad = 0.45f,
		.pitch_rad = 0.16f,
		.yfov_rad = 0.52f,
		.radius = 2.0f,
	};
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

	return distance_x > distance_y ? distance_x : distance_y;
}

float camera_tan_half(float angle_rad)
{
	return scalar_sin(0.5f * angle_rad) / scalar_cos(0.5f * angle_rad);
}

void camera_frame(struct camera *camera, const struct bounds *bounds,
	const struct camera_framing *framing)
{
	float tan_y = camera_tan_half(camera->yfov_rad) / framing->margin;
	float half[3], farthest = 0.0f;

	camera->yaw_rad = framing->yaw_rad;
	camera->pitch_rad = framing->pitch_rad;
	camera->shift_x = framing->shift_x;
	bounds_center(bounds, camera->target);
	for (int axis = 0; axis < 3; axis++) {
		half[axis] = bounds_is_empty(bounds)
			? 0.5f
			: 0.5f * (bounds->high[axis] - bounds->low[axis]);
	}
	for (int i = 0; i < YAW_STEPS * 8; i++) {
		float corner[3], right[3], up[3], back[3], distance;
		float yaw = (float)(i / 8) * (2.0f * SCALAR_PI / YAW_STEPS);

		for (int axis = 0; axis < 3; axis++) {
			corner[axis] = i >> axis & 1 ? half[axis] : -half[axis];
		}
		view_axes(yaw, camera->pitch_rad, right, up, back);
		distance = distance_for(corner, right, up, back,
			tan_y * framing->aspect, tan_y);
		farthest = distance > farthest ? distance : farthest;
	}
	camera->distance = farthest > 0.0f ? farthest : 1.0f;
	camera->radius = glm_vec3_norm(half) * 1.5f;
}

void camera_orbit(struct camera *camera, float yaw_rad, float pitch_rad)
{
	camera->yaw_rad += yaw_rad;
	if (camera->yaw_rad > SCALAR_PI) {
		camera->yaw_rad -= 2.0f * SCALAR_PI;
	}
	if (camera->yaw_rad < -SCALAR_PI) {
		camera->yaw_rad += 2.0f * SCALAR_PI;
	}
	camera->pitch_rad =
		scalar_clamp(camera->pitch_rad + pitch_rad, 0.02f, 1.5f);
}

void camera_eye(const struct camera *camera, float out[3])
{
	float right[3], up[3], back[3];

	view_axes(camera->yaw_rad, camera->pitch_rad, right, up, back);
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = camera->target[axis] + back[axis] * camera->distance;
	}
}

void camera_view(const struct camera *camera, mat4 out)
{
	float axis[3][3], eye[3];

	view_axes(camera->yaw_rad, camera->pitch_rad, axis[0], axis[1], axis[2]);
	camera_eye(camera, eye);
	glm_mat4_identity(out);
	for (int row = 0; row < 3; row++) {
		for (int column = 0; column < 3; column++) {
			out[column][row] = axis[row][column];
		}
		out[3][row] = -glm_vec3_dot(axis[row], eye);
	}
}

void camera_near_plane(const struct camera *camera, float out[4])
{
	const struct camera_frustum frustum = camera_frustum(camera, 1, 1);
	mat4 view;

	camera_view(camera, view);
	for (int i = 0; i < 4; i++) {
		out[i] = -view[i][2];
	}
	out[3] -= fx16_to_float(frustum.near);
}

struct camera_frustum camera_frustum(
	const struct camera *camera, int width, int height)
{
	/* The ground at the picture's lower edge is nearer than the model. */
	float near = scalar_clamp(camera->distance - camera->radius,
		0.05f * camera->distance, 0.35f * camera->distance);
	float far = 2.2f * camera->distance + 3.0f * camera->radius;
	float top = near * camera_tan_half(camera->yfov_rad);
	float half_width = top * (float)width / (float)height;
	float shift = camera->shift_x * half_width;

	return (struct camera_frustum){
		.left = fx16_from_float(-half_width - shift),
		.right = fx16_from_float(half_width - shift),
		.bottom = -fx16_from_float(top),
		.top = fx16_from_float(top),
		.near = fx16_from_float(near),
		.far = fx16_from_float(far),
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
