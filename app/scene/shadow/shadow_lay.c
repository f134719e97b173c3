#include "app/scene/shadow/shadow_lay.h"

#include "app/anim/math/vec.h"
#include "platform/base/scalar.h"

#include <float.h>

/* Nodes on a tile's side: between them the waves bend by 0.8% of their height. */
static const float nodes_a_tile = 6.0f;
/* Finding a node takes about as long as interpolating three points. */
static const int points_a_node = 2;

/* The height of level ground, which the uneven ground is near. */
static float level_of(const struct shadow_light *light)
{
	return light->relief ? light->relief->y : light->ground->y;
}

static float height_at(const struct shadow_light *light, float x, float z)
{
	return light->relief ? shadow_relief_height(light->relief, x, z)
			     : floor_height(light->ground, x, z);
}

/* How far apart the nodes of the grid are. */
static float node_length(const struct shadow_light *light)
{
	const struct shadow_relief *relief = light->relief;

	if (!relief) {
		return light->ground->tile / nodes_a_tile;
	}
	return scalar_min(relief->cell[0], relief->cell[1]);
}

/*
 * Returns the distance from a point to the ground along the light. It starts at
 * level ground and makes one step of the secant method, which leaves an error
 * below floor_mesh_error().
 */
static float distance_to_ground(
	const struct shadow_light *light, const float from[3])
{
	const float *towards = light->towards;
	float per_height = 1.0f / towards[1];
	float guess[2] = {(from[1] - level_of(light)) * per_height, 0.0f};
	float height[2], slope;

	for (int i = 0; i < 2; i++) {
		height[i] = height_at(light, from[0] - towards[0] * guess[i],
			from[2] - towards[2] * guess[i]);
		if (i == 0) {
			guess[1] = (from[1] - height[0]) * per_height;
		}
	}
	if (height[1] == height[0]) {
		return guess[1];
	}
	slope = (height[1] - height[0]) / (guess[1] - guess[0]);
	return guess[1] -
		(height[1] - height[0]) /
		scalar_clamp(towards[1] + slope, 0.5f * towards[1], 2.0f);
}

static void lay_point(const struct shadow_light *light, const float from[3],
	float to[3], struct bounds *box)
{
	vec_add_scaled(
		from, light->towards, -distance_to_ground(light, from), to);
	if (light->relief) {
		shadow_relief_lift(light->relief, light->eye, to);
	} else {
		floor_lift(light->ground, light->eye, to);
	}
	bounds_add(box, to);
}

/*
 * The grid over the part of level ground that the light through the points
 * would meet. length is the distance of neighbouring nodes, per_length its
 * inverse.
 */
struct area {
	float low[2], per_length, length;
	int count[2]; /* nodes along x and z */
};

/* Where the light through a point would meet level ground: x, z. */
static void find_level(
	const struct shadow_light *light, const float from[3], float out[2])
{
	float fall = (from[1] - level_of(light)) / light->towards[1];

	out[0] = from[0] - light->towards[0] * fall;
	out[1] = from[2] - light->towards[2] * fall;
}

/*
 * Returns false if no grid is worth while or possible: for few points, a large
 * area, or coordinates that are not finite.
 */
static bool find_area(const struct shadow_light *light, const float (*from)[3],
	int count, struct area *area)
{
	float high[2] = {-FLT_MAX, -FLT_MAX}, nodes = 1.0f;
	bool finite = true;

	*area = (struct area){.low = {FLT_MAX, FLT_MAX},
		.per_length = 1.0f / node_length(light),
		.length = node_length(light)};
	for (int i = 0; i < count; i++) {
		float at[2];

		find_level(light, from[i], at);
		for (int axis = 0; axis < 2; axis++) {
			finite = finite && scalar_abs(at[axis]) < BOUNDS_MAX;
			area->low[axis] = scalar_min(at[axis], area->low[axis]);
			high[axis] = scalar_max(at[axis], high[axis]);
		}
	}
	for (int axis = 0; finite && axis < 2; axis++) {
		float steps = (high[axis] - area->low[axis]) * area->per_length;

		if (!(steps >= 0.0f && steps < SHADOW_NODES_MAX)) {
			return false;
		}
		/* The last point is before the last node, or at it. */
		area->count[axis] = (int)steps + 2;
		nodes *= (float)area->count[axis];
	}
	return finite && nodes <= SHADOW_NODES_MAX &&
		nodes * (float)points_a_node <= (float)count;
}

static void find_nodes(struct shadow_grid *grid, const struct area *area,
	const struct shadow_light *light, struct bounds *box)
{
	grid->node_count = area->count[0] * area->count[1];
	for (int i = 0; i < grid->node_count; i++) {
		int column = i % area->count[0], row = i / area->count[0];
		const float from[3] = {
			area->low[0] + (float)column * area->length,
			level_of(light),
			area->low[1] + (float)row * area->length};

		lay_point(light, from, grid->node[i], box);
	}
}

/* Interpolates between the four nodes around a point. */
static void interpolate(const struct shadow_grid *grid, const struct area *area,
	const float level[2], float out[3])
{
	float x = (level[0] - area->low[0]) * area->per_length;
	float z = (level[1] - area->low[1]) * area->per_length;
	int column = (int)x, row = (int)z;
	const float(*near)[3] =
		(const float(*)[3])grid->node + row * area->count[0] + column;
	const float(*far)[3] = near + area->count[0];

	x -= (float)column;
	z -= (float)row;
	for (int axis = 0; axis < 3; axis++) {
		float a = near[0][axis] + x * (near[1][axis] - near[0][axis]);
		float b = far[0][axis] + x * (far[1][axis] - far[0][axis]);

		out[axis] = a + z * (b - a);
	}
}

void shadow_lay(struct shadow_grid *grid, const struct shadow_light *light,
	const float (*from)[3], int count, float (*to)[3], struct bounds *box)
{
	struct area area;

	grid->node_count = 0;
	if (!find_area(light, from, count, &area)) {
		for (int i = 0; i < count; i++) {
			lay_point(light, from[i], to[i], box);
		}
		return;
	}
	find_nodes(grid, &area, light, box);
	for (int i = 0; i < count; i++) {
		float level[2];

		find_level(light, from[i], level);
		interpolate(grid, &area, level, to[i]);
	}
}
