#include "app/anim/procedural/capsule.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "platform/base/scalar.h"

#include <string.h>

void capsule_to_world(const struct capsule *capsule, int count,
	const mat4 *world, struct capsule_world *out)
{
	mat4 *at = (mat4 *)world;

	for (int i = 0; i < count; i++) {
		const struct capsule *c = &capsule[i];

		matrix_apply(at[c->node_a], c->offset_a, out[i].a);
		matrix_apply(at[c->node_b], c->offset_b, out[i].b);
		out[i].radius = c->radius;
	}
}

/* Finds the point of the segment a-b that is nearest to the given point. */
static void nearest(
	const struct capsule_world *capsule, const float point[3], float out[3])
{
	float line[3], offset[3];
	float length2, along;

	vec_subtract(capsule->b, capsule->a, line);
	vec_subtract(point, capsule->a, offset);
	length2 = vec_dot(line, line);
	along = vec_dot(offset, line);
	/* Most points are nearest to an end, where no division is needed. */
	along = !(along > 0) ? 0 : along < length2 ? along / length2 : 1;
	vec_add_scaled(capsule->a, line, along, out);
}

/* Writes a fixed unit direction at right angles to the segment. */
static void any_side(const struct capsule_world *capsule, float out[3])
{
	float line[3];
	float least[3] = {0, 0, 0};

	vec_subtract(capsule->b, capsule->a, line);
	vec_normalize(line);
	least[scalar_abs(line[2]) < 0.9f ? 2 : 0] = 1;
	vec_add_scaled(least, line, -vec_dot(least, line), out);
	vec_normalize(out);
}

bool capsule_push(
	const struct capsule_world *capsule, float margin, float point[3])
{
	float limit = capsule->radius + margin;
	float axis[3], out[3];
	float distance2;

	nearest(capsule, point, axis);
	vec_subtract(point, axis, out);
	distance2 = vec_dot(out, out);
	if (distance2 >= limit * limit) {
		return false;
	}
	if (vec_normalize(out) == 0) {
		any_side(capsule, out);
	}
	vec_add_scaled(axis, out, limit, point);
	return true;
}

bool capsule_push_all(const struct capsule_world *capsule, int count,
	float margin, float point[3])
{
	bool moved = false;

	for (int i = 0; i < count; i++) {
		moved = capsule_push(&capsule[i], margin, point) || moved;
	}
	return moved;
}
