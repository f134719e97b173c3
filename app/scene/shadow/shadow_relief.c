#include "app/scene/shadow/shadow_relief.h"

#include "app/scene/instance/bounds.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <float.h>

enum {
	LAST = SHADOW_RELIEF_NODES - 1
};

/* Marks a node that no triangle covers; below any height. */
static const float none = -FLT_MAX;
/* How far outside a triangle a node counts as inside, in its sides. */
static const float border = 1e-3f;
/*
 * The parts of the way to the eye by which a point moves: enough for rounding
 * of depths, and so little that the figure does not hide its shadow's place.
 */
static const float least_lift = 0.004f, most_lift = 0.25f;

static void get_corner(const struct instance *instance,
	const struct drawable *drawable, uint32_t vertex, float out[3])
{
	instance_world_vertex(instance, drawable, (int)vertex, out);
	for (int axis = 0; axis < 3; axis++) {
		out[axis] *= instance->unit_scale;
	}
}

static struct bounds box_of(
	const struct instance *instance, const int *drawable, int count)
{
	struct bounds box = bounds_empty();

	for (int i = 0; i < count; i++) {
		const struct drawable *of = &instance->drawable[drawable[i]];

		for (int v = 0; v < of->primitive->vertex_count; v++) {
			float at[3];

			get_corner(instance, of, (uint32_t)v, at);
			bounds_add(&box, at);
		}
	}
	return box;
}

/* The first and the last node that may be within low and high. */
static void find_nodes(const struct shadow_relief *relief, int axis, float low,
	float high, int out[2])
{
	float from = (low - relief->low[axis]) / relief->cell[axis];
	float to = (high - relief->low[axis]) / relief->cell[axis];

	out[0] = (int)scalar_clamp(from - 0.01f, 0.0f, (float)LAST);
	out[1] = (int)scalar_clamp(to + 1.01f, 0.0f, (float)LAST);
}

/* Raises the nodes in a triangle, seen from above, to its height. */
static void add_triangle(struct shadow_relief *relief, float corner[3][3])
{
	const float *a = corner[0], *b = corner[1], *c = corner[2];
	float area =
		(b[0] - a[0]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[0] - a[0]);
	struct bounds box = bounds_empty();
	int x[2], z[2];

	for (int i = 0; i < 3; i++) {
		bounds_add(&box, corner[i]);
	}
	if (area == 0.0f) {
		return;
	}
	find_nodes(relief, 0, box.low[0], box.high[0], x);
	find_nodes(relief, 1, box.low[2], box.high[2], z);
	for (int row = z[0]; row <= z[1]; row++) {
		for (int column = x[0]; column <= x[1]; column++) {
			float *height = &relief->height[row][column];
			float dx = relief->low[0] +
				(float)column * relief->cell[0] - a[0];
			float dz = relief->low[1] +
				(float)row * relief->cell[1] - a[2];
			float u = (dx * (c[2] - a[2]) - dz * (c[0] - a[0])) /
				area;
			float v = (dz * (b[0] - a[0]) - dx * (b[2] - a[2])) /
				area;
			float y = a[1] + u * (b[1] - a[1]) + v * (c[1] - a[1]);

			if (u >= -border && v >= -border &&
				u + v <= 1 + border && y > *height) {
				*height = y;
			}
		}
	}
}

static void add_drawable(struct shadow_relief *relief,
	const struct instance *instance, const struct drawable *drawable)
{
	const struct model_primitive *primitive = drawable->primitive;

	for (int k = 0; k + 2 < primitive->index_count; k += 3) {
		float corner[3][3];

		for (int i = 0; i < 3; i++) {
			get_corner(instance, drawable, primitive->index[k + i],
				corner[i]);
		}
		add_triangle(relief, corner);
	}
}

/* Gives a node that no triangle covers the height of one beside it. */
static bool fill_node(struct shadow_relief *relief, int row, int column)
{
	static const int beside[4][2] = {{0, -1}, {-1, 0}, {0, 1}, {1, 0}};

	for (int i = 0; i < 4; i++) {
		int z = row + beside[i][0], x = column + beside[i][1];

		if (z >= 0 && z <= LAST && x >= 0 && x <= LAST &&
			relief->height[z][x] != none) {
			relief->height[row][column] = relief->height[z][x];
			return true;
		}
	}
	return false;
}

static void fill_holes(struct shadow_relief *relief)
{
	bool filled = true;

	while (filled) {
		filled = false;
		for (int i = 0; i < SHADOW_RELIEF_NODES * SHADOW_RELIEF_NODES;
			i++) {
			int row = i / SHADOW_RELIEF_NODES,
			    column = i % SHADOW_RELIEF_NODES;

			if (relief->height[row][column] == none &&
				fill_node(relief, row, column)) {
				filled = true;
			}
		}
	}
}

/* Finds the mean height and the largest error at a vertex. */
static void measure(struct shadow_relief *relief,
	const struct instance *instance, const int *drawable, int count)
{
	float sum = 0.0f;

	for (int row = 0; row <= LAST; row++) {
		for (int column = 0; column <= LAST; column++) {
			sum += relief->height[row][column];
		}
	}
	relief->y = sum / (SHADOW_RELIEF_NODES * SHADOW_RELIEF_NODES);
	for (int i = 0; i < count; i++) {
		const struct drawable *of = &instance->drawable[drawable[i]];

		for (int v = 0; v < of->primitive->vertex_count; v++) {
			float at[3], off;

			get_corner(instance, of, (uint32_t)v, at);
			off = scalar_abs(at[1] -
				shadow_relief_height(relief, at[0], at[2]));
			relief->error = scalar_max(off, relief->error);
		}
	}
}

int shadow_relief_make(struct shadow_relief *relief, struct instance *instance,
	const int *drawable, int count)
{
	struct bounds box = box_of(instance, drawable, count);

	*relief = (struct shadow_relief){.low = {box.low[0], box.low[2]},
		.cell = {(box.high[0] - box.low[0]) / LAST,
			(box.high[2] - box.low[2]) / LAST}};
	if (!(relief->cell[0] > 0.0f && relief->cell[1] > 0.0f)) {
		return 0;
	}
	relief->height = arena_alloc(
		&instance->arena, SHADOW_RELIEF_NODES, sizeof(*relief->height));
	if (!relief->height) {
		return -ENOMEM;
	}
	for (int row = 0; row <= LAST; row++) {
		for (int column = 0; column <= LAST; column++) {
			relief->height[row][column] = none;
		}
	}
	for (int i = 0; i < count; i++) {
		add_drawable(relief, instance, &instance->drawable[drawable[i]]);
	}
	fill_holes(relief);
	measure(relief, instance, drawable, count);
	return 0;
}

float shadow_relief_height(const struct shadow_relief *relief, float x, float z)
{
	float u = scalar_clamp((x - relief->low[0]) / relief->cell[0], 0.0f,
		(float)LAST - 1e-3f);
	float v = scalar_clamp((z - relief->low[1]) / relief->cell[1], 0.0f,
		(float)LAST - 1e-3f);
	int column = (int)u, row = (int)v;
	const float *near = &relief->height[row][column];
	const float *far = &relief->height[row + 1][column];
	float a, b;

	u -= (float)column;
	v -= (float)row;
	a = near[0] + u * (near[1] - near[0]);
	b = far[0] + u * (far[1] - far[0]);
	return a + v * (b - a);
}

void shadow_relief_lift(
	const struct shadow_relief *relief, const float eye[3], float point[3])
{
	float above = eye[1] - point[1];
	float part =
		above > 0.0f ? least_lift + relief->error / above : most_lift;

	part = scalar_min(part, most_lift);
	for (int axis = 0; axis < 3; axis++) {
		point[axis] += part * (eye[axis] - point[axis]);
	}
}
