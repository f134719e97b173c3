/*
 * The data of a character's morphs (AN4044, section 1), a part of
 * character_data.h.
 */
#ifndef APP_CHARACTER_CHARACTER_MORPH_H
#define APP_CHARACTER_CHARACTER_MORPH_H

#include "app/anim/morph.h"
#include "app/scene/instance/bend.h"

enum character_curve_kind {
	CHARACTER_CURVE_LINEAR,
	CHARACTER_CURVE_SINE,
	CHARACTER_CURVE_TABLE,
	CHARACTER_CURVE_BEZIER,
};

enum {
	CHARACTER_TABLE_MAX = 32,
	CHARACTER_CURVES_MAX = 4
};

/* How a morph gets from Source to Destiny. */
struct character_curve {
	enum character_curve_kind kind;
	const char *name; /* for people */
	int table_count;
	float table[CHARACTER_TABLE_MAX]; /* or the Bezier's x1 y1 x2 y2 */
	/* Of the sine: its displacement, and how it runs through the shape. */
	struct morph_wave wave;
};

/* AN4044's morph between key frames. */
struct character_morph {
	const char *name;
	int node;
	int target_count;
	int key_count;
	bool plain_keys;       /* key 0 is the base, key k is target k - 1 */
	struct morph_key *key; /* [key_count]: weights in groups of three */
	const char **key_name; /* [key_count] */
	float duration_s;
	int frame_count; /* frames that a morph takes if it goes by frames */
	int curve_count;
	struct character_curve curve[CHARACTER_CURVES_MAX];
	struct bend_neck neck; /* above which the shape turns */
	const float *turn_deg; /* or NULL */
	const float *weight;   /* how much of the morph is shown, 0..1 */
	/* without parts, a sine moves the node instead of the vertices */
	struct bend bend;

	/* Changes: */
	struct morph morph; /* of the weights */
	/* keys: the one that the morph goes to, and the destiny before that */
	int destiny, before;
	int chosen; /* index in curve */
	bool by_frames;
	float pace;
};

#endif
