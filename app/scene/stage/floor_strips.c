#include "app/scene/stage/floor_strips.h"

#include "app/scene/stage/floor_view.h"
#include "platform/base/scalar.h"

/* Rounding of less than a pixel is left to the row that is not counted. */
static const float safe_px = 0.5f;

static void set_row(struct floor_strips *strips, int row,
	const struct floor_view *view, float slope, float ground, float alpha)
{
	for (int side = 0; side < 2; side++) {
		float *p = strips->position[2 * row + side];

		floor_view_unproject(
			view, slope, side ? view->right : view->left, p);
		p[1] = ground;
		strips->alpha[2 * row + side] =
			(uint8_t)(scalar_clamp(alpha, 0.0f, 1.0f) * 255.0f +
				0.5f);
	}
}

/* The number of whole rows below a slope. */
static int count_rows(const struct floor_view *view, float slope, int height)
{
	float rows = (slope - view->edge) / view->row;

	return (int)scalar_clamp(rows, 0.0f, (float)height);
}

/* Far from the origin, where 16.16 has no numbers, the ground is not drawn. */
static bool is_in_reach(const struct floor_view *view)
{
	const float most = 32000.0f;

	return scalar_abs(view->eye[0]) < most &&
		scalar_abs(view->eye[1]) < most &&
		scalar_abs(view->eye[2]) < most;
}

void floor_strips_find(struct floor_strips *strips, const struct camera *camera,
	int width, int height, float y, float opaque_end, float end)
{
	struct floor_view view;
	float slope[3];
	bool near;

	*strips = (struct floor_strips){.horizon_px = height, .end_px = height};
	floor_view_init(&view, camera, width, height, y);
	if (view.height <= 0.0f) {
		return;
	}
	slope[0] = floor_view_slope(&view, view.near);
	near = slope[0] <= view.bottom;
	slope[0] = near ? view.bottom : slope[0];
	slope[2] = scalar_min(floor_view_slope_ahead(&view, end),
		scalar_min(floor_view_slope(&view, view.far), view.top));
	slope[2] = scalar_clamp(slope[2], slope[0], view.top);
	slope[1] = scalar_clamp(
		floor_view_slope_ahead(&view, opaque_end), slope[0], slope[2]);
	strips->opaque = slope[1] > slope[0];
	strips->fading = slope[2] > slope[1];
	for (int i = 0; i < 3 && slope[2] > slope[0]; i++) {
		set_row(strips, i, &view, slope[i], y,
			(end - floor_view_ahead(&view, slope[i])) /
				(end - opaque_end));
	}
	/* The row that the edge crosses is covered only in part. */
	if (strips->opaque && near && is_in_reach(&view)) {
		strips->covered_px = count_rows(&view, slope[1], height) - 1 -
			(int)(scalar_clamp(view.error_px, 0.0f, (float)height) +
				safe_px);
		strips->covered_px =
			strips->covered_px > 0 ? strips->covered_px : 0;
	}
	strips->end_px = count_rows(&view, slope[2], height);
	strips->horizon_px =
		count_rows(&view, view.sine / view.cosine, height - 1) + 1;
}
