/*
 * The file of presets for shaken bones, which people and limber edit.
 */
#ifndef APP_CHARACTER_PRESETS_PRESET_FILE_H
#define APP_CHARACTER_PRESETS_PRESET_FILE_H

#include "app/anim/procedural/procedural.h"
#include "platform/base/log.h"

enum {
	PRESETS_MAX = 16,
	PRESET_PATH_SIZE = 1024
};

/* The name of the preset file in assets/. */
extern const char preset_file_asset[];

struct preset_file {
	char path[PRESET_PATH_SIZE]; /* "" if there is no file */
	struct procedural_preset preset[PRESETS_MAX];
	int count; /* at least 1 after preset_file_find() */
};

/*
 * Reads the presets at path, of which there may be none. Leaves file->path as
 * it is. Returns 0, or -errno after logging an error.
 */
int preset_file_load(
	struct preset_file *file, const char *path, const struct log *log);

/*
 * Finds and reads the presets in assets/. Without any there is one preset, the
 * document's. Returns 0, or -errno after logging an error if the file is
 * malformed.
 */
int preset_file_find(struct preset_file *file, const struct log *log);

/* A number of a preset that the tuner can change. */
struct preset_field {
	const char *name; /* on the display */
	const char *key;  /* in the file */
	int element;      /* index of the number in a key with three numbers */
	float step, low, high;
};

enum {
	PRESET_FIELDS = 10
};

extern const struct preset_field preset_fields[PRESET_FIELDS];

/* Returns the address of the field in the preset. */
float *preset_value(
	struct procedural_preset *preset, const struct preset_field *field);

/*
 * Writes a preset to its section of the file, or to a new section, and keeps
 * everything else, comments included. Returns 0, or -errno after logging an
 * error; then the file is unchanged.
 */
int preset_file_save(const char *path, const struct procedural_preset *preset,
	const struct log *log);

#endif
