#include "app/scene/instance/bounds_drawable.h"

#include "platform/base/compiler.h"

#include <math.h>
#include <string.h>

/* Signed halves of a word in the order of unsigned ones, and back. */
static uint32_t flip_signs(uint32_t halves)
{
	return halves ^ 0x80008000u;
}

/*
 * Adds the posed vertices, which are the first ones.
 * Finds the 16-bit bounds first, two numbers at a time, and converts only
 * these. The result equals that of converting each vertex, because the
 * conversion is monotonic.
 */
static void add_skinned(struct bounds *bounds, const struct drawable *drawable)
{
	const struct fixed_placement *placement = &drawable->fixed->placement;
	const struct fixed_vector *v = drawable->fixed->position;
	int count = fixed_skin_posed_count(
		&drawable->fixed->skin, drawable->posed_lod);
	uint32_t low[2] = {UINT32_MAX, UINT32_MAX}, high[2] = {0, 0};

	if (count == 0) {
		return;
	}
	for (int i = 0; i < count; i++) {
		for (size_t k = 0; k < 2; k++) {
			uint32_t word;

			memcpy(&word, (const uint8_t *)&v[i] + 4 * k,
				sizeof(word));
			word = flip_signs(word);
			low[k] = least_halves(low[k], word);
			high[k] = most_halves(high[k], word);
		}
	}
	for (int side = 0; side < 2; side++) {
		const uint32_t *flipped = side ? high : low;
		uint32_t word[2] = {
			flip_signs(flipped[0]), flip_signs(flipped[1])};
		struct fixed_vector corner;
		float point[3];

		memcpy(&corner, word, sizeof(corner));
		fixed_placement_apply(placement, &corner, point);
		bounds_add(bounds, point);
	}
}

/* Adds vertices that a skin places: instance_world_vertex() in scene units. */
static void add_placed(struct bounds *bounds, const struct instance *instance,
	const struct drawable *drawable)
{
	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float point[3];

		instance_world_vertex(instance, drawable, v, point);
		for (int axis = 0; axis < 3; axis++) {
			point[axis] *= instance->unit_scale;
		}
		bounds_add(bounds, point);
	}
}

/*
 * Finds the least and the greatest sum of a node's matrix and the vertices, on
 * each axis, without those that are not numbers.
 */
static struct bounds sums_of(const vec4 *world, const struct drawable *drawable)
{
	struct bounds sums = bounds_empty();

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float from[3], sum[3];

		drawable_position(drawable, v, from);
		for (int axis = 0; axis < 3; axis++) {
			sum[axis] = world[0][axis] * from[0] +
				world[1][axis] * from[1] +
				world[2][axis] * from[2];
		}
		if (isnan(sum[0]) || isnan(sum[1]) || isnan(sum[2])) {
			continue;
		}
		for (int axis = 0; axis < 3; axis++) {
			float at = sum[axis];

			sums.low[axis] =
				at < sums.low[axis] ? at : sums.low[axis];
			sums.high[axis] =
				at > sums.high[axis] ? at : sums.high[axis];
		}
	}
	return sums;
}

/*
 * Adds vertices that a node places. What instance_world_vertex() does with the
 * sums of the matrix never exchanges the order of two of them: it divides by a
 * positive number, adds and multiplies. So the box of the sums gives the box of
 * the vertices, to the bit.
 */
static void add_rigid(struct bounds *bounds, const struct instance *instance,
	const struct drawable *drawable)
{
	const vec4 *world = instance->world[drawable->node];
	struct bounds box = sums_of(world, drawable);
	float *side[2] = {box.low, box.high};

	if (bounds_is_empty(&box)) {
		return;
	}
	for (int i = 0; i < 2; i++) {
		for (int axis = 0; axis < 3; axis++) {
			side[i][axis] = (side[i][axis] / drawable->vertex_scale +
						world[3][axis]) *
				instance->unit_scale;
		}
		bounds_add(bounds, side[i]);
	}
}

struct bounds bounds_of_drawable(
	const struct instance *instance, const struct drawable *drawable)
{
	struct bounds bounds = bounds_empty();

	if (drawable->skin < 0) {
		add_rigid(&bounds, instance, drawable);
	} else if (drawable->fixed) {
		add_skinned(&bounds, drawable);
	} else {
		add_placed(&bounds, instance, drawable);
	}
	return bounds;
}
