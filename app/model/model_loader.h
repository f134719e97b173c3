/*
 * The interface of a loader, and functions that all loaders share. The table of
 * loaders is in model_load.c.
 */
#ifndef APP_MODEL_MODEL_LOADER_H
#define APP_MODEL_MODEL_LOADER_H

#include "app/model/examine/examine.h"
#include "app/model/model.h"
#include "app/model/model_file.h"

struct model_format {
	const char *name; /* for display: "glTF" */

	/* Whether the bytes begin like this format. They may be any bytes. */
	bool (*recognise)(const uint8_t *data, size_t size);

	/* See model_load(); recognise() has returned true for the bytes. */
	int (*load)(const struct model_source *source, const struct log *log,
		struct model **out);

	/* See model_examine(). */
	int (*examine)(const struct model_source *source,
		const struct examiner *examiner, const struct log *log);
};

/*
 * Returns an empty model in an arena of its own, which also holds the struct
 * and the budget. The source's bytes count against the budget until the load
 * has ended. The model copies the source's name and format. Returns NULL, after
 * an error on the log, if there is not enough memory.
 */
struct model *model_create(const struct model_source *source,
	const char *format, const struct log *log);

/*
 * Makes the influences of a primitive satisfy model.h: negative weights become
 * 0, influences of weight 0 get joint 0, and weights are scaled to sum to 1. A
 * vertex whose weights are all 0 follows its first joint. Weights must be
 * finite.
 */
void model_normalize_influences(struct model_primitive *primitive);

/* Returns the primitive's largest joint number; -1 without influences. */
int model_max_joint(const struct model_primitive *primitive);

/*
 * Moves the keys of a clip's channels into an arena, but only the first key of
 * a constant channel. If a channel has both packed and value, one of them is
 * kept and the other one becomes NULL. keys[i] is an arena with the keys of
 * channel i alone; it is released once they are copied. Returns 0 or -ENOMEM.
 */
int model_keep_clip(
	struct model_clip *clip, struct arena *keys, struct arena *arena);

/*
 * Called for each model that is loaded or examined: sets constant and unit of
 * all channels and lead_s of all clips, and makes successive channels with
 * equal key times share one array.
 */
void model_prepare_clips(struct model *model);

#endif
