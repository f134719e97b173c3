/*
 * Sections [layer], and the masks of the bones that layers move.
 */
#include "app/character/build/build.h"

#include "app/anim/pose_blend.h"
#include "app/character/run/layers.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	MASKS_MAX = 32
};

/* What a layer's section says. Mask and entry are made from it later. */
struct draft {
	struct character_layer layer;
	int clip;   /* -1: none was given */
	bool moved; /* only nodes that the clip moves */
	int soft;   /* levels over which the mask's edge fades */
	int mask_count;
	struct {
		int node;
		float weight;
	} mask[MASKS_MAX];
};

static int read_clip(struct character_words *words,
	const struct character_key *key, void *member)
{
	(void)key;
	*(int *)member = character_name_clip(words);
	return *(int *)member == -1 ? -EINVAL : 0;
}

/* Returns true if node is top or below it, and by how many levels. */
static bool is_below(const struct model *model, int node, int top, int *levels)
{
	*levels = 0;
	while (node > top) {
		node = model->node[node].parent;
		(*levels)++;
	}
	return node == top;
}

/*
 * Gives the weight to the top node and all below it; the first soft levels get
 * a growing part of it.
 */
static void mask_subtree(
	float *mask, const struct model *model, int top, float weight, int soft)
{
	for (int i = top; i < model->node_count; i++) {
		int levels;

		if (is_below(model, i, top, &levels)) {
			mask[i] = levels < soft ? weight * (float)(levels + 1) /
					(float)(soft + 1)
						: weight;
		}
	}
}

/* mask = NODE [WEIGHT], NODE [WEIGHT] ...; also in several lines. */
static int read_mask(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct draft *draft = member;

	do {
		int node = character_name_node(words);
		float weight = 1;

		if (node < 0) {
			return -EINVAL;
		}
		if (character_take_number(words, &weight) &&
			(weight < 0 || weight > 1)) {
			return character_fail(words,
				"a weight is from 0 to 1: give %s", key->right);
		}
		if (draft->mask_count == MASKS_MAX) {
			return character_fail(words,
				"a layer has at most %d masks", MASKS_MAX);
		}
		draft->mask[draft->mask_count].node = node;
		draft->mask[draft->mask_count++].weight = weight;
	} while (character_take(words, ","));
	return 0;
}

static const char *const modes[] = {"override", "additive", NULL};
static const char *const plays[] = {"loop", "once", NULL};
static const char *const extents[] = {"all", "moved", NULL};

/* Reads one of two words; the second one is true. */
static int read_either(struct character_words *words,
	const struct character_key *key, void *member)
{
	int choice = 0;
	int error = character_read_choice(words, key, &choice);

	*(bool *)member = choice == 1;
	return error;
}

static const struct character_key keys[] = {
	CHARACTER_SWITCH_KEYS(struct draft, layer.is),
	{"clip", read_clip, offsetof(struct draft, clip),
		.right = "the name of a clip"},
	{"mode", read_either, offsetof(struct draft, layer.additive),
		.choice = modes, .right = "override or additive"},
	{"play", read_either, offsetof(struct draft, layer.once),
		.choice = plays, .right = "loop or once"},
	{"rate", character_read_value, offsetof(struct draft, layer.rate), -100,
		100, .right = "a number from -100 to 100, or a parameter"},
	{"mask", read_mask,
		.right = "a node and perhaps a weight, such as shoulder.R 1"},
	{"nodes", read_either, offsetof(struct draft, moved), .choice = extents,
		.right = "all or moved"},
	{"soft", character_read_count, offsetof(struct draft, soft), 0, 16,
		.right = "a whole number of levels from 0 to 16"},
	{0},
};

_Static_assert(offsetof(struct draft, layer) == 0,
	"keys of a layer are keys of a draft");

/*
 * Takes the nodes that no channel of the clip moves out of the mask. Returns 0
 * or -ENOMEM.
 */
static int keep_moved(
	float *mask, const struct model *model, const struct model_clip *clip)
{
	bool *moved = calloc((size_t)model->node_count + 1, sizeof(*moved));

	if (!moved) {
		return -ENOMEM;
	}
	if (clip) {
		model_clip_mark_moved(clip, moved);
	}
	for (int i = 0; i < model->node_count; i++) {
		mask[i] = moved[i] ? mask[i] : 0;
	}
	free(moved);
	return 0;
}

static int make_mask(struct character_build *build, const struct draft *draft,
	struct character_layer *layer)
{
	const struct model *model = build->model;

	if (draft->mask_count == 0 && !draft->moved) {
		return 0;
	}
	layer->mask =
		ARENA_ARRAY(build->arena, float, (size_t)model->node_count);
	if (!layer->mask) {
		return character_fail_memory(build);
	}
	for (int i = 0; draft->mask_count == 0 && i < model->node_count; i++) {
		layer->mask[i] = 1;
	}
	for (int i = 0; i < draft->mask_count; i++) {
		mask_subtree(layer->mask, model, draft->mask[i].node,
			draft->mask[i].weight, draft->soft);
	}
	if (draft->moved &&
		keep_moved(layer->mask, model, layer->entry.of->clip) != 0) {
		return character_fail_memory(build);
	}
	return 0;
}

/*
 * Makes the pose from which an additive layer's clip differs by what is added.
 */
static int make_reference(
	struct character_build *build, struct character_layer *layer)
{
	const struct model_clip *clip = layer->entry.of->clip;

	if (!layer->additive) {
		return 0;
	}
	if (pose_init(&layer->reference, build->model, build->arena)) {
		return character_fail_memory(build);
	}
	if (clip) {
		clip_sample(
			clip, 0, &(struct clip_cursor){0}, &layer->reference);
	}
	return 0;
}

static int read_layer(struct character_build *build,
	const struct character_section *section, void *one)
{
	static const float as_it_is = 1;
	struct character_layer *layer = one;
	struct draft draft = {.clip = -1};
	int error = character_add_switch(build, section, &layer->is);

	layer->rate = &as_it_is;
	draft.layer = *layer;
	if (!error) {
		error = character_read_section(build, section, keys, &draft);
	}
	*layer = draft.layer;
	/* It is switched by the action "play" alone. */
	layer->is.on = layer->is.on && !layer->once;
	if (!error && draft.clip == -1) {
		return character_fail_section(build, section,
			"a layer plays a clip: add clip = NAME");
	}
	if (!error) {
		character_init_entry(build, draft.clip, &layer->entry);
		layer->entry.cursor = character_make_cursors(build, 1);
		error = layer->entry.cursor ? make_mask(build, &draft, layer)
					    : -ENOMEM;
	}
	if (!error) {
		layer->entry.cursor->only = layer->mask;
	}
	if (!error) {
		error = make_reference(build, layer);
	}
	character_add_op(
		build, CHARACTER_STAGE_LAYER, character_layer_run, layer);
	return error;
}

/*
 * Finds what layers have to mix: whatever some clip changes. All else has its
 * rest value, both in the pose and in the layer's clip.
 */
static int find_paths(struct character_build *build)
{
	struct character *character = build->character;
	const struct model *model = build->model;
	uint8_t *paths =
		ARENA_ARRAY(build->arena, uint8_t, (size_t)model->node_count);

	if (!paths) {
		return character_fail_memory(build);
	}
	for (int i = 0; i < character->clip_count; i++) {
		clip_add_paths(character->clip[i].clip, model, paths);
	}
	for (int i = 0; i < character->layer_count; i++) {
		character->layer[i].entry.cursor->paths = paths;
	}
	return 0;
}

int character_build_layers(struct character_build *build)
{
	static const struct character_kind kind = {
		"layer", sizeof(struct character_layer), read_layer};

	int error = character_read_kind(build, &kind,
		&build->character->layer_count, &build->character->layer);

	return error ? error : find_paths(build);
}
