/*
 * Baked candidates as models that any glTF program plays.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_H
#define APP_COMPARE_EXPORT_EXPORT_H

#include "app/compare/comparison.h"

/*
 * Writes FOLDER/morph-N.glb for each listed morph, N being its key frames,
 * and FOLDER/rigid.glb; makes the folder where it is missing. 0, or -errno
 * after a sentence.
 */
int comparison_export(const struct comparison *comparison, const char *folder,
	const struct log *log);

#endif
