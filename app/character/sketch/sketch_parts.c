#include "app/character/sketch/sketch_parts.h"

#include "app/character/sketch/sketch_joints.h"
#include "app/character/sketch/sketch_names.h"
#include "app/scene/hud/hud_name.h"
#include "platform/base/arena.h"
#include "platform/base/compiler.h"

#include <errno.h>
#include <string.h>

static bool is_rigid(const struct model *model, int node)
{
	return model->node[node].mesh >= 0 && model->node[node].skin < 0;
}

/* Arrays have an element for each node. */
struct search {
	const struct model *model;
	const bool *is_joint, *is_named;
	int *meshes; /* rigid meshes of the node and of all below it */
	int *shown;  /* children that are rigid meshes */
	struct sketch_turn *turn;
	int count; /* of rigid meshes */
};

static int init(
	struct search *search, const struct model *model, struct arena *arena)
{
	search->meshes = ARENA_ARRAY(arena, int, (size_t)model->node_count);
	search->shown = ARENA_ARRAY(arena, int, (size_t)model->node_count);
	search->turn = ARENA_ARRAY(
		arena, struct sketch_turn, (size_t)model->node_count);
	if (!search->meshes || !search->shown || !search->turn ||
		sketch_find_turns(model, search->turn) != 0) {
		return -ENOMEM;
	}
	for (int i = model->node_count - 1; i >= 0; i--) {
		int parent = model->node[i].parent, one = is_rigid(model, i);

		search->meshes[i] += one;
		search->count += one;
		if (parent >= 0) {
			search->meshes[parent] += search->meshes[i];
			search->shown[parent] += one;
		}
	}
	return 0;
}

static bool can_be_named(const struct search *search, int node)
{
	return search->is_named[node] &&
		sketch_fits_heading(search->model->node[node].name);
}

/*
 * Whether a node without a mesh turns some of the meshes, which hang on it: in
 * many models a part's node holds its pivot, and a child its mesh.
 */
static bool is_pivot(const struct search *search, int node)
{
	const struct model_node *of = &search->model->node[node];

	return of->mesh < 0 && !of->matrix && !search->is_joint[node] &&
		search->shown[node] > 0 &&
		search->meshes[node] < search->count &&
		can_be_named(search, node);
}

/* Whether a mesh is nothing but the form of the pivot above it. */
static bool is_form(const struct search *search, int node)
{
	static const float none[3];
	const struct model_node *of = &search->model->node[node];

	return of->parent >= 0 && is_pivot(search, of->parent) &&
		search->meshes[node] == 1 &&
		(search->shown[of->parent] == 1 ||
			memcmp(of->rest.translation, none, sizeof(none)) == 0);
}

static bool is_part(const struct search *search, int node)
{
	return is_pivot(search, node) ||
		(is_rigid(search->model, node) && !search->is_joint[node] &&
			can_be_named(search, node) && !is_form(search, node));
}

/* Whether other parts hang on a part. */
static bool carries_parts(const struct search *search, int node)
{
	int own = is_rigid(search->model, node) ? 1 : search->shown[node];

	return search->meshes[node] > own;
}

/* Whether a needle or a disc carries no other part. */
static bool is_flat_end(const struct search *search, int node)
{
	enum sketch_turn_form form = search->turn[node].form;

	return !carries_parts(search, node) &&
		(form == SKETCH_TURN_DISC || form == SKETCH_TURN_NEEDLE);
}

static bool is_needle(const struct search *search, int node)
{
	return search->turn[node].form == SKETCH_TURN_NEEDLE &&
		!carries_parts(search, node);
}

/* A rod or a board on which parts hang turns as freely as any other part. */
static struct sketch_turn turn_of(const struct search *search, int node)
{
	struct sketch_turn turn = search->turn[node];

	if ((turn.form == SKETCH_TURN_ROD || turn.form == SKETCH_TURN_HINGE) &&
		carries_parts(search, node)) {
		turn.form = SKETCH_TURN_FREE;
	}
	return turn;
}

/* A part is called as its node is. */
static void find(
	const struct search *search, bool needles, struct sketch_parts *out)
{
	for (int i = 0;
		i < search->model->node_count && out->count < SKETCH_PARTS; i++) {
		if (is_part(search, i) && is_needle(search, i) == needles) {
			out->turn[out->count] = turn_of(search, i);
			out->node[out->count++] = i;
		}
	}
}

/* Joints take the place of parts, if there are some. Returns 0 or -ENOMEM. */
static int find_joints(const struct search *search, struct arena *arena,
	struct sketch_parts *out)
{
	const struct model *model = search->model;
	bool *may_be_part = ARENA_ARRAY(arena, bool, (size_t)model->node_count);
	struct sketch_parts joints = {.bones = true, .moved = true};
	int error = may_be_part ? 0 : -ENOMEM;
	bool any = false;

	for (int i = 0; i < model->node_count && !error; i++) {
		may_be_part[i] = search->is_joint[i] && can_be_named(search, i);
		any = any || may_be_part[i];
	}
	if (any) {
		error = sketch_find_joints(model, may_be_part, SKETCH_PARTS,
			joints.node, &joints.count);
	}
	*out = joints.count > 0 ? joints : *out;
	return error;
}

/* Returns true if a part has another one above it. */
static bool hangs(const struct search *search, int node)
{
	int above = search->model->node[node].parent;

	while (above >= 0 && !is_rigid(search->model, above) &&
		!is_pivot(search, above)) {
		above = search->model->node[above].parent;
	}
	return above >= 0;
}

/* Whether users expect to move the part, rather than the camera around it. */
static bool is_to_move(const struct search *search, int node, int count)
{
	return hangs(search, node) || (count > 1 && is_flat_end(search, node));
}

int sketch_find_parts(const struct model *model, const bool *is_joint,
	const bool *is_named, bool still, struct sketch_parts *out)
{
	struct arena arena = arena_empty();
	struct search search = {
		.model = model, .is_joint = is_joint, .is_named = is_named};
	int error = init(&search, model, &arena);

	*out = (struct sketch_parts){.count = 0};
	if (!error) {
		find(&search, true, out);
		find(&search, false, out);
	}
	for (int i = 0; i < out->count && still; i++) {
		out->moved = out->moved ||
			is_to_move(&search, out->node[i], out->count);
	}
	if (!error && still && !out->moved) {
		error = find_joints(&search, &arena, out);
	}
	arena_release(&arena);
	return error;
}

/* What turns a part about x, y and z. */
static const char *const freedom[] = {"pitch", "heading", "bank"};

static void write_freedoms(
	const struct sketch_turn *turn, const char *mark, FILE *out)
{
	/* Of x and y; of a rod, those across it. */
	int up = 0, left = 1;

	if (turn->form == SKETCH_TURN_DISC || turn->form == SKETCH_TURN_NEEDLE) {
		fprintf(out, "%s%s = 0 ; in its plane, without limits\n\n",
			mark, freedom[turn->axis.axis]);
		return;
	}
	if (turn->form == SKETCH_TURN_HINGE) {
		fprintf(out, "%s%s = 0 -110 110 60 ; on its hinge\n\n", mark,
			freedom[turn->axis.axis]);
		return;
	}
	if (turn->form == SKETCH_TURN_ROD) {
		up = turn->across[0].axis;
		left = turn->across[1].axis;
	}
	fprintf(out, "%s%s = 0 -90 90 45\n%s%s = 0 -45 45 45\n\n", mark,
		freedom[left], mark, freedom[up]);
}

void sketch_write_parts(
	const struct model *model, const struct sketch_parts *parts, FILE *out)
{
	const char *mark = parts->moved ? "" : ";";

	if (parts->count > 0) {
		fprintf(out, "; %s: start, lowest, highest, degrees a second.\n",
			parts->bones ? "Bones turn on their joints"
				     : "Rigid parts turn on their pivots");
	}
	for (int i = 0; i < parts->count; i++) {
		fprintf(out, "%s[part ", mark);
		sketch_write_name(out, model->node[parts->node[i]].name);
		fputs("]\n", out);
		write_freedoms(&parts->turn[i], mark, out);
	}
}

/* What a button does with a part: how it turns about which axis. */
struct move {
	const char *button;
	int axis;
	const char *how;
	int factor;
};

static void write_move(const struct model *model,
	const struct sketch_parts *parts, int part, const struct move *move,
	FILE *out)
{
	const char *name = model->node[parts->node[part]].name;
	char number[HUD_NAME_BYTES];

	fprintf(out, "%s = move ", move->button);
	sketch_write_name(out, name);
	/* The labels are for the screen. */
	fprintf(out, " %s %d \"turn %s %s\"\n", freedom[move->axis],
		move->factor, hud_name(name, "part", part + 1, number),
		move->how);
}

static void write_free(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out)
{
	static const struct move moves[] = {
		{"UP", 0, "back", -1},
		{"DOWN", 0, "forward", 1},
		{"LEFT", 1, "left", -1},
		{"RIGHT", 1, "right", 1},
	};

	for (size_t i = 0; i < ARRAY_COUNT(moves); i++) {
		write_move(model, parts, part, &moves[i], out);
	}
}

/* A flat or round part turns about one axis. */
static void write_disc(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out)
{
	/* Seen from in front or from above, left is counter-clockwise. */
	static const struct move moves[] = {
		{"UP", 0, "back", -1},
		{"DOWN", 0, "forward", 1},
		{"LEFT", 1, "left", 1},
		{"RIGHT", 1, "right", -1},
		{"LEFT", 2, "left", 1},
		{"RIGHT", 2, "right", -1},
	};
	const struct sketch_turn_axis *about = &parts->turn[part].axis;
	/* LEFT turns a door as it turns a free part: clockwise from above. */
	bool exchange =
		about->seen == 1 && parts->turn[part].form == SKETCH_TURN_HINGE;

	for (size_t i = 0; i < ARRAY_COUNT(moves); i++) {
		struct move move = moves[i];

		if (move.axis == about->seen) {
			move.axis = about->axis;
			move.factor *= exchange ? -about->sign : about->sign;
			write_move(model, parts, part, &move, out);
		}
	}
	fputs(about->seen == 0 ? SKETCH_CAMERA_TURNS : SKETCH_CAMERA_TILTS, out);
}

/* A rod does not turn about its length, which nobody would see. */
static void write_rod(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out)
{
	/* By the axis of the model along which the rod lies. */
	static const struct move moves[3][4] = {
		{{"UP", 0, "up", 1}, {"DOWN", 0, "down", -1},
			{"LEFT", 1, "forward", -1}, {"RIGHT", 1, "back", 1}},
		{{"UP", 0, "back", -1}, {"DOWN", 0, "forward", 1},
			{"LEFT", 1, "left", 1}, {"RIGHT", 1, "right", -1}},
		{{"UP", 0, "up", -1}, {"DOWN", 0, "down", 1},
			{"LEFT", 1, "left", -1}, {"RIGHT", 1, "right", 1}},
	};
	const struct sketch_turn *turn = &parts->turn[part];

	for (size_t i = 0; i < ARRAY_COUNT(moves[0]); i++) {
		struct move move = moves[turn->axis.seen][i];
		const struct sketch_turn_axis *about = &turn->across[move.axis];

		move.axis = about->axis;
		/* It is the far end that goes where the button says. */
		move.factor *= about->sign * turn->axis.sign;
		write_move(model, parts, part, &move, out);
	}
}

void sketch_write_part_buttons(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out)
{
	fprintf(out, "[buttons part%d]\nwhen = arrows is part%d\n", part + 1,
		part + 1);
	switch (parts->turn[part].form) {
	case SKETCH_TURN_FREE:
		write_free(model, parts, part, out);
		break;
	case SKETCH_TURN_ROD:
		write_rod(model, parts, part, out);
		break;
	default:
		write_disc(model, parts, part, out);
		break;
	}
	fputc('\n', out);
}
