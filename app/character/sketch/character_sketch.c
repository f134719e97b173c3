#include "app/character/sketch/character_sketch.h"

#include "app/anim/pose.h"
#include "app/character/sketch/sketch_feet.h"
#include "app/character/sketch/sketch_layers.h"
#include "app/character/sketch/sketch_motion.h"
#include "app/character/sketch/sketch_names.h"
#include "app/character/sketch/sketch_once.h"
#include "app/character/sketch/sketch_parts.h"
#include "app/model/origin/model_origin.h"
#include "platform/base/printable.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	EXPRESSIONS_MAX = 12,
	CHAINS_MAX = 6
};

static void write_state(const struct model *model, int clip,
	const struct character_sketch_play *play, bool once, FILE *out)
{
	static const char *const repeats[] = {
		[CLIP_ONCE] = "repeat = once\n",
		[CLIP_LOOP] = "",
		[CLIP_PING_PONG] = "repeat = ping-pong\n",
	};

	fputs("[state ", out);
	sketch_write_heading(out, model, clip);
	fputs("]\nclip = ", out);
	sketch_write_clip(out, model, clip);
	fprintf(out, "\n%s", repeats[play->repeat]);
	if (once) {
		sketch_write_once(model, clip, out);
	}
	if (model->clip_count == 1) {
		fputs("rate = rate\n", out);
	} else if (play->rate != 1) {
		fprintf(out, "rate = %g\n", (double)play->rate);
	}
	fprintf(out, "fade = 0.3 ; of %.2f s\n\n",
		(double)model->clip[clip].duration_s);
}

static void write_states(const struct model *model,
	const struct character_sketch_play *play,
	const struct sketch_once *once, FILE *out)
{
	float low = play->rate < 0 ? play->rate : 0;
	float high = play->rate > 3 ? play->rate : 3;

	if (model->clip_count == 0) {
		fputs("; The model has no clips: it stands still until buttons or effects move it.\n\n",
			out);
		return;
	}
	if (model->clip_count == 1) {
		fprintf(out,
			"; How fast the clip plays.\n"
			"[parameter rate]\nrange = %g %g\nstart = %g\nease = 0.3\n\n",
			(double)low, (double)high, (double)play->rate);
	}
	fputs("; Each clip is a state. The first one plays at the start. A state that\n"
	      "; plays once goes on with another: repeat = once and next = STATE.\n",
		out);
	if (model->clip_count > CHARACTER_SKETCH_CLIPS) {
		fprintf(out, "; These are %d of the model's %d clips.\n",
			CHARACTER_SKETCH_CLIPS, model->clip_count);
	}
	for (int i = 0; i < model->clip_count && i < CHARACTER_SKETCH_CLIPS;
		i++) {
		int clip = (play->clip + i) % model->clip_count;

		write_state(model, clip, play,
			clip < CHARACTER_SKETCH_CLIPS && once->clip[clip], out);
	}
}

/* Whether a clip moves the node's morph targets by itself. */
static bool is_animated(const struct model *model, int node)
{
	for (int c = 0; c < model->clip_count; c++) {
		if (model_clip_moves_weights(&model->clip[c], node)) {
			return true;
		}
	}
	return false;
}

/* The node whose shapes buttons choose, or -1. */
static int find_shapes(const struct model *model)
{
	int node = model_find_morphed(model);

	return node >= 0 && is_animated(model, node) ? -1 : node;
}

/*
 * A section, whose lines begin with mark. Beside a clip that moves the same
 * shapes it is a suggestion: the camera would leave room for all shapes.
 */
static void write_morph_section(const struct model *model, int node, FILE *out)
{
	const char *mark = is_animated(model, node) ? ";" : "";
	const char *name = model->node[node].name;

	fprintf(out,
		"; The shape goes from key frame to key frame: the neutral shape and each\n"
		"; morph target. curve = sine 0.02, table 0 1.2 1 or bezier 0.4 0 0.2 1.\n"
		"%s[morph shape]\n",
		mark);
	if (sketch_is_usable(name) && model_find_node(model, name) == node) {
		fprintf(out, "%snode = ", mark);
		sketch_write_name(out, name);
		fputc('\n', out);
	}
	fprintf(out, "%stime = 0.6\n%scurve = bezier 0.4 0 0.2 1\n\n", mark,
		mark);
}

static void write_morph(const struct model *model, FILE *out)
{
	int node = model_find_morphed(model);
	const struct model_mesh *mesh;

	if (node < 0) {
		return;
	}
	mesh = &model->mesh[model->node[node].mesh];
	write_morph_section(model, node, out);
	fputs("; Expressions are mixed, each with a weight of its own.\n", out);
	if (mesh->target_count > EXPRESSIONS_MAX) {
		fprintf(out, "; These are %d of the mesh's %d targets.\n",
			EXPRESSIONS_MAX, mesh->target_count);
	}
	for (int i = 0; i < mesh->target_count && i < EXPRESSIONS_MAX; i++) {
		fprintf(out, ";[expression face%d]\n;targets = ", i);
		sketch_write_target(out, mesh, i);
		fputs(" 1\n;on = no\n\n", out);
	}
}

/*
 * [node_count] each: which nodes are joints, which can be named, their numbers
 * of children, and where they are at rest.
 */
struct bones {
	bool *is_joint, *is_named;
	int *child_count;
	mat4 *world;
};

/* 0 or -ENOMEM. */
static int find_bones(
	struct bones *bones, const struct model *model, struct arena *arena)
{
	struct pose pose;

	bones->is_joint = model_find_joints(model, arena);
	bones->is_named = sketch_find_named_nodes(model, arena);
	bones->child_count = ARENA_ARRAY(arena, int, model->node_count);
	bones->world = ARENA_ARRAY(arena, mat4, (size_t)model->node_count);
	if (!bones->is_joint || !bones->is_named || !bones->child_count ||
		!bones->world || pose_init(&pose, model, arena) != 0) {
		return -ENOMEM;
	}
	pose_world(&pose, model, NULL, bones->world);
	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].parent >= 0) {
			bones->child_count[model->node[i].parent]++;
		}
	}
	return 0;
}

/* Returns the number of bones from last up to where the skeleton branches. */
static int chain_length(
	const struct model *model, const struct bones *bones, int last)
{
	int count = 1;
	int node = model->node[last].parent;

	while (node >= 0 && bones->is_joint[node] &&
		bones->child_count[node] == 1) {
		node = model->node[node].parent;
		count++;
	}
	return count;
}

/* The box of the bones at rest and its longest side, in metres. */
struct bone_box {
	float low[3], high[3], size;
};

static struct bone_box measure_bones(
	const struct model *model, const struct bones *bones)
{
	struct bone_box box = {.size = 0.0f};
	float *low = box.low, *high = box.high;

	for (int i = 0, found = 0; i < model->node_count; i++) {
		for (int axis = 0; axis < 3 && bones->is_joint[i]; axis++) {
			float at = bones->world[i][3][axis];

			low[axis] = !found || at < low[axis] ? at : low[axis];
			high[axis] = !found || at > high[axis] ? at : high[axis];
			found = found || axis == 2;
		}
	}
	for (int axis = 0; axis < 3; axis++) {
		float side = high[axis] - low[axis];

		box.size = scalar_max(side, box.size);
	}
	return box;
}

/* Suggests a ball in front of the figure's middle, a little to its left. */
static void write_target(
	const struct model *model, const struct bone_box *box, FILE *out)
{
	const float *low = box->low, *high = box->high;
	float size = box->size;
	const float ball[3] = {0.5f * (low[0] + high[0]) + 0.18f * size,
		low[1] + 0.6f * (high[1] - low[1]),
		0.5f * (low[2] + high[2]) + 0.3f * size};
	double place[3];
	int decimals = 2;

	/*
	 * Exact to a hundredth of the model, however far from the origin it is.
	 */
	for (float side = size; side < 1.0f && decimals < 9; side *= 10.0f) {
		decimals++;
	}
	model_origin_to_file(model, ball, place);
	fprintf(out,
		";[target ball]\n;place = %.*f %.*f %.*f\n;radius = %.2g\n\n",
		decimals, place[0], decimals, place[1], decimals, place[2],
		(double)(0.03f * size));
}

static void write_chains(
	const struct model *model, const struct bones *bones, FILE *out)
{
	int written = 0, length;

	for (int i = 0; i < model->node_count && written < CHAINS_MAX; i++) {
		if (!bones->is_joint[i] || bones->child_count[i] > 0 ||
			!bones->is_named[i]) {
			continue;
		}
		length = chain_length(model, bones, i);
		if (length < 2) {
			continue;
		}
		if (written++ == 0) {
			struct bone_box box = measure_bones(model, bones);

			fputs("; Chains of bones. They may swing as springs, or reach for a target:\n",
				out);
			write_target(model, &box, out);
		}
		fprintf(out, ";[spring swing%d]\n;bones = ", written);
		sketch_write_name(out, model->node[i].name);
		fprintf(out, " %d", length < 16 ? length : 16);
		fprintf(out, "\n\n;[reach reach%d]\n;chain = ", written);
		sketch_write_name(out, model->node[i].name);
		fprintf(out, " %d\n;target = ball\n;on = no\n\n",
			length < 16 ? length : 16);
	}
}

/* Returns true if nothing but buttons moves the model. */
static bool is_still(const struct model *model)
{
	return model->clip_count == 0 && find_shapes(model) < 0;
}

/*
 * Writes what single nodes may do. If nothing else moves the model, buttons
 * will move the parts that are found. Returns 0 or -ENOMEM.
 */
static int write_nodes(
	const struct model *model, struct sketch_parts *parts, FILE *out)
{
	struct arena arena = arena_empty();
	struct bones bones;
	int error = find_bones(&bones, model, &arena);

	if (!error) {
		error = sketch_find_parts(model, bones.is_joint, bones.is_named,
			is_still(model), parts);
	}
	if (!error) {
		sketch_write_parts(model, parts, out);
		sketch_write_feet(model, bones.is_joint, bones.is_named,
			(const mat4 *)bones.world, out);
		write_chains(model, &bones, out);
	}
	arena_release(&arena);
	return error;
}

/* What UP and DOWN do in one mode, which is a section [buttons] of its own. */
static const struct mode {
	const char *name, *up, *down;
} mode_clips = {"clips", "previous \"play the previous clip\"",
	"next \"play the next clip\""},
  mode_rate = {"rate", "add rate 0.25 \"play faster\"",
	  "add rate -0.25 \"play slower\""},
  mode_shapes = {"shapes", "morph shape previous \"show the previous shape\"",
	  "morph shape next \"show the next shape\""},
  mode_camera = {"camera", SKETCH_CAMERA_UP, SKETCH_CAMERA_DOWN};

static void write_mode(const struct mode *mode, FILE *out)
{
	fprintf(out,
		"[buttons %s]\nwhen = arrows is %s\nlabel = no\nUP = %s\nDOWN = %s\n\n",
		mode->name, mode->name, mode->up, mode->down);
}

/* F9 chooses what UP and DOWN do with a model that has clips. */
static void write_modes(const struct model *model, bool has_shapes, FILE *out)
{
	const struct mode *first =
		model->clip_count > 1 ? &mode_clips : &mode_rate;

	fprintf(out, "[parameter arrows]\nchoices = %s%s camera\nlabel = no\n\n",
		first->name, has_shapes ? " shapes" : "");
	write_mode(first, out);
	if (has_shapes) {
		write_mode(&mode_shapes, out);
	}
	write_mode(&mode_camera, out);
}

/* F9 chooses what the arrows move. */
static void write_part_modes(
	const struct model *model, const struct sketch_parts *parts, FILE *out)
{
	fputs("[parameter arrows]\nchoices =", out);
	for (int i = 0; i < parts->count; i++) {
		fprintf(out, " part%d", i + 1);
	}
	fputs(" camera\nlabel = no\n\n", out);
	for (int i = 0; i < parts->count; i++) {
		sketch_write_part_buttons(model, parts, i, out);
	}
	fputs("[buttons camera]\nwhen = arrows is camera\nlabel = no\n" SKETCH_CAMERA_TILTS
			SKETCH_CAMERA_TURNS
	      "\n[buttons]\nF9 = add arrows 1 \"choose what the arrows move\"\n",
		out);
}

static void write_buttons(const struct model *model,
	const struct sketch_parts *parts, bool some_once, FILE *out)
{
	bool has_clips = model->clip_count > 0;
	bool has_shapes = find_shapes(model) >= 0;

	fputs("; BUTTON = ACTION, ACTION \"what it does\". Also BUTTON hold, long and\n"
	      "; release, and two buttons: UP+DOWN.\n",
		out);
	if (has_clips) {
		write_modes(model, has_shapes, out);
		fputs("[buttons]\nF9 = add arrows 1 \"choose what UP and DOWN do\"\n",
			out);
	} else if (parts->moved) {
		write_part_modes(model, parts, out);
	} else {
		fputs("[buttons]\n" SKETCH_CAMERA_TILTS, out);
	}
	if (has_shapes && !has_clips) {
		fprintf(out,
			"LEFT = %s\nRIGHT = %s\n"
			"F9 = morph shape neutral \"show the neutral shape\"\n",
			mode_shapes.up, mode_shapes.down);
	} else if (!parts->moved) {
		fputs(SKETCH_CAMERA_TURNS, out);
	}
	fputs("ENTER = pause \"pause or continue\"\n", out);
	if (some_once) {
		fputs("ENTER long = next, previous \"play the clip again\"\n",
			out);
	}
	fputs("F6 = camera zoom -120 \"move the camera closer\"\n"
	      "F8 = camera zoom 120 \"move the camera away\"\n",
		out);
	fputs(model->clip_count > 1
			? "F10 = row \"play all clips in a row, or stop\"\n"
			: "F10 = labels \"show or hide the labels\"\n",
		out);
}

/* The tour of a model with shapes shows them all. */
static void write_scene(const struct model *model, FILE *out)
{
	int node = find_shapes(model), count;

	fputs("; The camera; yaw = 26 and pitch = 9 would be its angles, and zoom = 0.2 would\n"
	      "; bring it into a room.\n"
	      "[scene]\nmargin = 1.1\nlabels = left\n",
		out);
	if (node >= 0 && model->clip_count == 0) {
		count = model->mesh[model->node[node].mesh].target_count;
		count = count < EXPRESSIONS_MAX ? count : EXPRESSIONS_MAX;
		fprintf(out,
			"; What happens while nobody presses buttons, from time to time.\n"
			"period = %d\n",
			count + 1);
		for (int i = 0; i <= count; i++) {
			fprintf(out, "tour = %d morph shape next\n", i);
		}
	}
	fputc('\n', out);
}

int character_sketch(const struct model *model,
	const struct character_sketch_play *play, FILE *out)
{
	const struct character_sketch_play plain = {
		.rate = 1, .repeat = CLIP_LOOP};
	const char *slash = strrchr(model->path, '/');
	struct sketch_parts parts;
	struct sketch_once once;
	int error;

	play = play ? play : &plain;
	error = sketch_find_once(model, play, &once);
	if (error) {
		return error;
	}
	fputs("; How ", out);
	printable_put(slash ? slash + 1 : model->path, out);
	fputs(" behaves. limber play finds this file beside the model when its\n"
	      "; name is that of the model with .character at the end. limber doctor MODEL\n"
	      "; checks it, and man limber describes it. Lines that begin with ; are\n"
	      "; suggestions.\n\n",
		out);
	write_states(model, play, &once, out);
	error = sketch_write_layers(model, play->clip, out);
	if (error) {
		return error;
	}
	error = sketch_write_motion(model, out);
	if (error) {
		return error;
	}
	write_morph(model, out);
	error = write_nodes(model, &parts, out);
	if (error) {
		return error;
	}
	write_scene(model, out);
	write_buttons(model, &parts, once.any && model->clip_count > 1, out);
	return 0;
}
