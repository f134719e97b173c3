/*
 * Sections [expression] and [morph].
 */
#include "app/character/build/build.h"

#include "app/character/run/layers.h"

#include <errno.h>
#include <string.h>

enum {
	PARTS_MAX = 32,
	KEYS_MAX = 64
};

/* Reads the section's node, or takes the first one with morph targets. */
static int find_node(struct character_build *build,
	const struct character_section *section, int *node)
{
	*node = model_find_morphed(build->model);
	for (const struct character_line *line = section->first; line;
		line = line->next) {
		struct character_words words = {build, line, 0};

		if (strcmp(line->key, "node") == 0) {
			int named = character_name_node(&words);
			int mesh =
				named < 0 ? -1 : build->model->node[named].mesh;

			if (named < 0) {
				return -EINVAL;
			}
			if (mesh < 0 ||
				build->model->mesh[mesh].target_count == 0) {
				return character_fail(&words,
					"the node has no morph targets: name one that has");
			}
			*node = named;
		}
	}
	return *node >= 0 ? 0
			  : character_fail_section(build, section,
				    "the model has no morph targets");
}

static int skip_word(struct character_words *words,
	const struct character_key *key, void *member)
{
	(void)key;
	(void)member;
	character_next_word(words);
	return 0;
}

/* A mix of targets: TARGET [AMOUNT], TARGET [AMOUNT] ... */
struct mix {
	int node;
	int count;
	int target[PARTS_MAX];
	float amount[PARTS_MAX];
};

static int read_mix(
	struct character_words *words, const char *right, struct mix *mix)
{
	do {
		int target = character_name_target(words, mix->node);
		float amount = 1;

		if (target < 0) {
			return -EINVAL;
		}
		if (character_take_number(words, &amount) &&
			(amount < -10 || amount > 10)) {
			return character_fail(words,
				"an amount is from -10 to 10: give %s", right);
		}
		if (mix->count == PARTS_MAX) {
			return character_fail(words,
				"at most %d targets can be mixed", PARTS_MAX);
		}
		mix->target[mix->count] = target;
		mix->amount[mix->count++] = amount;
	} while (character_take(words, ","));
	return 0;
}

struct expression_draft {
	struct character_expression expression;
	struct mix mix;
};

static int read_targets(struct character_words *words,
	const struct character_key *key, void *member)
{
	return read_mix(words, key->right, member);
}

static const struct character_key expression_keys[] = {
	CHARACTER_SWITCH_KEYS(struct expression_draft, expression.is),
	{"node", skip_word, .right = "the name of a node"},
	{"targets", read_targets, offsetof(struct expression_draft, mix),
		.right = "targets and amounts, such as smile 1, blink 0.3"},
	{0},
};

static int read_expression(struct character_build *build,
	const struct character_section *section, void *one)
{
	struct character_expression *expression = one;
	struct expression_draft draft = {.mix = {0}};
	int error = character_add_switch(build, section, &expression->is);
	int first;

	draft.expression = *expression;
	if (!error) {
		error = find_node(build, section, &draft.mix.node);
	}
	if (!error) {
		error = character_read_section(
			build, section, expression_keys, &draft);
	}
	if (error) {
		return error;
	}
	if (draft.mix.count == 0) {
		return character_fail_section(build, section,
			"an expression mixes targets: add targets = NAME AMOUNT");
	}
	*expression = draft.expression;
	expression->count = draft.mix.count;
	expression->target =
		ARENA_ARRAY(build->arena, int, (size_t)draft.mix.count);
	expression->amount =
		ARENA_ARRAY(build->arena, float, (size_t)draft.mix.count);
	if (!expression->target || !expression->amount) {
		return character_fail_memory(build);
	}
	first = build->model->node[draft.mix.node].weight_offset;
	for (int i = 0; i < draft.mix.count; i++) {
		expression->target[i] = first + draft.mix.target[i];
		expression->amount[i] = draft.mix.amount[i];
	}
	character_add_op(build, CHARACTER_STAGE_MORPH, character_expression_run,
		expression);
	return 0;
}

int character_build_expressions(struct character_build *build)
{
	static const struct character_kind kind = {"expression",
		sizeof(struct character_expression), read_expression};

	return character_read_kind(build, &kind,
		&build->character->expression_count,
		&build->character->expression);
}

/*
 * Returns the number of groups of three weights, which the morph's loops take.
 */
static int triples(const struct character_morph *morph)
{
	return (morph->target_count + 2) / 3;
}

/* Returns the address of a target's weight in the last key frame. */
static float *last_weight(const struct character_morph *morph, int target)
{
	const struct morph_key *key = &morph->key[morph->key_count - 1];

	return (float *)&key->position[target / 3][target % 3];
}

/* Adds a key frame with all weights 0. */
static int add_key(struct character_build *build, struct character_morph *morph,
	const char *name)
{
	float(*weight)[3] = arena_alloc(
		build->arena, (size_t)triples(morph), sizeof(*weight));

	if (!weight) {
		return character_fail_memory(build);
	}
	morph->key[morph->key_count].position = (const float(*)[3])weight;
	morph->key_name[morph->key_count++] = name;
	return 0;
}

/* key = NAME, TARGET [AMOUNT], ... */
static int read_key(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_morph *morph = member;
	struct mix mix = {.node = morph->node};
	const char *name = character_next_word(words);
	int error;

	if (!name) {
		return character_fail(
			words, "the name is missing: give %s", key->right);
	}
	if (morph->key_count == KEYS_MAX) {
		return character_fail(
			words, "a morph has at most %d key frames", KEYS_MAX);
	}
	error = add_key(words->build, morph, name);
	if (!error && character_take(words, ",")) {
		error = read_mix(words, key->right, &mix);
	}
	for (int i = 0; i < mix.count && !error; i++) {
		*last_weight(morph, mix.target[i]) = mix.amount[i];
	}
	return error;
}

static int read_neck(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct bend_neck *neck = member;
	float height[2];
	int error = character_read_numbers2(words, key, height);

	if (!error && !(height[0] < height[1])) {
		return character_fail(words,
			"the second height has to be larger: give %s",
			key->right);
	}
	neck->low = height[0];
	neck->high = height[1];
	return error;
}

static const struct character_key morph_keys[] = {
	{"node", skip_word, .right = "the name of a node"},
	{"key", read_key,
		.right = "a name and targets, such as smirk, smile 0.6, blink 0.2"},
	{"time", character_read_number,
		offsetof(struct character_morph, duration_s), 0, 60,
		.right = "seconds from 0 to 60"},
	{"frames", character_read_count,
		offsetof(struct character_morph, frame_count), 1, 10000,
		.right = "a whole number of frames from 1 to 10000"},
	{"curve", character_read_curve,
		.right = "linear, sine METRES, sine METRES X Y Z DELAY, table 0 ... 1 or bezier X1 Y1 X2 Y2"},
	{"direction", character_read_curve_direction,
		.right = "x y z, such as 0 0 1"},
	{"weight", character_read_value, offsetof(struct character_morph, weight),
		0, 1, .right = "a number from 0 to 1, or a parameter"},
	{"neck", read_neck, offsetof(struct character_morph, neck),
		.right = "two heights in metres, such as 0.1 0.15"},
	{"turn", character_read_value, offsetof(struct character_morph, turn_deg),
		-28, 28, .right = "degrees from -28 to 28, or a parameter"},
	{0},
};

/* Without a line "key", there are the neutral shape and each target. */
static int add_target_keys(
	struct character_build *build, struct character_morph *morph)
{
	const struct model_mesh *mesh =
		&build->model->mesh[build->model->node[morph->node].mesh];
	int error = add_key(build, morph, "neutral");

	morph->plain_keys = true;
	for (int i = 0; i < morph->target_count && i < KEYS_MAX - 1 && !error;
		i++) {
		char number[16];
		const char *name = mesh->target_name[i];

		snprintf(number, sizeof(number), "%d", i);
		name = name[0] ? name : arena_strdup(build->arena, number);
		error = name ? add_key(build, morph, name)
			     : character_fail_memory(build);
		if (!error) {
			*last_weight(morph, i) = 1;
		}
	}
	return error;
}

static int take_memory(
	struct character_build *build, struct character_morph *morph)
{
	morph->key = ARENA_ARRAY(build->arena, struct morph_key, KEYS_MAX);
	morph->key_name = ARENA_ARRAY(build->arena, const char *, KEYS_MAX);
	return morph->key && morph->key_name ? 0 : character_fail_memory(build);
}

/* Returns true if the section has a line with this key. */
static bool has_key(const struct character_section *section, const char *key)
{
	const struct character_line *line = section->first;

	while (line && strcmp(line->key, key) != 0) {
		line = line->next;
	}
	return line;
}

/* Only a morph with a sine or a neck bends its vertices one by one. */
static int init_bend(
	struct character_build *build, struct character_morph *morph)
{
	bool bends = morph->turn_deg;

	if (morph->curve_count == 0) {
		morph->curve_count = 1;
		morph->curve[0].name = "linear";
	}
	for (int i = 0; i < morph->curve_count; i++) {
		bends = bends || morph->curve[i].kind == CHARACTER_CURVE_SINE;
	}
	morph->frame_count += morph->frame_count == 0
		? (int)(morph->duration_s * 30 + 0.5f)
		: 0;
	morph->frame_count += morph->frame_count == 0;
	if (!bends) {
		return 0;
	}
	if (bend_init(&morph->bend, build->character->instance, morph->node,
		    &morph->neck) != 0) {
		return character_fail_memory(build);
	}
	character_morph_use_curve(morph, 0);
	character_morph_bend(morph, 0);
	return 0;
}

static int read_morph(struct character_build *build,
	const struct character_section *section, void *one)
{
	struct character_morph *morph = one;
	static const float whole = 1;
	int node;
	int error = find_node(build, section, &node);

	if (error) {
		return error;
	}
	*morph = (struct character_morph){
		.name = section->name,
		.node = node,
		.target_count = build->model->mesh[build->model->node[node].mesh]
					.target_count,
		.duration_s = 0.6f,
		.curve[0].wave.direction = {0, 0, 1},
		.neck = {.low = 1e6f, .high = 2e6f},
		.weight = &whole,
		.pace = 1,
	};
	error = take_memory(build, morph);
	if (!error) {
		error = character_read_section(
			build, section, morph_keys, morph);
	}
	if (!error && morph->key_count == 0) {
		error = add_target_keys(build, morph);
	}
	if (!error) {
		error = init_bend(build, morph);
	}
	if (!error) {
		/* With both keys, a morph begins over time. */
		morph->by_frames =
			has_key(section, "frames") && !has_key(section, "time");
		error = morph_init(&morph->morph, triples(morph), morph->key[0],
				build->arena)
			? character_fail_memory(build)
			: 0;
		character_add_op(build, CHARACTER_STAGE_MORPH,
			character_morph_run, morph);
	}
	return error;
}

int character_build_morphs(struct character_build *build)
{
	static const struct character_kind kind = {
		"morph", sizeof(struct character_morph), read_morph};

	return character_read_kind(build, &kind, &build->character->morph_count,
		&build->character->morph);
}
