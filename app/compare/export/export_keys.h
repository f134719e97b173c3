/*
 * A row of key frames as a model to be drawn, to predict what drawing and
 * gathering it costs.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_KEYS_H
#define APP_COMPARE_EXPORT_EXPORT_KEYS_H

#include "app/compare/comparison.h"

/*
 * Whether the row's file gets levels of detail of its own when it is loaded, so
 * that it is not drawn as the model is: facets (export_levels.c). If clips have
 * too many key frames to be drawn, false.
 */
bool export_keys_differ(const struct comparison *comparison);

/*
 * Loads the row's file with other key frames: those of each clip are its ends
 * and, unless there are many clips, the moments in the middles of so many
 * parts. Otherwise as export_load().
 */
int export_keys_load(const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log,
	struct model **out);

#endif
