/*
 * A character: how a model behaves, as a character file says it.
 *
 * character_create() compiles the file for one instance (format.md describes
 * it). A frame is character_press() for each button event, then
 * character_update(), after which the instance's pose is that of the frame and
 * the caller calls instance_update(). No frame allocates memory or looks up a
 * name, and equal inputs give equal poses on every machine.
 */
#ifndef APP_CHARACTER_CHARACTER_H
#define APP_CHARACTER_CHARACTER_H

#include "app/character/character_data.h"
#include "app/character/text/character_text.h"

/*
 * Compiles the character file at path for the instance, which has to outlive
 * the character. Memory counts against the model's budget. Returns 0, or
 * -errno after one error that names file and line; then *out is NULL. Release
 * it with character_destroy().
 */
int character_load(const char *path, struct instance *instance,
	const struct log *log, struct character **out);

/* The same from a stream; path stands in messages. Nothing can be included. */
int character_read(FILE *file, const char *path, struct instance *instance,
	const struct log *log, struct character **out);

/* Returns a number that changes when one of the character's files changes. */
uint64_t character_stamp(const struct character *character);

/* Frees the character; NULL is allowed. */
void character_destroy(struct character *character);

/*
 * Lets a new character continue where another one is, for instance after its
 * file was edited: at the same time, with the same labels and, if it has a
 * state of that name, in the same state. A tour begins again.
 */
void character_go_on(
	struct character *character, const struct character *before);

/* Takes a button event; the next update acts on it. */
void character_press(
	struct character *character, const struct button_event *event);

/* What a frame depends on besides the buttons. */
struct character_frame {
	double time_s;      /* never decreases */
	float motion_level; /* before the video camera, 0..1 */
	float eye[3];       /* of the camera, in metres */
};

/*
 * Advances the character to this frame and writes the pose into the instance.
 * Afterwards the instance's world matrices are those of this pose.
 */
void character_update(
	struct character *character, const struct character_frame *frame);

/*
 * Bends the vertices of morphs that instance_update() has made from the pose.
 */
void character_bend(struct character *character);

/* Writes the name of a binding's buttons, such as "UP+DOWN" or "F8 held". */
void character_button_text(
	const struct character_binding *binding, char *text, size_t size);

/* Returns true if the binding's condition holds now. */
bool character_button_acts(const struct character_binding *binding);

/* Prints what each button does, and each line once. */
void character_print_buttons(const struct character *character, FILE *out);

#endif
