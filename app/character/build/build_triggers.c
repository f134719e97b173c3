/*
 * Sections [trigger].
 */
#include "app/character/build/build.h"

static const struct character_key keys[] = {
	{"when", character_read_condition,
		offsetof(struct character_trigger, when),
		.right = "a comparison: speed > 2, speed < 1 or chosen is arm"},
	{"then", character_read_actions, offsetof(struct character_trigger, then),
		.right = "actions, such as attach Crate Hand"},
	{"else", character_read_actions,
		offsetof(struct character_trigger, otherwise),
		.right = "actions, such as drop Crate"},
	{0},
};

static int read_trigger(struct character_build *build,
	const struct character_section *section, void *one)
{
	struct character_trigger *trigger = one;
	int error = character_read_section(build, section, keys, trigger);

	return error || trigger->when
		? error
		: character_fail_missing(build, section, "when = VALUE > VALUE");
}

int character_build_triggers(struct character_build *build)
{
	static const struct character_kind kind = {
		"trigger", sizeof(struct character_trigger), read_trigger};

	return character_read_kind(build, &kind,
		&build->character->trigger_count, &build->character->trigger);
}
