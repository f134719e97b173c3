#include "app/anim/procedural/cloth.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/substep.h"
#include "platform/base/scalar.h"

#include <string.h>

static const float GIVE = 1.02f; /* limit of a column's length, times its rest
				    length */

void cloth_reset(struct cloth *cloth)
{
	cloth->begun = false;
}

/* Puts all particles into the rest shape, at the nodes. */
static void begin_at_rest(struct cloth *cloth, const mat4 *world)
{
	int columns = cloth->settings.columns;

	for (int i = 0; i < cloth->count; i++) {
		matrix_apply(((mat4 *)world)[cloth->pin[i % columns]],
			cloth->offset[i], cloth->position[i]);
		memset(cloth->velocity[i], 0, sizeof(cloth->velocity[i]));
	}
	memcpy(cloth->pin_from, cloth->position,
		(size_t)columns * sizeof(*cloth->pin_from));
	cloth->begun = true;
}

static void find_pins(struct cloth *cloth, const mat4 *world)
{
	for (int c = 0; c < cloth->settings.columns; c++) {
		matrix_apply(((mat4 *)world)[cloth->pin[c]], cloth->offset[c],
			cloth->pin_to[c]);
	}
}

static bool jumped(const struct cloth *cloth)
{
	float limit = 4 * cloth->hang[cloth->count - 1];
	float offset[3];

	vec_subtract(cloth->pin_to[0], cloth->pin_from[0], offset);
	return !(vec_length(offset) <= limit);
}

/*
 * Accelerates a particle along its normal by the wind relative to it. fraction,
 * 0..0.5, is the part of the difference that it takes over.
 */
static void blow(struct cloth *cloth, int i, float fraction)
{
	const float *normal = cloth->normal[i];
	float past[3];

	vec_subtract(cloth->settings.wind, cloth->velocity[i], past);
	vec_add_scaled(cloth->velocity[i], normal,
		fraction * vec_dot(past, normal), cloth->velocity[i]);
}

static void fall(struct cloth *cloth, float part_s)
{
	const struct cloth_settings *settings = &cloth->settings;
	float air = scalar_clamp(settings->air * part_s, 0, 0.5f);
	float kept = 1 / (1 + part_s * settings->damping);

	for (int i = settings->columns; i < cloth->count; i++) {
		float *velocity = cloth->velocity[i];

		memcpy(cloth->before[i], cloth->position[i],
			sizeof(cloth->before[i]));
		blow(cloth, i, air);
		for (int k = 0; k < 3; k++) {
			velocity[k] =
				(velocity[k] + part_s * settings->gravity[k]) *
				kept;
			cloth->position[i][k] += part_s * velocity[k];
		}
	}
}

/* Moves the ends of a link towards its length. Pinned particles do not move. */
static void hold_link(struct cloth *cloth, const struct cloth_link *link)
{
	float *a = cloth->position[link->a];
	float *b = cloth->position[link->b];
	bool pinned_a = link->a < cloth->settings.columns;
	bool pinned_b = link->b < cloth->settings.columns;
	float offset[3];
	float length, excess;

	if (pinned_a && pinned_b) {
		return;
	}
	vec_subtract(b, a, offset);
	length = vec_length(offset);
	if (!(length > 1e-9f)) {
		return;
	}
	excess = link->stiffness * (length - link->length) / length;
	if (pinned_a || pinned_b) {
		vec_add_scaled(pinned_a ? b : a, offset,
			pinned_a ? -excess : excess, pinned_a ? b : a);
		return;
	}
	vec_add_scaled(a, offset, 0.5f * excess, a);
	vec_add_scaled(b, offset, -0.5f * excess, b);
}

/* Keeps a particle no farther from its column's pin than the column is long. */
static void hold_reach(struct cloth *cloth, int i, int column)
{
	const float *pin = cloth->position[column];
	float limit = cloth->hang[i] * GIVE;
	float offset[3];
	float length;

	vec_subtract(cloth->position[i], pin, offset);
	length = vec_length(offset);
	if (length > limit) {
		vec_add_scaled(pin, offset, limit / length, cloth->position[i]);
	}
}

static void hold_together(struct cloth *cloth,
	const struct capsule_world *capsule, int capsule_count)
{
	for (int p = 0; p < cloth->settings.passes; p++) {
		for (int l = 0; l < cloth->link_count; l++) {
			hold_link(cloth, &cloth->link[l]);
		}
	}
	for (int i = cloth->settings.columns, c = 0; i < cloth->count; i++) {
		hold_reach(cloth, i, c);
		if (capsule_push_all(capsule, capsule_count,
			    cloth->settings.radius, cloth->position[i])) {
			hold_reach(cloth, i, c);
		}
		c = c + 1 < cloth->settings.columns ? c + 1 : 0;
	}
}

/*
 * Computes velocities from the distances covered in this part of the step, and
 * limits them.
 */
static void find_speed(struct cloth *cloth, float part_s)
{
	float fastest = cloth->settings.fastest;

	for (int i = cloth->settings.columns; i < cloth->count; i++) {
		float *velocity = cloth->velocity[i];
		float speed;

		vec_subtract(cloth->position[i], cloth->before[i], velocity);
		for (int k = 0; k < 3; k++) {
			velocity[k] /= part_s;
		}
		speed = vec_length(velocity);
		if (!(speed <= fastest)) {
			float scale = speed > 0 ? fastest / speed : 0;

			for (int k = 0; k < 3; k++) {
				velocity[k] *= scale;
			}
		}
	}
}

static void move_pins(struct cloth *cloth, float fraction)
{
	for (int c = 0; c < cloth->settings.columns; c++) {
		vec_mix(cloth->pin_from[c], cloth->pin_to[c], fraction,
			cloth->position[c]);
	}
}

/*
 * Computes normals from the neighbours. At an edge, the particle itself stands
 * for the missing neighbour.
 */
static void find_normals(struct cloth *cloth)
{
	int columns = cloth->settings.columns;
	int rows = cloth->settings.rows;

	for (int r = 0; r < rows; r++) {
		for (int c = 0; c < columns; c++) {
			int i = r * columns + c;
			int left = c > 0 ? i - 1 : i;
			int right = c + 1 < columns ? i + 1 : i;
			int above = r > 0 ? i - columns : i;
			int below = r + 1 < rows ? i + columns : i;
			float across[3], down[3], normal[3];

			vec_subtract(cloth->position[right],
				cloth->position[left], across);
			vec_subtract(cloth->position[below],
				cloth->position[above], down);
			vec_cross(down, across, normal);
			if (vec_normalize(normal) > 0) {
				memcpy(cloth->normal[i], normal, sizeof(normal));
			}
		}
	}
}

void cloth_update(struct cloth *cloth, float step_s,
	const struct capsule_world *capsule, int capsule_count,
	const mat4 *world)
{
	const struct substep substep = substep_divide(step_s);

	find_pins(cloth, world);
	if (!cloth->begun || jumped(cloth)) {
		begin_at_rest(cloth, world);
		find_normals(cloth);
	}
	for (int p = 1; p <= substep.count; p++) {
		fall(cloth, substep.part_s);
		move_pins(cloth, (float)p / (float)substep.count);
		hold_together(cloth, capsule, capsule_count);
		find_speed(cloth, substep.part_s);
	}
	memcpy(cloth->pin_from, cloth->pin_to,
		(size_t)cloth->settings.columns * sizeof(*cloth->pin_from));
	find_normals(cloth);
}
