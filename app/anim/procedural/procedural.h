/*
 * Shaken bones: "Physic-based Implementation" (3.2 and 3.3) of the document on
 * offline and physics-based animation.
 *
 * A cosine swings a bone and its descendants, on top of the pose that a clip
 * gives them. The strength changes with each level below the bone. A preset
 * holds the parameters; struct procedural holds a running swing and its fade.
 */
#ifndef APP_ANIM_PROCEDURAL_PROCEDURAL_H
#define APP_ANIM_PROCEDURAL_PROCEDURAL_H

#include "app/anim/pose.h"

#include <stddef.h>

/* A swing's parameters; in the document named m_fAnimProcedural... */
struct procedural_preset {
	char name[32];
	float speed; /* radians a second of the cosine's angle */
	float amplitude;
	float attenuation;    /* added to the modifier at each level */
	float translation[3]; /* at factor 1, in units of the member unit */
	float rotation[3];    /* at factor 1, radians about x, then y, then z */
	float modifier;       /* modifier of the bone where the swing begins */
	float unit;           /* the document's unit of length, in the model's
				 unit */
};

/* A numeric member of a preset. In a text its key is its name. */
struct procedural_field {
	const char *key;
	size_t offset;
	int count; /* floats: 1 or 3 */
};

enum {
	PROCEDURAL_FIELDS = 7
};

/* All numeric members, in the order in which a preset is written. */
extern const struct procedural_field procedural_fields[PROCEDURAL_FIELDS];

/* The document's values, named "snowboard", with modifier and unit 1. */
struct procedural_preset procedural_preset_default(void);

/*
 * Reads presets from a text:
 *	[snowboard]           ; begins a preset with the default's values
 *	speed = 40
 *	translation = 0 1 0
 * Keys are the members' names; ; and # begin comments. path is the file's name
 * in messages. Returns the number of presets read. After an error it logs one
 * message with the line's number and returns -EINVAL, or -ENOSPC for more than
 * capacity presets.
 */
int procedural_presets_parse(const char *text, const char *path,
	const struct log *log, struct procedural_preset *preset, int capacity);

/* Index of the preset of that name, or -1. */
int procedural_preset_find(
	const struct procedural_preset *preset, int count, const char *name);

/* One swing: the document's runtime parameters. */
struct procedural {
	struct procedural_preset preset; /* in the document ...TYPE */
	int node;   /* the bone where it begins; -1: none */
	float fade; /* in the document ...FADE: 1 is off, 0 is full */
	float fade_goal;
	float fade_rate; /* a second */
};

/* A swing that is off until procedural_fade() fades it in. */
struct procedural procedural_begin(
	const struct procedural_preset *preset, int node);

/*
 * Starts moving the fade to goal, 0 (full) to 1 (off), at the rate that covers
 * the whole range 0..1 in duration_s. With a duration of 0 or less, the fade is
 * goal at once.
 */
void procedural_fade(
	struct procedural *procedural, float goal, float duration_s);

/* Advances the fade by step_s. */
void procedural_update(struct procedural *procedural, float step_s);

/*
 * The modifier (m_fBoneModifier) of a bone that is level levels below the one
 * where the swing begins. Each level adds the attenuation while the modifier is
 * above 0.1. The result is at least 0.
 */
float procedural_modifier(const struct procedural_preset *preset, int level);

/*
 * Applies translation and rotation, times the factor, to the bone and its
 * descendants: local = local * T * R. The factor, m_fFactor, is
 * cos(time * speed) * amplitude * modifier * (1 - fade). At fade 1 the pose
 * does not change.
 */
void procedural_apply(
	const struct procedural *procedural, double time_s, struct pose *pose);

#endif
