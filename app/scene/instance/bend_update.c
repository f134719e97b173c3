/*
 * Bends vertices in each frame (bend.h), in float or in fixed point.
 */
#include "app/scene/instance/bend.h"

#include "app/anim/math/vec.h"
#include "platform/base/scalar.h"

enum {
	/*
	 * A slope is a mean over this many places to either side, which softens
	 * the light at the wave's ends.
	 */
	SMOOTH_STEPS = 14
};

/* A frame's turn and wave; lengths are in local units. */
struct motion {
	bool waves;
	float sine, less; /* of the turn: its sine, and 1 - its cosine */
	float height[BEND_STEPS]; /* of the wave at each place */
	float slope[BEND_STEPS];  /* its change along the axis */
	const struct morph_wave *wave;
};

static void find_motion(struct motion *motion, const struct bend *bend,
	float turn_rad, float omega)
{
	float length = 0.0f;

	motion->wave = &bend->wave;
	motion->waves =
		omega > 0.0f && omega < 1.0f && bend->wave.amplitude != 0.0f;
	motion->sine = scalar_sin(turn_rad);
	motion->less = 1.0f - scalar_cos(turn_rad);
	for (int axis = 0; axis < 3; axis++) {
		length += scalar_abs(bend->wave.axis[axis]) *
			(bend->high[axis] - bend->low[axis]);
	}
	for (int i = 0; motion->waves && i < BEND_STEPS; i++) {
		motion->height[i] = morph_wave_at(
			&bend->wave, omega, (float)i / (BEND_STEPS - 1));
	}
	for (int i = 0; motion->waves && i < BEND_STEPS; i++) {
		int from = i > SMOOTH_STEPS ? i - SMOOTH_STEPS : 0;
		int to = i < BEND_STEPS - 1 - SMOOTH_STEPS ? i + SMOOTH_STEPS
							   : BEND_STEPS - 1;

		motion->slope[i] = length > 0.0f
			? (motion->height[to] - motion->height[from]) *
				(BEND_STEPS - 1) / ((float)(to - from) * length)
			: 0.0f;
	}
}

static void bend_float(const struct motion *motion, const struct bend *bend,
	const struct bend_part *part)
{
	float unit = part->drawable->vertex_scale;
	int count = part->drawable->primitive->vertex_count;
	const float *d = motion->wave->direction, *a = motion->wave->axis;

	for (int i = 0; i < count; i++) {
		const struct bend_vertex *vertex = &part->vertex[i];
		const float *p = part->from_position[i];
		const float *n = part->from_normal[i];
		float turn = (float)vertex->turn_q14 / 16384.0f;
		float sine = motion->sine * turn;
		float less = motion->less * turn * turn;
		float height = 0.0f, tilt = 0.0f;
		float x = p[0] - bend->neck.x * unit;
		float z = p[2] - bend->neck.z * unit;
		float turned[3] = {n[0] + n[2] * sine - n[0] * less, n[1],
			n[2] - n[0] * sine - n[2] * less};

		if (motion->waves && vertex->reach_q14 > 0) {
			float reach = (float)vertex->reach_q14 / 16384.0f;

			height = motion->height[vertex->place] * reach * unit;
			tilt = motion->slope[vertex->place] * reach *
				vec_dot(d, turned);
		}
		part->position[i][0] =
			p[0] + z * sine - x * less + d[0] * height;
		part->position[i][1] = p[1] + d[1] * height;
		part->position[i][2] =
			p[2] - x * sine - z * less + d[2] * height;
		for (int axis = 0; axis < 3; axis++) {
			part->normal[i][axis] = turned[axis] - a[axis] * tilt;
		}
	}
}

/* The same with factors in Q14 and lengths in units of 16-bit positions. */
struct fixed_motion {
	int32_t sine, less;
	int32_t center_x, center_z; /* of the neck */
	int32_t direction[3], axis[3];
	int32_t height[BEND_STEPS], slope[BEND_STEPS];
};

static int32_t q14(float value)
{
	return (int32_t)(scalar_clamp(value, -3.9f, 3.9f) * 16384.0f);
}

static int32_t whole(float value)
{
	return (int32_t)scalar_clamp(value, -60000.0f, 60000.0f);
}

static void find_fixed_motion(struct fixed_motion *fixed,
	const struct motion *motion, const struct bend *bend,
	const struct drawable *drawable)
{
	const struct fixed_placement *placement = &drawable->fixed->placement;
	float unit = drawable->vertex_scale, per_unit = 1.0f / placement->scale;

	fixed->sine = q14(motion->sine);
	fixed->less = q14(motion->less);
	fixed->center_x =
		whole((bend->neck.x * unit - placement->offset[0]) * per_unit);
	fixed->center_z =
		whole((bend->neck.z * unit - placement->offset[2]) * per_unit);
	for (int axis = 0; axis < 3; axis++) {
		fixed->direction[axis] = q14(motion->wave->direction[axis]);
		fixed->axis[axis] = q14(motion->wave->axis[axis]);
	}
	for (int i = 0; motion->waves && i < BEND_STEPS; i++) {
		fixed->height[i] = whole(motion->height[i] * unit * per_unit);
		fixed->slope[i] = q14(motion->slope[i]);
	}
}

static int16_t to_16(int32_t value)
{
	return (int16_t)(value < -32767 ? -32767
			: value > 32767 ? 32767
					: value);
}

/*
 * Turns x and z by the part turn (Q14) of the frame's turn. Sums stay below
 * 2^31, as |x|, |z| < 2^17 and, for turns up to half a radian, |sine| < 2^13.
 */
static void turn_vector(
	const struct fixed_motion *fixed, int32_t turn, int32_t *x, int32_t *z)
{
	int32_t sine = fixed->sine * turn >> 14;
	int32_t less = (fixed->less * turn >> 14) * turn >> 14;
	int32_t old_x = *x;

	*x += (*z * sine - old_x * less) >> 14;
	*z += (-old_x * sine - *z * less) >> 14;
}

static void bend_vertex(const struct fixed_motion *fixed,
	const struct bend_vertex *vertex, bool waves, int32_t p[3], int32_t n[3])
{
	const int32_t *d = fixed->direction, *a = fixed->axis;
	int32_t turn = vertex->turn_q14, height, tilt, facing;

	if (turn > 0) {
		p[0] -= fixed->center_x;
		p[2] -= fixed->center_z;
		turn_vector(fixed, turn, &p[0], &p[2]);
		turn_vector(fixed, turn, &n[0], &n[2]);
		p[0] += fixed->center_x;
		p[2] += fixed->center_z;
	}
	if (!waves || vertex->reach_q14 == 0) {
		return;
	}
	height = fixed->height[vertex->place] * (vertex->reach_q14 >> 1) >> 13;
	facing =
		(d[0] * (n[0] >> 2) + d[1] * (n[1] >> 2) + d[2] * (n[2] >> 2)) >>
		14;
	tilt = fixed->slope[vertex->place] * (vertex->reach_q14 >> 2) >> 12;
	tilt = (tilt >> 2) * (facing >> 2) >> 8;
	for (int axis = 0; axis < 3; axis++) {
		p[axis] += (height >> 2) * (d[axis] >> 2) >> 10;
		n[axis] -= (tilt >> 2) * (a[axis] >> 2) >> 10;
	}
}

static void bend_fixed(const struct motion *motion, const struct bend *bend,
	const struct bend_part *part)
{
	const struct drawable_fixed *from = part->drawable->fixed;
	int count = part->drawable->primitive->vertex_count;
	struct fixed_motion fixed;

	find_fixed_motion(&fixed, motion, bend, part->drawable);
	for (int i = 0; i < count; i++) {
		int32_t p[3] = {from->position[i].x, from->position[i].y,
			from->position[i].z};
		int32_t n[3] = {from->normal[i].x, from->normal[i].y,
			from->normal[i].z};

		bend_vertex(&fixed, &part->vertex[i], motion->waves, p, n);
		part->fixed_position[i] = (struct fixed_vector){
			0, to_16(p[0]), to_16(p[1]), to_16(p[2])};
		part->fixed_normal[i] = (struct fixed_vector){
			0, to_16(n[0]), to_16(n[1]), to_16(n[2])};
	}
}

void bend_update(struct bend *bend, float turn_rad, float omega)
{
	struct motion motion;

	find_motion(&motion, bend, turn_rad, omega);
	for (int p = 0; p < bend->part_count; p++) {
		if (bend->part[p].drawable->fixed) {
			bend_fixed(&motion, bend, &bend->part[p]);
		} else {
			bend_float(&motion, bend, &bend->part[p]);
		}
	}
}
