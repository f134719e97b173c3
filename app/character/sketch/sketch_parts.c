#include "app/character/sketch/sketch_parts.h"

#include "app/character/sketch/sketch_names.h"
#include "app/scene/hud/hud_name.h"

static bool is_rigid(const struct model *model, int node)
{
	return model->node[node].mesh >= 0 && model->node[node].skin < 0;
}

/* A part is called as its node is. */
static void find(const struct model *model, const bool *is_joint,
	const bool *is_named, bool joints, struct sketch_parts *out)
{
	for (int i = 0; i < model->node_count && out->count < SKETCH_PARTS; i++) {
		bool fits = joints ? is_joint[i]
				   : is_rigid(model, i) && !is_joint[i];

		if (fits && is_named[i] &&
			sketch_fits_heading(model->node[i].name)) {
			out->node[out->count++] = i;
		}
	}
}

/* Returns true if a rigid part has another one above it. */
static bool hangs(const struct model *model, int node)
{
	int above = model->node[node].parent;

	while (above >= 0 && !is_rigid(model, above)) {
		above = model->node[above].parent;
	}
	return above >= 0;
}

void sketch_find_parts(const struct model *model, const bool *is_joint,
	const bool *is_named, bool still, struct sketch_parts *out)
{
	struct sketch_parts joints = {.moved = true};

	*out = (struct sketch_parts){.count = 0};
	find(model, is_joint, is_named, false, out);
	for (int i = 0; i < out->count; i++) {
		out->moved = out->moved || (still && hangs(model, out->node[i]));
	}
	if (still && !out->moved) {
		find(model, is_joint, is_named, true, &joints);
		*out = joints.count > 0 ? joints : *out;
	}
}

void sketch_write_parts(
	const struct model *model, const struct sketch_parts *parts, FILE *out)
{
	const char *mark = parts->moved ? "" : ";";

	if (parts->count > 0) {
		fprintf(out, "; %s: start, lowest, highest, degrees a second.\n",
			is_rigid(model, parts->node[0])
				? "Rigid parts turn on their pivots"
				: "Bones turn on their joints");
	}
	for (int i = 0; i < parts->count; i++) {
		fprintf(out, "%s[part ", mark);
		sketch_write_name(out, model->node[parts->node[i]].name);
		fprintf(out,
			"]\n%sheading = 0 -90 90 45\n%spitch = 0 -45 45 45\n\n",
			mark, mark);
	}
}

void sketch_write_part_buttons(const struct model *model,
	const struct sketch_parts *parts, int part, FILE *out)
{
	static const struct {
		const char *button, *freedom, *how;
		int factor;
	} moves[] = {
		{"UP", "pitch", "back", -1},
		{"DOWN", "pitch", "forward", 1},
		{"LEFT", "heading", "left", -1},
		{"RIGHT", "heading", "right", 1},
	};
	const char *name = model->node[parts->node[part]].name;
	char number[HUD_NAME_BYTES];
	/* The labels are for the screen. */
	const char *shown = hud_name(name, "part", part + 1, number);

	fprintf(out, "[buttons part%d]\nwhen = arrows is part%d\n", part + 1,
		part + 1);
	for (size_t i = 0; i < sizeof(moves) / sizeof(moves[0]); i++) {
		fprintf(out, "%s = move ", moves[i].button);
		sketch_write_name(out, name);
		fprintf(out, " %s %d \"turn %s %s\"\n", moves[i].freedom,
			moves[i].factor, shown, moves[i].how);
	}
	fputc('\n', out);
}
