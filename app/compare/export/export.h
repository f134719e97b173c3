/*
 * Writes the rows of a comparison as glTF files, which other programs can play.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_H
#define APP_COMPARE_EXPORT_EXPORT_H

#include "app/compare/comparison.h"

/* Whether export_comparison() may write a file of this name. */
bool export_names(const char *name);

/*
 * Creates the folder if it does not exist. Returns 0, or -errno after logging
 * an error.
 */
int export_make_folder(const char *folder, const struct log *log);

/*
 * Builds a row's glTF file in memory and loads it. *out shares the images of
 * the comparison's model, which must outlive it; the caller releases *out with
 * model_destroy(). Returns 0, or -errno after logging an error.
 */
int export_load(const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log,
	struct model **out);

/*
 * Writes a file for each listed row but the model itself: FOLDER/morph-N.glb
 * with N fitted keys, morph-even-N.glb, rigid.glb, skin-K.glb with K
 * influences a vertex, and skin.glb without morph targets. Each has all clips
 * that were compared. A file that limber could not load, because it is
 * larger than MODEL_FILE_BYTES_MAX, is left out with a warning. Creates the
 * folder if it does not exist. Returns 0, or -errno after logging an error.
 */
int export_comparison(const struct comparison *comparison, const char *folder,
	const struct log *log);

#endif
