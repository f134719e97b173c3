/*
 * What errors of a clip are measured with: the model, its exact poses, moments
 * and a screen of 480x640.
 */
#ifndef TESTS_SUPPORT_MODEL_COMPARED_CLIP_H
#define TESTS_SUPPORT_MODEL_COMPARED_CLIP_H

#include "app/compare/measure/reference.h"
#include "app/compare/measure/screen_view.h"
#include "app/compare/measure/time_grid.h"

struct compared_clip {
	struct log log; /* to standard error */
	struct model *model;
	struct reference *reference;
	struct time_grid grid;
	struct screen_view screen;
};

/* Loads the file, which must be valid; end with compared_clip_end(). */
void compared_clip_begin(
	struct compared_clip *compared, const char *path, const char *clip);

void compared_clip_end(struct compared_clip *compared);

#endif
