/*
 * Finds the character of a model: that of a file, or a sketch of one.
 */
#ifndef APP_CHARACTER_CHARACTER_OPEN_H
#define APP_CHARACTER_CHARACTER_OPEN_H

#include "app/character/character.h"

/* What the user asks for. */
struct character_request {
	const char *model_path;
	const char *file; /* a character file, "none", or NULL: the one beside
			     the model if there is one */
	const char *clip; /* name or index of the first clip, or NULL */
	float rate;       /* of a sketch's clips; below 0: backwards */
	enum clip_repeat repeat;
	bool all_loop; /* the user has asked for CLIP_LOOP */
};

/*
 * Writes the path of the character file. Returns false if there is none. If the
 * request names a clip, the file beside the model is not used.
 */
bool character_open_path(
	const struct character_request *request, char *path, size_t size);

/*
 * Loads the file or, without one, what `limber character` would write for the
 * instance's model. Returns 0, or -errno after logging an error; see
 * character_load().
 */
int character_open(const struct character_request *request,
	struct instance *instance, const struct log *log,
	struct character **out);

/*
 * Returns a number that changes when files of the character change, or when a
 * file appears beside a model that had none; 0 without a file.
 */
uint64_t character_open_stamp(const struct character_request *request,
	const struct character *character);

#endif
