#include "app/character/run/triggers.h"

#include "app/character/run/condition.h"
#include "app/character/run/pending.h"

void character_triggers_update(struct character *character)
{
	for (int i = 0; i < character->trigger_count; i++) {
		struct character_trigger *trigger = &character->trigger[i];
		bool holds = character_condition_holds(trigger->when);

		if (character->seen_triggers && holds != trigger->held) {
			character_pending_add(character,
				holds ? trigger->then : trigger->otherwise, 1);
		}
		trigger->held = holds;
	}
	character->seen_triggers = true;
}
