/*
 * Finds units in which positions fit 16 bits.
 *
 * Positions are stored as fractions of a unit, a power of two that is at least
 * as large as the largest coordinate. The matrices that place the vertices
 * multiply by the unit: the inverse bind matrices of a skin, or the scale of a
 * node without children.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_SCALE_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_SCALE_H

#include "app/model/gltf/document/gltf_document.h"

struct optimize_scale {
	float *mesh; /* [meshes]: the unit, or 0: positions stay as they are */
	float *skin; /* [skins]: the unit of the skin's meshes, or 0 */
};

/*
 * Meshes of one skin have the same unit. Returns 0, or -errno; an error of the
 * file is logged. The caller calls optimize_scale_release() in either case.
 */
int optimize_scale_find(
	struct optimize_scale *scale, const struct gltf_document *document);

void optimize_scale_release(struct optimize_scale *scale);

#endif
