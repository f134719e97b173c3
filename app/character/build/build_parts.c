/*
 * Sections [part] and [sequence].
 */
#include "app/character/build/build.h"

#include "app/anim/math/vec.h"
#include "app/character/parts/held.h"
#include "app/character/parts/parts.h"

#include <errno.h>
#include <string.h>

static const char *const freedom_names[CHARACTER_FREEDOMS] = {
	"heading", "pitch", "bank", "x", "y", "z"};

/* A degree of freedom without limits; angles and shifts differ in speed. */
static struct character_freedom unlimited(int which, float metre)
{
	return (struct character_freedom){.given = true,
		.low = -1e6f,
		.high = 1e6f,
		.speed = which < CHARACTER_X ? 45 : 0.5f * metre};
}

/* START LOW HIGH [SPEED], or the name of a parameter that it follows. */
static int read_freedom(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_part *part = member;
	int which = 0;
	struct character_freedom *freedom;

	while (strcmp(freedom_names[which], key->name) != 0) {
		which++;
	}
	freedom = &part->freedom[which];
	part->follows[which] = NULL;
	*freedom = unlimited(which, words->build->character->metre);
	if (!character_take_number(words, &freedom->start)) {
		return character_read_value(words, key, &part->follows[which]);
	}
	if (character_take_number(words, &freedom->low) &&
		!character_take_number(words, &freedom->high)) {
		return character_fail(words,
			"the highest value is missing: give %s", key->right);
	}
	character_take_number(words, &freedom->speed);
	if (freedom->low > freedom->start || freedom->start > freedom->high) {
		return character_fail(words,
			"the start has to lie between the lowest and the highest value: give %s",
			key->right);
	}
	freedom->value = freedom->start;
	return 0;
}

/* order = heading pitch bank, the outermost rotation first. */
static int read_order(struct character_words *words,
	const struct character_key *key, void *member)
{
	int *order = member;
	bool has[3] = {false};

	for (int i = 0; i < 3; i++) {
		int which = 0;

		while (which < 3 &&
			!character_take(words, freedom_names[which])) {
			which++;
		}
		if (which == 3 || has[which]) {
			return character_fail(
				words, "give each of %s once", key->right);
		}
		has[which] = true;
		order[i] = which;
	}
	return 0;
}

static int read_first(struct character_words *words,
	const struct character_key *key, void *member)
{
	int choice = 0;
	int error = character_read_choice(words, key, &choice);

	*(bool *)member = choice == 1;
	return error;
}

static int fail_guards(const struct character_words *words)
{
	return character_fail(
		words, "a part has at most %d capsules", CHARACTER_GUARDS_MAX);
}

/*
 * radius and tip describe the first capsule, each guard a further one, in any
 * order of the lines. Returns NULL if there is no room.
 */
static struct character_guard *first_guard(struct character_part *part)
{
	if (!part->has_radius) {
		if (part->guard_count == CHARACTER_GUARDS_MAX) {
			return NULL;
		}
		memmove(&part->guard[1], &part->guard[0],
			(size_t)part->guard_count * sizeof(part->guard[0]));
		part->guard[0] = (struct character_guard){0};
		part->guard_count++;
		part->has_radius = true;
	}
	return &part->guard[0];
}

static int read_radius(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_guard *guard = first_guard(member);

	return guard ? character_read_number(words, key, &guard->radius_m)
		     : fail_guards(words);
}

static int read_tip(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_guard *guard = first_guard(member);

	return guard ? character_read_numbers3(words, key, guard->to)
		     : fail_guards(words);
}

/* guard = METRES [X Y Z [X Y Z]] */
static int read_guard(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_part *part = member;
	struct character_guard *guard = &part->guard[part->guard_count];
	int error;

	if (part->guard_count == CHARACTER_GUARDS_MAX) {
		return fail_guards(words);
	}
	part->guard_count++;
	error = character_read_number(words, key, &guard->radius_m);
	if (error || character_at_end(words)) {
		return error;
	}
	error = character_read_numbers3(words, key, guard->to);
	if (!error && !character_at_end(words)) {
		memcpy(guard->from, guard->to, sizeof(guard->from));
		error = character_read_numbers3(words, key, guard->to);
	}
	return error;
}

/* top = Y X Z X Z */
static int read_top(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_part *part = member;
	float *top;

	if (part->top_count == CHARACTER_TOPS_MAX) {
		return character_fail(words, "a part has at most %d tops",
			CHARACTER_TOPS_MAX);
	}
	top = part->top[part->top_count++];
	for (int i = 0; i < 5; i++) {
		if (!character_take_number(words, &top[i])) {
			return character_fail_value(words, key);
		}
	}
	return top[1] < top[3] && top[2] < top[4]
		? 0
		: character_fail(
			  words, "the second corner has the larger x and z");
}

static const char *const firsts[] = {"translate", "rotate", NULL};

#define ANGLE \
	"START LOW HIGH SPEED in degrees, such as 0 -60 60 45, or a parameter"
#define SHIFT \
	"START LOW HIGH SPEED in metres, such as 0 -0.4 0.8 0.35, or a parameter"

static const struct character_key keys[] = {
	{"node", character_read_node, offsetof(struct character_part, node),
		.right = "the name of a node"},
	{"order", read_order, offsetof(struct character_part, order),
		.right = "heading pitch bank"},
	{"first", read_first, offsetof(struct character_part, rotates_first),
		.choice = firsts, .right = "translate or rotate"},
	{"heading", read_freedom, .right = ANGLE},
	{"pitch", read_freedom, .right = ANGLE},
	{"bank", read_freedom, .right = ANGLE},
	{"x", read_freedom, .right = SHIFT},
	{"y", read_freedom, .right = SHIFT},
	{"z", read_freedom, .right = SHIFT},
	{"radius", read_radius, 0, 0, CHARACTER_LENGTH_MAX,
		.right = "metres that other parts and the ground keep away"},
	{"tip", read_tip, .right = "x y z in metres from the pivot"},
	{"guard", read_guard,
		.right = "metres that others keep away, and one or two ends x y z, such as 0.05 0 0.5 0"},
	{"top", read_top,
		.right = "the height of a level surface, and x z of two of its corners, such as 0.1 -0.2 -0.3 0.2 0.3"},
	{0},
};

/* What one metre along each axis is in the frame of a node, or of the world. */
static void find_metre(const struct instance *instance, int node, float metre[3])
{
	for (int axis = 0; axis < 3; axis++) {
		float length = node < 0
			? 1.0f
			: vec_length(instance->world[node][axis]);

		metre[axis] = length > 0.0f ? 1.0f / length : 1.0f;
	}
}

/* Converts what the file says in metres, as a node above may have a scale. */
static void use_units_of_node(
	const struct instance *instance, struct character_part *part)
{
	float metre[3];

	find_metre(instance, instance->model->node[part->node].parent,
		part->metre);
	find_metre(instance, part->node, metre);
	for (int i = 0; i < part->guard_count; i++) {
		for (int axis = 0; axis < 3; axis++) {
			part->guard[i].from[axis] *= metre[axis];
			part->guard[i].to[axis] *= metre[axis];
		}
	}
	for (int i = 0; i < part->top_count; i++) {
		float *top = part->top[i];

		top[0] *= metre[1];
		top[1] *= metre[0];
		top[2] *= metre[2];
		top[3] *= metre[0];
		top[4] *= metre[2];
	}
}

static int build_part(struct character_build *build,
	const struct character_section *section, struct character_part *part)
{
	int error;

	*part = (struct character_part){
		.name = section->name,
		.node = -1,
		.order = {CHARACTER_HEADING, CHARACTER_PITCH, CHARACTER_BANK},
		.holder = -1,
	};
	error = character_read_section(build, section, keys, part);
	if (!error && part->node < 0) {
		part->node = character_name_in_heading(build, section, "node",
			section->name, character_name_node);
		error = part->node < 0 ? -EINVAL : 0;
	}
	if (!error) {
		use_units_of_node(build->character->instance, part);
		character_held_init(build->character->instance, part);
	}
	return error;
}

int character_build_part_list(struct character_build *build)
{
	struct character *character = build->character;

	character->part_count = character_text_count(build->text, "part");
	character->part = ARENA_ARRAY(build->arena, struct character_part,
		(size_t)character->part_count);
	return character->part ? 0 : character_fail_memory(build);
}

int character_read_freedom(struct character_words *words, int *part)
{
	const char *name;
	int which = 0;

	*part = character_name_section(words, "part");
	if (*part < 0) {
		return -EINVAL;
	}
	name = character_next_word(words);
	while (name && which < CHARACTER_FREEDOMS &&
		strcmp(freedom_names[which], name) != 0) {
		which++;
	}
	if (!name || which == CHARACTER_FREEDOMS) {
		return character_fail(words,
			"%s is not one of heading, pitch, bank, x, y and z",
			name ? name : "\"\"");
	}
	return which;
}

int character_build_parts(struct character_build *build)
{
	struct character *character = build->character;
	const struct character_section *section =
		character_text_find(build->text->first, "part");
	int error = 0;

	for (int i = 0; section && !error; i++) {
		error = build_part(build, section, &character->part[i]);
		section = character_text_find(section->next, "part");
	}
	if (!error && character->part_count > 0) {
		character_add_op(
			build, CHARACTER_STAGE_PART, character_parts_run, NULL);
		character_add_op(build, CHARACTER_STAGE_ATTACHED,
			character_held_run, NULL);
	}
	return error;
}

/* PART FREEDOM VALUE */
static int read_goal(struct character_words *words, const char *right,
	struct character_step *step)
{
	struct character *character = words->build->character;
	struct character_goal *goal =
		ARENA_NEW(words->build->arena, struct character_goal);
	struct character_goal **last = &step->goal;
	struct character_freedom *freedom;
	const char *name;

	if (!goal) {
		return character_fail_memory(words->build);
	}
	goal->part = character_name_section(words, "part");
	if (goal->part < 0) {
		return -EINVAL;
	}
	name = character_next_word(words);
	while (name && goal->freedom < CHARACTER_FREEDOMS &&
		strcmp(freedom_names[goal->freedom], name) != 0) {
		goal->freedom++;
	}
	if (!name || goal->freedom == CHARACTER_FREEDOMS ||
		!character_take_number(words, &goal->value)) {
		return character_fail(words, "give %s", right);
	}
	freedom = &character->part[goal->part].freedom[goal->freedom];
	if (freedom->given &&
		(goal->value < freedom->low || goal->value > freedom->high)) {
		return character_fail(words,
			"%g is outside of the part's limits %g to %g",
			(double)goal->value, (double)freedom->low,
			(double)freedom->high);
	}
	if (!freedom->given) {
		*freedom = unlimited(
			goal->freedom, words->build->character->metre);
	}
	while (*last) {
		last = &(*last)->next;
	}
	*last = goal;
	return 0;
}

/* step = NAME SECONDS, PART FREEDOM VALUE, ... */
static int read_step(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_sequence *sequence = member;
	struct character_step **last = &sequence->step;
	struct character_step *step =
		ARENA_NEW(words->build->arena, struct character_step);
	int error = 0;

	if (!step) {
		return character_fail_memory(words->build);
	}
	step->name = character_next_word(words);
	if (!step->name || !character_take_number(words, &step->duration_s) ||
		step->duration_s < 0.01f || step->duration_s > 3600) {
		return character_fail(words,
			"a step begins with its name and its seconds, 0.01 to 3600: give %s",
			key->right);
	}
	while (*last) {
		last = &(*last)->next;
	}
	*last = step;
	while (!error && character_take(words, ",")) {
		error = read_goal(words,
			"PART FREEDOM VALUE, such as Arm pitch 16.7", step);
	}
	return error;
}

/* Actions at the end of the last step. */
static int read_then(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_sequence *sequence = member;
	struct character_step *step = sequence->step;

	if (!step) {
		return character_fail(words,
			"there is no step before it: write a line \"step\" first");
	}
	while (step->next) {
		step = step->next;
	}
	return character_read_actions(words, key, &step->then);
}

static const struct character_key sequence_keys[] = {
	{"step", read_step,
		.right = "a name, seconds and values, such as lift 0.7, Arm pitch 13, Hand pitch 60"},
	{"then", read_then, .right = "actions, such as attach Crate Hand"},
	{"repeat", character_read_switch,
		offsetof(struct character_sequence, repeat),
		.right = "yes or no"},
	{"start", character_read_switch,
		offsetof(struct character_sequence, start), .right = "yes or no"},
	{0},
};

static int read_sequence(struct character_build *build,
	const struct character_section *section, void *one)
{
	struct character_sequence *sequence = one;
	int error =
		character_read_section(build, section, sequence_keys, sequence);

	sequence->name = section->name;
	if (!error && sequence->start) {
		character_sequence_start(build->character, sequence, false);
	}
	character_add_op(build, CHARACTER_STAGE_SEQUENCE,
		character_sequence_run, sequence);
	return error;
}

int character_build_sequences(struct character_build *build)
{
	static const struct character_kind kind = {
		"sequence", sizeof(struct character_sequence), read_sequence};

	return character_read_kind(build, &kind,
		&build->character->sequence_count, &build->character->sequence);
}
