/*
 * Looks up names: of the model's nodes, clips and targets, and of the file's
 * sections and switches. Also keeps the lists of switches and operations.
 */
#include "app/anim/procedural/bone.h"
#include "app/character/build/build.h"
#include "platform/base/name_list.h"
#include "platform/base/printable.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const char *character_own_name(
	const struct character_build *build, const char *name)
{
	const struct character_section *names =
		character_text_find(build->text->first, "names");
	const char *own = name;

	/* The last line counts: it stands below those of included files. */
	for (const struct character_line *line = names ? names->first : NULL;
		line; line = line->next) {
		if (line->word_count > 0 && strcmp(line->key, name) == 0) {
			own = line->word[0].text;
		}
	}
	return own;
}

enum {
	NAME_BYTES = 256 /* more than a line has */
};

/*
 * Whether a message cannot show the name's letters, as those of a file that was
 * saved in Latin-1.
 */
static bool is_garbled(const char *name)
{
	char shown[NAME_BYTES];

	if (strlen(name) >= sizeof(shown)) {
		return false;
	}
	strcpy(shown, name);
	printable_make(shown);
	return strcmp(shown, name) != 0;
}

/*
 * Fails because nothing has the name, which is "" if the line has none.
 * add_all() adds the names that there are.
 */
static int fail_name(struct character_words *words, const char *what,
	const char *name,
	void (*add_all)(struct name_choice *choice, const void *context),
	const void *context)
{
	struct name_choice choice = {.wanted = name};
	const struct name_list *list = &choice.list;
	const char *are;

	name_choice_list(&choice, add_all, context);
	are = strstr(list->text, ", ") ? "are" : "is only";
	if (is_garbled(name)) {
		character_fail(words,
			"there is no %s named %s: if this file is not in UTF-8, save it as UTF-8",
			what, name);
	} else if (!list->text[0]) {
		character_fail(words,
			"there is no %s named %s: no %s of the model has a name",
			what, name, what);
	} else if (!name[0]) {
		character_fail(words, "the %s's name is missing: there %s %s",
			what, are, list->text);
	} else {
		character_fail(words, "there is no %s named %s: there %s %s",
			what, name, are, list->text);
	}
	return -1;
}

static void add_named(struct name_choice *choice, const char *name, int number)
{
	char text[16];

	if (name[0]) {
		name_choice_add(choice, name);
	} else {
		snprintf(text, sizeof(text), "%d", number);
		name_choice_add(choice, text);
	}
}

static void add_nodes(struct name_choice *choice, const void *context)
{
	const struct model *model = context;

	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].name[0]) {
			name_choice_add(choice, model->node[i].name);
		}
	}
}

static void add_clips(struct name_choice *choice, const void *context)
{
	const struct model *model = context;

	for (int i = 0; i < model->clip_count; i++) {
		add_named(choice, model->clip[i].name, i);
	}
	name_choice_add(choice, "rest");
}

static void add_targets(struct name_choice *choice, const void *context)
{
	const struct model_mesh *mesh = context;

	for (int i = 0; i < mesh->target_count; i++) {
		add_named(choice, mesh->target_name[i], i);
	}
}

/* Adds the names of the section and of those below it of the same kind. */
static void add_sections(struct name_choice *choice, const void *context)
{
	const struct character_section *section = context;
	const char *kind = section->kind;

	for (; section; section = character_text_find(section->next, kind)) {
		name_choice_add(choice, section->name);
	}
}

int character_name_node(struct character_words *words)
{
	const struct character_build *build = words->build;
	const char *word = character_next_word(words);
	const char *name = word ? character_own_name(build, word) : "";
	int node = model_find_node(build->model, name);

	return node >= 0 && name[0]
		? node
		: fail_name(words, "node", name, add_nodes, build->model);
}

int character_name_clip(struct character_words *words)
{
	const struct character_build *build = words->build;
	const char *word = character_next_word(words);
	const char *name = word ? character_own_name(build, word) : "";
	int clip = word ? model_find_clip(build->model, name) : -1;

	if (clip >= 0) {
		return clip;
	}
	return word && strcmp(word, "rest") == 0
		? -2
		: fail_name(words, "clip", name, add_clips, build->model);
}

int character_name_target(struct character_words *words, int node)
{
	const struct character_build *build = words->build;
	const struct model_mesh *mesh =
		&build->model->mesh[build->model->node[node].mesh];
	const char *word = character_next_word(words);
	const char *name = word ? character_own_name(build, word) : "";
	char *end;
	long number;

	for (int i = 0; i < mesh->target_count; i++) {
		if (name[0] && strcmp(mesh->target_name[i], name) == 0) {
			return i;
		}
	}
	number = strtol(name, &end, 10);
	if (*name && !*end && number >= 0 && number < mesh->target_count) {
		return (int)number;
	}
	return fail_name(words, "morph target", name, add_targets, mesh);
}

int character_name_section(struct character_words *words, const char *kind)
{
	const struct character_section *first =
		character_text_find(words->build->text->first, kind);
	const struct character_section *section = first;
	const char *name = character_next_word(words);

	for (int i = 0; section; i++) {
		if (name && strcmp(section->name, name) == 0) {
			return i;
		}
		section = character_text_find(section->next, kind);
	}
	if (!first) {
		const char *missing = name && name[0] ? name : "NAME";

		character_fail(words,
			"there is no %s named %s: add a section [%s %s]", kind,
			missing, kind, missing);
		return -1;
	}
	return fail_name(words, kind, name ? name : "", add_sections, first);
}

int character_name_state(struct character_words *words)
{
	return character_name_section(words, "state");
}

int character_name_in_heading(struct character_build *build,
	const struct character_section *section, const char *key,
	const char *name, int (*find)(struct character_words *words))
{
	struct character_word word = {name, true};
	struct character_line line = {.file = section->file,
		.number = section->number,
		.section = section->heading,
		.key = key,
		.word_count = 1,
		.word = &word};
	struct character_words words = {build, &line, 0};

	return find(&words);
}

static bool is_switch(const char *kind)
{
	static const char *const switches[] = {"layer", "expression", "shake",
		"look", "reach", "turn", "spring", "breath", "muscle", "feet",
		"cape"};

	for (size_t i = 0; i < ARRAY_COUNT(switches); i++) {
		if (strcmp(kind, switches[i]) == 0) {
			return true;
		}
	}
	return false;
}

int character_find_switch(const struct character_build *build, const char *name)
{
	int index = 0;

	for (const struct character_section *section = build->text->first;
		section; section = section->next) {
		if (is_switch(section->kind)) {
			if (strcmp(section->name, name) == 0) {
				return index;
			}
			index++;
		}
	}
	return -1;
}

int character_add_switch(struct character_build *build,
	const struct character_section *section, struct character_switch *is)
{
	static const float whole = 1;
	int index = character_find_switch(build, section->name);
	struct character *character = build->character;

	if (character->switches[index]) {
		return character_fail_section(build, section,
			"there already is a [%s %s]: give this one another name",
			character->switches[index]->kind, section->name);
	}
	*is = (struct character_switch){
		.name = section->name,
		.kind = section->kind,
		.weight = &whole,
		.fade_s = 0.4f,
		.on = true,
	};
	character->switches[index] = is;
	return 0;
}

void character_start_switches(struct character *character)
{
	for (int i = 0; i < character->switch_count; i++) {
		struct character_switch *is = character->switches[i];

		is->is_on = is->on;
		is->level = is->on ? 1 : 0;
		is->now = is->level * *is->weight;
	}
}

static const char *const kinds[] = {"character", "names", "parameter", "clip",
	"state", "transition", "layer", "expression", "morph", "part",
	"sequence", "trigger", "target", "shake", "look", "reach", "turn",
	"spring", "breath", "muscle", "feet", "cape", "output", "motion",
	"scene", "buttons", NULL};

/* Kinds of which there may be several, each with a name. */
static bool is_named(const char *kind)
{
	static const char *const single[] = {
		"character", "names", "motion", "scene", "buttons"};

	for (size_t i = 0; i < ARRAY_COUNT(single); i++) {
		if (strcmp(kind, single[i]) == 0) {
			return false;
		}
	}
	return true;
}

static int check_section(
	struct character_build *build, const struct character_section *section)
{
	bool two = strcmp(section->kind, "transition") == 0;
	bool has_name = section->name[0], has_other = section->other[0];
	struct name_list list = {""};
	int i = 0;

	for (; kinds[i] && strcmp(kinds[i], section->kind) != 0; i++) {
		name_list_add(&list, kinds[i]);
	}
	if (!kinds[i]) {
		return character_fail_section(build, section,
			"there is no such kind of section: use one of %s",
			list.text);
	}
	/* Buttons may have a name, for those that depend on a parameter. */
	if (strcmp(section->kind, "buttons") == 0 && !has_other) {
		return 0;
	}
	if (is_named(section->kind) != has_name || two != has_other) {
		return character_fail_section(build, section,
			two ? "write [transition FROM TO]"
				: is_named(section->kind)
				? "this kind of section has one name: write [KIND NAME]"
				: "this kind of section has no name: write [KIND]");
	}
	return 0;
}

int character_build_names(struct character_build *build)
{
	struct character *character = build->character;
	size_t sections = 0;
	int error = 0;

	for (const struct character_section *section = build->text->first;
		section && !error; section = section->next) {
		error = check_section(build, section);
		character->switch_count += is_switch(section->kind);
		sections++;
	}
	if (error) {
		return error;
	}
	character->switches = ARENA_ARRAY(build->arena,
		struct character_switch *, (size_t)character->switch_count);
	/*
	 * One more than sections: those of parts have two together.
	 */
	character->op =
		ARENA_ARRAY(build->arena, struct character_op, sections + 1);
	return character->switches && character->op
		? 0
		: character_fail_memory(build);
}

/* Operations run by stages, and within one in the order they were added. */
void character_add_op(struct character_build *build, enum character_stage stage,
	void (*run)(struct character *character, void *what), void *what)
{
	struct character *character = build->character;
	int at = character->op_count++;

	for (; at > 0 && character->op[at - 1].stage > stage; at--) {
		character->op[at] = character->op[at - 1];
	}
	character->op[at] =
		(struct character_op){.stage = stage, .run = run, .what = what};
}

/* The world matrices must be those of the rest pose. */
void character_to_bone(const struct character_build *build, int node,
	const float direction[3], float out[3])
{
	bone_to_axes((const mat4 *)build->character->instance->world, node,
		direction, out);
}
