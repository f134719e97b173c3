/*
 * Makes a glTF file smaller without changing its pictures by more than a bound.
 *
 * Keys that interpolation between other keys can replace are left out, floats
 * become integers, and unused parts are removed. The result is loaded and
 * played beside the original, and made more exact until the largest error of a
 * vertex is within the bound.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_H

#include "app/model/model.h"

#include <stdint.h>

struct optimize_request {
	float bound_px;      /* the largest error of a vertex */
	int width, height;   /* pixels of the picture that frames the model */
	size_t memory_bytes; /* the budget of each model that is loaded */
	/*
	 * A text, or NULL: nodes whose names occur in it keep their keys, even
	 * if nothing drawn follows them.
	 */
	const char *named;
	/* NULL, or called now and then with the steps done and expected. */
	void (*progress)(void *context, int done, int total);
	void *progress_context;
};

/* The bytes of a file by use, and the number of keys of all channels. */
struct optimize_sizes {
	size_t file, keys, vertices, indices, rest;
	long key_count;
};

/* Nodes that clips move, but that nothing drawn or needed follows. */
struct optimize_idle {
	int count;
	const char *name; /* of the first one, in the model; may be "" */
};

struct optimize_result {
	struct optimize_sizes before, after;
	float peak_px; /* the largest error of a vertex, in any clip */
	/*
	 * The bound of earlier runs, as the file states it. This run may only
	 * add the difference to bound_px, so that errors do not add up.
	 */
	float earlier_px;
	struct optimize_idle idle; /* their motion is left out */
	uint8_t *data; /* [after.file]: the new file; the caller frees it */
};

/*
 * Reads the file at model->path again and makes it smaller; model is the loaded
 * file. Returns 0, or -errno after logging an error: -ENOTSUP if it is not
 * glTF. Then *out has no data.
 */
int optimize_model(const struct model *model,
	const struct optimize_request *request, const struct log *log,
	struct optimize_result *out);

#endif
