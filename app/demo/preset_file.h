/*
 * The presets of shaken bones as a file that programs and people write.
 */
#ifndef APP_DEMO_PRESET_FILE_H
#define APP_DEMO_PRESET_FILE_H

#include "app/anim/procedural/procedural.h"
#include "platform/base/log.h"

enum {
	PRESETS_MAX = 16,
	PRESET_PATH_SIZE = 1024
};

/* The asset that has them. */
extern const char preset_file_asset[];

struct preset_file {
	char path[PRESET_PATH_SIZE]; /* "" where there is no file */
	struct procedural_preset preset[PRESETS_MAX];
	int count; /* at least 1 */
};

/*
 * Reads the presets that come with the program; without the file the
 * document's own is left. 0, or -errno after a sentence for a file that is
 * wrong.
 */
int preset_file_read(struct preset_file *file, const struct log *log);

/* A number of a preset that can be changed. */
struct preset_field {
	const char *name; /* for people */
	const char *key;  /* in the file */
	int element;      /* of a key with three */
	float step, low, high;
};

enum {
	PRESET_FIELDS = 10
};

extern const struct preset_field preset_fields[PRESET_FIELDS];

/* Where the preset has it. */
float *preset_value(
	struct procedural_preset *preset, const struct preset_field *field);

/*
 * Writes a preset into its section of the file, all else in it as it was,
 * comments too; a section that is missing is added. 0, or -errno after a
 * sentence and the file as before.
 */
int preset_file_save(const char *path, const struct procedural_preset *preset,
	const struct log *log);

#endif
