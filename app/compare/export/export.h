/*
 * Writes the baked candidates as glTF files, which other programs can play.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_H
#define APP_COMPARE_EXPORT_EXPORT_H

#include "app/compare/comparison.h"

/*
 * Writes FOLDER/morph-N.glb for each listed morph of N key frames, and
 * FOLDER/rigid.glb. Creates the folder if it does not exist. Returns 0, or
 * -errno after logging an error.
 */
int export_comparison(const struct comparison *comparison, const char *folder,
	const struct log *log);

#endif
