/*
 * Checks the character file of a model.
 */
#ifndef APP_CMD_DOCTOR_DOCTOR_CHARACTER_H
#define APP_CMD_DOCTOR_DOCTOR_CHARACTER_H

#include "app/character/character_open.h"

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

/* What a character file contains. */
struct doctor_character {
	char path[PATH_MAX];
	bool found; /* the model has a file */
	bool right; /* the file is valid for the model */
	int states, layers, effects, buttons;
};

/*
 * Loads the character file that is requested or, without a request, that lies
 * beside the model, if there is one. Logs its errors and warnings to findings,
 * and errors of the model to log. Returns 0, or -errno if the model cannot be
 * loaded.
 */
int doctor_character_check(const struct character_request *request,
	size_t memory_bytes, const struct log *findings, const struct log *log,
	struct doctor_character *out);

#endif
