#include "app/anim/hierarchy.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"

#include <errno.h>
#include <string.h>

static const float AXIS_HEADING[3] = {0, 1, 0};
static const float AXIS_PITCH[3] = {1, 0, 0};
static const float AXIS_BANK[3] = {0, 0, 1};

struct turn {
	float angle_rad;
	const float *axis;
};

struct hierarchy_pivot hierarchy_pivot_default(void)
{
	return (struct hierarchy_pivot){
		.parent = -1,
		.part = -1,
		.scale = {1, 1, 1},
	};
}

/* The pivot's three rotations in its own order, the first one outermost. */
static void order_turns(const struct hierarchy_pivot *pivot, struct turn turn[3])
{
	struct turn heading = {pivot->heading_rad, AXIS_HEADING};
	struct turn pitch = {pivot->pitch_rad, AXIS_PITCH};
	struct turn bank = {pivot->bank_rad, AXIS_BANK};

	switch (pivot->order) {
	case HIERARCHY_HEADING_PITCH_BANK:
		turn[0] = heading;
		turn[1] = pitch;
		turn[2] = bank;
		break;
	case HIERARCHY_PITCH_HEADING_BANK:
		turn[0] = pitch;
		turn[1] = heading;
		turn[2] = bank;
		break;
	case HIERARCHY_PITCH_BANK_HEADING:
		turn[0] = pitch;
		turn[1] = bank;
		turn[2] = heading;
		break;
	}
}

static bool is_scaled(const struct hierarchy_pivot *pivot)
{
	return pivot->scale[0] != 1 || pivot->scale[1] != 1 ||
		pivot->scale[2] != 1;
}

static void transform(const struct hierarchy_pivot *pivot,
	const struct hierarchy_visitor *visitor)
{
	struct turn turn[3] = {{0}};

	visitor->translate(visitor->user, pivot->position);
	order_turns(pivot, turn);
	for (int i = 0; i < 3; i++) {
		if (turn[i].angle_rad != 0) {
			visitor->rotate(
				visitor->user, turn[i].angle_rad, turn[i].axis);
		}
	}
	if (is_scaled(pivot)) {
		visitor->scale(visitor->user, pivot->scale);
	}
}

/* With a few dozen pivots, looking through all for children is cheap. */
static void walk_children(const struct hierarchy *hierarchy,
	const struct hierarchy_visitor *visitor, int parent, int level)
{
	if (level > HIERARCHY_DEPTH) {
		return;
	}
	for (int i = parent + 1; i < hierarchy->pivot_count; i++) {
		const struct hierarchy_pivot *pivot = &hierarchy->pivot[i];

		if (pivot->parent != parent) {
			continue;
		}
		visitor->push(visitor->user);
		transform(pivot, visitor);
		if (pivot->part >= 0) {
			visitor->draw(visitor->user, pivot->part);
		}
		walk_children(hierarchy, visitor, i, level + 1);
		visitor->pop(visitor->user);
	}
}

void hierarchy_walk(const struct hierarchy *hierarchy,
	const struct hierarchy_visitor *visitor)
{
	walk_children(hierarchy, visitor, -1, 1);
}

int hierarchy_check(const struct hierarchy *hierarchy)
{
	for (int i = 0; i < hierarchy->pivot_count; i++) {
		int parent = hierarchy->pivot[i].parent;
		int level = 1;

		if (parent < -1 || parent >= i) {
			return -EINVAL;
		}
		for (; parent >= 0; parent = hierarchy->pivot[parent].parent) {
			level++;
		}
		if (level > HIERARCHY_DEPTH) {
			return -EINVAL;
		}
	}
	return 0;
}

static void pivot_matrix(const struct hierarchy_pivot *pivot, mat4 out)
{
	struct transform local = transform_identity();
	struct turn turn[3] = {{0}};

	memcpy(local.translation, pivot->position, sizeof(pivot->position));
	memcpy(local.scale, pivot->scale, sizeof(pivot->scale));
	order_turns(pivot, turn);
	for (int i = 0; i < 3; i++) {
		float rotation[4];

		quat_from_axis_angle(turn[i].axis, turn[i].angle_rad, rotation);
		quat_multiply(local.rotation, rotation, local.rotation);
	}
	transform_to_matrix(&local, out);
}

void hierarchy_world(const struct hierarchy *hierarchy, mat4 *world)
{
	for (int i = 0; i < hierarchy->pivot_count; i++) {
		const struct hierarchy_pivot *pivot = &hierarchy->pivot[i];

		pivot_matrix(pivot, world[i]);
		if (pivot->parent >= 0) {
			matrix_multiply(
				world[pivot->parent], world[i], world[i]);
		}
	}
}
