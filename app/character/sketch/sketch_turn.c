#include "app/character/sketch/sketch_turn.h"

#include "app/anim/math/quat.h"
#include "app/character/sketch/sketch_body.h"
#include "app/character/sketch/sketch_ring.h"
#include "platform/base/arena.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

/* A flat part is at most this thick, as a part of its width. */
static const float flat_part = 0.4f;
/* A disc is at least this wide and a needle at most, as a part of its length. */
static const float disc_part = 0.8f, needle_part = 0.25f;
/* A pivot is in the middle if both sides have at least this part. */
static const float middle_part = 0.3f;
/*
 * A round part has its pivot at least so far from each side. Its corners are at
 * most so far from the axle, in halves of its width: those of a box are farther
 * by the root of 2, those of an octagon as far as its width tells.
 */
static const float round_middle_part = 0.45f, round_reach = 1.1f;
/* A longer round part is no wheel, in widths. */
static const float drum_part = 1.5f;
/* A hinge is at most so far from the edge, as a part of the width. */
static const float edge_part = 0.1f;
/* The hand of a clock has its pivot at most so far from the middle, in radii. */
static const float hand_off = 0.1f;

/* The axes by the length of the box's sides, the shortest first. */
static void sort_axes(const struct bounds *box, int axis[3])
{
	for (int i = 0; i < 3; i++) {
		float side = sketch_side(box, i);
		int shorter = 0;

		for (int k = 0; k < 3; k++) {
			float other = sketch_side(box, k);

			shorter += other < side || (other == side && k < i);
		}
		axis[shorter] = i;
	}
}

/* An axis of a node that is rotated so in the model at rest. */
static struct sketch_turn_axis see(const float rotation[4], int axis)
{
	struct sketch_turn_axis seen = {.axis = axis};
	float along[3] = {0};

	along[axis] = 1;
	quat_rotate(rotation, along, along);
	for (int i = 1; i < 3; i++) {
		if (scalar_abs(along[i]) > scalar_abs(along[seen.seen])) {
			seen.seen = i;
		}
	}
	seen.sign = along[seen.seen] < 0 ? -1 : 1;
	return seen;
}

/* Whether a body is round about an axis, as a wheel of any thickness is. */
static bool is_round(
	const struct sketch_body *body, struct sketch_turn_axis about)
{
	const struct bounds *box = &body->box;
	int a = (about.axis + 1) % 3, b = (about.axis + 2) % 3;
	float width = sketch_side(box, a), other = sketch_side(box, b), reach;

	if (!sketch_is_pivot_within(box, a, round_middle_part) ||
		!sketch_is_pivot_within(box, b, round_middle_part)) {
		return false;
	}
	reach = round_reach * 0.25f * (width + other);
	return body->reach[about.axis] <= reach * reach &&
		sketch_side(box, about.axis) <= drum_part * width &&
		/* What stands on its pivot may nod, as a head does. */
		sketch_is_pivot_within(
			box, about.axis, about.seen == 1 ? middle_part : 0);
}

/* The only axis about which a body is round, or -1: a ball is about all. */
static int axle_of(const struct sketch_body *body, const float rotation[4])
{
	int axle = -1;

	for (int i = 0; i < 3; i++) {
		if (is_round(body, see(rotation, i))) {
			if (axle >= 0) {
				return -1;
			}
			axle = i;
		}
	}
	return axle;
}

/* Judges a body of which no side is empty but the thin one. */
static enum sketch_turn_form judge_box(
	const struct bounds *box, const int axis[3])
{
	float thin = sketch_side(box, axis[0]), wide = sketch_side(box, axis[1]);
	float length = sketch_side(box, axis[2]);
	bool flat = thin <= flat_part * wide;
	bool middle = sketch_is_pivot_within(box, axis[1], middle_part);

	if (wide <= needle_part * length && middle &&
		sketch_is_pivot_within(box, axis[2], 0)) {
		if (flat) {
			return SKETCH_TURN_NEEDLE;
		}
		return sketch_is_pivot_within(box, axis[0], middle_part)
			? SKETCH_TURN_ROD
			: SKETCH_TURN_FREE;
	}
	if (flat && wide >= disc_part * length && middle &&
		sketch_is_pivot_within(box, axis[2], middle_part)) {
		return SKETCH_TURN_DISC;
	}
	return flat ? SKETCH_TURN_HINGE : SKETCH_TURN_FREE;
}

static bool is_at_edge(const struct bounds *box, int axis)
{
	return scalar_abs(scalar_abs(sketch_pivot(box, axis) - 0.5f) - 0.5f) <=
		edge_part;
}

/*
 * Finds the edge on which a flat part turns: of a corner the upright one, as
 * that of a door. Returns false if its pivot is at none, or in a level corner.
 */
static bool find_hinge(const struct bounds *box, const int axis[3],
	const float rotation[4], struct sketch_turn_axis *hinge)
{
	struct sketch_turn_axis first = see(rotation, axis[1]);
	struct sketch_turn_axis second = see(rotation, axis[2]);
	bool along_first = is_at_edge(box, axis[2]);
	bool along_second = is_at_edge(box, axis[1]);

	if (along_first && along_second) {
		along_first = first.seen == 1;
		along_second = second.seen == 1;
	}
	if (along_first == along_second) {
		return false;
	}
	*hinge = along_first ? first : second;
	return true;
}

/* Fills how a rod swings, whose node is rotated so in the model at rest. */
static void find_swings(const struct bounds *box, const float rotation[4],
	struct sketch_turn *turn)
{
	int along = turn->axis.axis;
	struct sketch_turn_axis first = see(rotation, (along + 1) % 3);
	struct sketch_turn_axis second = see(rotation, (along + 2) % 3);
	/* An upright rod leans forward about x, a level one turns about y. */
	bool upright = turn->axis.seen == 1;
	bool exchange = upright ? second.seen == 0 : first.seen == 1;

	turn->across[0] = exchange ? second : first;
	turn->across[1] = exchange ? first : second;
	if (sketch_pivot(box, along) > 0.5f) {
		turn->axis.sign = -turn->axis.sign;
	}
}

static struct sketch_turn judge(
	const struct sketch_body *body, const float rotation[4])
{
	struct sketch_turn turn = {.form = SKETCH_TURN_FREE};
	const struct bounds *box = &body->box;
	int axis[3], axle = axle_of(body, rotation);

	sort_axes(box, axis);
	if (sketch_side(box, axis[1]) > 0) {
		turn.form = judge_box(box, axis);
	}
	turn.axis = see(rotation, 0);
	if (turn.form == SKETCH_TURN_HINGE &&
		!find_hinge(box, axis, rotation, &turn.axis)) {
		turn.form = SKETCH_TURN_FREE;
	}
	if (turn.form == SKETCH_TURN_DISC || turn.form == SKETCH_TURN_NEEDLE) {
		turn.axis = see(rotation, axis[0]);
	} else if (turn.form == SKETCH_TURN_ROD) {
		turn.axis = see(rotation, axis[2]);
		find_swings(box, rotation, &turn);
	} else if (turn.form == SKETCH_TURN_FREE && axle >= 0) {
		turn.form = SKETCH_TURN_DISC;
		turn.axis = see(rotation, axle);
	}
	return turn;
}

/* The side of a disc's box, in the frame of what hangs on it. */
static float side_below(
	const struct model_node *node, const struct sketch_body *disc, int axis)
{
	float side = sketch_side(&disc->box, axis);
	/* The body of a node has the node's scale if it is its own. */
	bool own = node->mesh >= 0 && node->skin < 0;

	return own ? side / scalar_abs(node->rest.scale[axis]) : side;
}

/*
 * Turns a rod into a needle if it lies over a disc, its parent, from its middle
 * and no farther than its edge, as the hand of a clock does.
 */
static void find_hand(const struct model *model, int node,
	const struct sketch_body *body, struct sketch_turn *turn)
{
	const struct model_node *of = &model->node[node];
	const float *at = of->rest.translation;
	struct sketch_turn *rod = &turn[node];
	const struct sketch_turn *disc = &turn[of->parent];
	const struct model_node *face = &model->node[of->parent];
	int along = rod->axis.axis, axis = disc->axis.axis;
	int a = (axis + 1) % 3, b = (axis + 2) % 3;
	float radius = 0.25f *
		(side_below(face, &body[of->parent], a) +
			side_below(face, &body[of->parent], b));
	float low = -body[node].box.low[along];
	float high = body[node].box.high[along];

	if (rod->axis.seen != disc->axis.seen &&
		(low > high ? low : high) <= radius &&
		at[a] * at[a] + at[b] * at[b] <=
			hand_off * hand_off * radius * radius) {
		rod->form = SKETCH_TURN_NEEDLE;
		rod->axis = rod->across[0].seen == disc->axis.seen
			? rod->across[0]
			: rod->across[1];
	}
}

/*
 * Judges each node by its body and the axis of its ring; rotation has room for
 * those of the model.
 */
static void judge_all(const struct model *model, const struct sketch_body *body,
	const int *ring, float (*rotation)[4], struct sketch_turn *turn)
{
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *of = &model->node[i];

		memcpy(rotation[i], of->rest.rotation, sizeof(rotation[i]));
		if (of->parent >= 0) {
			quat_multiply(rotation[of->parent], of->rest.rotation,
				rotation[i]);
		}
		turn[i] = (struct sketch_turn){.axis = see(rotation[i], 0)};
		if (bounds_is_empty(&body[i].box) || of->matrix) {
			continue;
		}
		turn[i] = judge(&body[i], rotation[i]);
		if (ring[i] >= 0 && turn[i].form != SKETCH_TURN_DISC) {
			turn[i].form = SKETCH_TURN_DISC;
			turn[i].axis = see(rotation[i], ring[i]);
		}
		if (turn[i].form == SKETCH_TURN_ROD && of->parent >= 0 &&
			turn[of->parent].form == SKETCH_TURN_DISC) {
			find_hand(model, i, body, turn);
		}
	}
}

int sketch_find_turns(const struct model *model, struct sketch_turn *turn)
{
	struct arena arena = arena_empty();
	size_t count = (size_t)model->node_count;
	struct sketch_body *body =
		ARENA_ARRAY(&arena, struct sketch_body, count);
	int *ring = ARENA_ARRAY(&arena, int, count);
	float(*rotation)[4] = arena_alloc(&arena, count, sizeof(*rotation));
	int error = body && ring && rotation ? 0 : -ENOMEM;

	if (!error) {
		sketch_measure_bodies(model, body);
		error = sketch_find_rings(model, body, ring);
	}
	if (!error) {
		judge_all(model, body, ring, rotation, turn);
	}
	arena_release(&arena);
	return error;
}
