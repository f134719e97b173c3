/*
 * Compiles a character: reads its text, runs the steps of the compilation in
 * their order, and sets the character to its start.
 */
#include "app/character/build/build.h"

#include "app/character/character.h"
#include "app/character/run/pending.h"

#include <errno.h>
#include <stdlib.h>

static int build_all(struct character_build *build)
{
	static int (*const steps[])(struct character_build * build) = {
		character_build_names,
		character_build_part_list,
		character_build_parameters,
		character_build_motion,
		character_build_clip_list,
		character_build_targets,
		character_build_parts,
		character_build_morphs,
		character_build_outputs,
		character_build_layers,
		character_build_expressions,
		character_build_effects,
		character_build_capes,
		character_build_states,
		character_build_clips,
		character_build_sequences,
		character_build_triggers,
		character_build_buttons,
		character_build_scene,
	};
	int error = 0;

	for (size_t i = 0; i < ARRAY_COUNT(steps) && !error; i++) {
		error = steps[i](build);
	}
	return error;
}

/* The poses that a frame works in. */
static int init_poses(struct character_build *build)
{
	struct character *character = build->character;

	return pose_init(&character->scratch, build->model, build->arena) ||
			pose_init(&character->still, build->model, build->arena)
		? character_fail_memory(build)
		: 0;
}

static int read_text(struct character *character, FILE *file, const char *path,
	const struct log *log)
{
	return file ? character_text_read(&character->text, &character->arena,
			      file, path, false, log)
		    : character_text_load(
			      &character->text, &character->arena, path, log);
}

static int create(FILE *file, const char *path, struct instance *instance,
	const struct log *log, struct character **out)
{
	struct character *character = calloc(1, sizeof(*character));
	struct character_build build = {
		.character = character,
		.model = instance->model,
		.log = log,
	};
	int error;

	*out = NULL;
	if (!character) {
		log_error(log, "%s: there is not enough memory", path);
		return -ENOMEM;
	}
	character->arena = arena_within(instance->model->budget);
	character->instance = instance;
	build.text = &character->text;
	build.arena = &character->arena;
	pose_rest(&instance->pose, instance->model);
	instance_update_nodes(instance);
	error = read_text(character, file, path, log);
	if (!error) {
		error = init_poses(&build);
	}
	if (!error) {
		error = build_all(&build);
	}
	if (error) {
		character_destroy(character);
		return error;
	}
	character_start_switches(character);
	character_pending_add(character, character->machine.state[0].enter, 1);
	*out = character;
	return 0;
}

int character_load(const char *path, struct instance *instance,
	const struct log *log, struct character **out)
{
	return create(NULL, path, instance, log, out);
}

int character_read(FILE *file, const char *path, struct instance *instance,
	const struct log *log, struct character **out)
{
	return create(file, path, instance, log, out);
}
