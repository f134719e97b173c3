/*
 * Two pairs of feet of which there are only the ankles and the points of the
 * soles. A test puts them where it likes, as if clips had.
 */
#ifndef TESTS_UNIT_APP_CHARACTER_RUN_FOOTING_H
#define TESTS_UNIT_APP_CHARACTER_RUN_FOOTING_H

#include "app/character/run/feet.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	SIDE, /* of the sole, beside the line from heel to toe */
	HEEL,
	TOE,
	ANKLE,
	PLACES,
	PAIRS = 2
};

struct footing {
	mat4 world[PAIRS * 2 * PLACES];
	struct instance instance;
	float sole_m[3][PAIRS][CHARACTER_SAMPLES];
	struct character_clip clip[3];
	struct character_entry entry[3];
	struct character_state state[2];
	struct character_feet feet[PAIRS];
	struct character character;
};

static inline float *place_of(
	struct footing *footing, int pair, int side, int place)
{
	return footing->world[(2 * pair + side) * PLACES + place][3];
}

static inline void make_foot(struct footing *footing, int pair, int side)
{
	static const float at[PLACES][3] = {[SIDE] = {0.05f, 0, 0.06f},
		[HEEL] = {0, 0, -0.1f},
		[TOE] = {0, 0, 0.2f},
		[ANKLE] = {0, 0.1f, 0}};
	static const float origin[3] = {0};
	struct character_foot *foot = &footing->feet[pair].foot[side];
	int first = (2 * pair + side) * PLACES;

	for (int i = 0; i < PLACES; i++) {
		float *place = place_of(footing, pair, side, i);

		memcpy(place, at[i], sizeof(at[i]));
		place[0] += side == 0 ? 0.1f : -0.1f;
		if (i != ANKLE) {
			foot->sole[i] =
				character_sole_on_node(first + i, origin);
		}
	}
	foot->leg.tip = first + ANKLE;
	foot->sole_count = ANKLE;
	foot->heel = HEEL;
	foot->toe = TOE;
	foot->planted_m = 0.004f;
	foot->step_s = -1;
}

/*
 * All feet point along +z and stand on the ground at height 0. The figure is 2
 * m tall. One clip plays alone, and frames take 10 ms.
 */
static inline void footing_begin(struct footing *footing)
{
	struct character *character = &footing->character;

	memset(footing, 0, sizeof(*footing));
	for (int i = 0; i < PAIRS * 2 * PLACES; i++) {
		for (int k = 0; k < 4; k++) {
			footing->world[i][k][k] = 1;
		}
	}
	footing->instance.world = footing->world;
	for (int i = 0; i < 3; i++) {
		footing->clip[i].sole_m = footing->sole_m[i];
		footing->entry[i].of = &footing->clip[i];
	}
	footing->entry[0].weight = 1;
	footing->state[1].entry = footing->entry;
	footing->state[1].entry_count = 3;
	for (int pair = 0; pair < PAIRS; pair++) {
		footing->feet[pair].is.now = 1;
		footing->feet[pair].height_m = 2;
		footing->feet[pair].pair = pair;
		make_foot(footing, pair, 0);
		make_foot(footing, pair, 1);
	}
	footing->feet[0].next = &footing->feet[1];
	character->instance = &footing->instance;
	character->machine.state = footing->state;
	character->machine.current = 1;
	character->feet = footing->feet;
	character->step_s = 0.01f;
}

/* Moves a foot as a clip does. */
static inline void move_foot(
	struct footing *footing, int pair, int side, float x, float y, float z)
{
	for (int i = 0; i < PLACES; i++) {
		float *place = place_of(footing, pair, side, i);

		place[0] += x;
		place[1] += y;
		place[2] += z;
	}
}

#endif
