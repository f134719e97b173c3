/*
 * Converts one clip to one technique and measures the result.
 */
#ifndef APP_COMPARE_COMPARISON_CELL_H
#define APP_COMPARE_COMPARISON_CELL_H

#include "app/compare/comparison.h"
#include "platform/process/jobs.h"

/*
 * Sets rest, screen and turns of comparison->clip[clip], whose grid is made, and
 * thins or refines the grid. Instances are made with
 * jobs locked, because threads share the model's memory budget. Returns 0, or
 * -errno after logging an error.
 */
int comparison_clip_prepare(struct comparison *comparison, int clip,
	struct jobs *jobs, const struct log *log);

/* Fills comparison->row[row].cell[clip]. Returns 0, or -errno after logging. */
int comparison_cell_measure(struct comparison *comparison, int row, int clip,
	struct jobs *jobs, const struct log *log);

#endif
