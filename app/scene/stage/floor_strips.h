/*
 * The part of level ground that a camera sees, as two strips of the picture.
 *
 * The camera does not roll, so all ground in one row of pixels is equally far
 * ahead. Level ground is therefore two quads that extend from the left to the
 * right edge of the picture: the near one is opaque, the far one fades out
 * towards the end of the ground. Neither extends beyond the picture.
 */
#ifndef APP_SCENE_STAGE_FLOOR_STRIPS_H
#define APP_SCENE_STAGE_FLOOR_STRIPS_H

#include "app/scene/stage/camera.h"

struct floor_strips {
	/*
	 * A triangle strip of left and right vertices: at the near edge, where
	 * fading begins, and where it ends. A quad out of view has no height.
	 */
	float position[6][3]; /* scene units */
	uint8_t alpha[6];
	bool opaque, fading; /* whether each quad is in view */
	/* Rows of pixels, counted from the picture's lower edge. */
	int covered_px; /* covered completely by opaque ground */
	int horizon_px; /* below the horizon */
	int end_px;     /* below the end of the ground */
};

/*
 * Computes the strips of the plane at height y. opaque_end and end are level
 * distances ahead of the eye, in scene units: where the ground begins to fade
 * and where it ends.
 */
void floor_strips_find(struct floor_strips *strips, const struct camera *camera,
	int width, int height, float y, float opaque_end, float end);

#endif
