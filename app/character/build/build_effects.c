/*
 * Sections of the effects, by a table of their kinds: [shake], [turn],
 * [spring], [breath] and [muscle] are read here, the others in files of their
 * own.
 */
#include "app/character/build/build.h"

#include "app/anim/math/matrix.h"
#include "app/character/presets/preset_file.h"
#include "app/character/run/effects.h"
#include "app/character/run/feet.h"

#include <limits.h>
#include <string.h>

#define SHAKE(name) offsetof(struct character_shake, name)

/* The file lies beside the character file that names it. */
static int read_presets(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_shake *shake = member;
	struct character_build *build = words->build;
	const char *name = character_next_word(words);
	char path[PATH_MAX];
	struct preset_file *file;
	int error;

	if (!build->text->is_file || !name ||
		!character_text_path_near(
			words->line->file, name, path, sizeof(path))) {
		return character_fail(words,
			"a file is needed that lies beside this one: give %s",
			key->right);
	}
	file = ARENA_NEW(build->arena, struct preset_file);
	if (!file) {
		return character_fail_memory(build);
	}
	error = preset_file_load(file, path, build->log);
	if (error) {
		return error;
	}
	if (file->count == 0) {
		return character_fail(words, "%s has no preset", path);
	}
	shake->preset = file->preset;
	shake->preset_count = file->count;
	for (int i = 0; i < file->count; i++) {
		shake->preset[i].unit *= build->character->metre;
	}
	shake->swing.preset = shake->preset[0];
	return 0;
}

/* Bones are shifted in their own units, which differ below a scaled node. */
static void use_units_of_bone(
	const struct character_build *build, struct character_shake *shake)
{
	float scale = matrix_scale((const mat4 *)&build->character->instance
					   ->world[shake->swing.node]);

	if (!(scale > 0)) {
		return;
	}
	shake->swing.preset.unit /= scale;
	for (int i = 0; i < shake->preset_count; i++) {
		shake->preset[i].unit /= scale;
	}
}

static const struct character_key shake_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_shake, is),
	{"bone", character_read_node, SHAKE(swing.node),
		.right = "the name of a node"},
	{"speed", character_read_number, SHAKE(swing.preset.speed), 0, 200,
		.right = "radians a second from 0 to 200"},
	{"amplitude", character_read_number, SHAKE(swing.preset.amplitude), 0,
		4, .right = "a number from 0 to 4"},
	{"attenuation", character_read_number, SHAKE(swing.preset.attenuation),
		-2, 2, .right = "a number from -2 to 2"},
	{"modifier", character_read_number, SHAKE(swing.preset.modifier), 0, 4,
		.right = "a number from 0 to 4"},
	{"translation", character_read_numbers3, SHAKE(swing.preset.translation),
		.right = "x y z in units, such as 0 1 0"},
	{"rotation", character_read_numbers3, SHAKE(swing.preset.rotation),
		.right = "radians about x, y and z, such as 0 0.1 0"},
	{"unit", character_read_number, SHAKE(swing.preset.unit),
		.right = "metres, such as 0.01"},
	{"delay", character_read_number, SHAKE(delay_s), 0, 10,
		.right = "seconds from 0 to 10"},
	{"presets", read_presets,
		.right = "the name of a file in the same folder, such as presets.ini"},
	{0},
};

static int build_shake(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_shake *shake = what;
	struct procedural_preset preset = procedural_preset_default();
	int error;

	build->character->shake[build->character->shake_count++] = shake;
	preset.unit = 0.01f * build->character->metre;
	shake->swing = procedural_begin(&preset, -1);
	error = character_read_section(build, section, shake_keys, shake);
	if (!error && shake->swing.node < 0) {
		error = character_fail_missing(build, section, "bone = NODE");
	}
	if (!error) {
		use_units_of_bone(build, shake);
	}
	return error;
}

static int read_turn_bones(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_turn *turn = member;

	do {
		int error;

		if (turn->bone_count == CHARACTER_BONES_MAX) {
			return character_fail(words,
				"there are at most %d bones",
				CHARACTER_BONES_MAX);
		}
		error = character_read_node(
			words, key, &turn->bone[turn->bone_count++]);
		if (error) {
			return error;
		}
	} while (character_take(words, ","));
	return 0;
}

static const char *const turn_from[] = {"clip", "rest", NULL};

static const struct character_key turn_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_turn, is),
	{"bone", read_turn_bones, .right = "nodes, with commas between"},
	{"axis", character_read_direction, offsetof(struct character_turn, axis),
		.right = "x y z of the model at rest, such as 1 0 0"},
	{"from", character_read_choice, offsetof(struct character_turn, from),
		.choice = turn_from, .right = "clip or rest"},
	{"angle", character_read_angle,
		offsetof(struct character_turn, angle_rad), -360, 360,
		.right = "degrees from -360 to 360"},
	{0},
};

static int build_turn(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_turn *turn = what;
	int error;

	turn->axis[0] = 1;
	turn->angle_rad = 0.5f;
	error = character_read_section(build, section, turn_keys, turn);
	for (int i = 0; i < turn->bone_count && !error; i++) {
		character_to_bone(
			build, turn->bone[i], turn->axis, turn->bone_axis[i]);
	}
	return error || turn->bone_count > 0
		? error
		: character_fail_missing(build, section, "bone = NODE");
}

static int read_spring_bones(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_spring *effect = member;
	struct spring made;
	float count;
	int last;
	int error = character_read_node(words, key, &last);

	if (error) {
		return error;
	}
	if (!character_take_number(words, &count) ||
		spring_init(&made, words->build->model, last, (int)count) != 0) {
		return character_fail(words,
			"the number of bones is from 1 to %d, and the last one has so many above it: give %s",
			SPRING_MAX, key->right);
	}
	made.gravity[1] *= words->build->character->metre;
	effect->spring = made;
	return 0;
}

/* body = NODE NODE RADIUS [X Y Z]: a capsule that the bones do not enter. */
static int read_body(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_spring *effect = member;

	if (effect->body_count == CHARACTER_BONES_MAX) {
		return character_fail(words, "there are at most %d bodies",
			CHARACTER_BONES_MAX);
	}
	return character_read_capsule(
		words, key, &effect->body[effect->body_count++]);
}

#define SPRING(name) offsetof(struct character_spring, spring.name)

static const struct character_key spring_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_spring, is),
	{"bones", read_spring_bones,
		.right = "the last bone and the number of bones, such as ponytail.4 4"},
	{"frequency", character_read_number, SPRING(frequency_hz), 0, 15,
		.right = "Hz from 0 to 15"},
	{"damping", character_read_number, SPRING(damping), 0, 10,
		.right = "a ratio from 0 to 10"},
	{"gravity", character_read_numbers3, SPRING(gravity),
		.right = "x y z in m/s2, such as 0 -9.81 0"},
	{"limit", character_read_angle, SPRING(limit_rad), 0, 180,
		.right = "degrees from 0 to 180"},
	{"radius", character_read_number, SPRING(radius), 0,
		CHARACTER_LENGTH_MAX, .right = "metres kept from bodies"},
	{"body", read_body,
		.right = "two nodes and a radius, such as hips chest 0.13"},
	{0},
};

/* The line "bones" makes the spring, so it is read before the others. */
static int build_spring(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_spring *effect = what;

	int error;

	if (!section->first || strcmp(section->first->key, "bones") != 0) {
		return character_fail_missing(
			build, section, "bones = LAST COUNT as its first line");
	}
	error = character_read_section(build, section, spring_keys, effect);

	memcpy(effect->gravity, effect->spring.gravity, sizeof(effect->gravity));
	return error;
}

#define BREATH(name) offsetof(struct character_breath, breath.name)

static const struct character_key breath_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_breath, is),
	{"bone", character_read_node, BREATH(chest),
		.right = "the name of a node"},
	{"rate", character_read_number, BREATH(rate_hz), 0, 10,
		.right = "breaths a second from 0 to 10"},
	{"swell", character_read_numbers3, BREATH(swell),
		.right = "growth along x, y and z, such as 0.02 0.01 0.05"},
	{"lift", character_read_angle, BREATH(lift_rad), -45, 45,
		.right = "degrees from -45 to 45"},
	{0},
};

static int build_breath(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_breath *effect = what;
	int error;

	effect->breath = breath_default(-1);
	error = character_read_section(build, section, breath_keys, effect);
	return error || effect->breath.chest >= 0
		? error
		: character_fail_missing(build, section, "bone = NODE");
}

#define MUSCLE(name) offsetof(struct character_muscle, name)

static const struct character_key muscle_keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_muscle, is),
	{"joint", character_read_node, MUSCLE(muscle.joint),
		.right = "the node whose bend drives the muscle"},
	{"bone", character_read_node, MUSCLE(muscle.node),
		.right = "the node that swells"},
	{"from", character_read_angle, MUSCLE(muscle.from_rad), 0, 180,
		.right = "degrees from 0 to 180"},
	{"to", character_read_angle, MUSCLE(muscle.to_rad), 0, 180,
		.right = "degrees from 0 to 180"},
	{"swell", character_read_numbers3, MUSCLE(swell),
		.right = "growth along x, y and z, such as 0.16 0 0.16"},
	{0},
};

static int build_muscle(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_muscle *effect = what;
	int error;

	effect->muscle = (struct muscle){.joint = -1,
		.node = -1,
		.weight = -1,
		.from_rad = 0.3f,
		.to_rad = 1.6f};
	error = character_read_section(build, section, muscle_keys, effect);
	if (error) {
		return error;
	}
	return effect->muscle.joint < 0 || effect->muscle.node < 0
		? character_fail_missing(
			  build, section, "joint = NODE and bone = NODE")
		: 0;
}

static const struct {
	const char *kind;
	size_t size;
	enum character_stage stage;
	int (*build)(struct character_build *build,
		const struct character_section *section, void *effect);
	void (*run)(struct character *character, void *effect);
} effects[] = {
	{"shake", sizeof(struct character_shake), CHARACTER_STAGE_BONE,
		build_shake, character_shake_run},
	{"turn", sizeof(struct character_turn), CHARACTER_STAGE_BONE,
		build_turn, character_turn_run},
	{"breath", sizeof(struct character_breath), CHARACTER_STAGE_BONE,
		build_breath, character_breath_run},
	{"muscle", sizeof(struct character_muscle), CHARACTER_STAGE_BONE,
		build_muscle, character_muscle_run},
	{"feet", sizeof(struct character_feet), CHARACTER_STAGE_WORLD,
		character_build_feet, character_feet_run},
	{"look", sizeof(struct character_look), CHARACTER_STAGE_WORLD,
		character_build_look, character_look_run},
	{"reach", sizeof(struct character_reach), CHARACTER_STAGE_WORLD,
		character_build_reach, character_reach_run},
	{"spring", sizeof(struct character_spring), CHARACTER_STAGE_WORLD,
		build_spring, character_spring_run},
};

static int build_effect(struct character_build *build,
	const struct character_section *section, size_t kind)
{
	/* Every effect begins with its switch. */
	void *effect = arena_alloc(build->arena, 1, effects[kind].size);
	int error;

	if (!effect) {
		return character_fail_memory(build);
	}
	error = character_add_switch(build, section, effect);
	if (!error) {
		error = effects[kind].build(build, section, effect);
	}
	if (!error) {
		character_add_op(
			build, effects[kind].stage, effects[kind].run, effect);
	}
	return error;
}

int character_build_effects(struct character_build *build)
{
	struct character *character = build->character;
	int error = 0;

	character->shake = ARENA_ARRAY(build->arena, struct character_shake *,
		(size_t)character_text_count(build->text, "shake"));
	if (!character->shake) {
		return character_fail_memory(build);
	}

	for (size_t kind = 0; kind < ARRAY_COUNT(effects) && !error; kind++) {
		const struct character_section *section = character_text_find(
			build->text->first, effects[kind].kind);

		while (section && !error) {
			error = build_effect(build, section, kind);
			section = character_text_find(
				section->next, effects[kind].kind);
		}
	}
	return error;
}
