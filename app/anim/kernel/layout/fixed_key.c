#include "app/anim/kernel/layout/fixed_key.h"

#include "app/anim/kernel/fixed_number.h"
#include "platform/base/scalar.h"

#include <errno.h>

enum {
	KEY_MAX = 16383 /* pairs hold -2 times a number in 16 bits */
};

struct fixed_range fixed_range_empty(void)
{
	return (struct fixed_range){
		{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
}

void fixed_range_add(
	struct fixed_range *range, int count, const float (*position)[3])
{
	for (int i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			float at = position[i][k];

			/* Makes fixed_range_placement() return an error. */
			at = fixed_can_use(at) ? at : -1e30f;
			range->low[k] = at < range->low[k] ? at : range->low[k];
			range->high[k] =
				at > range->high[k] ? at : range->high[k];
		}
	}
}

int fixed_range_placement(
	const struct fixed_range *range, struct fixed_placement *placement)
{
	float half = 1e-12f;

	*placement = (struct fixed_placement){.scale = 1};
	for (int k = 0; k < 3; k++) {
		float side = 0.5f * (range->high[k] - range->low[k]);

		if (range->high[k] < range->low[k]) {
			continue;
		}
		if (!fixed_can_use(range->low[k]) ||
			!fixed_can_use(range->high[k])) {
			return -ERANGE;
		}
		placement->offset[k] = range->low[k] + side;
		half = side > half ? side : half;
	}
	placement->scale = half / KEY_MAX;
	return 0;
}

static int16_t key_round(float value)
{
	return fixed_round(scalar_clamp(value, -KEY_MAX, KEY_MAX));
}

void fixed_key_positions(int count, const float (*position)[3],
	const struct fixed_placement *placement, struct fixed_vector *out)
{
	const float *from = placement->offset;
	float scale = 1.0f / placement->scale;

	for (int i = 0; i < count; i++) {
		out[i].fraction = 0;
		out[i].x = key_round((position[i][0] - from[0]) * scale);
		out[i].y = key_round((position[i][1] - from[1]) * scale);
		out[i].z = key_round((position[i][2] - from[2]) * scale);
	}
}

void fixed_key_normals(
	int count, const float (*normal)[3], struct fixed_vector *out)
{
	static const struct fixed_placement unit = {1.0f / KEY_MAX, {0, 0, 0}};

	fixed_key_positions(count, normal, &unit, out);
}

static struct fixed_pair lerp_pair(int16_t source, int16_t destiny)
{
	return (struct fixed_pair){
		(int16_t)(-2 * source), (int16_t)(-2 * destiny)};
}

void fixed_lerp_prepare(int count, const struct fixed_vector *source,
	const struct fixed_vector *destiny, struct fixed_pair (*pair)[3])
{
	for (int i = 0; i < count; i++) {
		pair[i][0] = lerp_pair(source[i].x, destiny[i].x);
		pair[i][1] = lerp_pair(source[i].y, destiny[i].y);
		pair[i][2] = lerp_pair(source[i].z, destiny[i].z);
	}
}
