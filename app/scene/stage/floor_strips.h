/*
 * What a camera sees of level ground: rows of the picture.
 *
 * A camera that does not roll sees ground that is equally far ahead in one row.
 * So the ground is two strips that reach from side to side of the picture: the
 * near one is opaque, the far one fades towards where the ground ends. Nothing
 * of them lies outside of the picture.
 */
#ifndef APP_SCENE_STAGE_FLOOR_STRIPS_H
#define APP_SCENE_STAGE_FLOOR_STRIPS_H

#include "app/scene/stage/camera.h"

struct floor_strips {
	/*
	 * A strip of triangles, left and right: the near edge, where fading
	 * begins, where it ends. Strips that are not seen have no height.
	 */
	float position[6][3]; /* scene units */
	uint8_t alpha[6];
	bool opaque, fading; /* which strips are there */
	/* Rows of the picture from its lower edge up. */
	int covered_px; /* wholly covered by opaque ground */
	int horizon_px; /* that see the plane, however far away */
};

/* Of level ground at a height, as far ahead of the eye as these. */
void floor_strips_find(struct floor_strips *strips, const struct camera *camera,
	int width, int height, float y, float solid_end, float end);

#endif
