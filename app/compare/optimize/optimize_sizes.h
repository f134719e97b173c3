/*
 * Counts what the bytes of a glTF file are used for.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_SIZES_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_SIZES_H

#include "app/compare/optimize/optimize.h"
#include "app/model/gltf/document/gltf_document.h"

/* Returns 0 or -ENOMEM. */
int optimize_sizes_of(
	const struct gltf_document *document, struct optimize_sizes *out);

#endif
