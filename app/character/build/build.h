/*
 * Compiling a character: what the files of this folder share.
 *
 * First all sections with names are counted and their structs allocated, so
 * that a line may name what stands below it. Then each kind of section is read
 * by a table of its keys. An error is logged once, where a word is wrong, with
 * file, line, key and what would be right.
 */
#ifndef APP_CHARACTER_BUILD_BUILD_H
#define APP_CHARACTER_BUILD_BUILD_H

#include "app/anim/procedural/capsule.h"
#include "app/character/character_data.h"
#include "app/character/text/character_text.h"

struct character_build {
	const struct character_text *text;
	struct character *character;
	const struct model *model;
	struct arena *arena; /* the character's */
	const struct log *log;
};

/* The words of a line that are left to read. */
struct character_words {
	struct character_build *build;
	const struct character_line *line;
	int next;
};

/*
 * A key of a section. read() takes words and writes the member that lies
 * .member bytes behind the section's struct; it returns 0, or -errno after
 * logging an error. The other members are parameters of read().
 */
struct character_key {
	const char *name;
	int (*read)(struct character_words *words,
		const struct character_key *key, void *member);
	size_t member;
	float low, high;           /* of numbers; equal: any number */
	const char *const *choice; /* of character_read_choice(), ends NULL */
	const char *right;         /* an example of a right value */
};

/*
 * Returns 0, or -EINVAL after logging that an earlier line of the same file has
 * this key.
 */
int character_check_once(
	const struct character_section *section, struct character_words *words);

/*
 * Reads all lines of a section into out by a table of keys that ends with a
 * NULL name. Words that are left in a line are an error.
 */
int character_read_section(struct character_build *build,
	const struct character_section *section,
	const struct character_key *keys, void *out);

/*
 * A kind of section, and the size of the struct that each of them is read into.
 */
struct character_kind {
	const char *name;
	size_t size;
	/* Reads one section into its struct, which is all zero. 0 or -errno. */
	int (*read)(struct character_build *build,
		const struct character_section *section, void *one);
};

/*
 * Makes an array of all sections of a kind. *count becomes their number and
 * *(TYPE **)array their structs, both before the first one is read, so that a
 * section may name any other one. Returns 0, or -errno after logging an error.
 */
int character_read_kind(struct character_build *build,
	const struct character_kind *kind, int *count, void *array);

/* Logs "FILE:LINE: [section] key: SENTENCE" and returns -EINVAL. */
int character_fail(const struct character_words *words, const char *format, ...)
	PRINTF_LIKE(2, 3);

/* Logs that memory is short and returns -ENOMEM. */
int character_fail_memory(const struct character_build *build);

/* Fails for a section as a whole. */
int character_fail_section(struct character_build *build,
	const struct character_section *section, const char *format, ...)
	PRINTF_LIKE(3, 4);

/* Fails because a section lacks a line. */
int character_fail_missing(struct character_build *build,
	const struct character_section *section, const char *what);

/* Fails because the next word is not what the key needs. */
int character_fail_value(
	const struct character_words *words, const struct character_key *key);

/*
 * Takes the next word. Returns NULL at the end of the line or before a comma.
 */
const char *character_next_word(struct character_words *words);
/* Returns true if the next word, not in quotes, is this one. */
bool character_next_is(const struct character_words *words, const char *word);

/* Takes the word if it is the next one. */
bool character_take(struct character_words *words, const char *word);

/* Returns true if all words of the line have been taken. */
bool character_at_end(const struct character_words *words);

/* The longest length of a file, whatever unit the model has. */
#define CHARACTER_LENGTH_MAX 1e6f

/* Takes a number between -1e9 and 1e9, or returns false and takes nothing. */
bool character_take_number(struct character_words *words, float *out);
/* The same, but a number outside of low..high is not taken either. */
bool character_take_within(
	struct character_words *words, float low, float high, float *out);

/* Readers for tables; the member has the type in brackets. */
int character_read_number(struct character_words *words,
	const struct character_key *key, void *member); /* float */
int character_read_numbers2(struct character_words *words,
	const struct character_key *key, void *member); /* float[2] */
int character_read_numbers3(struct character_words *words,
	const struct character_key *key, void *member); /* float[3] */
int character_read_angle(struct character_words *words,
	const struct character_key *key, void *member); /* float, radians */
int character_read_direction(struct character_words *words,
	const struct character_key *key, void *member); /* float[3], unit */
int character_read_count(struct character_words *words,
	const struct character_key *key, void *member); /* int */
int character_read_switch(struct character_words *words,
	const struct character_key *key, void *member); /* bool: yes or no */
int character_read_unlabelled(struct character_words *words,
	const struct character_key *key, void *member); /* bool: no or yes */
int character_read_choice(struct character_words *words,
	const struct character_key *key, void *member); /* int: its index */
int character_read_value(struct character_words *words,
	const struct character_key *key, void *member); /* const float * */
int character_read_node(struct character_words *words,
	const struct character_key *key, void *member); /* int */
int character_read_state(struct character_words *words,
	const struct character_key *key, void *member); /* int */
int character_read_fade(struct character_words *words,
	const struct character_key *key, void *member); /* struct .._fade */
int character_read_condition(struct character_words *words,
	const struct character_key *key,
	void *member); /* .._condition *, adds */
int character_read_curve(struct character_words *words,
	const struct character_key *key, void *member); /* .._morph, adds */
int character_read_curve_direction(struct character_words *words,
	const struct character_key *key, void *member); /* .._morph */
int character_read_actions(struct character_words *words,
	const struct character_key *key, void *member); /* .._action *, adds */

/*
 * Reads NODE NODE RADIUS [X Y Z], a capsule from node to node, both ends of
 * which are moved by x y z in their nodes' frames. 0 or -EINVAL.
 */
int character_read_capsule(struct character_words *words,
	const struct character_key *key, struct capsule *capsule);

/* Reads UPPER LOWER TIP, each below the one before. 0 or -EINVAL. */
struct ik_limb;
int character_read_limb(struct character_words *words,
	const struct character_key *key, struct ik_limb *limb);

/*
 * Takes the name of one of a parameter's choices and stores its value; returns
 * false for any other word.
 */
bool character_take_choice(struct character_words *words,
	const struct character_parameter *parameter, float *out);

/*
 * Names. Each returns an index, or -1 after an error that lists the names
 * that there are. A name is first looked up in [names].
 */
int character_name_node(struct character_words *words);
int character_name_clip(struct character_words *words); /* -2: rest pose */
int character_name_target(struct character_words *words, int node);
int character_name_section(struct character_words *words, const char *kind);
int character_name_state(struct character_words *words);

/*
 * Looks up a name of a section's heading by one of the functions above; key
 * stands in error messages.
 */
int character_name_in_heading(struct character_build *build,
	const struct character_section *section, const char *key,
	const char *name, int (*find)(struct character_words *words));

/*
 * Reads a part and one of its degrees of freedom. Returns the latter, or
 * -EINVAL after an error.
 */
int character_read_freedom(struct character_words *words, int *part);

/*
 * Returns the index of a switch by its section's name, or -1 without an error.
 */
int character_find_switch(const struct character_build *build, const char *name);

/* Returns the model's own name for a name of the file, see [names]. */
const char *character_own_name(
	const struct character_build *build, const char *name);

/*
 * Reads one action, to the end of the line or to a comma, and adds it to the
 * list. is_held, which may be NULL, is set for actions that go on while a
 * button is held.
 */
int character_read_action(struct character_words *words,
	struct character_action **list, bool *is_held);

/* The steps of a compilation, in their order. */
int character_build_names(struct character_build *build);
int character_build_part_list(struct character_build *build);
int character_build_parameters(struct character_build *build);
int character_build_motion(struct character_build *build);
int character_build_clip_list(struct character_build *build);
int character_build_targets(struct character_build *build);
int character_build_parts(struct character_build *build);
int character_build_morphs(struct character_build *build);
int character_build_outputs(struct character_build *build);
int character_build_layers(struct character_build *build);
int character_build_expressions(struct character_build *build);
int character_build_effects(struct character_build *build);
int character_build_look(struct character_build *build,
	const struct character_section *section, void *look);
int character_build_feet(struct character_build *build,
	const struct character_section *section, void *feet);
int character_build_reach(struct character_build *build,
	const struct character_section *section, void *reach);
int character_build_capes(struct character_build *build);
int character_build_clips(struct character_build *build);
int character_build_states(struct character_build *build);
int character_build_triggers(struct character_build *build);
int character_build_sequences(struct character_build *build);
int character_build_scene(struct character_build *build);
int character_build_buttons(struct character_build *build);

/*
 * Adds an operation at the end of its stage. The list has room for one
 * operation for each section of the text.
 */
void character_add_op(struct character_build *build, enum character_stage stage,
	void (*run)(struct character *character, void *what), void *what);

/*
 * Initialises a switch with its defaults and makes it one of the character's.
 * -EINVAL after an error if the section's name is that of another switch.
 */
int character_add_switch(struct character_build *build,
	const struct character_section *section, struct character_switch *is);

/* Sets all switches to what their sections say. */
void character_start_switches(struct character *character);

/* Converts a direction of the model at rest to the frame of a bone at rest. */
void character_to_bone(const struct character_build *build, int node,
	const float direction[3], float out[3]);

/* Initialises an entry without a cursor. clip -2 is the rest pose. */
void character_init_entry(const struct character_build *build, int clip,
	struct character_entry *entry);

/* Makes cursors for clips that play at once. Returns NULL after an error. */
struct clip_cursor *character_make_cursors(
	struct character_build *build, int count);

/* The keys that all sections with a switch have; member is that of the switch. */
#define CHARACTER_SWITCH_KEYS(type, member)                                    \
	{"weight", character_read_value, offsetof(type, member.weight), 0, 1,  \
		.right = "a number from 0 to 1, or a parameter"},              \
		{"fade", character_read_number, offsetof(type, member.fade_s), \
			0, 60, .right = "seconds, such as 0.4"},               \
		{"label", character_read_unlabelled,                           \
			offsetof(type, member.unlabelled),                     \
			.right = "yes or no"},                                 \
	{                                                                      \
		"on", character_read_switch, offsetof(type, member.on),        \
			.right = "yes or no"                                   \
	}

#endif
