#include "app/character/state/inertia.h"

#include "app/anim/ease.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"

#include <errno.h>

static const float least_turn_rad = 1e-4f;
static const float least_shift_m = 1e-6f;

int inertia_init(
	struct inertia *inertia, const struct model *model, struct arena *arena)
{
	size_t nodes = (size_t)model->node_count;
	int error = pose_init(&inertia->last, model, arena);

	if (!error) {
		error = pose_init(&inertia->older, model, arena);
	}
	inertia->turn = ARENA_ARRAY(arena, struct inertia_offset, nodes);
	inertia->shift = ARENA_ARRAY(arena, struct inertia_offset, nodes);
	inertia->scale = arena_alloc(arena, nodes, sizeof(*inertia->scale));
	inertia->weight = ARENA_ARRAY(arena, float, (size_t)model->weight_count);
	inertia_reset(inertia);
	return inertia->turn && inertia->shift && inertia->scale &&
			inertia->weight
		? error
		: -ENOMEM;
}

void inertia_reset(struct inertia *inertia)
{
	inertia->shown = 0;
	inertia->running = false;
}

/*
 * Computes the rotation from one rotation to another, with its angle in 0..pi.
 */
static void difference(const float from[4], const float to[4], float out[4])
{
	float back[4];

	quat_conjugate(from, back);
	quat_multiply(to, back, out);
	if (out[3] < 0) {
		for (int i = 0; i < 4; i++) {
			out[i] = -out[i];
		}
	}
}

/*
 * The polynomial that falls from size with the given velocity to 0 at end_s,
 * where velocity and acceleration are 0 too. It must not overshoot, so it may
 * end earlier.
 */
static void shape(struct inertia_offset *offset, float velocity, float end_s)
{
	float x = offset->size, v = velocity < 0 ? velocity : 0;
	float *c = offset->coefficient;
	float t, a;

	if (v < 0 && -5 * x / v < end_s) {
		end_s = -5 * x / v;
	}
	t = end_s;
	a = (-8 * v * t - 20 * x) / (t * t);
	a = a > 0 ? a : 0;
	c[0] = x;
	c[1] = v;
	c[2] = 0.5f * a;
	c[3] = -(3 * a * t * t + 12 * v * t + 20 * x) / (2 * t * t * t);
	c[4] = (3 * a * t * t + 16 * v * t + 30 * x) / (2 * t * t * t * t);
	c[5] = -(a * t * t + 6 * v * t + 12 * x) / (2 * t * t * t * t * t);
	offset->end_s = end_s;
}

/* Returns the angle of a rotation about an axis. */
static float angle_about(const float turn[4], const float axis[3])
{
	return 2 * scalar_atan2(vec_dot(turn, axis), turn[3]);
}

static void begin_turn(struct inertia *inertia, int node,
	const struct pose *fresh, struct inertia_offset *offset)
{
	const float *to = fresh->local[node].rotation;
	float turn[4], older[4];

	difference(to, inertia->last.local[node].rotation, turn);
	for (int i = 0; i < 3; i++) {
		offset->direction[i] = turn[i];
	}
	offset->size =
		2 * scalar_atan2(vec_normalize(offset->direction), turn[3]);
	if (!(offset->size > least_turn_rad)) {
		offset->size = 0;
		return;
	}
	difference(to, inertia->older.local[node].rotation, older);
	shape(offset,
		inertia->shown > 1
			? (offset->size - angle_about(older, offset->direction)) /
				inertia->step_s
			: 0,
		inertia->duration_s);
}

static void begin_shift(struct inertia *inertia, int node,
	const struct pose *fresh, struct inertia_offset *offset)
{
	const float *to = fresh->local[node].translation;
	float older[3];

	vec_subtract(
		inertia->last.local[node].translation, to, offset->direction);
	offset->size = vec_normalize(offset->direction);
	if (!(offset->size > least_shift_m)) {
		offset->size = 0;
		return;
	}
	vec_subtract(inertia->older.local[node].translation, to, older);
	shape(offset,
		inertia->shown > 1
			? (offset->size - vec_dot(older, offset->direction)) /
				inertia->step_s
			: 0,
		inertia->duration_s);
}

void inertia_begin(struct inertia *inertia, const struct pose *fresh,
	float duration_s, enum inertia_curve curve)
{
	const struct pose *last = &inertia->last;

	inertia->running = inertia->shown > 0 && duration_s > 0;
	if (!inertia->running) {
		return;
	}
	inertia->curve = curve;
	inertia->duration_s = duration_s;
	inertia->elapsed_s = 0;
	inertia->scales = false;
	for (int n = 0; n < fresh->node_count; n++) {
		begin_turn(inertia, n, fresh, &inertia->turn[n]);
		begin_shift(inertia, n, fresh, &inertia->shift[n]);
		vec_subtract(last->local[n].scale, fresh->local[n].scale,
			inertia->scale[n]);
		inertia->scales = inertia->scales ||
			vec_dot(inertia->scale[n], inertia->scale[n]) > 0;
	}
	for (int i = 0; i < fresh->weight_count; i++) {
		inertia->weight[i] = last->weight[i] - fresh->weight[i];
	}
}

static float size_at(const struct inertia *inertia,
	const struct inertia_offset *offset, float left)
{
	const float *c = offset->coefficient;
	float t = inertia->elapsed_s;

	if (inertia->curve != INERTIA_SMOOTH) {
		return offset->size * left;
	}
	if (t >= offset->end_s) {
		return 0;
	}
	return ((((c[5] * t + c[4]) * t + c[3]) * t + c[2]) * t + c[1]) * t +
		c[0];
}

static void apply_node(
	const struct inertia *inertia, int node, float left, struct pose *pose)
{
	const struct inertia_offset *turn = &inertia->turn[node];
	const struct inertia_offset *shift = &inertia->shift[node];
	struct transform *local = &pose->local[node];

	if (turn->size > 0) {
		float sine = scalar_sin(0.5f * size_at(inertia, turn, left));
		float rotation[4];

		for (int i = 0; i < 3; i++) {
			rotation[i] = turn->direction[i] * sine;
		}
		/* Half of an angle up to pi has a cosine of at least 0. */
		rotation[3] = scalar_sqrt(1 - sine * sine);
		quat_multiply(rotation, local->rotation, local->rotation);
		pose->animated[node] = true;
	}
	if (shift->size > 0) {
		vec_add_scaled(local->translation, shift->direction,
			size_at(inertia, shift, left), local->translation);
		pose->animated[node] = true;
	}
	if (inertia->scales &&
		vec_dot(inertia->scale[node], inertia->scale[node]) > 0) {
		vec_add_scaled(
			local->scale, inertia->scale[node], left, local->scale);
		pose->animated[node] = true;
	}
}

void inertia_apply(struct inertia *inertia, float step_s, struct pose *pose)
{
	float left;

	if (!inertia->running) {
		return;
	}
	inertia->elapsed_s += step_s;
	if (inertia->elapsed_s >= inertia->duration_s) {
		inertia->running = false;
		return;
	}
	left = 1 -
		ease_at(inertia->curve == INERTIA_LINEAR ? EASE_LINEAR
							 : EASE_CUBIC,
			inertia->elapsed_s / inertia->duration_s);
	for (int n = 0; n < pose->node_count; n++) {
		apply_node(inertia, n, left, pose);
	}
	for (int i = 0; i < pose->weight_count; i++) {
		pose->weight[i] += inertia->weight[i] * left;
	}
}

void inertia_keep(
	struct inertia *inertia, const struct pose *shown, float step_s)
{
	struct pose oldest = inertia->older;

	inertia->older = inertia->last;
	inertia->last = oldest;
	pose_copy(&inertia->last, shown);
	/* A frame without a step has no velocity. */
	inertia->shown = step_s > 0 && inertia->shown > 0 ? 2 : 1;
	inertia->step_s = step_s;
}
