/*
 * Sections [cape]: shapes a grid of cloth that hangs from a bone.
 */
#include "app/character/build/build.h"
#include "app/character/run/effects.h"

#include <errno.h>

enum {
	COLUMNS = 13,
	ROWS = 10
};

/* body = NODE NODE RADIUS [X Y Z]: a capsule that the cloth does not enter. */
static int read_body(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_cape *cape = member;

	if (cape->body_count == CHARACTER_CAPE_BODIES) {
		return character_fail(words, "there are at most %d bodies",
			CHARACTER_CAPE_BODIES);
	}
	return character_read_capsule(
		words, key, &cape->body[cape->body_count++]);
}

#define CAPE(name) offsetof(struct character_cape, name)

static const struct character_key keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_cape, is),
	{"bone", character_read_node, CAPE(bone), .right = "the name of a node"},
	{"place", character_read_numbers3, CAPE(place),
		.right = "x y z of the middle of its upper edge, such as 0 1.45 -0.12"},
	{"width", character_read_number, CAPE(width), 1e-6f,
		CHARACTER_LENGTH_MAX, .right = "metres of its upper edge"},
	{"length", character_read_number, CAPE(length), 1e-6f,
		CHARACTER_LENGTH_MAX,
		.right = "metres from the upper edge to the hem"},
	{"flare", character_read_number, CAPE(flare), 0.1f, 10,
		.right = "the hem's width in upper edges, such as 1.4"},
	{"pleat", character_read_number, CAPE(pleat), 0, CHARACTER_LENGTH_MAX,
		.right = "metres of depth at the hem, such as 0.03"},
	{"shoulders", character_read_numbers2, CAPE(shoulders),
		.right = "metres that the ends of its upper edge are below and before its middle, such as 0.045 0.06"},
	{"radius", character_read_number, CAPE(radius), 0, CHARACTER_LENGTH_MAX,
		.right = "metres kept from bodies, such as 0.02"},
	{"color", character_read_numbers3, CAPE(color), 0, 1,
		.right = "red, green and blue from 0 to 1"},
	{"body", read_body,
		.right = "two nodes and a radius, such as hips chest 0.13"},
	{0},
};

/* Columns run from the wearer's left to right: the cape faces back. */
static void shape_of(const struct character_cape *cape, float shape[][3])
{
	for (int i = 0; i < COLUMNS * ROWS; i++) {
		float across =
			1 - 2 * (float)(i % COLUMNS) / (float)(COLUMNS - 1);
		float down = (float)(i / COLUMNS) / (float)(ROWS - 1);
		float flare = 1 + (cape->flare - 1) * down;
		float pleat = scalar_cos(across * SCALAR_PI * 3) * cape->pleat *
			(0.12f + 0.88f * down);

		shape[i][0] =
			cape->place[0] + across * 0.5f * cape->width * flare;
		shape[i][1] = cape->place[1] - cape->length * down -
			cape->shoulders[0] * across * across;
		shape[i][2] = cape->place[2] + pleat -
			0.06f * cape->length * down +
			cape->shoulders[1] * across * across * (1 - 0.5f * down);
	}
}

static int make_cloth(struct character_build *build, struct character_cape *cape)
{
	struct cloth_settings settings = cloth_settings_default();
	float shape[COLUMNS * ROWS][3];
	int pin[COLUMNS];

	settings.columns = COLUMNS;
	settings.rows = ROWS;
	settings.radius = cape->radius;
	settings.gravity[1] *= build->character->metre;
	settings.fastest *= build->character->metre;
	settings.bend = 0.45f;
	for (int i = 0; i < COLUMNS; i++) {
		pin[i] = cape->bone;
	}
	shape_of(cape, shape);
	cape->index_count = 6 * (COLUMNS - 1) * (ROWS - 1);
	cape->index =
		ARENA_ARRAY(build->arena, uint16_t, (size_t)cape->index_count);
	if (!cape->index ||
		cloth_init(&cape->cloth, &settings, (const float(*)[3])shape,
			pin, (const mat4 *)build->character->instance->world,
			build->arena) != 0) {
		return character_fail_memory(build);
	}
	cloth_triangles(&settings, cape->index);
	return 0;
}

static int read_cape(struct character_build *build,
	const struct character_section *section, void *one)
{
	struct character_cape *cape = one;
	float metre = build->character->metre;
	int error = character_add_switch(build, section, &cape->is);

	cape->bone = -1;
	cape->width = 0.33f * metre;
	cape->length = 0.8f * metre;
	cape->flare = 1.35f;
	cape->pleat = 0.034f * metre;
	cape->radius = 0.02f * metre;
	cape->color[0] = 0.82f;
	cape->color[1] = 0.15f;
	cape->color[2] = 0.19f;
	if (!error) {
		error = character_read_section(build, section, keys, cape);
	}
	if (!error && cape->bone < 0) {
		error = character_fail_missing(
			build, section, "bone = NODE and place = X Y Z");
	}
	if (!error) {
		error = make_cloth(build, cape);
	}
	character_add_op(build, CHARACTER_STAGE_CLOTH, character_cape_run, cape);
	return error;
}

int character_build_capes(struct character_build *build)
{
	static const struct character_kind kind = {
		"cape", sizeof(struct character_cape), read_cape};
	struct character *character = build->character;

	if (character_text_count(build->text, "cape") > CHARACTER_CAPES_MAX) {
		return character_fail_section(build,
			character_text_find(build->text->first, "cape"),
			"a character has at most %d capes", CHARACTER_CAPES_MAX);
	}
	return character_read_kind(
		build, &kind, &character->cape_count, &character->cape);
}
