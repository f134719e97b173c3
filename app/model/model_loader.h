/*
 * What a loader of a file format is, and what all of them share.
 *
 * A new format is one row of the table in model.c.
 */
#ifndef APP_MODEL_MODEL_LOADER_H
#define APP_MODEL_MODEL_LOADER_H

#include "app/model/examine/examine.h"
#include "app/model/model.h"
#include "app/model/model_file.h"

struct model_format {
	const char *name; /* for people: "glTF" */

	/* Whether the bytes look like this format; must not trust them. */
	bool (*recognise)(const uint8_t *data, size_t size);

	/* As model_load() promises, from bytes that were recognised. */
	int (*load)(const struct model_source *source, const struct log *log,
		struct model **out);

	/* As model_examine() promises. */
	int (*examine)(const struct model_source *source,
		const struct examiner *examiner, const struct log *log);
};

/*
 * An empty model in an arena of its own, which also holds the struct itself;
 * path and format are copied. NULL when memory is short.
 */
struct model *model_create(const char *path, const char *format);

/*
 * Makes the influences of a primitive what model.h promises: negative weights
 * become 0, those that are 0 point to joint 0, the rest sum to 1. A vertex
 * whose weights are all 0 goes to its first joint. Weights must be finite.
 */
void model_normalize_influences(struct model_primitive *primitive);

/* The largest joint number that counts in the primitive; -1 without any. */
int model_max_joint(const struct model_primitive *primitive);

/*
 * For whole models, after any loader: sets model_channel.constant and unit
 * where they are so, and makes channels in a row that have equal times share
 * one array.
 */
void model_prepare_clips(struct model *model);

#endif
