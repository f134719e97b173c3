/*
 * A machine of states of one clip of 2 s each, frame by frame. The clip of
 * state s gives a morph weight the value 10 s + t after t seconds; the rest
 * pose gives it 100.
 */
#ifndef TESTS_UNIT_APP_CHARACTER_STATE_STATES_H
#define TESTS_UNIT_APP_CHARACTER_STATE_STATES_H

#include "app/character/state/machine.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	STATES = 4,
	ENTRIES = 3
};

static const float step_s = 0.25f;

struct states {
	struct bones bones;
	float value[STATES][2];
	struct model_channel channel[STATES];
	struct model_clip clip[STATES];
	struct character_clip of[STATES];
	struct clip_cursor cursor[ENTRIES];
	struct character_entry entry[STATES][ENTRIES];
	uint8_t paths[STATES][1];
	float rate[STATES], position[STATES];
	struct character_action enter[STATES], leave[STATES];
	struct character_state state[STATES];
	struct character_transition transition[4];
	struct instance instance;
	struct character character;
};

static const float key_s[2] = {0, 2};

/* Gives a clip another length; one of 0 becomes the rest pose. */
static inline void states_shorten(struct states *f, int i, float duration_s)
{
	f->clip[i].duration_s = duration_s;
	if (duration_s == 0) {
		f->of[i].clip = NULL;
	}
}

static inline void make_clip(struct states *f, int i)
{
	f->value[i][0] = 10 * (float)i;
	f->value[i][1] = 10 * (float)i + 2;
	f->channel[i] = (struct model_channel){.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = 1,
		.key_count = 2,
		.time_s = key_s,
		.value = f->value[i]};
	f->clip[i] = (struct model_clip){.name = "clip",
		.duration_s = 2,
		.channel_count = 1,
		.channel = &f->channel[i]};
	f->of[i].clip = &f->clip[i];
}

static inline void make_state(struct states *f, int s)
{
	f->rate[s] = 1;
	/* Actions that concern no state. */
	f->enter[s].verb = f->leave[s].verb = CHARACTER_LABELS;
	f->enter[s].index = s;
	f->leave[s].index = 10 + s;
	for (int i = 0; i < ENTRIES; i++) {
		f->entry[s][i] = (struct character_entry){.of = &f->of[s],
			.at = (float)i,
			.cursor = &f->cursor[i]};
	}
	f->state[s] = (struct character_state){.name = "state",
		.entry_count = 1,
		.entry = f->entry[s],
		.paths = f->paths[s],
		.position = &f->position[s],
		.rate = &f->rate[s],
		.repeat = CLIP_LOOP,
		.next = -1,
		.enter = &f->enter[s],
		.leave = &f->leave[s]};
}

static inline void states_begin(struct states *f)
{
	struct bones *bones = &f->bones;
	struct character *character = &f->character;
	struct character_machine *machine = &character->machine;
	struct arena *arena = &bones->model.arena;

	memset(f, 0, sizeof(*f));
	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones->node[0].mesh = 0;
	bones->model.weight_count = 1;
	bones->rest_weights[0] = 100;
	bones->mesh[0].target_count = 1;
	for (int i = 0; i < STATES; i++) {
		make_clip(f, i);
		make_state(f, i);
	}
	bones->model.clip = f->clip;
	bones->model.clip_count = STATES;
	bones_pose(bones);
	for (int i = 0; i < ENTRIES; i++) {
		assert_int_equal(
			clip_cursor_init(&f->cursor[i], &bones->model, arena),
			0);
	}
	assert_int_equal(pose_init(&character->still, &bones->model, arena), 0);
	assert_int_equal(
		inertia_init(&machine->inertia, &bones->model, arena), 0);
	f->instance.pose = bones->pose;
	f->instance.model = &bones->model;
	character->instance = &f->instance;
	character->motion.root = -1;
	machine->state = f->state;
	machine->state_count = STATES;
	machine->transition = f->transition;
	machine->wanted = machine->running = -1;
	machine->fresh = true;
}

static inline void states_end(struct states *f)
{
	bones_end(&f->bones);
}

/* Updates so often. Returns what is shown then. */
static inline float states_run(struct states *f, int frames)
{
	f->character.step_s = step_s;
	f->character.exact_s = (double)step_s;
	for (int i = 0; i < frames; i++) {
		f->character.pending_count = 0;
		character_machine_update(&f->character);
	}
	return f->instance.pose.weight[0];
}

#endif
