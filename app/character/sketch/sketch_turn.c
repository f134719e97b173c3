#include "app/character/sketch/sketch_turn.h"

#include "app/anim/math/quat.h"
#include "app/scene/instance/bounds.h"
#include "platform/base/arena.h"

#include <errno.h>
#include <string.h>

/* A flat part is at most this thick, as a part of its width. */
static const float flat_part = 0.4f;
/* A disc is at least this wide and a needle at most, as a part of its length. */
static const float disc_part = 0.8f, needle_part = 0.25f;
/* A pivot is in the middle if both sides have at least this part. */
static const float middle_part = 0.3f;

/* Adds a node's mesh, in the frame of its parent or, if own, in its own. */
static void add_mesh(
	const struct model *model, int node, bool own, struct bounds *box)
{
	const struct model_node *of = &model->node[node];
	const struct model_mesh *mesh = &model->mesh[of->mesh];

	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *one = &mesh->primitive[p];

		for (int v = 0; v < one->vertex_count; v++) {
			float at[3];

			for (int i = 0; i < 3; i++) {
				at[i] = one->position[v][i] * of->rest.scale[i];
			}
			if (!own) {
				quat_rotate(of->rest.rotation, at, at);
				for (int i = 0; i < 3; i++) {
					at[i] += of->rest.translation[i];
				}
			}
			bounds_add(box, at);
		}
	}
}

static bool is_rigid(const struct model_node *node)
{
	return node->mesh >= 0 && node->skin < 0;
}

/* Adds what a node shows to its own box, or to that of the pivot above it. */
static void add_node(const struct model *model, int node, struct bounds *box)
{
	const struct model_node *of = &model->node[node];
	int parent = of->parent;

	if (!is_rigid(of)) {
		return;
	}
	add_mesh(model, node, true, &box[node]);
	if (parent >= 0 && !is_rigid(&model->node[parent]) && !of->matrix) {
		add_mesh(model, node, false, &box[parent]);
	}
}

/* Where the pivot is along an axis: 0 at the lower side, 1 at the upper one. */
static float pivot_at(const struct bounds *box, int axis)
{
	return -box->low[axis] / (box->high[axis] - box->low[axis]);
}

static bool is_in_middle(const struct bounds *box, int axis)
{
	float at = pivot_at(box, axis);

	return at >= middle_part && at <= 1 - middle_part;
}

static struct sketch_turn judge(const struct bounds *box)
{
	struct sketch_turn turn = {.form = SKETCH_TURN_FREE, .sign = 1};
	int thin = 0, wide, length;
	float side[3];

	for (int i = 0; i < 3; i++) {
		side[i] = box->high[i] - box->low[i];
		thin = side[i] < side[thin] ? i : thin;
	}
	wide = (thin + 1) % 3;
	length = (thin + 2) % 3;
	if (side[wide] > side[length]) {
		wide = length;
		length = (thin + 1) % 3;
	}
	if (side[wide] <= 0 || side[thin] > flat_part * side[wide] ||
		!is_in_middle(box, wide)) {
		return turn;
	}
	if (side[wide] <= needle_part * side[length] &&
		pivot_at(box, length) >= 0 && pivot_at(box, length) <= 1) {
		turn.form = SKETCH_TURN_NEEDLE;
	} else if (side[wide] >= disc_part * side[length] &&
		is_in_middle(box, length)) {
		turn.form = SKETCH_TURN_DISC;
	}
	turn.axis = turn.form == SKETCH_TURN_FREE ? 0 : thin;
	return turn;
}

/* Finds how the axis lies in the model at rest, whose node is rotated so. */
static void find_seen(const float rotation[4], struct sketch_turn *turn)
{
	float axis[3] = {0}, length[3];

	axis[turn->axis] = 1;
	quat_rotate(rotation, axis, axis);
	for (int i = 0; i < 3; i++) {
		length[i] = axis[i] < 0 ? -axis[i] : axis[i];
		turn->seen = length[i] > length[turn->seen] ? i : turn->seen;
	}
	turn->sign = axis[turn->seen] < 0 ? -1 : 1;
}

/* Judges each node by its box; rotation has room for those of the model. */
static void judge_all(const struct model *model, const struct bounds *box,
	float (*rotation)[4], struct sketch_turn *turn)
{
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *of = &model->node[i];

		memcpy(rotation[i], of->rest.rotation, sizeof(rotation[i]));
		if (of->parent >= 0) {
			quat_multiply(rotation[of->parent], of->rest.rotation,
				rotation[i]);
		}
		turn[i] = (struct sketch_turn){.sign = 1};
		if (!bounds_is_empty(&box[i]) && !of->matrix) {
			turn[i] = judge(&box[i]);
			find_seen(rotation[i], &turn[i]);
		}
	}
}

int sketch_find_turns(const struct model *model, struct sketch_turn *turn)
{
	struct arena arena = arena_empty();
	size_t count = (size_t)model->node_count;
	struct bounds *box = ARENA_ARRAY(&arena, struct bounds, count);
	float(*rotation)[4] = arena_alloc(&arena, count, sizeof(*rotation));
	int error = box && rotation ? 0 : -ENOMEM;

	for (int i = 0; i < model->node_count && !error; i++) {
		box[i] = bounds_empty();
		add_node(model, i, box);
	}
	if (!error) {
		judge_all(model, box, rotation, turn);
	}
	arena_release(&arena);
	return error;
}
