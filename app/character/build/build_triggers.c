#include "app/character/build/build.h"

static const struct character_key keys[] = {
	{"when", character_read_condition,
		offsetof(struct character_trigger, when), 0, 0, NULL,
		"a comparison: speed > 2, speed < 1 or chosen is arm"},
	{"then", character_read_actions, offsetof(struct character_trigger, then),
		0, 0, NULL, "actions, such as attach Crate Hand"},
	{"else", character_read_actions,
		offsetof(struct character_trigger, otherwise), 0, 0, NULL,
		"actions, such as drop Crate"},
	{0},
};

int character_build_triggers(struct character_build *build)
{
	struct character *character = build->character;
	const struct character_section *section =
		character_text_find(build->text->first, "trigger");
	int error = 0;

	character->trigger_count = character_text_count(build->text, "trigger");
	character->trigger = ARENA_ARRAY(build->arena, struct character_trigger,
		(size_t)character->trigger_count);
	if (!character->trigger) {
		return character_fail_memory(build);
	}
	for (int i = 0; section && !error; i++) {
		struct character_trigger *trigger = &character->trigger[i];

		trigger->name = section->name;
		error = character_read_section(build, section, keys, trigger);
		if (!error && !trigger->when) {
			return character_fail_missing(
				build, section, "when = VALUE > VALUE");
		}
		section = character_text_find(section->next, "trigger");
	}
	return error;
}
