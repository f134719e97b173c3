/*
 * Converts one clip to one technique and measures the result.
 */
#ifndef APP_COMPARE_COMPARISON_CELL_H
#define APP_COMPARE_COMPARISON_CELL_H

#include "app/compare/comparison.h"
#include "platform/process/jobs.h"

/*
 * Makes the clip's time grid and view. Instances are made under the lock of
 * jobs, since a model's memory budget serves one thread at a time. Returns 0,
 * or -errno after logging an error.
 */
int comparison_clip_prepare(struct comparison *comparison, int clip,
	struct jobs *jobs, const struct log *log);

/* Fills comparison->row[row].cell[clip]. Returns 0, or -errno after logging. */
int comparison_cell_measure(struct comparison *comparison, int row, int clip,
	struct jobs *jobs, const struct log *log);

#endif
