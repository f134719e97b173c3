/*
 * Shaken bones: "Physic-based Implementation" (3.2 and 3.3) of the document on
 * offline and physics-based animation.
 *
 * A cosine swings a bone and, more or less strongly with each level below it,
 * its descendants, on top of whatever a clip made of them. The swing is a
 * preset's; when and how far it is faded in is the state's.
 */
#ifndef APP_ANIM_PROCEDURAL_PROCEDURAL_H
#define APP_ANIM_PROCEDURAL_PROCEDURAL_H

#include "app/anim/pose.h"

#include <stddef.h>

/* The document's initial parameters, m_fAnimProcedural... */
struct procedural_preset {
	char name[32];
	float speed; /* radians a second */
	float amplitude;
	float attenuation;    /* added to the modifier with each level */
	float translation[3]; /* at factor 1, in the document's units */
	float rotation[3];    /* at factor 1, radians about x, then y, z */
	float modifier;       /* of the bone where the swing begins */
	float unit; /* one of the document's units in the bone's own */
};

/* A member of a preset that is numbers; its key in a text is its name. */
struct procedural_field {
	const char *key;
	size_t offset;
	int count; /* of floats */
};

enum {
	PROCEDURAL_FIELDS = 7
};

/* In the order in which they are written. */
extern const struct procedural_field procedural_fields[PROCEDURAL_FIELDS];

/* The document's values under the name "snowboard"; modifier and unit 1. */
struct procedural_preset procedural_preset_default(void);

/*
 * Reads presets out of a text:
 *	[snowboard]           ; a preset begins, with the default's values
 *	speed = 40
 *	translation = 0 1 0
 * Keys are the members' names; ; and # begin comments. path is for sentences.
 * Returns how many were read into preset, or -EINVAL after one sentence that
 * names the line, or -ENOSPC after one when room is too small.
 */
int procedural_presets_parse(const char *text, const char *path,
	const struct log *log, struct procedural_preset *preset, int room);

/* Index of the preset of that name, or -1. */
int procedural_preset_find(
	const struct procedural_preset *preset, int count, const char *name);

/* One swing: the document's runtime parameters. */
struct procedural {
	struct procedural_preset preset; /* ...TYPE */
	int node;                        /* where it begins */
	float fade;                      /* ...FADE: 1 is off, 0 is full */
	float fade_goal;
	float fade_rate; /* a second */
};

/* Off, until procedural_fade() lets it in. */
struct procedural procedural_begin(
	const struct procedural_preset *preset, int node);

/* Sends the fade to 0 (full) or 1 (off) within duration_s from full range. */
void procedural_fade(
	struct procedural *procedural, float goal, float duration_s);

/* Moves the fade. */
void procedural_update(struct procedural *procedural, float step_s);

/*
 * m_fBoneModifier at a number of levels below the bone: with each level, if
 * it is above 0.1, the attenuation is added; it is never below 0.
 */
float procedural_modifier(const struct procedural_preset *preset, int level);

/*
 * m_fFactor of a bone: cos(time * speed) * amplitude * modifier * (1 - fade).
 */
float procedural_factor(
	const struct procedural *procedural, double time_s, int level);

/*
 * Multiplies translation and rotation, times the factor, onto the bone and
 * its descendants: local = local * T * R. At fade 1 the pose is left alone.
 */
void procedural_apply(
	const struct procedural *procedural, double time_s, struct pose *pose);

#endif
