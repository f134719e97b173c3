#include "app/scene/stage/floor_mesh.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "app/scene/draw/triangle_list.h"
#include "app/scene/stage/floor_view.h"
#include "platform/base/scalar.h"

#include <float.h>
#include <string.h>

/*
 * Rows of the picture, as slopes (floor_view.h): of the nearest ground, where
 * ground begins to fade, and where it ends.
 */
struct extent {
	float near, fading, end;
};

/*
 * Takes the point where a row's ray, which has to fall, is this much (rise)
 * above the plane. Returns the row that shows the plane's point right below
 * that point.
 */
static float find_below(const struct floor_view *view, float slope, float rise)
{
	float fall = view->sine - view->cosine * slope;
	float depth = (view->height - rise) / fall;

	return (slope * depth - rise * view->cosine) /
		(depth + rise * view->sine);
}

static bool falls(const struct floor_view *view, float slope)
{
	return view->sine - view->cosine * slope > 1e-3f;
}

/*
 * Returns the row of the nearest point of the plane whose ground, at any height
 * of the waves, can be seen at the picture's lower edge.
 */
static float find_near(const struct floor_view *view, float wave_height)
{
	float nearest = floor_view_slope(view, view->near);
	float low, high;

	/* In these cases waves may be seen anywhere beyond the near plane. */
	if (!falls(view, view->bottom) || view->height < 1.5f * wave_height) {
		return nearest;
	}
	low = find_below(view, view->bottom, -wave_height);
	high = find_below(view, view->bottom, wave_height);
	low = scalar_min(low, high);
	return scalar_max(low, nearest);
}

static float find_top(const struct floor_view *view, float wave_height)
{
	float low, high;

	if (!falls(view, view->top) || view->height < 1.5f * wave_height) {
		return view->top;
	}
	low = find_below(view, view->top, -wave_height);
	high = find_below(view, view->top, wave_height);
	return scalar_max(low, high);
}

static struct extent find_extent(
	const struct floor_view *view, const struct floor_mesh_ground *ground)
{
	struct extent extent = {.near = find_near(view, ground->wave_height)};
	float far = floor_view_slope(view, view->far);
	float top = find_top(view, ground->wave_height);

	extent.end = floor_view_slope_ahead(view, ground->end);
	extent.end = scalar_min(far, extent.end);
	extent.end = scalar_min(top, extent.end);
	extent.fading =
		scalar_clamp(floor_view_slope_ahead(view, ground->opaque_end),
			extent.near, extent.end);
	return extent;
}

static float slope_of_row(const struct extent *extent, int row)
{
	float left = 1.0f - (float)row / FLOOR_OPAQUE_ROWS;
	float fading = (float)(row - FLOOR_OPAQUE_ROWS) / FLOOR_FADING_ROWS;

	return row < FLOOR_OPAQUE_ROWS
		? extent->fading +
			(extent->near - extent->fading) * left *
				scalar_sqrt(left)
		: extent->fading + (extent->end - extent->fading) * fading;
}

static void place_row(struct floor_mesh *mesh, const struct floor_view *view,
	const struct floor_mesh_ground *ground, int row, float slope)
{
	int first = row * (FLOOR_COLUMNS + 1);
	float left = ground->end - floor_view_ahead(view, slope);
	float alpha = scalar_clamp(
		left / (ground->end - ground->opaque_end), 0.0f, 1.0f);
	float depth = floor_view_depth(view, slope);
	/* Ground in a trough is farther away, where the picture is wider. */
	float wider = 1.0f + ground->wave_height * view->sine / depth;

	for (int i = 0; i <= FLOOR_COLUMNS; i++) {
		float across = view->left +
			(view->right - view->left) * (float)i / FLOOR_COLUMNS;

		floor_view_unproject(
			view, slope, across * wider, mesh->position[first + i]);
		mesh->position[first + i][1] = ground->y;
		mesh->alpha[first + i] = (uint8_t)(row <= FLOOR_OPAQUE_ROWS
				? 255.0f
				: alpha * 255.0f + 0.5f);
	}
}

void floor_mesh_find(struct floor_mesh *mesh, const struct camera *camera,
	int width, int height, const struct floor_mesh_ground *ground)
{
	struct floor_view view;
	struct extent extent;

	mesh->seen = false;
	floor_view_init(&view, camera, width, height, ground->y);
	if (view.height <= 0.0f) {
		return;
	}
	extent = find_extent(&view, ground);
	if (!(extent.near < extent.end)) {
		return;
	}
	mesh->seen = true;
	for (int row = 0; row <= FLOOR_ROWS; row++) {
		place_row(mesh, &view, ground, row, slope_of_row(&extent, row));
	}
}

void floor_mesh_list(uint16_t index[FLOOR_INDICES])
{
	uint16_t *next = index;

	for (int row = FLOOR_ROWS - 1; row >= 0; row--) {
		for (int column = 0; column < FLOOR_COLUMNS; column++) {
			uint32_t a =
				(uint32_t)(row * (FLOOR_COLUMNS + 1) + column);
			uint32_t far = a + FLOOR_COLUMNS + 1;

			next = triangle_list_add(next, a + 1, far + 1, far);
			next = triangle_list_add(next, a, a + 1, far);
		}
	}
}

/* The sector, in a plan from above, in which an eye sees a box. */
struct sector {
	const float *eye;
	float ahead[2];  /* x, z; a unit vector towards the box's middle */
	float far;       /* nothing of the box is farther ahead */
	float low, high; /* distance across divided by distance ahead */
};

static void find_plan(
	const struct sector *sector, const float point[3], float out[2])
{
	float x = point[0] - sector->eye[0], z = point[2] - sector->eye[2];

	out[0] = x * sector->ahead[0] + z * sector->ahead[1];
	out[1] = z * sector->ahead[0] - x * sector->ahead[1];
}

/* Returns false if a part of the box is not ahead of the eye. */
static bool find_sector(
	struct sector *sector, const float eye[3], const struct bounds *box)
{
	float middle[3], length;

	bounds_center(box, middle);
	vec_subtract(middle, eye, middle);
	length = scalar_sqrt(middle[0] * middle[0] + middle[2] * middle[2]);
	if (!(length > 0.0f)) {
		return false;
	}
	*sector = (struct sector){.eye = eye,
		.ahead = {middle[0] / length, middle[2] / length},
		.low = FLT_MAX,
		.high = -FLT_MAX};
	for (int i = 0; i < 4; i++) {
		float corner[3] = {i & 1 ? box->high[0] : box->low[0], 0.0f,
			i & 2 ? box->high[2] : box->low[2]};
		float plan[2], across;

		find_plan(sector, corner, plan);
		if (!(plan[0] > 0.01f * length)) {
			return false;
		}
		across = plan[1] / plan[0];
		sector->far = scalar_max(plan[0], sector->far);
		sector->low = scalar_min(across, sector->low);
		sector->high = scalar_max(across, sector->high);
	}
	return true;
}

/*
 * Returns true if a triangle shows its lower side to the eye. The factor
 * normal[1] tells which side is the upper one.
 */
static bool faces_away(const float *const corner[3], const float eye[3])
{
	float ab[3], ac[3], normal[3], to_eye[3];

	vec_subtract(corner[1], corner[0], ab);
	vec_subtract(corner[2], corner[0], ac);
	vec_subtract(eye, corner[0], to_eye);
	vec_cross(ab, ac, normal);
	return !(vec_dot(normal, to_eye) * normal[1] > 0.0f);
}

/* Returns true if all corners are beyond the sector or on one side of it. */
static bool is_outside(const float *const corner[3], const struct sector *sector)
{
	int beyond = 0, left = 0, right = 0;

	for (int i = 0; i < 3; i++) {
		float plan[2];

		find_plan(sector, corner[i], plan);
		beyond += plan[0] > sector->far;
		left += plan[1] < sector->low * plan[0];
		right += plan[1] > sector->high * plan[0];
	}
	return beyond == 3 || left == 3 || right == 3;
}

bool floor_mesh_may_hide(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const float eye[3],
	const struct bounds *box)
{
	struct sector sector;

	if (!mesh->seen || !find_sector(&sector, eye, box)) {
		return true;
	}
	for (int i = 0; i < FLOOR_INDICES; i += 3) {
		const float *const corner[3] = {mesh->position[index[i]],
			mesh->position[index[i + 1]],
			mesh->position[index[i + 2]]};

		if (faces_away(corner, eye) && !is_outside(corner, &sector)) {
			return true;
		}
	}
	return false;
}

/* A rectangle of the picture at depth 1; x to the right, y upwards. */
struct window {
	float low[2], high[2];
};

static const struct window everywhere = {
	{-FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX}};
static const struct window nowhere = {{FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX}};

/*
 * Extends the window to a point in eye space. A point that is not in front of
 * the eye may be anywhere in the picture.
 */
static void add_to_window(struct window *window, const float eye[3])
{
	if (!(eye[2] < 0.0f)) {
		*window = everywhere;
		return;
	}
	for (int axis = 0; axis < 2; axis++) {
		float at = eye[axis] / -eye[2];

		window->low[axis] = scalar_min(at, window->low[axis]);
		window->high[axis] = scalar_max(at, window->high[axis]);
	}
}

/* view is NULL for a box that is in eye space. */
static void add_box(struct window *window, mat4 *view, const struct bounds *box)
{
	for (int i = 0; i < 8 && !bounds_is_empty(box); i++) {
		float corner[3] = {i & 1 ? box->high[0] : box->low[0],
			i & 2 ? box->high[1] : box->low[1],
			i & 4 ? box->high[2] : box->low[2]};

		if (view) {
			matrix_apply(*view, corner, corner);
		}
		add_to_window(window, corner);
	}
}

static struct window find_window(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const struct camera *camera,
	mat4 *view, const struct floor_content *content)
{
	struct window window = nowhere;
	float eye[3];

	if (!content->bounded) {
		return everywhere;
	}
	camera_eye(camera, eye);
	add_box(&window, NULL, &content->standing);
	if (!bounds_is_empty(&content->lying) &&
		floor_mesh_may_hide(mesh, index, eye, &content->lying)) {
		add_box(&window, view, &content->lying);
	}
	return window;
}

/*
 * Returns true if the picture of a cell, which is two triangles between two
 * columns, overlaps the window.
 */
static bool is_cell_in(const uint16_t *cell,
	const float vertex[FLOOR_VERTICES][3], const struct window *window)
{
	struct window own = nowhere;

	/* The first four of its six indices are the cell's four corners. */
	for (int i = 0; i < 4; i++) {
		add_to_window(&own, vertex[cell[i]]);
	}
	return own.low[0] <= window->high[0] && window->low[0] <= own.high[0] &&
		own.low[1] <= window->high[1] && window->low[1] <= own.high[1];
}

/*
 * Adds a cell to the last run if that is drawn in the same way, else to a new
 * one.
 */
static void add_cell(
	struct floor_order *order, const uint16_t *cell, struct floor_run kind)
{
	struct floor_run *last =
		order->run_count > 0 ? &order->run[order->run_count - 1] : NULL;

	if (!last || last->fading != kind.fading ||
		last->with_depth != kind.with_depth) {
		last = &order->run[order->run_count++];
		*last = kind;
	}
	memcpy(order->index + order->index_count, cell, 6 * sizeof(*cell));
	order->index_count += 6;
	last->index_count += 6;
}

/*
 * Cells of one row do not cover each other, so their order is free. Each row
 * begins with the kind of cells with which the row behind it ended, which saves
 * runs.
 */
static void add_row(struct floor_order *order, const uint16_t *cells,
	bool fading, const bool in[FLOOR_COLUMNS])
{
	bool last = order->run_count > 0 &&
		order->run[order->run_count - 1].with_depth;

	for (int i = 0; i < 2 * FLOOR_COLUMNS; i++) {
		bool wanted = i < FLOOR_COLUMNS ? last : !last;
		int column = i % FLOOR_COLUMNS;

		if (in[column] == wanted) {
			add_cell(order, cells + column * 6,
				(struct floor_run){.fading = fading,
					.with_depth = wanted});
		}
	}
}

void floor_mesh_order(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const struct camera *camera,
	const struct floor_content *content, struct floor_order *out)
{
	float vertex[FLOOR_VERTICES][3];
	struct window window;
	mat4 view;

	out->run_count = out->index_count = 0;
	camera_view(camera, view);
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		matrix_apply(view, mesh->position[i], vertex[i]);
	}
	window = find_window(mesh, index, camera, &view, content);
	for (int row = 0; row < FLOOR_ROWS; row++) {
		const uint16_t *cells = index + row * FLOOR_COLUMNS * 6;
		bool in[FLOOR_COLUMNS];

		for (int i = 0; i < FLOOR_COLUMNS; i++) {
			in[i] = is_cell_in(cells + i * 6, vertex, &window);
		}
		add_row(out, cells, row < FLOOR_FADING_ROWS, in);
	}
}
