/*
 * Makes a glTF file smaller without changing its pictures by more than a bound.
 *
 * Keys are left out that lie between others, numbers become integers, and what
 * nothing uses is removed. The result is loaded and played beside the original,
 * and made more exact until the largest error of a vertex keeps to the bound.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_H

#include "app/model/model.h"

#include <stdint.h>

struct optimize_request {
	float bound_px; /* the largest error of a vertex */
	int width,
		height; /* of the picture in which the model fits, in pixels */
	size_t memory_bytes; /* the budget of each model that is loaded */
	/* Called now and then with the steps done and their number; or NULL. */
	void (*progress)(void *context, int done, int total);
	void *progress_context;
};

/* Bytes, and the keys of all channels. */
struct optimize_sizes {
	size_t file, keys, vertices, indices, rest;
	long key_count;
};

struct optimize_result {
	struct optimize_sizes before, after;
	float peak_px; /* the largest error of a vertex, in any clip */
	/*
	 * What the file states about earlier runs: their errors add up, so that
	 * a file optimised twice keeps to the larger bound.
	 */
	float earlier_px;
	uint8_t *data; /* [after.file]: the new file; the caller frees it */
};

/*
 * Reads the glTF file at path anew; model is the same file, which has loaded.
 * Returns 0, or -errno after logging an error: -ENOTSUP for another format.
 */
int optimize_model(const struct model *model,
	const struct optimize_request *request, const struct log *log,
	struct optimize_result *out);

#endif
