/*
 * Sections [look] and [reach], and the limbs and targets that effects aim with.
 */
#include "app/character/build/build.h"

#include "app/character/run/effects.h"

#include <errno.h>
#include <string.h>

static int read_target(struct character_words *words,
	const struct character_key *key, void *member)
{
	int index = character_name_section(words, "target");

	(void)key;
	if (index < 0) {
		return -EINVAL;
	}
	*(struct character_target **)member =
		&words->build->character->target[index];
	words->build->character->target[index].has_users = true;
	return 0;
}

/* Where a model looks at rest. */
static const float front[3] = {0, 0, 1};
static const float up[3] = {0, 1, 0};

static int read_look_bone(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_look *look = member;
	int at = look->bone_count;
	float rate = 0;
	int node;

	if (at == CHARACTER_BONES_MAX) {
		return character_fail(words, "there are at most %d bones",
			CHARACTER_BONES_MAX);
	}
	node = character_name_node(words);
	if (node < 0) {
		return -EINVAL;
	}
	look->share[at] = 1;
	if (character_take_number(words, &look->share[at]) &&
		(look->share[at] < 0 || look->share[at] > 1)) {
		return character_fail(
			words, "a share is from 0 to 1: give %s", key->right);
	}
	character_take_number(words, &rate);
	if (rate < 0 || rate > 100) {
		return character_fail(
			words, "a rate is from 0 to 100: give %s", key->right);
	}
	look->bone[at] = lookat_default(node);
	look->bone[at].rate = rate > 0 ? rate : look->bone[at].rate;
	character_to_bone(words->build, node, front, look->bone[at].forward);
	character_to_bone(words->build, node, up, look->bone[at].up);
	look->bone_count++;
	return 0;
}

/* Settings after the bones; they hold for all bones of the section. */
static int read_look_number(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_look *look = member;
	float value[3];
	bool is_vector = strcmp(key->name, "forward") == 0 ||
		strcmp(key->name, "up") == 0;
	int error = is_vector ? character_read_direction(words, key, value)
			      : character_read_number(words, key, value);

	if (!error && look->bone_count == 0) {
		return character_fail(
			words, "name the bones first: add bone = NODE above");
	}
	for (int i = 0; i < look->bone_count && !error; i++) {
		struct lookat *bone = &look->bone[i];

		if (is_vector) {
			character_to_bone(words->build, bone->node, value,
				key->name[0] == 'f' ? bone->forward : bone->up);
		} else if (key->name[0] == 'y') {
			bone->yaw_limit_rad = value[0] * (SCALAR_PI / 180);
			bone->release_rad = 0;
		} else if (key->name[0] == 'p') {
			bone->pitch_limit_rad = value[0] * (SCALAR_PI / 180);
		} else {
			bone->rate = value[0];
		}
	}
	return error;
}

static const struct character_key look_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_look, is),
	{"bone", read_look_bone,
		.right = "a node, its share of the turn and its rate, such as neck 0.4 or eye.L 1 20"},
	{"target", read_target, offsetof(struct character_look, target),
		.right = "the name of a [target]"},
	{"forward", read_look_number,
		.right = "x y z of the model at rest, such as 0 0 1"},
	{"up", read_look_number,
		.right = "x y z of the model at rest, such as 0 1 0"},
	{"yaw", read_look_number, 0, 1, 179, .right = "degrees from 1 to 179"},
	{"pitch", read_look_number, 0, 1, 89, .right = "degrees from 1 to 89"},
	{"rate", read_look_number, 0, 0, 100, .right = "a number from 0 to 100"},
	{0},
};

int character_build_look(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_look *look = what;
	int error = character_read_section(build, section, look_keys, look);

	if (error) {
		return error;
	}
	return look->bone_count == 0
		? character_fail_missing(build, section, "bone = NODE")
		: !look->target ? character_fail_missing(build, section,
					  "target = NAME, and a [target NAME]")
				: 0;
}

int character_read_limb(struct character_words *words,
	const struct character_key *key, struct ik_limb *limb)
{
	int node[3];

	for (int i = 0; i < 3; i++) {
		int error = character_read_node(words, key, &node[i]);

		if (error) {
			return error;
		}
		if (i > 0 &&
			(node[i] == node[i - 1] ||
				!model_is_below(words->build->model, node[i],
					node[i - 1]))) {
			return character_fail(words,
				"each bone has to be below the one before it: give %s",
				key->right);
		}
	}
	*limb = (struct ik_limb){node[0], node[1], node[2], 0};
	return 0;
}

static int read_limb(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_reach *reach = member;

	reach->is_chain = false;
	return character_read_limb(words, key, &reach->limb);
}

static int read_chain(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_reach *reach = member;
	float count;
	int tip;
	int error = character_read_node(words, key, &tip);

	if (error) {
		return error;
	}
	if (!character_take_number(words, &count) ||
		ik_chain_init(&reach->chain, words->build->model, tip,
			(int)count) != 0) {
		return character_fail(words,
			"the number of bones is from 2 to %d, and the tip has so many above it: give %s",
			IK_CHAIN_MAX, key->right);
	}
	reach->chain.tolerance *= words->build->character->metre;
	reach->is_chain = true;
	return 0;
}

/* The limit of each bone's turn from rest. */
static int read_limit(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_reach *reach = member;
	float limit_rad = 0;
	int error = character_read_angle(words, key, &limit_rad);

	if (!error && !reach->is_chain) {
		return character_fail(words,
			"only a chain has a limit: add chain = TIP COUNT above");
	}
	for (int i = 0; i < reach->chain.count; i++) {
		reach->chain.limit_rad[i] = limit_rad;
	}
	return error;
}

static int read_pole(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_reach *reach = member;

	reach->has_pole = true;
	return character_read_numbers3(words, key, reach->pole);
}

static int read_grip(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_reach *reach = member;

	reach->has_grip = true;
	return character_read_numbers3(words, key, reach->grip);
}

static const struct character_key reach_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_reach, is),
	{"limb", read_limb,
		.right = "three nodes, such as upper_arm.R forearm.R hand.R"},
	{"chain", read_chain,
		.right = "the last bone and the number of bones, such as tail.5 6"},
	{"limit", read_limit, 0, 0.1f, 180, .right = "degrees from 0.1 to 180"},
	{"target", read_target, offsetof(struct character_reach, target),
		.right = "the name of a [target]"},
	{"short", character_read_number,
		offsetof(struct character_reach, short_m), 0,
		CHARACTER_LENGTH_MAX,
		.right = "metres that the tip stops before the target"},
	{"grip", read_grip,
		.right = "x y z of the target in the tip's frame, such as 0 0.06 0"},
	{"pole", read_pole,
		.right = "x y z from the target, towards which the middle bends"},
	{0},
};

int character_build_reach(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_reach *reach = what;
	int error;

	reach->limb.upper = -1;
	error = character_read_section(build, section, reach_keys, reach);
	if (error) {
		return error;
	}
	if (reach->is_chain && reach->has_grip) {
		return character_fail_section(build, section,
			"only a limb has a grip: write limb = UPPER LOWER TIP");
	}
	return !reach->is_chain && reach->limb.upper < 0
		? character_fail_missing(build, section,
			  "limb = UPPER LOWER TIP or chain = TIP COUNT")
		: !reach->target ? character_fail_missing(build, section,
					   "target = NAME, and a [target NAME]")
				 : 0;
}
