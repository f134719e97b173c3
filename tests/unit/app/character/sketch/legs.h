/* Skeletons with legs, and what a sketch says about their feet. */
#ifndef TESTS_UNIT_APP_CHARACTER_SKETCH_LEGS_H
#define TESTS_UNIT_APP_CHARACTER_SKETCH_LEGS_H

#include "app/character/sketch/sketch_feet.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	NODES = 260,
	ROOT = 0, /* of two_legs() */
	HIPS,
	LEFT, /* thigh, shin and foot */
	RIGHT = LEFT + 3,
	TOE = RIGHT + 3
};

/* Nodes with names n0, n1 and so on, all of which are joints. */
struct bones {
	struct model_node node[NODES];
	bool is_joint[NODES], is_named[NODES];
	mat4 world[NODES];
	char name[NODES][64];
	struct model model;
};

static inline int add(struct bones *bones, int parent, float x, float y, float z)
{
	int i = bones->model.node_count++;

	assert_true(i < NODES);
	snprintf(bones->name[i], sizeof(bones->name[i]), "n%d", i);
	bones->node[i] = (struct model_node){
		.name = bones->name[i], .parent = parent, .mesh = -1, .skin = -1};
	bones->is_joint[i] = bones->is_named[i] = true;
	bones->world[i][3][0] = x;
	bones->world[i][3][1] = y;
	bones->world[i][3][2] = z;
	return i;
}

/* A straight leg on the ground, of two bones of the same length. */
static inline int add_leg(
	struct bones *bones, int hips, float x, float z, float length)
{
	int upper = add(bones, hips, x, length, z);
	int lower = add(bones, upper, x, 0.5f * length, z);

	add(bones, lower, x, 0, z);
	return upper;
}

static inline struct bones *no_bones(void)
{
	struct bones *bones = calloc(1, sizeof(*bones));

	assert_non_null(bones);
	bones->model.node = bones->node;
	return bones;
}

/* Legs of this length, and a toe on the ground. */
static inline struct bones *two_legs(float length)
{
	struct bones *bones = no_bones();

	add(bones, -1, 0, 2 * length, 0);
	add(bones, ROOT, 0, length + 2, 0);
	assert_int_equal(add_leg(bones, HIPS, 2, 0, length), LEFT);
	assert_int_equal(add_leg(bones, HIPS, -2, 0, length), RIGHT);
	add(bones, RIGHT + 2, -2, 0, 1);
	return bones;
}

/* Asks for the hips and thighs of each section [feet], and frees the bones. */
static inline void expect_feet(struct bones *bones, const char *wanted)
{
	char *text = NULL, found[256] = "";
	size_t size = 0, length = 0;
	FILE *out = open_memstream(&text, &size);

	assert_non_null(out);
	sketch_write_feet(&bones->model, bones->is_joint, bones->is_named,
		(const mat4 *)bones->world, out);
	assert_int_equal(fclose(out), 0);
	for (char *at = text; (at = strstr(at, "\n;[feet feet")); at++) {
		int number, hips, left, right;

		assert_int_equal(sscanf(at,
					 "\n;[feet feet%d]\n;hips = n%d\n"
					 ";left = n%d %*s %*s\n;right = n%d",
					 &number, &hips, &left, &right),
			4);
		length +=
			(size_t)snprintf(found + length, sizeof(found) - length,
				"%d: %d %d %d, ", number, hips, left, right);
	}
	assert_string_equal(found, wanted);
	assert_int_equal(size == 0, *wanted == '\0');
	free(text);
	free(bones);
}

#endif
