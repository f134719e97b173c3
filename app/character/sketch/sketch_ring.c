#include "app/character/sketch/sketch_ring.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "platform/base/arena.h"
#include "platform/base/scalar.h"

#include <errno.h>

enum {
	FEWEST = 3,
	MOST = 32
};

/* Exporters round: a quaternion, steps of the ring, parts of a part's size. */
static const float off_axis = 0.01f, off_step = 0.05f, off_place = 0.02f;

/* What hangs on a node. */
struct ring {
	int count; /* of children that show something */
	int first; /* of them */
	int axis;  /* -1 until the second one tells it */
	bool broken;
	uint32_t taken; /* a bit for each step */
};

/* Finds how many children of each node show something. */
static void count_children(const struct model *model,
	const struct sketch_body *body, bool *shows, struct ring *ring)
{
	for (int i = model->node_count - 1; i >= 0; i--) {
		int parent = model->node[i].parent;

		shows[i] = shows[i] || !bounds_is_empty(&body[i].box);
		if (parent >= 0 && shows[i]) {
			shows[parent] = true;
			ring[parent].count++;
			ring[parent].first = i;
		}
	}
}

/* The axis of a rotation that turns about x, y or z; -1 if it does not. */
static int axis_of(const float rotation[4])
{
	int axis = 0;

	for (int i = 1; i < 3; i++) {
		if (scalar_abs(rotation[i]) > scalar_abs(rotation[axis])) {
			axis = i;
		}
	}
	for (int i = 0; i < 3; i++) {
		if (i != axis && scalar_abs(rotation[i]) > off_axis) {
			return -1;
		}
	}
	return axis;
}

/* Whether a rotation takes the place of the first part to that of another. */
static bool takes_to(const float rotation[4], const struct model_node *first,
	const struct model_node *other, const struct sketch_body *body)
{
	float at[3], way[3], size = vec_length(first->rest.translation);

	for (int i = 0; i < 3; i++) {
		size += scalar_sqrt(body->reach[i]);
	}
	quat_rotate(rotation, first->rest.translation, at);
	vec_subtract(other->rest.translation, at, way);
	return vec_length(way) <= off_place * size;
}

/* Which step of count a turn about an axis is; 0 if it is none, or between two. */
static int step_of(const float rotation[4], int axis, int count)
{
	/* The angle is twice that of the quaternion: -count..count steps. */
	float steps = scalar_atan2(rotation[axis], rotation[3]) * (float)count /
		SCALAR_PI;
	float nearest = scalar_floor(steps + 0.5f);

	if (scalar_abs(steps - nearest) > off_step) {
		return 0;
	}
	return ((int)nearest + count) % count;
}

/* Whether a part fits the ring, in which it then takes its step. */
static bool takes_step(const struct model *model,
	const struct sketch_body *body, int node, struct ring *ring)
{
	const struct model_node *first = &model->node[ring->first];
	const struct model_node *other = &model->node[node];
	float turn[4];
	int axis, step;

	if (ring->count > MOST || first->matrix || other->matrix) {
		return false;
	}
	quat_conjugate(first->rest.rotation, turn);
	quat_multiply(other->rest.rotation, turn, turn);
	axis = axis_of(turn);
	if (axis < 0 || (ring->axis >= 0 && axis != ring->axis) ||
		!takes_to(turn, first, other, &body[ring->first])) {
		return false;
	}
	step = step_of(turn, axis, ring->count);
	if (step <= 0 || (ring->taken >> step & 1) != 0) {
		return false;
	}
	ring->axis = axis;
	ring->taken |= 1U << step;
	return true;
}

static void find(const struct model *model, const struct sketch_body *body,
	const bool *shows, struct ring *ring)
{
	for (int i = 0; i < model->node_count; i++) {
		int parent = model->node[i].parent;
		struct ring *of = parent < 0 ? NULL : &ring[parent];

		if (of && shows[i] && i != of->first && !of->broken) {
			of->broken = !takes_step(model, body, i, of);
		}
	}
}

int sketch_find_rings(
	const struct model *model, const struct sketch_body *body, int *axis)
{
	struct arena arena = arena_empty();
	size_t count = (size_t)model->node_count;
	bool *shows = ARENA_ARRAY(&arena, bool, count);
	struct ring *ring = ARENA_ARRAY(&arena, struct ring, count);
	int error = shows && ring ? 0 : -ENOMEM;

	for (int i = 0; i < model->node_count && !error; i++) {
		ring[i].axis = -1;
	}
	if (!error) {
		count_children(model, body, shows, ring);
		find(model, body, shows, ring);
	}
	for (int i = 0; i < model->node_count && !error; i++) {
		bool whole = ring[i].count >= FEWEST && !ring[i].broken;

		axis[i] = whole ? ring[i].axis : -1;
	}
	arena_release(&arena);
	return error;
}
