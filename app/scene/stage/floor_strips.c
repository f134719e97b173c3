#include "app/scene/stage/floor_strips.h"

#include "platform/base/scalar.h"

#include <cglm/cglm.h>

/*
 * The camera's view of the plane. A row of pixels is given by its slope: the
 * height of its ray at depth 1 in eye space.
 */
struct view {
	mat4 world_to_eye;
	float eye[3];
	float left, right, bottom, top; /* the picture at depth 1, inset */
	float edge, row;    /* slope of the lower edge; step between rows */
	float sine, cosine; /* of the camera's pitch below the horizon */
	float height;       /* of the eye above the ground */
	float near, far;    /* depths of the clip planes, inset */
};

/*
 * Quads that end a quarter of a pixel inside the picture still cover every
 * pixel's centre and are not clipped. Where 16.16 is too coarse for that, they
 * extend eight pixels beyond the picture instead.
 */
static float choose_inset(const struct camera_frustum *frustum)
{
	const fx16_t fine = 2048;

	return frustum->top - frustum->bottom < fine ||
			frustum->right - frustum->left < fine
		? -8.0f
		: 0.25f;
}

static void init_view(struct view *view, const struct camera *camera, int width,
	int height, float ground)
{
	const struct camera_frustum frustum =
		camera_frustum(camera, width, height);
	float unit = 1.0f / (float)(frustum.near > 0 ? frustum.near : 1),
	      inset = choose_inset(&frustum);
	float column =
		(float)(frustum.right - frustum.left) * unit / (float)width;

	view->row = (float)(frustum.top - frustum.bottom) * unit / (float)height;
	view->edge = (float)frustum.bottom * unit;
	view->left = (float)frustum.left * unit + inset * column;
	view->right = (float)frustum.right * unit - inset * column;
	view->bottom = view->edge + inset * view->row;
	view->top = (float)frustum.top * unit - inset * view->row;
	camera_view(camera, view->world_to_eye);
	camera_eye(camera, view->eye);
	view->sine = view->world_to_eye[1][2];
	view->cosine = view->world_to_eye[1][1];
	view->height = view->eye[1] - ground;
	view->near = 1.01f * fx16_to_float(frustum.near);
	view->far = 0.99f * fx16_to_float(frustum.far);
}

static float min(float a, float b)
{
	return a < b ? a : b;
}

/* The depth in eye space of the ground in a row. */
static float depth_at(const struct view *view, float slope)
{
	return view->height / (view->sine - view->cosine * slope);
}

static float slope_of_depth(const struct view *view, float depth)
{
	return (view->sine - view->height / depth) / view->cosine;
}

/* The level distance ahead of the eye of the ground in a row. */
static float ahead_at(const struct view *view, float slope)
{
	return depth_at(view, slope) * (slope * view->sine + view->cosine);
}

/* The row that shows the ground at a level distance ahead of the eye. */
static float slope_ahead(const struct view *view, float ahead)
{
	float forward = view->height * view->sine + ahead * view->cosine;

	return forward > 0.0f
		? (ahead * view->sine - view->height * view->cosine) / forward
		: view->bottom;
}

static void unproject(
	const struct view *view, float slope, float across, float out[3])
{
	float depth = depth_at(view, slope);

	for (int i = 0; i < 3; i++) {
		out[i] = view->eye[i] +
			depth *
				(view->world_to_eye[i][0] * across +
					view->world_to_eye[i][1] * slope -
					view->world_to_eye[i][2]);
	}
}

static void set_row(struct floor_strips *strips, int row,
	const struct view *view, float slope, float ground, float alpha)
{
	for (int side = 0; side < 2; side++) {
		float *p = strips->position[2 * row + side];

		unproject(view, slope, side ? view->right : view->left, p);
		p[1] = ground;
		strips->alpha[2 * row + side] =
			(uint8_t)(scalar_clamp(alpha, 0.0f, 1.0f) * 255.0f +
				0.5f);
	}
}

/* The number of whole rows below a slope. */
static int count_rows(const struct view *view, float slope, int height)
{
	float rows = (slope - view->edge) / view->row;

	return (int)scalar_clamp(rows, 0.0f, (float)height);
}

void floor_strips_find(struct floor_strips *strips, const struct camera *camera,
	int width, int height, float y, float opaque_end, float end)
{
	struct view view;
	float slope[3];
	bool near;

	*strips = (struct floor_strips){.horizon_px = height};
	init_view(&view, camera, width, height, y);
	if (view.height <= 0.0f) {
		return;
	}
	slope[0] = slope_of_depth(&view, view.near);
	near = slope[0] <= view.bottom;
	slope[0] = near ? view.bottom : slope[0];
	slope[2] = min(slope_ahead(&view, end),
		min(slope_of_depth(&view, view.far), view.top));
	slope[2] = scalar_clamp(slope[2], slope[0], view.top);
	slope[1] = scalar_clamp(
		slope_ahead(&view, opaque_end), slope[0], slope[2]);
	strips->opaque = slope[1] > slope[0];
	strips->fading = slope[2] > slope[1];
	for (int i = 0; i < 3 && slope[2] > slope[0]; i++) {
		set_row(strips, i, &view, slope[i], y,
			(end - ahead_at(&view, slope[i])) / (end - opaque_end));
	}
	/* The row that the edge crosses is covered only in part. */
	if (strips->opaque && near) {
		strips->covered_px = count_rows(&view, slope[1], height) - 1;
		strips->covered_px =
			strips->covered_px > 0 ? strips->covered_px : 0;
	}
	strips->horizon_px =
		count_rows(&view, view.sine / view.cosine, height - 1) + 1;
}
