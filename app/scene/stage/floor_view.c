#include "app/scene/stage/floor_view.h"

#include "platform/base/fixed.h"

#include <cglm/cglm.h>

/*
 * Returns by how much rounding may displace a point in the picture, in pixels;
 * pixel is a pixel's size at depth 1. The ground at the lower edge is half as
 * far away as the target.
 */
static float rounding_px(const struct camera *camera, float pixel)
{
	return camera_view_error(camera) / (0.5f * camera->distance * pixel);
}

/*
 * Quads that end a quarter of a pixel inside the picture still cover every
 * pixel's centre and are not clipped. Where 16.16 is too coarse for that, they
 * extend at least eight pixels beyond the picture instead.
 */
static float choose_inset(const struct camera_frustum *frustum, float error_px)
{
	const fx16_t fine = 2048;

	return frustum->top - frustum->bottom < fine ||
			frustum->right - frustum->left < fine || error_px > 0.25f
		? -8.0f - error_px
		: 0.25f;
}

void floor_view_init(struct floor_view *view, const struct camera *camera,
	int width, int height, float ground)
{
	const struct camera_frustum frustum =
		camera_frustum(camera, width, height);
	float unit = 1.0f / (float)(frustum.near > 0 ? frustum.near : 1);
	float column =
		(float)(frustum.right - frustum.left) * unit / (float)width;
	float inset;

	camera_eye(camera, view->eye);
	view->row = (float)(frustum.top - frustum.bottom) * unit / (float)height;
	view->error_px = rounding_px(camera, view->row);
	inset = choose_inset(&frustum, view->error_px);
	view->edge = (float)frustum.bottom * unit;
	view->left = (float)frustum.left * unit + inset * column;
	view->right = (float)frustum.right * unit - inset * column;
	view->bottom = view->edge + inset * view->row;
	view->top = (float)frustum.top * unit - inset * view->row;
	camera_view(camera, view->world_to_eye);
	view->sine = view->world_to_eye[1][2];
	view->cosine = view->world_to_eye[1][1];
	view->height = view->eye[1] - ground;
	view->near = 1.01f * fx16_to_float(frustum.near);
	view->far = 0.99f * fx16_to_float(frustum.far);
}

float floor_view_depth(const struct floor_view *view, float slope)
{
	return view->height / (view->sine - view->cosine * slope);
}

float floor_view_slope(const struct floor_view *view, float depth)
{
	return (view->sine - view->height / depth) / view->cosine;
}

float floor_view_ahead(const struct floor_view *view, float slope)
{
	return floor_view_depth(view, slope) *
		(slope * view->sine + view->cosine);
}

float floor_view_slope_ahead(const struct floor_view *view, float ahead)
{
	float forward = view->height * view->sine + ahead * view->cosine;

	return forward > 0.0f
		? (ahead * view->sine - view->height * view->cosine) / forward
		: view->bottom;
}

void floor_view_unproject(
	const struct floor_view *view, float slope, float across, float out[3])
{
	float depth = floor_view_depth(view, slope);

	for (int i = 0; i < 3; i++) {
		out[i] = view->eye[i] +
			depth *
				(view->world_to_eye[i][0] * across +
					view->world_to_eye[i][1] * slope -
					view->world_to_eye[i][2]);
	}
}
