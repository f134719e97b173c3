#include "app/character/parts/guard.h"

#include "app/anim/math/matrix.h"
#include "app/character/parts/distance.h"
#include "platform/base/scalar.h"

/* A capsule in the world. */
struct capsule_at {
	float radius, a[3], b[3];
};

static struct capsule_at capsule_of(const struct character *character,
	const struct character_part *part, int guard)
{
	mat4 *world = &character->instance->world[part->node];
	struct capsule_at out = {.radius = part->guard[guard].radius_m};

	matrix_apply(*world, part->guard[guard].from, out.a);
	matrix_apply(*world, part->guard[guard].to, out.b);
	return out;
}

/* Returns true if the part is attached to the node or to the node's parent. */
static bool is_held_by(
	const struct model *model, const struct character_part *part, int node)
{
	return part->holder >= 0 &&
		(part->holder == node ||
			part->holder == model->node[node].parent);
}

/*
 * Parts that share a joint may touch there, and a part may touch its holder and
 * the holder's children, such as fingers.
 */
static bool may_touch(const struct model *model, const struct character_part *a,
	const struct character_part *b)
{
	return model->node[a->node].parent == b->node ||
		model->node[b->node].parent == a->node ||
		is_held_by(model, a, b->node) || is_held_by(model, b, a->node);
}

static float depth_in_ground(
	const struct character *character, const struct capsule_at *one)
{
	float low = scalar_min(one->a[1], one->b[1]);

	return scalar_clamp(character->ground_m + one->radius - low, 0, 1e6f);
}

static float depth_in_part(const struct character *character,
	const struct capsule_at *one, const struct character_part *part)
{
	float depth = 0;

	for (int i = 0; i < part->guard_count; i++) {
		struct capsule_at other = capsule_of(character, part, i);

		depth += scalar_clamp(one->radius + other.radius -
				character_line_distance(
					one->a, one->b, other.a, other.b),
			0, 1e6f);
	}
	return depth;
}

float character_guard_depth(const struct character *character)
{
	const struct model *model = character->instance->model;
	float depth = 0;

	for (int i = 0; i < character->part_count; i++) {
		const struct character_part *part = &character->part[i];

		for (int g = 0; g < part->guard_count; g++) {
			struct capsule_at one = capsule_of(character, part, g);

			depth += depth_in_ground(character, &one);
			for (int j = 0; j < i; j++) {
				const struct character_part *other =
					&character->part[j];

				if (!may_touch(model, part, other)) {
					depth += depth_in_part(
						character, &one, other);
				}
			}
		}
	}
	return depth;
}
